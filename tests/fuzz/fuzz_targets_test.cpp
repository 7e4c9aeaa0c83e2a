// The fuzzers' targets over a few inputs, without libFuzzer, so that they never rot.
#include <catch2/catch.hpp>

#include <chrono>
#include <cstdlib>
#include <vector>

#include "fuzz/targets.h"
#include "support/random.h"

namespace softgl::test {
namespace {

// Inputs of the seeds from 1 on, at most 150 and for at most 2 s; SOFTGL_FUZZ_ROUNDS=n runs n of them.
void run(void (*target)(const Gl& gl, std::span<const uint8_t> bytes)) {
  const char* rounds = std::getenv("SOFTGL_FUZZ_ROUNDS");
  const uint64_t last = rounds ? std::strtoull(rounds, nullptr, 10) : 150;
  const auto start = std::chrono::steady_clock::now();
  for (uint64_t seed = 1; seed <= last; ++seed) {
    INFO("seed " << seed);
    Random random(seed);
    std::vector<uint8_t> bytes(size_t(random.integer(1, 2000)));
    for (uint8_t& byte : bytes) byte = uint8_t(random.bits());
    target(softgl_library(), bytes);
    if (!rounds && std::chrono::steady_clock::now() - start > std::chrono::seconds(2)) return;
  }
}

} // namespace

TEST_CASE("any bytes may become commands", "[fuzz]") { run(fuzz_commands); }
TEST_CASE("what bytes become is the same from a list", "[fuzz]") { run(fuzz_lists); }
TEST_CASE("any bytes may become framebuffer objects", "[fuzz]") { run(fuzz_framebuffers); }

} // namespace softgl::test
