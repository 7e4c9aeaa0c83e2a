// Thin lines as pixels along their major axis.
#pragma once

#include <cstdint>

#include "shaders/common/shaded_vertex.h"
#include "shaders/raster/raster_draw.h"
#include "shaders/raster/raster_lines.h"

namespace softgl {

constexpr int32_t kMostLinePixels = 1024;

/// Which pixels a line covers: at each pixel of its major axis `width` of them along the minor axis, of which
/// the first is `minor` >> kFraction there. `minor` grows by `slope` from one to the next.
struct LineSteps {
  static constexpr int kFraction = 40;
  int64_t minor, slope;
  int32_t width;
  bool x_major;
};

enum class LineKind { Nothing, Steps, Other };

/// Nothing: the line covers no pixel. Other: it is longer than kMostLinePixels or too short for steps, and
/// setup_line() takes it. For draws without multisampling.
LineKind step_line(const RasterDraw& draw, const ShadedVertices::Slot* corner0,
                   const ShadedVertices::Slot* corner1, LineSpan& span, LineSteps& steps);

} // namespace softgl
