#include "command/report.h"

#include <cstdio>
#include <ctime>
#include <sys/resource.h>

#include "common/json_text.h"
#include "common/program_error.h"

namespace softgl::cli {
namespace {

std::string triple(const double* values) {
  return "[" + json_number(values[0]) + ", " + json_number(values[1]) + ", " + json_number(values[2]) + "]";
}

std::string counts(const ModelReport& r) {
  const auto item = [](const char* name, uint64_t value) {
    return "  \"" + std::string(name) + "\": " + std::to_string(value) + ",\n";
  };
  return "  \"file\": " + json_string(r.name) + ",\n" + item("bytes", r.bytes) +
         item("vertices", r.positions) + item("texture_coordinates", r.texcoords) +
         item("normals", r.normals) + item("faces", r.faces) + item("triangles", r.triangles) +
         item("line_segments", r.segments) + item("points", r.points) + item("objects", r.objects) +
         item("groups", r.groups) + item("materials", r.materials) + item("textures", r.textures);
}

std::string warning_list(const Warnings& warnings) {
  std::string text = "  \"warning_count\": " + std::to_string(warnings.count()) + ",\n  \"warnings\": [";
  const char* separator = "\n    ";
  for (const std::string& sentence : warnings.sentences()) {
    text += separator + json_string(sentence);
    separator = ",\n    ";
  }
  return text + (warnings.sentences().empty() ? "]" : "\n  ]");
}

std::string surface_as_text(const ModelReport& r) {
  const SurfaceReport& s = *r.surface;
  std::string text = "  " + std::to_string(s.edges) + " edges, " + std::to_string(s.open_edges) + " open, " +
                     std::to_string(s.crowded_edges) + " of more than two triangles; " +
                     (s.open_edges || s.crowded_edges ? "not closed" : "volume " + json_number(s.volume)) +
                     "\n";
  for (size_t i = 0; i < s.parts.size(); ++i)
    text += "  " + r.material_names[i] + ": " + std::to_string(s.parts[i].triangles) + " triangles, area " +
            json_number(s.parts[i].area) + "\n";
  return text;
}

// The volume is null where the surface encloses none.
std::string surface_as_json(const ModelReport& r) {
  if (!r.surface) return {};
  const SurfaceReport& s = *r.surface;
  const bool closed = s.edges > 0 && s.open_edges == 0 && s.crowded_edges == 0;
  std::string text = "  \"volume\": " + (closed ? json_number(s.volume) : "null") +
                     ",\n  \"edges\": " + std::to_string(s.edges) +
                     ",\n  \"open_edges\": " + std::to_string(s.open_edges) +
                     ",\n  \"crowded_edges\": " + std::to_string(s.crowded_edges) + ",\n  \"parts\": [";
  for (size_t i = 0; i < s.parts.size(); ++i)
    text += std::string(i ? "," : "") + "\n    {\"material\": " + json_string(r.material_names[i]) +
            ", \"triangles\": " + std::to_string(s.parts[i].triangles) +
            ", \"area\": " + json_number(s.parts[i].area) + "}";
  return text + (s.parts.empty() ? "],\n" : "\n  ],\n");
}

} // namespace

std::string as_text(const ModelReport& r) {
  std::string text = r.name + ": " + std::to_string(r.triangles) + " triangles from " +
                     std::to_string(r.faces) + " faces, " + std::to_string(r.positions) + " vertices";
  const auto add = [&text](uint64_t count, const char* what) {
    if (count) text += ", " + std::to_string(count) + " " + what;
  };
  add(r.segments, "line segments");
  add(r.points, "points");
  add(r.texcoords, "texture coordinates");
  add(r.normals, "normals");
  add(r.objects, "objects");
  add(r.materials, "materials");
  add(r.textures, "textures");
  if (r.vertex_colors) text += ", vertex colors";
  if (r.smoothing_groups) text += ", smoothing groups";
  text += "\n  from " + triple(r.low) + " to " + triple(r.high) + ", area " + json_number(r.area) + "\n";
  return r.surface ? text + surface_as_text(r) : text;
}

std::string as_json(const ModelReport& r, const Warnings& warnings) {
  return "{\n" + counts(r) + "  \"vertex_colors\": " + (r.vertex_colors ? "true" : "false") +
         ",\n  \"smoothing_groups\": " + (r.smoothing_groups ? "true" : "false") +
         ",\n  \"low\": " + triple(r.low) + ",\n  \"high\": " + triple(r.high) +
         ",\n  \"area\": " + json_number(r.area) + ",\n" + surface_as_json(r) + warning_list(warnings) +
         "\n}\n";
}

std::string stats_as_json(const ModelReport& r, const RunTimes& t, int width, int height,
                          const Warnings& warnings) {
  return "{\n" + counts(r) + "  \"width\": " + std::to_string(width) +
         ",\n  \"height\": " + std::to_string(height) + ",\n" +
         usage_as_json({{"read", t.read},
                        {"prepare", t.prepare},
                        {"upload", t.upload},
                        {"draw", t.draw},
                        {"resolve", t.average},
                        {"write", t.write},
                        {"total", t.total}}) +
         ",\n" + warning_list(warnings) + "\n}\n";
}

std::string usage_as_json(const std::vector<Stage>& stages) {
  std::string text = "  \"milliseconds\": {\n";
  const auto add = [&text](const char* name, double seconds, const char* end) {
    char line[80];
    std::snprintf(line, sizeof line, "    \"%s\": %.3f%s\n", name, seconds * 1000, end);
    text += line;
  };
  for (const Stage& stage : stages) add(stage.name, stage.seconds, ",");
  add("cpu", double(std::clock()) / CLOCKS_PER_SEC, "");
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return text + "  },\n  \"peak_kib\": " + std::to_string(usage.ru_maxrss);
}

void print_text(const std::string& text, std::FILE* file) {
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0)
    throw ProgramError(kCannotWrite, "standard output: cannot write");
}

} // namespace softgl::cli
