#include "scene/placed_camera.h"

#include <algorithm>
#include <cmath>

#include "common/program_error.h"
#include "common/trigonometry.h"
#include "scene/camera_axes.h"

namespace softgl::cli {
namespace {

constexpr double kNearest = 1e-3; // of the far plane's distance, where the camera stands in the model

double length_of(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

void divide(double* v, double divisor) {
  for (int i = 0; i < 3; ++i) v[i] /= divisor;
}

Axes axes_of(const CameraPlacement& place, const double* eye, const double* target, UpAxis up_axis) {
  Axes axes{};
  for (int i = 0; i < 3; ++i) axes.back[i] = eye[i] - target[i];
  const double distance = length_of(axes.back);
  if (!(distance > 0)) throw ProgramError(kUsageError, "the camera stands where it looks to");
  divide(axes.back, distance);
  const Axes model = model_axes(up_axis);
  double up[3];
  for (int i = 0; i < 3; ++i) up[i] = place.up ? (*place.up)[size_t(i)] : model.up[i];
  cross(up, axes.back, axes.right);
  if (!(length_of(axes.right) > 1e-6 * length_of(up))) {
    if (place.up) throw ProgramError(kUsageError, "the camera looks along its own up direction");
    cross(model.back, axes.back, axes.right); // from above: the model's back is up
    for (double& value : axes.right) value = -value;
    if (!(length_of(axes.right) > 1e-6)) std::copy_n(model.right, 3, axes.right);
  }
  divide(axes.right, length_of(axes.right));
  cross(axes.back, axes.right, axes.up);
  return axes;
}

} // namespace

Camera place_camera(const CameraPoints& points, const CameraOptions& options, const ModelFrame& frame) {
  const CameraPlacement& place = *options.placement;
  double eye[3], target[3] = {0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    eye[i] = frame.to_frame(place.eye[size_t(i)], i);
    if (place.target) target[i] = frame.to_frame((*place.target)[size_t(i)], i);
  }
  const Axes axes = axes_of(place, eye, target, options.up);
  const auto component = [&](const double* axis) {
    return axis[0] * eye[0] + axis[1] * eye[1] + axis[2] * eye[2];
  };
  const double distance = component(axes.back);
  double ends[2] = {-1e300, -1e300};
  for_each_position(points, [&](const float* p) {
    ends[0] = std::max(ends[0], along(axes.back, p));
    ends[1] = std::max(ends[1], -along(axes.back, p));
  });
  find_largest(points, ends);
  double high = ends[0], low = -ends[1];
  if (high < low) high = low = 0;
  Camera camera{};
  set_view(camera, axes, component(axes.right), component(axes.up), distance);
  if (options.orthographic) {
    double half_height = place.height * frame.scale / 2;
    if (!(half_height > 0)) { // what shows all of the model
      const Camera fitted = fit_camera(points, options);
      half_height = 1 / fitted.projection[5];
    } else {
      half_height /= options.zoom;
    }
    const double depth = std::max(high - low, 1e-3);
    set_orthographic(camera, half_height, aspect_of(options), distance - high - depth / 100,
                     distance - low + depth / 100);
    return camera;
  }
  const double far = distance - low;
  if (!(far > 0))
    throw ProgramError(kCannotRead, "nothing of the model is before the camera; no picture written");
  set_perspective(camera, options, std::max(distance - high, far * kNearest), far);
  return camera;
}

CameraPlacement placement_of(const Camera& camera, const ModelFrame& frame) {
  CameraPlacement place;
  double eye[3], distance = 0;
  std::array<double, 3> target, up;
  for (int i = 0; i < 3; ++i) {
    eye[i] = 0;
    for (int row = 0; row < 3; ++row) eye[i] -= camera.view[4 * i + row] * camera.view[12 + row];
    distance += eye[i] * camera.view[4 * i + 2];
  }
  for (int i = 0; i < 3; ++i) {
    const auto axis = size_t(i);
    place.eye[axis] = eye[i] / frame.scale + frame.center[i];
    target[axis] = (eye[i] - camera.view[4 * i + 2] * distance) / frame.scale + frame.center[i];
    up[axis] = camera.view[4 * i + 1];
  }
  place.target = target;
  place.up = up;
  if (camera.projection[11] == 0)
    place.height = 2 / camera.projection[5] / frame.scale;
  else
    place.field_of_view = 2 * std::atan(1 / camera.projection[5]) * 57.29577951308232;
  return place;
}

} // namespace softgl::cli
