#include "scene/camera_axes.h"

#include <algorithm>

#include "common/trigonometry.h"

namespace softgl::cli {

void cross(const double* a, const double* b, double* result) {
  result[0] = a[1] * b[2] - a[2] * b[1];
  result[1] = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
}

Axes model_axes(UpAxis up) {
  Axes axes{};
  const int axis = int(up) / 2;
  const double sign = int(up) % 2 ? -1 : 1;
  axes.up[axis] = sign;
  // +Y up: front is +Z. +Z up: front is -Y, as CAD programs have it. +X up: front is +Z.
  if (axis == 2)
    axes.back[1] = -sign;
  else
    axes.back[2] = 1;
  cross(axes.up, axes.back, axes.right);
  return axes;
}

Axes camera_axes(const CameraOptions& options) {
  const Axes model = model_axes(options.up);
  const double sa = sine(options.azimuth), ca = cosine(options.azimuth);
  const double se = sine(options.elevation), ce = cosine(options.elevation);
  Axes level{}, axes{};
  double right[3], up[3];
  for (int i = 0; i < 3; ++i) {
    level.back[i] = ca * model.back[i] + sa * model.right[i];
    right[i] = ca * model.right[i] - sa * model.back[i];
    axes.back[i] = ce * level.back[i] + se * model.up[i];
    up[i] = ce * model.up[i] - se * level.back[i];
  }
  const double sr = sine(options.roll), cr = cosine(options.roll);
  for (int i = 0; i < 3; ++i) {
    axes.right[i] = cr * right[i] + sr * up[i];
    axes.up[i] = cr * up[i] - sr * right[i];
  }
  return axes;
}

void set_view(Camera& camera, const Axes& axes, double x, double y, double z) {
  const double* rows[3] = {axes.right, axes.up, axes.back};
  const double offset[3] = {-x, -y, -z};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) camera.view[4 * column + row] = rows[row][column];
    camera.view[12 + row] = offset[row];
    camera.view[4 * row + 3] = 0;
    camera.eye[row] = axes.back[row];
  }
  camera.view[15] = 1;
}

void set_orthographic(Camera& camera, double half_height, double aspect, double near, double far) {
  camera.projection[0] = 1 / (half_height * aspect);
  camera.projection[5] = 1 / half_height;
  camera.projection[10] = -2 / (far - near);
  camera.projection[14] = -(far + near) / (far - near);
  camera.projection[15] = 1;
}

void set_perspective(Camera& camera, const CameraOptions& options, double near, double far) {
  const double ty = tangent(options.field_of_view / 2), tx = ty * aspect_of(options);
  const double slack = std::max((far - near) * 0.01, near * 0.01);
  near = std::max(near - slack, near * 0.5);
  far += slack;
  camera.projection[0] = options.zoom / tx;
  camera.projection[5] = options.zoom / ty;
  camera.projection[10] = -(far + near) / (far - near);
  camera.projection[14] = -2 * far * near / (far - near);
  camera.projection[11] = -1;
}

} // namespace softgl::cli
