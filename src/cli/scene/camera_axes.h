// What cameras are made of: axes of the model and of the viewer, and the matrix of a view.
#pragma once

#include "scene/camera.h"

namespace softgl::cli {

struct Axes {
  double right[3], up[3], back[3]; // back: from the model to the viewer
};

// Of the upright model: its right, its up, and its front (towards the viewer of the front view).
Axes model_axes(UpAxis up);
Axes camera_axes(const CameraOptions& options);

void cross(const double* a, const double* b, double* result);

inline double along(const double* axis, const float* p) {
  return axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
}

template <class Visit> void for_each_position(const Mesh& mesh, const Visit& visit) {
  for (const GrowingArray<float>* positions :
       {&mesh.positions, &mesh.segment_positions, &mesh.point_positions})
    for (size_t i = 0; i < positions->size(); i += 3) visit(positions->data() + i);
}

template <class Visit> void for_each_position(const CameraPoints& points, const Visit& visit) {
  for (const Mesh* mesh : points.meshes) for_each_position(*mesh, visit);
}

// Of the places of all processes.
template <size_t kCount> void find_largest(const CameraPoints& points, double (&values)[kCount]) {
  if (points.largest_of_all) points.largest_of_all(values, kCount);
}

// The part of the picture that a model fills.
inline constexpr double kFill = 1 - 2 * kMargin;

inline double aspect_of(const CameraOptions& options) { return double(options.width) / options.height; }

// The camera stands at x, y, z along its axes.
void set_view(Camera& camera, const Axes& axes, double x, double y, double z);

// Parallel rays; `near` and `far` are distances of planes.
void set_orthographic(Camera& camera, double half_height, double aspect, double near, double far);
// `near` and `far` are those of the model; its field of view and zoom are the options'.
void set_perspective(Camera& camera, const CameraOptions& options, double near, double far);

} // namespace softgl::cli
