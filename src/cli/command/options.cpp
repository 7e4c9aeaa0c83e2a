#include "command/options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/option_values.h"
#include "scene/lighting_setup.h"

#ifndef SOFTGL_VERSION
#define SOFTGL_VERSION "unknown"
#endif

namespace softgl::cli {
namespace {

constexpr int kFigurePart = 400; // pixels: the sheet is then 2072 wide

constexpr const char* kFooter = R"(
Examples:
  softgl teapot.obj -o teapot.png
  softgl part.obj -o part.png --up +Z --view front --size 1920x1080 --aa 4
  softgl bust.obj -o - --bg transparent --color '#d8c8b0' > bust.png
  curl -s https://example.org/model.obj | softgl - -o model.ppm
  softgl info part.obj --json

Exit codes: 0 done, 2 wrong usage, 3 model unreadable or without visible geometry (and any warning with --strict),
4 picture cannot be written.
Environment: SOFTGL_THREADS=n (as --threads), SOFTGL_ISA=baseline|v2|v3|v4 (instruction set of the kernels).)";

// Runs a parser of option_values as a CLI11 check, so that its sentence names the option.
template <class Parse> auto checked(Parse parse) {
  return [parse](const auto& text) {
    try {
      parse(text);
      return true;
    } catch (const std::invalid_argument& mistake) { throw CLI::ValidationError(mistake.what()); }
  };
}

CLI::Validator range(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& text) -> std::string {
        double value;
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
        char sentence[128];
        std::snprintf(sentence, sizeof sentence, "must be a number from %g to %g", low, high);
        return sentence;
      },
      "");
}

template <class Use> void add_reflectance(CLI::App& app, const char* name, const char* description, Use use) {
  app.add_option_function<std::string>(
         name, checked([use](const std::string& text) { use(parse_reflectance(text)); }), description)
      ->type_name("K");
}

} // namespace

ParsedOptions parse_options(int argc, const char* const* argv) {
  ProgramOptions options;
  CLI::App app("softgl draws OBJ models with the OpenGL fixed-function pipeline, on the CPU.", "softgl");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("softgl ") + SOFTGL_VERSION);
  app.get_formatter()->column_width(26);
  app.option_defaults()->always_capture_default(false);

  app.add_option("model", options.model, "OBJ file; - for standard input")->type_name("MODEL.obj");
  app.add_option("-o,--output", options.output,
                 "picture to write (.png .ppm .pam .jpg .bmp .tga); - for standard output")
      ->type_name("FILE");
  app.add_option("--format", options.format, "picture format where the file name does not say it")
      ->type_name("png|ppm|..");
  std::string png = "default";
  app.add_option("--png", png, "effort for PNG files: fast, default or small")
      ->check(CLI::IsMember({"fast", "default", "small"}))
      ->type_name("HOW");
  app.add_option_function<std::string>("-s,--size", checked([&](const std::string& t) {
                                         parse_size(t, options.render.width, options.render.height);
                                       }),
                                       "size of the picture [1024x1024]")
      ->type_name("WxH");

  std::string view;
  double azimuth = NAN, elevation = NAN;
  app.add_option("--view", view, "iso (three-quarter view), front, back, left, right, top or bottom [iso]")
      ->check(CLI::IsMember({"iso", "front", "back", "left", "right", "top", "bottom"}))
      ->type_name("NAME");
  app.add_option("--az", azimuth, "degrees to the right of the named view, else of the front [35]")
      ->check(range(-1e6, 1e6))
      ->type_name("DEG");
  app.add_option("--el", elevation, "degrees above the named view, else above the horizon [25]")
      ->check(range(-1e6, 1e6))
      ->type_name("DEG");
  app.add_option("--roll", options.camera.roll, "degrees the camera is turned clockwise [0]")
      ->check(range(-1e6, 1e6))
      ->type_name("DEG");
  app.add_option("--zoom", options.camera.zoom, "magnification after fitting [1]")
      ->check(range(1e-3, 1e3))
      ->type_name("FACTOR");
  app.add_option("--fov", options.camera.field_of_view, "vertical field of view in degrees [30]")
      ->check(range(1, 150))
      ->type_name("DEG");
  app.add_flag("--ortho", options.camera.orthographic, "parallel projection");
  app.add_option_function<std::string>(
         "--up", checked([&](const std::string& t) { options.camera.up = parse_up_axis(t); }),
         "axis of the model that points up: +Y, +Z, -X ... or auto [+Y]")
      ->type_name("AXIS");

  LightingOptions& lighting = options.render.lighting;
  std::string shading = "gouraud", specular = "half";
  app.add_option("--shading", shading, "flat, gouraud (lit per vertex) or phong (lit per pixel) [gouraud]")
      ->check(CLI::IsMember({"flat", "gouraud", "phong"}))
      ->type_name("HOW");
  app.add_option("--specular", specular,
                 "vector of the specular term: half (n.h)^ns or reflection (v.r)^ns [half]")
      ->check(CLI::IsMember({"half", "reflection"}))
      ->type_name("VECTOR");
  app.add_option_function<std::string>(
         "--terms", checked([&](const std::string& t) { lighting.terms = parse_terms(t); }),
         "terms of the light that are drawn: ambient,diffuse,specular,emission [all]")
      ->type_name("LIST");
  app.add_option_function<double>(
         "--crease",
         [&](double angle) {
           options.normals.crease_angle = angle;
           options.normals.ignore_groups = true;
         },
         "generated normals: smooth up to this angle between faces, whatever the smoothing groups [40 where "
         "there are none]")
      ->check(range(0, 180))
      ->type_name("DEG");
  app.add_option_function<std::vector<std::string>>(
         "--light",
         [&](const std::vector<std::string>& all) {
           checked([&](const std::vector<std::string>& texts) {
             for (const std::string& text : texts) lighting.lights.push_back(parse_light(text));
           })(all);
         },
         "key, headlight, x,y,z (direction as seen), model:x,y,z or +Y (direction in the model's axes), "
         "at:x,y,z (place in "
         "the model); then /color:COLOR, and for a place "
         "/spot:x,y,z/cutoff:DEG/exponent:N/attenuation:C,L,Q; may be "
         "repeated [key]")
      ->allow_extra_args(false)
      ->type_name("LIGHT");
  add_reflectance(app, "--ambient-light",
                  "light that comes from everywhere: a number, r,g,b or a color [0.2]",
                  [&](const auto& rgb) { std::copy(rgb.begin(), rgb.end(), lighting.ambient); });
  add_reflectance(app, "--ka", "ambient reflectance of all materials",
                  [&](const auto& rgb) { options.materials.ambient = rgb; });
  add_reflectance(app, "--kd", "diffuse reflectance of all materials",
                  [&](const auto& rgb) { options.materials.diffuse = rgb; });
  add_reflectance(app, "--ks", "specular reflectance of all materials",
                  [&](const auto& rgb) { options.materials.specular = rgb; });
  app.add_option("--ns", options.materials.shininess, "specular exponent of all materials, 0 to 128")
      ->check(range(0, 128))
      ->type_name("N");
  app.add_option_function<std::string>(
         "--bg", checked([&](const std::string& t) { options.render.background = parse_background(t); }),
         "background: #rrggbb, name, r,g,b from 0 to 1, or transparent [#2e333a]")
      ->type_name("COLOR");
  app.add_option_function<std::string>("--color,--colour", checked([&](const std::string& t) {
                                         parse_color(t); // three numbers or a name; one number is no color
                                         options.materials.color = parse_reflectance(t);
                                       }),
                                       "one color for the whole model instead of its materials")
      ->type_name("COLOR");
  int samples = 1;
  app.add_option("--aa", samples, "samples per pixel: 1, 4 or 16 [1]")
      ->check(CLI::IsMember({1, 4, 16}))
      ->type_name("N");

  app.add_option("--threads", options.threads, "threads [as many as the machine has]")
      ->check(range(1, 1024))
      ->type_name("N");
  std::string stats;
  app.add_option("--stats", stats,
                 "print times and counts: json (to standard error if the picture goes to standard output)")
      ->check(CLI::IsMember({"json"}))
      ->type_name("json");
  app.add_flag("--strict", options.strict, "a warning ends the run with exit code 3");
  app.add_flag("-q,--quiet", options.quiet, "no warnings");
  app.add_flag("-v,--verbose", options.verbose, "more about the model and what is left out");

  CLI::App* info = app.add_subcommand("info", "describe a model instead of drawing it");
  info->add_option("model", options.model, "OBJ file; - for standard input")
      ->required()
      ->type_name("MODEL.obj");
  info->add_flag("--json", options.json, "as JSON");
  info->add_flag("--strict", options.strict, "a warning ends the run with exit code 3");
  info->add_flag("-q,--quiet", options.quiet, "no warnings");
  info->add_flag("-v,--verbose", options.verbose, "more about what is left out");
  info->add_option("--threads", options.threads, "threads")->check(range(1, 1024))->type_name("N");

  CLI::App* figure = app.add_subcommand(
      "figure", "draw the terms of the light, exponents, Gouraud and Phong shading and both "
                "specular vectors side by side, on one labelled sheet; takes the options "
                "of a picture, --size being that of each part [400x400]");
  figure->add_option("model", options.model, "OBJ file; without one a sphere")->type_name("MODEL.obj");
  figure->fallthrough();

  const auto usage = [](const std::string& sentence) {
    std::fprintf(stderr, "softgl: %s (softgl --help shows the options)\n", sentence.c_str());
    return ParsedOptions{std::nullopt, 2};
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return {std::nullopt, app.exit(help)};
  } catch (const CLI::CallForVersion& version) {
    return {std::nullopt, app.exit(version)};
  } catch (const CLI::Error& mistake) {
    std::string sentence = mistake.what();
    for (char& c : sentence) c = c == '\n' ? ' ' : c;
    return usage(sentence);
  }

  if (*info) {
    options.command = ProgramOptions::kInfo;
    return {options, 0};
  }
  if (*figure) {
    options.command = ProgramOptions::kFigure;
    if (options.render.background.transparent) return usage("a figure has no transparent background");
    if (!app.count("--size")) options.render.width = options.render.height = kFigurePart;
    if (options.camera.up == UpAxis::kAuto && options.model.empty()) options.camera.up = UpAxis::kPlusY;
  }
  if (options.model.empty() && !*figure) return usage("no model given");
  if (options.output.empty()) return usage("no output file given; -o PICTURE.png names one");
  if (options.format.empty()) options.format = image_format_of(options.output);
  if (options.format.empty()) {
    if (options.output != "-")
      return usage("cannot tell the picture format of \"" + options.output +
                   "\"; known are png, ppm, pam, jpg, bmp and tga");
    options.format = "png";
  }
  if (!is_image_format(options.format)) return usage("unknown picture format \"" + options.format + "\"");
  if (*figure && (options.render.width > 2048 || options.render.height > 2048))
    return usage("a figure's parts are at most 2048 pixels wide and high");
  options.png = png == "fast" ? PngEffort::kFast : png == "small" ? PngEffort::kSmall : PngEffort::kDefault;
  lighting.shading = shading == "flat" && !*figure ? Shading::kFlat
                     : shading == "phong"          ? Shading::kPhong
                                                   : Shading::kGouraud;
  lighting.reflection_vector = specular == "reflection";
  if (gl_lights_of(lighting) > kMostLights)
    return usage("--light: GL has 8 lights, and the key light takes two of them");
  options.render.samples_per_side = samples == 16 ? 4 : samples == 4 ? 2 : 1;
  const int side = options.render.samples_per_side;
  if (options.render.width * side > 16384 || options.render.height * side > 16384)
    return usage("--aa " + std::to_string(samples) + " allows pictures of up to " +
                 std::to_string(16384 / side) + " pixels a side");
  options.camera.width = options.render.width;
  options.camera.height = options.render.height;
  options.stats = !stats.empty();

  // The angles of a named view are where --az and --el count from; without one they count from the front.
  if (!view.empty()) {
    named_view(view, options.camera.azimuth, options.camera.elevation);
    if (!std::isnan(azimuth)) options.camera.azimuth += azimuth;
    if (!std::isnan(elevation)) options.camera.elevation += elevation;
  } else {
    if (!std::isnan(azimuth)) options.camera.azimuth = azimuth;
    if (!std::isnan(elevation)) options.camera.elevation = elevation;
  }
  return {options, 0};
}

} // namespace softgl::cli
