#include "view/view_motion.h"

#include <algorithm>
#include <cmath>

#include "scene/placed_camera.h"

namespace softgl::cli {
namespace {

double along(const double* axis, const std::array<double, 3>& v) {
  return axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
}

} // namespace

Axes axes_of(const Orbit& orbit, UpAxis up) {
  CameraOptions options;
  options.azimuth = orbit.azimuth;
  options.elevation = orbit.elevation;
  options.roll = orbit.roll;
  options.up = up;
  return camera_axes(options);
}

void turn(ViewState& state, double azimuth, double elevation) {
  if (!state.seen) return;
  Orbit& orbit = state.seen->orbit;
  orbit.azimuth = std::remainder(orbit.azimuth + azimuth, 360.0);
  orbit.elevation = std::clamp(orbit.elevation + elevation, -90.0, 90.0);
  state.orbit = orbit;
}

void pan(ViewState& state, double right, double down) {
  if (!state.seen) return;
  Orbit& orbit = state.seen->orbit;
  const Axes axes = axes_of(orbit, state.seen->up);
  const double unit = state.seen->height / state.height;
  for (size_t i = 0; i < 3; ++i) orbit.target[i] += unit * (down * axes.up[i] - right * axes.right[i]);
  state.orbit = orbit;
}

void magnify(ViewState& state, double factor) {
  const double zoom = std::clamp(state.zoom * factor, 1e-3, 1e3); // what --zoom takes
  if (state.seen) state.seen->height *= state.zoom / zoom;
  state.zoom = zoom;
}

void show_model(ViewState& state, size_t model) {
  if (model == state.model || model >= state.models.size()) return;
  state.model = model;
  if (state.orbit) { // its places mean nothing in another model; its direction does
    state.view.clear();
    state.azimuth = state.orbit->azimuth;
    state.elevation = state.orbit->elevation;
    state.roll = state.orbit->roll;
    state.orbit.reset();
  }
  state.place.clear();
  state.seen.reset();
}

OrbitPlace place_of(const Orbit& orbit, UpAxis up) {
  const Axes axes = axes_of(orbit, up);
  OrbitPlace place;
  for (size_t i = 0; i < 3; ++i) {
    place.eye[i] = orbit.target[i] + orbit.distance * axes.back[i];
    place.view_up[i] = axes.up[i];
  }
  return place;
}

SeenCamera seen_camera(const Camera& camera, const ModelFrame& frame, UpAxis model_up) {
  constexpr double kDegrees = 57.29577951308232;
  const CameraPlacement place = placement_of(camera, frame);
  SeenCamera seen;
  seen.up = model_up;
  seen.orbit.target = *place.target;
  std::array<double, 3> back;
  for (size_t i = 0; i < 3; ++i) back[i] = place.eye[i] - seen.orbit.target[i];
  // The target lies in the plane of the model's middle, which may be behind a camera that has a place.
  seen.orbit.distance = std::hypot(back[0], back[1], back[2]);
  for (size_t i = 0; i < 3; ++i) back[i] = camera.view[4 * i + 2];
  if (const double ahead = along(back.data(), place.eye) - along(back.data(), seen.orbit.target);
      !(ahead > 0)) {
    seen.orbit.distance = std::max(seen.orbit.distance, 1 / frame.scale);
    for (size_t i = 0; i < 3; ++i) seen.orbit.target[i] = place.eye[i] - seen.orbit.distance * back[i];
  }
  const Axes model = model_axes(model_up);
  seen.orbit.elevation = std::asin(std::clamp(along(model.up, back), -1.0, 1.0)) * kDegrees;
  const double x = along(model.right, back), z = along(model.back, back);
  const bool upright = std::hypot(x, z) < 1e-6; // seen from above or below: the azimuth is that of its up
  const std::array<double, 3> up = *place.up;
  if (!upright)
    seen.orbit.azimuth = std::atan2(x, z) * kDegrees;
  else
    seen.orbit.azimuth =
        (seen.orbit.elevation > 0 ? std::atan2(-along(model.right, up), -along(model.back, up))
                                  : std::atan2(along(model.right, up), along(model.back, up))) *
        kDegrees;
  const Axes level = axes_of(seen.orbit, model_up);
  seen.orbit.roll = std::atan2(-along(level.right, up), along(level.up, up)) * kDegrees;
  seen.height = place.height > 0 ? place.height : 2 / camera.projection[5] * seen.orbit.distance;
  return seen;
}

} // namespace softgl::cli
