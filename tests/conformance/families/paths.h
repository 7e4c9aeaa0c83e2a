// One scene, its vertices handed over in the way that is asked for: tests/identity.
#pragma once

#include "support/scene.h"

namespace softgl::test {

enum class Path { Immediate, List, NestedList, Arrays, Elements, ArrayElement, Buffers, ArraysInList };

/// Random primitives of all modes. `phong`: Phong-lit by several lights; otherwise lit and shaded in any way,
/// or not at all.
void draw_by_path(Stage& s, Path path, bool phong);

} // namespace softgl::test
