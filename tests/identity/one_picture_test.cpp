// One picture on every processor: each scene has one hash, whatever the instruction set and the number of
// threads; and what is Phong-lit, from immediate mode, lists and arrays, too.
#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>

#include "support/environment.h"
#include "test_paths.h"

namespace {

// Scenes of each family. A case draws them five times.
constexpr int kSeeds = 40;

bool processor_has(const std::string& isa) {
  __builtin_cpu_init();
  if (isa == "v2") return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
  if (isa == "v3")
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
  if (isa == "v4")
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
  return true;
}

bool built(const std::string& isa) {
  return std::string("," SOFTGL_TEST_ISAS ",").find("," + isa + ",") != std::string::npos;
}

// The hash of every scene, from a process of its own, as OSMesa or the specification has it.
std::map<std::string, std::string> hashes(const std::string& isa, int threads,
                                          const std::string& answers = "osmesa", int seeds = kSeeds) {
  const std::string command =
      "SOFTGL_ISA=" + isa + " SOFTGL_THREADS=" + std::to_string(threads) + " SOFTGL_ANSWERS=" + answers +
      " '" SOFTGL_TEST_BINARY_DIR "/softgl_conformance' --library softgl --hash --count " +
      std::to_string(softgl::test::seed_count(seeds)) + " --expect-isa " + isa;
  std::map<std::string, std::string> result;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe);
  char name[100], seed[32], hash[32];
  while (std::fscanf(pipe, "%99s %31s %31s", name, seed, hash) == 3)
    result[std::string(name) + " " + seed] = hash;
  REQUIRE(pclose(pipe) == 0);
  return result;
}

void check(const std::string& isa) {
  if (!built(isa) || !processor_has(isa)) { // ctest counts the case as skipped by these words
    WARN("SKIPPED: " << isa << (built(isa) ? " is not in this processor" : " is not in this build"));
    return;
  }
  static const auto reference = hashes("baseline", 1);
  REQUIRE(reference.size() > 20 * size_t(softgl::test::seed_count(kSeeds)));
  for (int threads : {1, 2, 3, 8}) {
    const auto got = hashes(isa, threads);
    REQUIRE(got.size() == reference.size());
    for (const auto& [scene, hash] : reference)
      if (got.at(scene) != hash)
        FAIL_CHECK(scene << " with " << isa << " and " << threads
                         << " threads has another hash than with baseline and one");
    for (int seed = 0; seed < softgl::test::seed_count(kSeeds); ++seed) {
      const std::string number = " " + std::to_string(seed), &hash = got.at("phong_immediate" + number);
      for (const char* family : {"phong_list", "phong_arrays"})
        if (got.at(family + number) != hash)
          FAIL_CHECK(family << number << " with " << isa << " and " << threads
                            << " threads has another hash than phong_immediate");
    }
  }
  constexpr int kFewSeeds = kSeeds / 8;
  static const auto specified = hashes("baseline", 1, "specification", kFewSeeds);
  for (const auto& [scene, hash] : hashes(isa, 3, "specification", kFewSeeds))
    if (specified.at(scene) != hash)
      FAIL_CHECK(scene << " with " << isa << " and 3 threads has another hash than with baseline and one, "
                       << "where the specification answers");
  SUCCEED();
}

} // namespace

TEST_CASE("one picture with 1, 2, 3 and 8 threads, baseline", "[identity][slow]") { check("baseline"); }
TEST_CASE("one picture with 1, 2, 3 and 8 threads, x86-64-v2", "[identity][slow]") { check("v2"); }
TEST_CASE("one picture with 1, 2, 3 and 8 threads, x86-64-v3", "[identity][slow]") { check("v3"); }
TEST_CASE("one picture with 1, 2, 3 and 8 threads, x86-64-v4", "[identity][slow]") { check("v4"); }
