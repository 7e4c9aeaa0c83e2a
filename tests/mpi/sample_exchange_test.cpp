// Samples of several processes become one picture: every number of them, without a process being started.
#include <catch2/catch.hpp>

#include "mpi/exchange_plan.h"
#include "mpi/part_deal.h"
#include "mpi/sample_message.h"

#include <cstring>
#include <random>

using namespace softgl::cli;

namespace {

constexpr int kWidth = 23, kHeight = 9;
constexpr size_t kSamples = size_t(kWidth) * kHeight;

struct Fragment {
  size_t sample;
  uint32_t depth, order, color;
};

PartSamples background() {
  PartSamples samples;
  samples.width = kWidth;
  samples.height = kHeight;
  samples.colors.fill(4 * kSamples, 7);
  samples.depths.fill(kSamples, 0xffffffffu);
  samples.orders.fill(kSamples, 0);
  return samples;
}

// As GL_LEQUAL draws, one after the other.
void draw(PartSamples& samples, const Fragment& fragment) {
  if (fragment.depth > samples.depths[fragment.sample]) return;
  samples.depths[fragment.sample] = fragment.depth;
  samples.orders[fragment.sample] = fragment.order;
  std::memcpy(&samples.colors[4 * fragment.sample], &fragment.color, 4);
}

bool same(const PartSamples& a, const PartSamples& b, Piece piece) {
  const size_t count = piece.last - piece.first;
  return std::memcmp(&a.colors[4 * piece.first], &b.colors[4 * piece.first], 4 * count) == 0 &&
         std::memcmp(&a.depths[piece.first], &b.depths[piece.first], 4 * count) == 0 &&
         std::memcmp(&a.orders[piece.first], &b.orders[piece.first], 4 * count) == 0;
}

// All rounds of all ranks; what each has in the end.
void compose(std::vector<PartSamples>& parts, const ExchangePlan& plan) {
  const Piece all{0, kSamples};
  for (size_t rank = size_t(plan.active()); rank < parts.size(); ++rank)
    merge_samples(parts[rank - size_t(plan.active())], all, pack_samples(parts[rank], all));
  for (size_t round = 0; round < plan.rounds(); ++round) {
    std::vector<std::vector<std::vector<uint32_t>>> messages(size_t(plan.active()));
    for (int rank = 0; rank < plan.active(); ++rank) {
      const ExchangePlan::Step step = plan.step(rank, round);
      REQUIRE(step.members[step.own] == rank);
      for (const Piece& piece : step.pieces)
        messages[size_t(rank)].push_back(pack_samples(parts[size_t(rank)], piece));
    }
    for (int rank = 0; rank < plan.active(); ++rank) {
      const ExchangePlan::Step step = plan.step(rank, round);
      for (const int member : step.members)
        if (member != rank)
          merge_samples(parts[size_t(rank)], step.pieces[step.own], messages[size_t(member)][step.own]);
    }
  }
}

} // namespace

TEST_CASE("mpi: samples of any number of ranks become what one process draws", "[mpi]") {
  std::mt19937 random(20261130);
  for (int ranks = 1; ranks <= 41; ++ranks) {
    std::vector<PartSamples> parts;
    for (int i = 0; i < ranks; ++i) parts.push_back(background());
    PartSamples expected = background();
    // Few depths, so that most are equal; steps go to ranks as it comes.
    for (uint32_t order = 1; order <= 60; ++order) {
      const size_t rank = random() % size_t(ranks);
      for (int i = 0; i < 12; ++i) {
        const size_t sample = random() % kSamples;
        const uint32_t depth = random() % 3 == 0 ? 0xffffffffu : random() % 3;
        const uint32_t color = uint32_t(random());
        const Fragment fragment{sample, depth, order, color};
        draw(expected, fragment);
        draw(parts[rank], fragment);
      }
    }
    const int radix = std::vector<int>{0, 2, 3, 8}[size_t(ranks) % 4];
    const ExchangePlan plan(ranks, kSamples, radix);
    compose(parts, plan);
    size_t covered = 0;
    INFO(ranks << " ranks, radix " << radix);
    for (int rank = 0; rank < ranks; ++rank) {
      const Piece piece = plan.final_piece(rank);
      CHECK(same(parts[size_t(rank)], expected, piece));
      covered += piece.last - piece.first;
    }
    CHECK(covered == kSamples);
  }
}

TEST_CASE("mpi: ranks exchange in groups that fit their number and the picture's size", "[mpi]") {
  const size_t small = 1000, large = size_t(1) << 24;
  CHECK(ExchangePlan(1, large).rounds() == 0);
  CHECK(ExchangePlan(16, large).rounds() == 4); // binary swap
  CHECK(ExchangePlan(16, small).rounds() == 2); // 8 and 2
  CHECK(ExchangePlan(6, large).rounds() == 2);
  CHECK(ExchangePlan(11, large).active() == 10); // 11 is prime and too large for a group
  CHECK(ExchangePlan(10000, large).active() == 10000);
  CHECK(ExchangePlan(9973, large).active() == 9800);
}

TEST_CASE("mpi: a message holds only the samples that were drawn to", "[mpi]") {
  PartSamples samples = background();
  CHECK(pack_samples(samples, {0, kSamples}).size() == 1);
  draw(samples, {5, 3, 2, 9});
  draw(samples, {6, 3, 2, 9});
  draw(samples, {100, 3, 2, 9});
  CHECK(pack_samples(samples, {0, kSamples}).size() == 1 + 2 * 2 + 3 * 3);
  CHECK(pack_samples(samples, {6, 100}).size() == 1 + 2 + 3);
}

TEST_CASE("mpi: parts are dealt in blocks of equal bytes, or in turns", "[mpi]") {
  CHECK(deal_parts({10, 10, 10, 10}, 2, Deal::kBlocks) == std::vector<int>{0, 0, 1, 1});
  CHECK(deal_parts({30, 10, 10, 10}, 2, Deal::kBlocks) == std::vector<int>{0, 1, 1, 1});
  CHECK(deal_parts({1, 1, 1, 1}, 3, Deal::kTurns) == std::vector<int>{0, 1, 2, 0});
  CHECK(deal_parts({0, 0}, 4, Deal::kBlocks) == std::vector<int>{0, 1}); // sizes that nobody knows
  const std::vector<NumberedText> parts = {{"a b.obj", 7}, {"", 0}, {"x\ny", 12345678901}};
  const std::vector<NumberedText> again = unpacked(packed(parts));
  REQUIRE(again.size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(again[i].text == parts[i].text);
    CHECK(again[i].number == parts[i].number);
  }
}
