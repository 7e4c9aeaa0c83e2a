// Between NewList and EndList: turns commands into records and vertices into runs.
#pragma once

#include "commands/vertices/vertex_stream.h"
#include "context/context.h"

namespace softgl {

/// Appends a command to the list; returns where its arguments go (aligned to 8 bytes, valid until the next
/// record). Without memory the error is set; only more than 256 bytes of arguments throw std::bad_alloc.
void* record(Context& context, uint16_t opcode, size_t argument_bytes);
/// A copy of `bytes` bytes that lives as long as the list. Throws std::bad_alloc.
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

// Called by the builder while a list is compiled.
/// `code` is raised when the list is played; between Begin and End GL_INVALID_OPERATION, also in place of
/// GL_NO_ERROR, unless the command is `allowed_inside`.
void compile_error(Context& context, GLenum code, bool allowed_inside = false);
void close_compiled_run(Context& context);             // no primitive is open
void close_loose_run(Context& context, bool with_end); // the Begin of these vertices is in no known list
void break_compiled_run(Context& context); // a command that is allowed inside an open primitive follows

} // namespace softgl
