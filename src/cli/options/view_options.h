// The options that say from where a picture sees the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

// As they are written. The angles of a named view are where --az and --el count from; without one they count
// from the front.
struct ViewWords {
  CameraOptions camera;
  std::vector<std::string> views;
  std::optional<double> azimuth, elevation;

  void add_to(CLI::App& app);
  // After parsing: the views of `options`, whose picture has its size.
  void complete(ProgramOptions& options);
};

} // namespace softgl::cli
