#include "command/model_loader.h"

#include <cmath>

#include "common/program_error.h"
#include "mesh/edge_table.h"
#include "mesh/face_triangulation.h"
#include "obj/file_search.h"
#include "obj/ply_reader.h"
#include "obj/stl_reader.h"

namespace softgl::cli {
namespace {

// A file of nothing but vertices is a point cloud.
void draw_vertices_as_points(ObjModel& model) {
  GrowingArray<int32_t>& points = model.chunks.back().point_vertices.values;
  for (size_t i = 0; i < model.position_count; ++i)
    if (!std::isnan(model.positions[3 * i])) points.append(int32_t(i));
  model.point_count = points.size();
}

void refuse_triangles(const ObjModel& model, const std::string& name, uint64_t most) {
  if (most == 0) return;
  uint64_t count = 0;
  for (const ObjChunk& chunk : model.chunks)
    count += chunk.corner_vertices.values.size() - 2 * uint64_t(chunk.face_count);
  if (count > most)
    throw ProgramError(kCannotRead, name + ": about " + std::to_string(count) +
                                        " triangles, more than --max-triangles allows");
}

} // namespace

LoadedModel load_model(const SourceText& text, unsigned threads, RemarkList& remarks, Warnings& warnings,
                       Warnings& notes, const LoadLimits& limits, bool with_edges) {
  LoadedModel loaded;
  loaded.library = MaterialLibrary(limits.strict_materials);
  const bool ply = is_ply(text), stl = !ply && is_stl(text);
  loaded.report.format = ply ? "PLY" : stl ? "STL" : "OBJ";
  loaded.model = ply   ? read_ply(text, remarks)
                 : stl ? read_stl(text, remarks)
                       : read_obj(text, threads, remarks);
  ObjModel& model = loaded.model;
  if (model.face_count + model.segment_count + model.point_count == 0 && model.position_count > 0 &&
      remarks.empty()) {
    draw_vertices_as_points(model);
    remarks.add("no elements", nullptr, "no faces, lines or points; the vertices are drawn as points");
  }
  if (model.face_count == 0 && model.segment_count == 0 && model.point_count == 0) {
    // What stands in a file that is no model is not worth a warning each.
    const std::string sentence = explain_missing_geometry(text);
    if (model.position_count > 0 || model.skips_elements) warnings.add(remarks, text);
    throw ProgramError(kCannotRead, sentence);
  }
  refuse_triangles(model, text.name(), limits.triangles);
  loaded.library.load_for(model, ModelFiles(text.name(), limits.any_path), remarks, warnings, notes);
  ModelReport& report = loaded.report;
  report.name = text.name();
  report.bytes = text.size();
  report.positions = model.position_count;
  report.texcoords = model.texcoord_count;
  report.normals = model.normal_count;
  report.faces = model.face_count;
  report.segments = model.segment_count;
  report.points = model.point_count;
  report.objects = model.object_count;
  report.groups = model.group_count;
  report.materials = loaded.library.materials().size() - 1;
  for (const Material& material : loaded.library.materials())
    report.textures += !material.diffuse_map.file.empty() || !material.opacity_map.file.empty();
  report.vertex_colors = !model.colors.empty();
  report.smoothing_groups = model.has_smoothing_groups;
  if (with_edges) loaded.edges = face_edges(model);
  triangulate_faces(model);
  report.triangles = triangle_count(model);
  return loaded;
}

} // namespace softgl::cli
