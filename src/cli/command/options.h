// The command line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "command/command_table.h"
#include "command/compare.h"
#include "command/model_loader.h"
#include "figure/language.h"
#include "image/image_writer.h"
#include "jobs/shard.h"
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

// What the run may use, for models of unknown origin. 0: no limit.
struct RunLimits {
  LoadLimits load;
  uint64_t input_bytes = 0; // but for pipes, see SourceText
  uint64_t memory_bytes = 0;
  int picture_side = 0;
  double seconds = 0;
  bool sandbox = false;
};

struct NamedView {
  std::string name;
  CameraOptions camera;
};

struct CameraPlaceOptions {
  std::optional<std::array<double, 3>> eye, target, view_up;
  std::string file, output; // JSON
};

struct FigureOptions {
  std::vector<std::string> words; // of the command line: names of figures and a model
  std::vector<std::string> names; // of figures, in order; none: the sheet
  Language language = language_of_environment();
  bool list = false;   // instead of drawing
  bool folder = false; // the output is one
};

struct BatchOptions {
  std::optional<Shard> shard;
  bool resume = false;
  std::string report; // empty: standard output
};

struct ProgramOptions {
  enum Command { kRender, kInfo, kFigure, kCompare, kView, kBatch } command = kRender;
  std::vector<std::string> models; // and folders of models, and lists for kBatch; none for kFigure: a sphere
  std::string output;
  std::string format; // of pictures; of figures also svg and html
  int bits = 8;       // of a PNG's channel
  PngEffort png = PngEffort::kDefault;
  std::vector<NamedView> views; // at least one
  CameraPlaceOptions place;
  std::vector<Pass> passes = {Pass::kColor};
  int turntable = 0; // pictures of a turn around the model; 0: no turn
  int frames_per_second = 25;
  int sheet_columns = 0, sheet_rows = 0; // no columns: no sheet; no rows: as many as it takes
  bool recursive = false, skip_existing = false, keep_going = false;
  RenderOptions render;
  NormalOptions normals;
  MaterialOptions materials;
  RunLimits limits;
  unsigned threads = 0; // 0: as many as the machine has
  bool quiet = false, verbose = false, strict = false;
  bool json = false; // info --json
  bool stats = false;
  CompareOptions compare;
  FigureOptions figure;
  std::string script; // of kView
  BatchOptions batch;
};

// An option as the command line has it, by its first long name; a flag has no values.
struct GivenOption {
  std::string name;
  std::vector<std::string> values;
};

// What main() is to do: options, or an end with that exit code (help, version, or a mistake already
// reported).
struct ParsedOptions {
  std::optional<ProgramOptions> options;
  int exit_code = 0;
  std::vector<GivenOption> given = {}; // with `options`, those of a picture, without the models
};

ParsedOptions parse_options(int argc, const char* const* argv);

// The options of one picture, for which there is a command line without the program's name. Of an option that
// comes twice the last counts, but for --light. Throws ProgramError (kUsageError).
ProgramOptions parse_picture(const std::vector<std::string>& words);

// What parse_options() takes.
CommandRow describe_command_line();

} // namespace softgl::cli
