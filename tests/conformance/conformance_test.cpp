// Every family of random scenes and every named scene, softgl against the live OSMesa: no byte may differ.
#include <catch2/catch.hpp>

#include <string>

#include "support/environment.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

// 60 scenes of each family. A process takes time to start.
constexpr int kSeedsPerCase = 30, kCasesPerFamily = 2;

class Invoker : public Catch::ITestInvoker {
public:
  Invoker(const Scene& scene, int first, int count) : scene_(scene), first_(first), count_(count) {}
  void invoke() const override {
    for (int seed = first_; seed < first_ + seed_count(count_); seed++) {
      const std::string difference = check_against_osmesa(scene_, uint64_t(seed));
      if (!difference.empty()) FAIL_CHECK(scene_.name << " " << seed << ": " << difference);
    }
    SUCCEED();
  }

private:
  Scene scene_;
  int first_, count_;
};

void add(const Scene& scene, int first, int count) {
  std::string name = "conformance " + scene.name;
  if (scene.random) name += " " + std::to_string(first) + " to " + std::to_string(first + count - 1);
  Catch::getMutableRegistryHub().registerTest(
      Catch::makeTestCase(new Invoker(scene, first, count), "",
                          Catch::NameAndTags(name, "[conformance][slow]"), CATCH_INTERNAL_LINEINFO));
}

} // namespace

// Called from main, when all scenes have registered themselves.
void register_conformance_tests() {
  for (const Scene& scene : named_scenes()) add(scene, 0, 1);
  for (const Scene& family : families())
    for (int i = 0; i < kCasesPerFamily; i++) add(family, i * kSeedsPerCase, kSeedsPerCase);
}

} // namespace softgl::test
