// The picture that reference/spec makes of a scene: records what a scene draws, casts a ray through each
// pixel and lights the point of the triangle that it hits, all in double.
#pragma once

#include <vector>

#include "support/runner.h"

namespace softgl::test {

struct SpecPicture {
  Picture drawn;              // by softgl, with the same calls
  std::vector<uint8_t> color; // RGBA, as in Picture
  /// Pixels whose answer does not hang on a rounding error: its color does not jump by more than 1/255
  /// within 1/128 pixel (edges, which are snapped to 1/256 pixel; the rim of a spotlight; where light begins
  /// to graze).
  std::vector<bool> certain;
  std::vector<bool> covered;
};

/// For scenes of triangles, strips and fans from glBegin and triangles from glDrawElements, lit,
/// Phong-shaded, depth-tested, opaque, each draw in a viewport of its own.
SpecPicture draw_with_spec(const Scene& scene, uint64_t seed);

} // namespace softgl::test
