// The command line.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "image/image_writer.h"
#include "mesh/normal_generator.h"
#include "scene/camera.h"
#include "scene/renderer.h"

namespace softgl::cli {

// What replaces the reflectances of all materials.
struct MaterialOptions {
  using Reflectance = std::optional<std::array<float, 3>>;
  Reflectance color; // ambient and diffuse, and no textures
  Reflectance ambient, diffuse, specular;
  std::optional<float> shininess;
};

struct ProgramOptions {
  enum Command { kRender, kInfo, kFigure } command = kRender;
  std::string model; // empty for kFigure: a sphere
  std::string output;
  std::string format;
  PngEffort png = PngEffort::kDefault;
  CameraOptions camera;
  RenderOptions render;
  NormalOptions normals;
  MaterialOptions materials;
  unsigned threads = 0; // 0: as many as the machine has
  bool quiet = false, verbose = false, strict = false;
  bool json = false; // info --json
  bool stats = false;
};

// What main() is to do: options, or an end with that exit code (help, version, or a mistake already
// reported).
struct ParsedOptions {
  std::optional<ProgramOptions> options;
  int exit_code = 0;
};

ParsedOptions parse_options(int argc, const char* const* argv);

} // namespace softgl::cli
