// softgl_faults over all streams: every case is a process that reports each place where the library does not
// survive the end of memory.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

#include "test_paths.h"

namespace softgl::test {
namespace {

void play_streams(const std::string& arguments) {
  const std::string command = SOFTGL_TEST_BINARY_DIR "/softgl_faults " + arguments;
  INFO(command);
  CHECK(std::system(command.c_str()) == 0);
}

} // namespace

// With threads the order of allocations is another one each time: fewer places are enough.
#define ALLOCATION_FAILURES(kind) \
  TEST_CASE("allocation failures: " kind, "[faults]") { \
    play_streams("--stream " kind " --threads 0"); \
    play_streams("--stream " kind " --threads 2 --most 60"); \
  }

ALLOCATION_FAILURES("vertices")
ALLOCATION_FAILURES("lists")
ALLOCATION_FAILURES("arrays")
ALLOCATION_FAILURES("textures")
ALLOCATION_FAILURES("pixels")
ALLOCATION_FAILURES("state")
ALLOCATION_FAILURES("contexts")

TEST_CASE("allocation failures: random episodes", "[faults]") { play_streams("--random 300 --threads 0"); }

} // namespace softgl::test
