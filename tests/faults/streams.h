// Command streams, one for every kind of thing that the library keeps in memory.
#pragma once

#include <string>
#include <vector>

#include "faults/player.h"

namespace softgl::test {

struct Stream {
  std::string name;
  void (*run)(Player& player);
};

/// In the order in which they stand in the files *_streams.cpp.
const std::vector<Stream>& vertex_streams();
const std::vector<Stream>& list_streams();
const std::vector<Stream>& array_streams();
const std::vector<Stream>& texture_streams();
const std::vector<Stream>& framebuffer_streams();
const std::vector<Stream>& pixel_streams();
const std::vector<Stream>& state_streams();
const std::vector<Stream>& context_streams();

/// All of them.
std::vector<Stream> all_streams();

/// Random commands with arguments that nobody should give (tests/fuzz), and scenes of the conformance
/// families.
void run_hostile_commands(Player& player);
void run_random_family(Player& player);

} // namespace softgl::test
