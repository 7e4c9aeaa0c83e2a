// What a picture is drawn from beside its model: the files that the command line names, and the camera.
#pragma once

#include "command/prepared_model.h"

namespace softgl::cli {

// Reads the picture behind the model and the camera where they are files. Throws ProgramError.
void read_named_files(ProgramOptions& options);

// At its place, or fitted to the model. `view.up` is the model's.
Camera picture_camera(const PreparedModel& model, const CameraOptions& view);

} // namespace softgl::cli
