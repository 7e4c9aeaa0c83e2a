// A camera that goes around the model.
#pragma once

#include "scene/camera.h"

namespace softgl::cli {

// The camera of one of `frames` pictures around the model's upright axis. Its distance and height are those
// at which no picture of a whole turn cuts the model, however many there are: it neither grows nor jumps.
Camera turntable_camera(const Mesh& mesh, const CameraOptions& options, int frame, int frames);

} // namespace softgl::cli
