// What the program says about a model: `softgl info` and --stats.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "common/warnings.h"
#include "mesh/model_frame.h"
#include "mesh/surface_report.h"
#include "obj/material_library.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

struct ModelReport {
  std::string name;
  const char* format = "OBJ"; // or PLY, STL
  uint64_t bytes = 0;
  uint64_t positions = 0, texcoords = 0, normals = 0;
  uint64_t faces = 0, triangles = 0, segments = 0, points = 0;
  uint64_t objects = 0, groups = 0, materials = 0, textures = 0;
  bool vertex_colors = false, smoothing_groups = false;
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  double area = 0;
  std::optional<SurfaceReport> surface;    // `softgl info` only
  std::vector<std::string> material_names; // of its parts
};

struct RunTimes {
  double read = 0, prepare = 0, upload = 0, draw = 0, average = 0, write = 0, total = 0; // seconds
};

// A part of the run for --stats.
struct Stage {
  const char* name;
  double seconds;
};

// Members of a JSON object: the stages and the processor's time in milliseconds, and the most memory so far.
std::string usage_as_json(const std::vector<Stage>& stages);

std::string as_text(const ModelReport& report);
std::string as_json(const ModelReport& report, const Warnings& warnings);
std::string stats_as_json(const ModelReport& report, const RunTimes& times, int width, int height,
                          const Warnings& warnings);

// Throws ProgramError (kCannotWrite).
void print_text(const std::string& text, std::FILE* file);

} // namespace softgl::cli
