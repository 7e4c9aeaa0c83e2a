#include "scene/turntable_camera.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"
#include "scene/camera_axes.h"

namespace softgl::cli {
namespace {

// The model and all that it sweeps in a turn around `up`, which goes through the middle of its bounds.
class SweptModel {
public:
  SweptModel(const Mesh& mesh, const double* up) : mesh_(mesh), up_(up) {}

  // How far it reaches along a direction. A point at height h and distance r from the axis reaches h times
  // the direction's upright part, and r times the length of its level part.
  double reach(const double* direction) const {
    double upright = 0, square = 0;
    for (int i = 0; i < 3; ++i) {
      upright += direction[i] * up_[i];
      square += direction[i] * direction[i];
    }
    const double level = std::sqrt(std::max(0.0, square - upright * upright));
    double most = -1e300;
    for_each_position(mesh_, [&](const float* p) {
      const double height = along(up_, p);
      const double distance =
          double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2] - height * height;
      most = std::max(most, height * upright + std::sqrt(std::max(0.0, distance)) * level);
    });
    return most;
  }

  // Along axis + slope * back, where `sign` turns the axis.
  double reach(const double* axis, double sign, const double* back, double slope) const {
    double direction[3];
    for (int i = 0; i < 3; ++i) direction[i] = sign * axis[i] + slope * back[i];
    return reach(direction);
  }

private:
  const Mesh& mesh_;
  const double* up_;
};

} // namespace

Camera turntable_camera(const Mesh& mesh, const CameraOptions& options, int frame, int frames) {
  CameraOptions turned = options;
  turned.azimuth += 360.0 * frame / frames;
  if (mesh.empty()) return fit_camera(mesh, turned);
  const Axes axes = camera_axes(turned);
  const Axes model = model_axes(options.up);
  const SweptModel swept(mesh, model.up);
  const double high = swept.reach(axes.back, 1, axes.back, 0),
               low = -swept.reach(axes.back, -1, axes.back, 0);
  // The same as fit_camera(), with the sides of the view touching what the model sweeps.
  const double ty = tangent(options.field_of_view / 2) * kFill, tx = ty * aspect_of(options);
  const double slope_x = options.orthographic ? 0 : tx, slope_y = options.orthographic ? 0 : ty;
  const double right = swept.reach(axes.right, 1, axes.back, slope_x);
  const double left = swept.reach(axes.right, -1, axes.back, slope_x);
  const double top = swept.reach(axes.up, 1, axes.back, slope_y);
  const double bottom = swept.reach(axes.up, -1, axes.back, slope_y);
  const double x = (right - left) / 2, y = (top - bottom) / 2;
  Camera camera{};
  if (options.orthographic) {
    const double aspect = aspect_of(options);
    double half_height = std::max((top + bottom) / 2, (right + left) / 2 / aspect) / kFill;
    if (!(half_height > 1e-9)) half_height = 1;
    half_height /= options.zoom;
    const double depth = std::max(high - low, half_height * 1e-3) * 1.01;
    set_view(camera, axes, x, y, (low + high) / 2 + depth);
    set_orthographic(camera, half_height, aspect, depth / 4, depth * 7 / 4);
    return camera;
  }
  double distance = std::max((right + left) / (2 * tx), (top + bottom) / (2 * ty));
  if (!(distance - high > 1e-6)) distance = high + 1 / ty;
  set_view(camera, axes, x, y, distance);
  set_perspective(camera, options, distance - high, distance - low);
  return camera;
}

} // namespace softgl::cli
