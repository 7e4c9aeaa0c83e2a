#include "api/door.h"

#include "api/call_trace.h"
#include "commands/vertices/list_compilation.h"
#include "commands/vertices/vertex_stream.h"

namespace softgl {

bool may_execute_keeping_run(Context& c) {
  if (c.guard & kNoContext) return false;
  // While a list is compiled, the guard of what is executed waits in the list compiler.
  const uint32_t guard = c.guard & kCompilingList ? c.lists.executing_guard : c.guard;
  if (guard & kInsideBeginEnd) {
    set_error(c, GL_INVALID_OPERATION);
    return false;
  }
  return true;
}

bool may_execute(Context& c) {
  if (!may_execute_keeping_run(c)) return false;
  if (c.guard & kCompilingList) {
    const ExecuteScope scope(c);
    if (c.guard & kRunPending) close_run(c);
  } else if (c.guard & kRunPending) {
    close_run(c);
  }
  return true;
}

bool may_execute_or_compile(Context& c) { return (c.guard & kCompilingList) || may_execute(c); }

void ignore_call(Context& c) { may_execute_keeping_run(c); }

void bad_scalar_parameter(Context& c) {
  if (c.guard & kCompilingList) return compile_error(c, {GL_INVALID_ENUM, "pname"});
  if (c.guard & kInsideBeginEnd) return set_error(c, GL_INVALID_OPERATION);
  set_error(c, GL_INVALID_ENUM, "pname");
}

void bad_texture_unit(Context& c) {
  if (!(c.guard & kNoContext)) set_error(c, GL_INVALID_ENUM, "target");
}

void out_of_memory() noexcept {
  Context& c = *current_context;
  if (!(c.guard & kNoContext)) set_error(c, GL_OUT_OF_MEMORY);
}

void unbuilt_command() {
  Context& c = *current_context;
  if (!(c.guard & kNoContext)) set_error(c, GL_INVALID_OPERATION);
}

void unsupported_command(const char* name) {
  if (!calls_watched.load(std::memory_order_relaxed)) return unbuilt_command();
  const uint32_t error_before = begin_unsupported_call(name);
  unbuilt_command();
  end_unsupported_call(name, error_before);
}

} // namespace softgl
