// What can be asked about a context's objects, beside its state (spec/state_snapshot.h).
#pragma once

#include "spec/state_snapshot.h"

namespace softgl::test {

/// Textures that are bound with their images, buffers that are bound, the framebuffer objects, maps, pixel
/// maps, and which names are objects.
void add_objects(const Gl& gl, StateSnapshot& snapshot);

} // namespace softgl::test
