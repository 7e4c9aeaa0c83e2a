// The entry of softgl_tests: Catch2's main, after the environment that fixes OSMesa's bytes.
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "support/environment.h"

namespace softgl::test {
void register_conformance_tests(); // conformance/conformance_test.cpp
}

int main(int argc, char** argv) {
  softgl::test::fix_environment();
  softgl::test::register_conformance_tests();
  return Catch::Session().run(argc, argv);
}
