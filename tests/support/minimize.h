// Cuts a scene that two libraries draw differently down to the calls that matter.
#pragma once

#include <vector>

#include "support/runner.h"

namespace softgl::test {

/// Which calls may be left out while the pictures still differ and no GL error appears (delta debugging).
/// Empty when the pictures do not differ to begin with. Colors may differ by `tolerance`.
std::vector<bool> minimize(const Gl& a, const Gl& b, const Scene& scene, uint64_t seed, int tolerance = 0);

/// Prints the calls of a scene that are not skipped, as C.
void print_calls(const Gl& gl, const Scene& scene, uint64_t seed, const std::vector<bool>& skip);

} // namespace softgl::test
