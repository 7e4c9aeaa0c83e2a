// The program softgl-conformance.
#include <cstdio>
#include <cstring>
#include <exception>

#include "run/options.h"

int main(int argc, char** argv) {
  try {
    return softgl::suite::run_suite(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "softgl-conformance: %s\n", e.what());
    return 2;
  }
}
