// Plays display lists.
#pragma once

namespace softgl {

struct Context;
struct DisplayList;

/// Executes the list. The caller holds a reference to it.
void play_list(Context& context, const DisplayList& list);

} // namespace softgl
