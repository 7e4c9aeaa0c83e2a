#include "command/picture_inputs.h"

#include "command/camera_file.h"
#include "image/comparison.h"
#include "image/picture_reader.h"
#include "scene/placed_camera.h"

namespace softgl::cli {

void read_named_files(ProgramOptions& options) {
  Background& background = options.render.background;
  if (!background.file.empty())
    background.picture = std::make_shared<const Picture>(as_opaque_picture(read_picture(background.file)));
  if (!options.place.file.empty()) {
    CameraOptions& camera = options.views.front().camera;
    camera.placement = read_camera(options.place.file);
    camera.orthographic = camera.placement->height > 0;
    if (camera.placement->field_of_view > 0) camera.field_of_view = camera.placement->field_of_view;
  }
}

Camera picture_camera(const PreparedModel& model, const CameraOptions& view) {
  return view.placement ? place_camera(model.mesh, view, model.frame) : fit_camera(model.mesh, view);
}

} // namespace softgl::cli
