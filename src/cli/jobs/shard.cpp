#include "jobs/shard.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>

#include "common/stable_hash.h"

namespace softgl::cli {
namespace {

constexpr uint64_t kDrawing = 1 << 20;
constexpr uint64_t kMostShards = 1000000;

// A whole number of at most nine digits.
bool read_number(const std::string& text, uint64_t& number) {
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
    return false;
  number = std::stoull(text);
  return true;
}

uint64_t variable(const char* name, const char* otherwise = nullptr) {
  const char* text = std::getenv(name);
  if (!text) text = otherwise;
  uint64_t number = 0;
  if (!text || !read_number(text, number))
    throw std::invalid_argument(std::string("the variable ") + name + " has no number");
  return number;
}

Shard slurm_shard() {
  const uint64_t id = variable("SLURM_ARRAY_TASK_ID"), first = variable("SLURM_ARRAY_TASK_MIN", "0"),
                 step = variable("SLURM_ARRAY_TASK_STEP", "1");
  const Shard shard{step && id >= first ? (id - first) / step + 1 : 0, variable("SLURM_ARRAY_TASK_COUNT")};
  if (shard.number == 0 || shard.number > shard.count || (id - first) % step != 0)
    throw std::invalid_argument("the numbers of the Slurm array are no range such as 1-10");
  return shard;
}

} // namespace

Shard parse_shard(const std::string& text) {
  if (text == "slurm") return slurm_shard();
  const size_t slash = std::min(text.find('/'), text.size());
  const std::string number = text.substr(0, slash);
  Shard shard;
  const bool counted = slash < text.size() && read_number(text.substr(slash + 1), shard.count);
  const bool numbered = number == "kubernetes" || read_number(number, shard.number);
  if (!counted || !numbered || shard.count == 0 || shard.count > kMostShards)
    throw std::invalid_argument("a shard is I/N such as 3/10, kubernetes/N or slurm");
  if (number == "kubernetes") shard.number = variable("JOB_COMPLETION_INDEX") + 1;
  if (shard.number == 0 || shard.number > shard.count)
    throw std::invalid_argument("of " + std::to_string(shard.count) + " shards the first is 1, the last " +
                                std::to_string(shard.count));
  return shard;
}

std::vector<size_t> jobs_of_shard(const std::vector<JobWeight>& jobs, const Shard& shard) {
  std::vector<uint64_t> hashes;
  for (const JobWeight& job : jobs) {
    StableHash hash;
    hash.add(job.name);
    hashes.push_back(hash.value());
  }
  std::vector<size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    if (jobs[a].bytes != jobs[b].bytes) return jobs[a].bytes > jobs[b].bytes;
    return hashes[a] != hashes[b] ? hashes[a] < hashes[b] : jobs[a].name < jobs[b].name;
  });
  using Load = std::pair<uint64_t, uint64_t>; // weight so far, number of the shard
  std::priority_queue<Load, std::vector<Load>, std::greater<>> shards;
  for (uint64_t number = 1; number <= shard.count; ++number) shards.emplace(0, number);
  std::vector<size_t> mine;
  for (const size_t job : order) {
    const auto [weight, number] = shards.top();
    shards.pop();
    shards.emplace(weight + jobs[job].bytes + kDrawing, number);
    if (number == shard.number) mine.push_back(job);
  }
  return mine;
}

} // namespace softgl::cli
