// A fragment program: key, constants and the list of stages that fill a block's final colors.
#pragma once

#include "shaders/fragment/fragment_block.h"
#include "shaders/fragment/fragment_constants.h"
#include "shaders/fragment/fragment_key.h"
#include "shaders/fragment/pixel_image.h"

namespace softgl {

struct FragmentStep {
  FragmentStage stage;
  int32_t unit; // texture unit, or 0
};

/// What the last stage before the alpha test multiplies alpha by.
enum class Coverage : uint8_t { None, Point, Line, Polygon };

struct FragmentProgram {
  static constexpr int kMaxSteps = 32;
  FragmentKey key;
  const FragmentConstants* constants;
  int32_t step_count;
  FragmentStep step[kMaxSteps];
  uint8_t r_units;   // units whose stages read the r coordinate too (three-dimensional, cube map and compared
                     // textures)
  uint8_t lod_units; // units whose stages read differences of coordinates across a 2x2 quad, to find a level
                     // or a filter
  uint8_t cube_units;  // units with cube maps: those differences are of the pixel's own row and column
  bool writes_depth;   // a stage sets the depth, which cannot be tested before
  bool writes_stencil; // instead of a depth a fragment has a stencil value, which is stored without any test
  bool bounds_depth;   // fragments where the stored depth is out of bounds die (GL_EXT_depth_bounds_test)
  bool reads_quads;    // a stage looks at the other pixels of its 2x2 quad: blocks must have whole ones
  Coverage coverage;   // of antialiased primitives; else None

  /// Fragments may fail the alpha test: of small triangles none dies in another stage.
  bool tests_alpha() const { return Compare(key.alpha_function) != Compare::Always; }
  /// A stage lets fragments die.
  bool drops() const {
    return tests_alpha() || coverage != Coverage::None ||
           (constants->image && constants->image->kind == PixelElement::Bit);
  }
  void add(FragmentStage stage, int32_t unit = 0) { step[step_count++] = {stage, unit}; }
};

/// The programs of a draw's antialiased primitives; null for kinds that are not antialiased.
struct SmoothPrograms {
  const FragmentProgram *point, *line, *polygon;
};

} // namespace softgl
