#include "mpi/ranks.h"

#include <algorithm>
#include <climits>
#include <mpi.h>
#include <new>
#include <numeric>

namespace softgl::cli {
namespace {

constexpr int kTag = 17;

MPI_Comm world() { return MPI_COMM_WORLD; }

uint64_t reduced(uint64_t value, MPI_Op operation) {
  uint64_t result = 0;
  MPI_Allreduce(&value, &result, 1, MPI_UINT64_T, operation, world());
  return result;
}

// Where each rank's text lies in the text of all.
struct Layout {
  std::vector<int> sizes, starts;
  int total = 0;

  Layout(int own, int ranks) : sizes(size_t(ranks)), starts(size_t(ranks)) {
    MPI_Allgather(&own, 1, MPI_INT, sizes.data(), 1, MPI_INT, world());
    for (size_t i = 0; i < sizes.size(); ++i) {
      if (sizes[i] > INT_MAX - total) throw std::bad_alloc();
      starts[i] = total;
      total += sizes[i];
    }
  }

  std::vector<std::string> cut(const std::string& all) const {
    std::vector<std::string> texts;
    for (size_t i = 0; i < sizes.size(); ++i)
      texts.push_back(all.substr(size_t(starts[i]), size_t(sizes[i])));
    return texts;
  }
};

} // namespace

Ranks::Ranks() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(world(), &rank_);
  MPI_Comm_size(world(), &count_);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(world(), MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &on_this_machine_);
  MPI_Comm_free(&machine);
}

Ranks::~Ranks() { MPI_Finalize(); }

void Ranks::together(const std::function<void()>& work) const {
  int code = kSuccess, failed = count_;
  std::string sentence;
  const auto fail = [&](int with, const char* what) {
    code = with;
    sentence = what;
    failed = rank_;
  };
  try {
    work();
  } catch (const ProgramError& error) { fail(error.code, error.what()); } catch (const std::bad_alloc&) {
    fail(kCannotRead, ("not enough memory in rank " + std::to_string(rank_)).c_str());
  } catch (const std::exception& error) { fail(kCannotRead, error.what()); }
  int lowest = count_;
  MPI_Allreduce(&failed, &lowest, 1, MPI_INT, MPI_MIN, world());
  if (lowest == count_) return;
  int size = int(sentence.size());
  MPI_Bcast(&size, 1, MPI_INT, lowest, world());
  sentence.resize(size_t(size));
  MPI_Bcast(sentence.data(), size, MPI_CHAR, lowest, world());
  MPI_Bcast(&code, 1, MPI_INT, lowest, world());
  throw SharedError(ExitCode(code), sentence);
}

void Ranks::abort(int code) const {
  MPI_Abort(world(), code);
  std::abort();
}

void Ranks::largest(double* values, size_t count) const {
  MPI_Allreduce(MPI_IN_PLACE, values, int(count), MPI_DOUBLE, MPI_MAX, world());
}

void Ranks::add(std::vector<int64_t>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), int(values.size()), MPI_INT64_T, MPI_SUM, world());
}

uint64_t Ranks::largest(uint64_t value) const { return reduced(value, MPI_MAX); }
uint64_t Ranks::sum(uint64_t value) const { return reduced(value, MPI_SUM); }

uint64_t Ranks::sum_before(uint64_t value) const {
  uint64_t before = 0;
  MPI_Exscan(&value, &before, 1, MPI_UINT64_T, MPI_SUM, world());
  return rank_ == 0 ? 0 : before;
}

std::string Ranks::broadcast(std::string text) const {
  uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, world());
  if (size > INT_MAX) throw std::bad_alloc();
  text.resize(size);
  MPI_Bcast(text.data(), int(size), MPI_CHAR, 0, world());
  return text;
}

std::vector<std::string> Ranks::gather(const std::string& text) const {
  const Layout layout(int(text.size()), count_);
  std::string all(is_first() ? size_t(layout.total) : 0, '\0');
  MPI_Gatherv(text.data(), int(text.size()), MPI_CHAR, all.data(), layout.sizes.data(), layout.starts.data(),
              MPI_CHAR, 0, world());
  return is_first() ? layout.cut(all) : std::vector<std::string>{};
}

std::vector<std::string> Ranks::gather_everywhere(const std::string& text) const {
  const Layout layout(int(text.size()), count_);
  std::string all(size_t(layout.total), '\0');
  MPI_Allgatherv(text.data(), int(text.size()), MPI_CHAR, all.data(), layout.sizes.data(),
                 layout.starts.data(), MPI_CHAR, world());
  return layout.cut(all);
}

void Ranks::exchange(const std::vector<Message>& messages, const std::vector<int>& senders,
                     const std::function<void(const Message&)>& take) const {
  std::vector<MPI_Request> requests(messages.size());
  for (size_t i = 0; i < messages.size(); ++i) {
    const std::vector<uint32_t>& words = messages[i].words;
    if (words.size() > INT_MAX) throw std::bad_alloc();
    MPI_Isend(words.data(), int(words.size()), MPI_UINT32_T, messages[i].rank, kTag, world(), &requests[i]);
    sent_bytes_ += 4 * words.size();
    ++sent_messages_;
  }
  // From each in turn: a rank that is ahead may have sent what the next round takes.
  for (const int sender : senders) {
    MPI_Status status;
    MPI_Probe(sender, kTag, world(), &status);
    int size = 0;
    MPI_Get_count(&status, MPI_UINT32_T, &size);
    Message message{sender, std::vector<uint32_t>(size_t(size))};
    MPI_Recv(message.words.data(), size, MPI_UINT32_T, sender, kTag, world(), MPI_STATUS_IGNORE);
    take(message);
  }
  MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

std::vector<std::vector<uint32_t>> Ranks::swap(std::vector<std::vector<uint32_t>> words) const {
  const auto count = size_t(count_), own = size_t(rank_);
  std::vector<int> to(count), from(count);
  for (size_t i = 0; i < count; ++i) {
    if (words[i].size() > INT_MAX) throw std::bad_alloc();
    to[i] = int(words[i].size());
  }
  MPI_Alltoall(to.data(), 1, MPI_INT, from.data(), 1, MPI_INT, world());
  std::vector<std::vector<uint32_t>> received(count);
  std::vector<MPI_Request> requests;
  for (size_t i = 0; i < count; ++i) {
    if (i == own || from[i] == 0) continue;
    received[i].resize(size_t(from[i]));
    requests.emplace_back();
    MPI_Irecv(received[i].data(), from[i], MPI_UINT32_T, int(i), kTag + 1, world(), &requests.back());
  }
  for (size_t i = 0; i < count; ++i) {
    if (i == own || to[i] == 0) continue;
    requests.emplace_back();
    MPI_Isend(words[i].data(), to[i], MPI_UINT32_T, int(i), kTag + 1, world(), &requests.back());
    sent_bytes_ += 4 * words[i].size();
    ++sent_messages_;
  }
  MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  received[own] = std::move(words[own]);
  return received;
}

} // namespace softgl::cli
