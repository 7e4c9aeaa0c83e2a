// Random texture environments.
#pragma once

#include "support/scene.h"

namespace softgl::test {

/// Environment of the active unit: a mode of its own or a combiner, which may read any of the first `units`
/// texels, all of which are there if `all_on`.
void random_environment(Stage& s, int units, bool all_on);

} // namespace softgl::test
