#include "mesh/model_frame.h"

#include <algorithm>
#include <cmath>

namespace softgl::cli {

ModelBounds bounds_of(const ObjModel& model) {
  const size_t count = model.position_count;
  GrowingArray<uint8_t> used;
  used.fill(count, 0);
  uint8_t* mark = used.data();
  for (const ObjChunk& chunk : model.chunks)
    for (const IndexList* list : {&chunk.corner_vertices, &chunk.line_vertices, &chunk.point_vertices})
      for (const int32_t vertex : list->values) mark[vertex] = 1;

  ModelBounds bounds;
  const double* p = model.positions.data();
  for (size_t i = 0; i < count; ++i) {
    if (!mark[i]) continue;
    for (size_t axis = 0; axis < 3; ++axis) {
      const double value = p[3 * i + axis];
      bounds.low[axis] = value < bounds.low[axis] ? value : bounds.low[axis];
      bounds.high[axis] = value > bounds.high[axis] ? value : bounds.high[axis];
    }
  }
  return bounds;
}

ModelFrame frame_model(const ObjModel& model) { return frame_model(model, bounds_of(model)); }

ModelFrame frame_model(const ObjModel& model, const ModelBounds& bounds) {
  ModelFrame frame;
  if (bounds.empty()) return frame;
  const double *low = bounds.low, *high = bounds.high;
  double half = 0;
  for (int axis = 0; axis < 3; ++axis) {
    frame.low[axis] = low[axis];
    frame.high[axis] = high[axis];
    frame.center[axis] = low[axis] / 2 + high[axis] / 2;
    half = std::max(half, high[axis] / 2 - low[axis] / 2);
  }
  int exponent = 0;
  if (half > 0) std::frexp(half, &exponent);
  frame.scale = std::ldexp(1.0, -exponent);

  const size_t count = model.position_count;
  const double* p = model.positions.data();
  float* out = frame.positions.extend(3 * count);
  for (size_t i = 0; i < count; ++i)
    for (size_t axis = 0; axis < 3; ++axis)
      out[3 * i + axis] = float((p[3 * i + axis] - frame.center[axis]) * frame.scale);
  return frame;
}

} // namespace softgl::cli
