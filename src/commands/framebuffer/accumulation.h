// glClear of the accumulation buffer.
#pragma once

#include "draw/draw_call.h"

namespace softgl {

struct Context;

/// True when the accumulation buffer is there and may hold something else than the value it is to be cleared
/// to. It has memory then; throws std::bad_alloc, and has changed nothing, when there is none.
bool prepare_accumulation_clear(Context& context);
/// Clears a box of the window, when prepared.
void clear_accumulation(Context& context, const WindowBox& box);

} // namespace softgl
