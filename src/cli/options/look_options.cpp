#include "options/look_options.h"

#include "options/option_kinds.h"
#include "options/option_values.h"

namespace softgl::cli {

void add_look(CLI::App& app, ProgramOptions& options) {
  LineOptions& lines = options.render.lines;
  app.add_option_function<std::string>(
         "--edges",
         [&lines](const std::string& word) { lines.edges = word == "sharp" ? Edges::kSharp : Edges::kAll; },
         "edges over the surface: all of the file's faces, or sharp and open ones")
      ->check(one_of({"all", "sharp"}))
      ->type_name("WHICH");
  add_number(app, "--edge-angle", "DEG", "sharp edges: those where faces meet at more than this [40]",
             lines.edge_angle, 0, 180);
  app.add_flag_callback(
      "--wireframe", [&lines] { lines.style = LineOptions::kWireframe; }, "edges only, not the surface");
  app.add_flag_callback(
      "--points", [&lines] { lines.style = LineOptions::kPoints; }, "vertices only, as points");
  app.add_flag("--hidden-lines", lines.hidden, "show lines and points that the surface hides, too");
  add_number(app, "--line-width", "PIXELS", "width of lines [1.5]", lines.width, 0.1, 64);
  add_number(app, "--point-size", "PIXELS", "size of points [4]", lines.point_size, 0.1, 64);
  add_parsed(app, "--line-color,--line-colour", "COLOR", "color of edges and points [dark or light]",
             [&lines](const std::string& text) {
               parse_color(text);
               lines.color = parse_reflectance(text);
             });
  app.add_flag("--ground", options.render.ground, "a soft shadow on the ground that the model stands on");
  app.add_flag("--srgb", options.render.srgb,
               "light in linear numbers: sRGB colors are decoded, the picture encoded");
}

void add_camera_place(CLI::App& app, ProgramOptions& options) {
  add_parsed(app, "--eye,--camera-position", "X,Y,Z", "place of the camera in the model's coordinates",
             [&options](const std::string& text) { options.place.eye = parse_triple(text); });
  add_parsed(app, "--target,--camera-focal-point", "X,Y,Z", "where it looks to [the model's middle]",
             [&options](const std::string& text) { options.place.target = parse_triple(text); });
  add_parsed(app, "--view-up,--camera-view-up", "X,Y,Z", "its up direction [the model's]",
             [&options](const std::string& text) { options.place.view_up = parse_triple(text); });
  app.add_option("--camera", options.place.file, "take the camera from this JSON file")->type_name("FILE");
  app.add_option("--write-camera", options.place.output, "write the picture's camera to this JSON file")
      ->type_name("FILE");
}

std::string complete_look(ProgramOptions& options) {
  const CameraPlaceOptions& place = options.place;
  LineOptions& lines = options.render.lines;
  if (lines.edge_angle && lines.edges == Edges::kAll) return "--edge-angle is for sharp edges";
  if (lines.edge_angle) lines.edges = Edges::kSharp;
  if (lines.style == LineOptions::kWireframe && lines.edges == Edges::kNone) lines.edges = Edges::kAll;
  const bool placed = place.eye || !place.file.empty();
  if (place.eye && !place.file.empty()) return "--eye and --camera are two places of one camera";
  if (!place.eye && (place.target || place.view_up)) return "--target and --view-up need --eye";
  if (placed && (options.views.size() > 1 || options.turntable))
    return "a camera with a place has one view, and no turntable";
  if (!place.output.empty() && (options.views.size() > 1 || options.turntable || options.models.size() > 1))
    return "--write-camera is for one picture";
  if (place.eye) {
    CameraPlacement placement;
    placement.eye = *place.eye;
    placement.target = place.target;
    placement.up = place.view_up;
    options.views.front().camera.placement = placement;
  }
  return {};
}

} // namespace softgl::cli
