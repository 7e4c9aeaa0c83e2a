// The picture that the specification asks for: for each pixel the answers that a correct implementation may
// give.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "spec/interval.h"

namespace softgl::suite {

using spec::Interval;

/// Sizes of points or widths of lines that a GL can draw (3.3.1, 3.4.2).
struct WidthRange {
  double least = 1, greatest = 64, step = 0.125;
  /// The supported one that is nearest.
  double nearest(double width) const {
    const double steps = step > 0 ? std::round((width - least) / step) * step : width - least;
    return std::clamp(least + steps, least, greatest);
  }
};

/// What the framebuffer of the GL under test is like, and what it may choose for all pictures.
struct Precision {
  int bits[4] = {8, 8, 8, 8}; // of red, green, blue, alpha; alpha may be 0
  int subpixel_bits = 4, depth_bits = 24, stencil_bits = 8, accumulation_bits = 16;
  WidthRange points, smooth_points, lines, smooth_lines;
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
  // The primitive that the depth is of, or 0, and its offset: drawn again, it has the same depths (A.3).
  size_t depth_source = 0;
  Interval depth_offset;
  int stencil = 0;
  Interval accumulated[4];
};

/// A set of pixels some of which must have the color: how a thin line is seen.
struct Witness {
  std::vector<int> pixels;
  Interval color[4];
  int least = 1, most = 1000;  // pixels that have it
  bool counts = false;         // `least` and `most` hold if nothing else is drawn to these pixels
  int touched = 0, hidden = 0; // sums of Expectation's when it was drawn
};

struct Expectation {
  int width = 0, height = 0;
  /// The first answer is that of the exact geometry; others are those of the other side of an edge.
  std::vector<std::vector<Answer>> pixels; // rows from below
  std::vector<Witness> witnesses;
  std::vector<int> touched; // how often a primitive may have changed the pixel
  std::vector<int> hidden;  // how often it was drawn over for certain
  int covered = 0;          // pixels that a primitive covers for certain

  int sum(const std::vector<int>& counts, const Witness& witness) const {
    int sum = 0;
    for (int pixel : witness.pixels) sum += counts[size_t(pixel)];
    return sum;
  }
  int uncertain() const {
    int count = 0;
    for (const auto& answers : pixels) count += answers.size() > 1;
    return count;
  }
};

} // namespace softgl::suite
