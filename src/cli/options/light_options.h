// The options of lights, of shading and of what materials reflect.
#pragma once

#include <string>

#include <CLI/App.hpp>

#include "options/program_options.h"

namespace softgl::cli {

// Words, as they are written.
struct LightingWords {
  std::string shading = "gouraud", specular; // specular: empty if it is not given

  void add_shading(CLI::App& app, ProgramOptions& options);
  // After parsing: a sentence about a mistake, or nothing. `figure`: for the lecture on lighting.
  std::string complete(ProgramOptions& options, bool figure) const;
};

void add_lights(CLI::App& app, ProgramOptions& options);
void add_reflectances(CLI::App& app, ProgramOptions& options);

} // namespace softgl::cli
