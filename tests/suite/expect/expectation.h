// The picture that the specification asks for: for each pixel the answers that a correct implementation may
// give.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "spec/interval.h"

namespace softgl::suite {

using spec::Interval;

/// What the framebuffer of the GL under test is like, and what it may choose for all pictures.
struct Precision {
  int bits[4] = {8, 8, 8, 8}; // of red, green, blue, alpha; alpha may be 0
  int subpixel_bits = 4;
  /// GL_WIN_phong_shading does not say whether interpolated normals are normalized.
  bool unit_normals = true;
  /// Half a step of a component's fixed-point number: what one rounding may change. More than 8 bits are
  /// rounded once more when they are read as bytes.
  double half_step(int component) const {
    const double stored = 0.5 / (std::ldexp(1, bits[component]) - 1), byte = 0.5 / 255;
    return bits[component] == 0 ? byte : bits[component] > 8 ? stored + byte : stored;
  }
};

struct Answer {
  Interval color[4]; // before it is rounded to the framebuffer's bits
  Interval depth;
};

/// A set of pixels one of which must have the color: how a thin line is seen.
struct Witness {
  std::vector<int> pixels;
  Interval color[4];
};

struct Expectation {
  int width = 0, height = 0;
  /// The first answer is that of the exact geometry; others are those of the other side of an edge.
  std::vector<std::vector<Answer>> pixels; // rows from below
  std::vector<Witness> witnesses;
  int covered = 0; // pixels that a primitive covers for certain

  int uncertain() const {
    int count = 0;
    for (const auto& answers : pixels) count += answers.size() > 1;
    return count;
  }
};

} // namespace softgl::suite
