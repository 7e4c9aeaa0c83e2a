// Random sequences of state commands on softgl and on OSMesa: the same errors and the same answers after
// each.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "spec/state_commands.h"
#include "spec/state_snapshot.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

// Runs one sequence; the text of the first difference, or nothing.
std::string run_sequence(uint64_t seed, int length) {
  const Gl &ours = softgl_library(), &theirs = osmesa_library();
  CurrentContext our_context(ours), their_context(theirs);
  Random random(seed);
  std::string history;
  for (int i = 0; i < length; ++i) {
    const StateCommand command = random_state_command(random);
    history += command.text + "\n";
    command.run(ours);
    command.run(theirs);
    const GLenum our_error = ours.GetError(), their_error = theirs.GetError();
    std::string difference;
    if (our_error != their_error)
      difference = "error " + std::to_string(our_error) + " | " + std::to_string(their_error) + "\n";
    const bool last = i + 1 == length;
    if (last || i % 8 == 7)
      difference += compare_snapshots(take_snapshot(ours, last), take_snapshot(theirs, last));
    if (!difference.empty())
      return "seed " + std::to_string(seed) + " after\n" + history + "softgl | OSMesa\n" + difference;
  }
  return "";
}

} // namespace

TEST_CASE("random state commands leave the state that OSMesa has", "[spec][state]") {
  const char* first = std::getenv("SOFTGL_TEST_SEED");
  const char* count = std::getenv("SOFTGL_TEST_COUNT");
  const uint64_t begin = first ? std::strtoull(first, nullptr, 10) : 1;
  const uint64_t end = begin + (count ? std::strtoull(count, nullptr, 10) : 20);
  for (uint64_t seed = begin; seed < end; ++seed) {
    const std::string difference = run_sequence(seed, 120);
    INFO(difference);
    REQUIRE(difference.empty());
  }
}
