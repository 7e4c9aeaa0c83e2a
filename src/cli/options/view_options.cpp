#include "options/view_options.h"

#include "options/option_kinds.h"
#include "options/option_values.h"

namespace softgl::cli {

void ViewWords::add_to(CLI::App& app) {
  camera.up = UpAxis::kAuto;
  add_parsed(app, "--view", "LIST", "iso, front, back, left, right, top or bottom; several with commas [iso]",
             [this](const std::string& text) { views = parse_views(text); })
      ->check(offers(view_names()));
  add_number(app, "--az", "DEG", "degrees to the right of the named view, else of the front [35]", azimuth,
             -1e6, 1e6);
  add_number(app, "--el", "DEG", "degrees above the named view, else above the horizon [25]", elevation, -1e6,
             1e6);
  add_number(app, "--roll", "DEG", "degrees the camera is turned clockwise [0]", camera.roll, -1e6, 1e6);
  add_number(app, "--zoom", "FACTOR", "magnification after fitting [1]", camera.zoom, 1e-3, 1e3);
  add_number(app, "--fov,--camera-view-angle", "DEG", "vertical field of view in degrees [30]",
             camera.field_of_view, 1, 150);
  app.add_flag("--ortho", camera.orthographic, "parallel projection");
  add_parsed(app, "--up", "AXIS", "axis that points up: +Y, +Z, -X ..., or auto: by the model's shape [auto]",
             [this](const std::string& text) { camera.up = parse_up_axis(text); })
      ->check(offers({"auto", "+X", "-X", "+Y", "-Y", "+Z", "-Z"}));
}

void ViewWords::complete(ProgramOptions& options) {
  camera.width = options.render.width;
  camera.height = options.render.height;
  if (views.empty()) views.emplace_back(azimuth || elevation ? "" : "iso");
  for (const std::string& name : views) {
    CameraOptions seen = camera;
    double from_azimuth = 0, from_elevation = 0;
    if (named_view(name, from_azimuth, from_elevation)) {
      seen.azimuth = from_azimuth;
      seen.elevation = from_elevation;
    }
    if (azimuth) seen.azimuth = from_azimuth + *azimuth;
    if (elevation) seen.elevation = from_elevation + *elevation;
    options.views.push_back({name.empty() ? "view" : name, seen});
  }
}

} // namespace softgl::cli
