// Every command of the library, to be called with arguments that are only known when the test runs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

#include "api/trace_tables.h"
#include "support/gl.h"

namespace softgl::test {

/// One argument: the member that the parameter's type asks for counts.
struct Argument {
  int64_t whole = 0;
  double real = 0;
  void* pointer = nullptr;
};

struct AnyCommand {
  const char* name; // without "gl"
  int parameter_count;
  const TraceParameter* parameters;
  /// Returns what the command returns, as bits.
  uint64_t (*call)(const Gl& gl, const Argument* arguments);
};

constexpr int kMostParameters = 15;

/// All commands of support/gl_functions.inc, in its order.
std::span<const AnyCommand> any_commands();

/// The values of a group of names of src/api/trace_tables.h, in ascending order.
std::span<const TraceName> names_of_group(uint8_t group);
/// The group of the values that a parameter takes; kNoNames if they have no names.
uint8_t group_of_parameter(uint32_t parameter);

/// "glEnable(GL_FOG)"; memory is told by its address.
std::string text_of(const AnyCommand& command, const Argument* arguments);

} // namespace softgl::test
