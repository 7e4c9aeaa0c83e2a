// How the camera of the window moves.
#pragma once

#include "mesh/model_frame.h"
#include "scene/camera_axes.h"
#include "view/view_state.h"

namespace softgl::cli {

// Both begin with the camera of the picture, and do nothing as long as there is none.
void turn(ViewState& state, double azimuth, double elevation); // degrees that the camera goes
void pan(ViewState& state, double right, double down);         // pixels that the picture goes
void magnify(ViewState& state, double factor);

// Another model has the same direction, and else the view that shows all of it.
void show_model(ViewState& state, size_t model);

// In the model's coordinates.
struct OrbitPlace {
  std::array<double, 3> eye, view_up;
};
OrbitPlace place_of(const Orbit& orbit, UpAxis up);
Axes axes_of(const Orbit& orbit, UpAxis up);

// The orbit of any camera; `up` is no kAuto.
SeenCamera seen_camera(const Camera& camera, const ModelFrame& frame, UpAxis up);

} // namespace softgl::cli
