// Arguments of any command: good ones, ones that are good elsewhere, and bad ones. Whatever GL makes of them,
// it reads and writes only memory that exists.
#pragma once

#include <array>
#include <string>

#include "fuzz/any_command.h"
#include "fuzz/choices.h"

namespace softgl::test {

using Arguments = std::array<Argument, kMostParameters>;

/// The memory that commands write to. Cleared before each command whose answer is looked at.
struct OutputMemory {
  static constexpr size_t kBytes = 1 << 22;
  static unsigned char* bytes();
};

/// Sizes are small or refused, counts are small: no command takes long. Arrays and images lie in memory that
/// is long enough for all of them.
Arguments choose_arguments(const AnyCommand& command, Choices& choices);

/// Brings a context into some state as a program may do: textures, buffers, framebuffer objects, lists,
/// stacks, with names from 1 to 5.
void prepare_objects(const Gl& gl, Choices& choices);

} // namespace softgl::test
