#include "mpi/compositor.h"

#include <algorithm>
#include <cstring>

#include "mpi/exchange_plan.h"
#include "mpi/sample_message.h"

namespace softgl::cli {
namespace {

// What the ranks beyond the plan's groups have goes to a rank of the groups.
void fold(PartSamples& samples, const ExchangePlan& plan, const Ranks& ranks) {
  const Piece all{0, samples.orders.size()};
  std::vector<Ranks::Message> messages;
  std::vector<int> senders;
  if (ranks.rank() >= plan.active())
    messages.push_back({ranks.rank() - plan.active(), pack_samples(samples, all)});
  else if (ranks.rank() + plan.active() < ranks.count())
    senders.push_back(ranks.rank() + plan.active());
  ranks.exchange(messages, senders,
                 [&](const Ranks::Message& message) { merge_samples(samples, all, message.words); });
}

void run_round(PartSamples& samples, const ExchangePlan::Step& step, const Ranks& ranks) {
  std::vector<Ranks::Message> messages;
  std::vector<int> senders;
  for (size_t i = 1; i < step.members.size(); ++i) { // each rank begins with another one
    const size_t member = (step.own + i) % step.members.size();
    messages.push_back({step.members[member], pack_samples(samples, step.pieces[member])});
    senders.push_back(step.members[(step.own + step.members.size() - i) % step.members.size()]);
  }
  ranks.exchange(messages, senders, [&](const Ranks::Message& message) {
    merge_samples(samples, step.pieces[step.own], message.words);
  });
}

void collect_colors(PartSamples& samples, const ExchangePlan& plan, const Ranks& ranks) {
  std::vector<Ranks::Message> messages;
  std::vector<int> senders;
  if (ranks.is_first())
    for (int rank = 1; rank < plan.active(); ++rank) senders.push_back(rank);
  else if (ranks.rank() < plan.active()) {
    const Piece piece = plan.final_piece(ranks.rank());
    std::vector<uint32_t> words(piece.last - piece.first);
    if (!words.empty()) std::memcpy(words.data(), samples.colors.data() + 4 * piece.first, 4 * words.size());
    messages.push_back({0, std::move(words)});
  }
  ranks.exchange(messages, senders, [&](const Ranks::Message& message) {
    if (message.words.empty()) return; // a rank without pixels
    std::memcpy(samples.colors.data() + 4 * plan.final_piece(message.rank).first, message.words.data(),
                4 * message.words.size());
  });
}

} // namespace

PartSamples compose_samples(PartSamples samples, int radix, const Ranks& ranks, bool& visible) {
  const ExchangePlan plan(ranks.count(), samples.orders.size(), radix);
  visible = ranks.any(
      std::any_of(samples.orders.begin(), samples.orders.end(), [](uint32_t order) { return order != 0; }));
  fold(samples, plan, ranks);
  for (size_t round = 0; ranks.rank() < plan.active() && round < plan.rounds(); ++round)
    run_round(samples, plan.step(ranks.rank(), round), ranks);
  samples.depths.release();
  samples.orders.release();
  collect_colors(samples, plan, ranks);
  return ranks.is_first() ? std::move(samples) : PartSamples();
}

} // namespace softgl::cli
