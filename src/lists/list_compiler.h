// Between NewList and EndList: turns commands into records and vertices into runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "base/gl_types.h"
#include "vertex/vertex_builder.h"

namespace softgl {

struct Context;
struct DisplayList;

struct ListCompiler {
  std::shared_ptr<DisplayList> list; // null: no list is being compiled
  GLuint name = 0;
  GLenum mode = GL_COMPILE;
  int depth = 0; // of CallList, while playing

  // While a list is compiled Context::builder and Context::guard belong to it; these are the ones of
  // execution.
  VertexBuilder executing_builder;
  uint32_t executing_guard = 0;

  struct Free {
    void operator()(float* p) const { std::free(p); }
  };
  std::unique_ptr<float, Free> vertices; // the builder's chunk while a list is compiled

  bool last_was_error = false;   // the last record stands for an error: nothing to execute
  std::vector<uint64_t> scratch; // takes the arguments of a command that only raises an error
  uint64_t emergency[32];        // the same when there is no memory: more than any command's arguments
};

/// Closes a pending run; see VertexBuilder::close_run.
void close_run(Context& context);

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
