// A light that the mouse turns.
#pragma once

#include <array>
#include <string>

#include "scene/camera_axes.h"
#include "scene/lighting_options.h"

namespace softgl::cli {

// As --light takes it.
std::string text_of(const LightOptions& light);

// The light that `text` describes, turned by degrees to the viewer's right and down. `axes`: the viewer's.
// One of several parts (key, three-point) becomes one that has the direction of its first part. A place in
// the model turns around `middle`.
std::string turned_light(const std::string& text, double right, double down, const Axes& axes,
                         const std::array<double, 3>& middle);

} // namespace softgl::cli
