// What the command line says.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "figure/language.h"
#include "image/image_writer.h"
#include "jobs/shard.h"
#include "mesh/normal_generator.h"
#include "options/run_limits.h"
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

struct NamedView {
  std::string name;
  CameraOptions camera;
};

struct CameraPlaceOptions {
  std::optional<std::array<double, 3>> eye, target, view_up;
  std::string file, output; // JSON
};

// `softgl compare`.
struct CompareOptions {
  std::string first, second;
  std::string difference; // picture, or folder of pictures; empty: none
  std::string sheet;      // both and their difference side by side; a folder for folders
  std::string mask;
  std::string junit;
  std::array<float, 4> tolerance = {0, 0, 0, 0};
  bool ignore_edges = false;
  double most_pixels = 0;                 // that may differ
  bool most_pixels_is_percentage = false; // of those compared
  std::optional<double> least_similarity; // decides instead of differing pixels
  bool json = false, quiet = false;
  bool stats = false; // times to standard error
  unsigned threads = 1;
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

} // namespace softgl::cli
