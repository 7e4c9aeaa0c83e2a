// What the doors use of the vertex builder and the list compiler.
#pragma once

#include "state/context.h"

namespace softgl {

[[gnu::weak]] void close_run(Context& c);
[[gnu::weak]] void* record(Context& c, uint16_t opcode, size_t argument_bytes);
[[gnu::weak]] const void* keep(Context& c, const void* data, size_t bytes);
[[gnu::weak]] bool execute_too(Context& c);
struct ExecuteScope { explicit ExecuteScope(Context&) {} };

} // namespace softgl
