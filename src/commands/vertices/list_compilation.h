// Between NewList and EndList: turns commands into records and vertices into runs.
#pragma once

#include "context/context.h"

namespace softgl {

// Where memory ends, the list fails (drop_vertices): nothing more is kept, commands are still executed where
// the mode says so, and EndList leaves an older list of that name as it was.

/// Appends a command to the list; returns where its arguments go (aligned to 8 bytes, valid until the next
/// record). Those of a command that is not kept are lost. Throws std::bad_alloc where more than 256 bytes
/// are.
void* record(Context& context, uint16_t opcode, size_t argument_bytes);
/// A copy of `bytes` bytes that lives as long as the list; `data` itself where the list has failed.
const void* keep(Context& context, const void* data, size_t bytes);
/// True when the command that was just recorded is to be executed, too (GL_COMPILE_AND_EXECUTE).
bool execute_too(const Context& context);

/// While alive, commands are executed although a list is being compiled.
class ExecuteScope {
public:
  explicit ExecuteScope(Context& context);
  ~ExecuteScope();
  ExecuteScope(const ExecuteScope&) = delete;
  ExecuteScope& operator=(const ExecuteScope&) = delete;

private:
  Context& context_;
  bool entered_;
};

/// The error is raised when the list is played; between Begin and End GL_INVALID_OPERATION, also in place of
/// GL_NO_ERROR, unless the command is `allowed_inside`.
void compile_error(Context& context, const Refusal& refusal, bool allowed_inside = false);
/// The error of a command that goes into lists: compile_error() while a list is compiled, else set_error().
void raise_error(Context& context, const Refusal& refusal, bool allowed_inside = false);
/// Moves the vertices that wait into the list. A primitive that is open ends in a later run, or in another
/// list.
void close_compiled_run(Context& context);
/// Appends the setting of an attribute. The run of vertices that follows it knows the value.
void record_attribute(Context& context, int slot, const float* value);
/// Stand around the Begin and End of an array draw, whose vertices are not mixed with others.
void open_array_run(Context& context);
void hide_array_run(Context& context);
/// An End whose Begin is in no known list.
void compile_end(Context& context);

} // namespace softgl
