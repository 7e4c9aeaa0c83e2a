// What the fuzzers do with bytes. Each target survives all bytes, or dies of a fault of the library.
#pragma once

#include <cstdint>
#include <span>

#include "support/gl.h"

namespace softgl::test {

/// All commands with all arguments, in any order.
void fuzz_commands(const Gl& gl, std::span<const uint8_t> bytes);

/// Commands that display lists keep: executed at once, and from a list. Picture and state must be the same.
void fuzz_lists(const Gl& gl, std::span<const uint8_t> bytes);

/// Framebuffer objects and their images: what is complete can be drawn to and read, and nothing else can.
void fuzz_framebuffers(const Gl& gl, std::span<const uint8_t> bytes);

/// Ends the program with a message, as a fuzzer wants to be told of a fault.
[[noreturn]] void fault(const char* what);

} // namespace softgl::test
