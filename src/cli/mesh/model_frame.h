// Where a model stands: its bounds, and its positions moved to the origin and scaled to about 1 before they
// become floats, so that neither size nor distance from the origin costs precision.
#pragma once

#include "obj/obj_reader.h"

namespace softgl::cli {

struct ModelFrame {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0}; // of everything that is drawn
  double center[3] = {0, 0, 0};
  double scale = 1;              // a power of two: scaling rounds nothing
  GrowingArray<float> positions; // (position - center) * scale, for each vertex of the file

  double to_frame(double value, int axis) const { return (value - center[axis]) * scale; }
};

// The least box around everything that is drawn.
struct ModelBounds {
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
  bool empty() const { return low[0] > high[0]; }
};

ModelBounds bounds_of(const ObjModel& model);

ModelFrame frame_model(const ObjModel& model);
// As a part of a model with these bounds.
ModelFrame frame_model(const ObjModel& model, const ModelBounds& bounds);

} // namespace softgl::cli
