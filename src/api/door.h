// What the generated doors do before they call a canonical command.
#pragma once

#include "api/unbuilt_command.h"
#include "commands/vertices/list_compilation.h"
#include "context/context.h"

namespace softgl {

/// For a door whose guard is not 0: false without a context, and with GL_INVALID_OPERATION between Begin and
/// End (2.6.3). Hands over a pending run of vertices.
[[gnu::cold]] bool may_execute(Context& c);
/// The same for a command that has nothing to do with vertices.
[[gnu::cold]] bool may_execute_keeping_run(Context& c);
/// The same for a command that compiles itself into a list.
[[gnu::cold]] bool may_execute_or_compile(Context& c);
/// For a call that lacks what a pointer ought to point to: GL_INVALID_OPERATION between Begin and End, or
/// nothing.
[[gnu::cold]] void ignore_call(Context& c);
/// A scalar form with a parameter that has several values: GL_INVALID_ENUM, or GL_INVALID_OPERATION between
/// Begin and End.
[[gnu::cold]] void bad_scalar_parameter(Context& c);
[[gnu::cold]] void bad_texture_unit(Context& c);
/// Nothing is thrown across a door: GL_OUT_OF_MEMORY in the current context.
[[gnu::cold]] void out_of_memory() noexcept;

} // namespace softgl
