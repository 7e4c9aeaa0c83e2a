// A camera as a file of JSON, to use it again:
//   {"eye": [0, 1, 5], "target": [0, 1, 0], "up": [0, 1, 0], "fov": 30}
// Parallel rays have "height", of the picture in the model's units, instead of "fov", which is in degrees.
// Target and up may be missing.
#pragma once

#include <string>

#include "common/source_text.h"
#include "scene/camera.h"

namespace softgl::cli {

// Throws ProgramError (kCannotRead), as the next.
CameraPlacement read_camera(const std::string& path);
CameraPlacement parse_camera(const SourceText& text);
void write_camera(const std::string& path, const CameraPlacement& place);

} // namespace softgl::cli
