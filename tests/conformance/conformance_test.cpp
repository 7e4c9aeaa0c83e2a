// Every family of random scenes and every named scene, softgl against the live OSMesa: no byte may differ.
// OSMesa takes 0.12 s for a scene, softgl less than 1 ms: manifest_test.cpp compares six times as many with
// hashes of OSMesa's pictures.
#include <catch2/catch.hpp>

#include <string>

#include "support/environment.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

constexpr int kSeeds = 10; // of each family

class Invoker : public Catch::ITestInvoker {
public:
  Invoker(const Scene& scene, int count) : scene_(scene), count_(count) {}
  void invoke() const override {
    for (int seed = 0; seed < seed_count(count_); seed++) {
      const std::string difference = check_against_osmesa(scene_, uint64_t(seed));
      if (!difference.empty()) FAIL_CHECK(scene_.name << " " << seed << ": " << difference);
    }
    SUCCEED();
  }

private:
  Scene scene_;
  int count_;
};

void add(const Scene& scene, int count) {
  Catch::getMutableRegistryHub().registerTest(Catch::makeTestCase(
      new Invoker(scene, count), "", Catch::NameAndTags("conformance " + scene.name, "[conformance][slow]"),
      CATCH_INTERNAL_LINEINFO));
}

} // namespace

// Called from main, when all scenes have registered themselves.
void register_conformance_tests() {
  for (const Scene& scene : named_scenes()) add(scene, 1);
  for (const Scene& family : families()) add(family, kSeeds);
}

} // namespace softgl::test
