// A camera at a place that is given, and the place of a camera.
#pragma once

#include "mesh/model_frame.h"
#include "scene/camera.h"

namespace softgl::cli {

// For options with a placement.
Camera place_camera(const CameraPoints& points, const CameraOptions& options, const ModelFrame& frame);

// Eye, target, up, field of view and height of any camera, in the model's coordinates.
CameraPlacement placement_of(const Camera& camera, const ModelFrame& frame);

} // namespace softgl::cli
