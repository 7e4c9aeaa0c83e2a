// Every command with random arguments against OSMesa, in the program softgl_arguments: OSMesa dies of some of
// them.
#include <catch2/catch.hpp>

#include <cstdlib>

#include "test_paths.h"

TEST_CASE("every command answers random arguments as OSMesa does", "[fuzz][arguments][slow]") {
  CHECK(std::system(SOFTGL_TEST_BINARY_DIR "/softgl_arguments --count 1 --every 25") == 0);
}
