#include "command/prepared_model.h"

#include <algorithm>

#include "command/model_loader.h"
#include "common/compressed_text.h"
#include "common/elapsed_time.h"
#include "image/srgb.h"
#include "mesh/edge_table.h"
#include "mesh/face_triangulation.h"
#include "scene/up_axis.h"

namespace softgl::cli {
namespace {

void replace(const MaterialOptions::Reflectance& chosen, float* reflectance) {
  if (chosen) std::copy(chosen->begin(), chosen->end(), reflectance);
}

UpAxis guess_up_axis(const PreparedModel& prepared, const SourceText& text, Warnings& warnings,
                     Warnings& notes) {
  const UpEvidence evidence = up_evidence(prepared.mesh, prepared.frame, prepared.materials,
                                          first_lines(text, prepared.report.format));
  notes.add(text.name(), "what speaks for +Z (positive) and +Y: " + as_text(evidence));
  if (!z_is_up(evidence)) return UpAxis::kPlusY;
  warnings.add_notice(text.name(), "turned: its +Z seems to point up (--up +Y draws it as it is)");
  return UpAxis::kPlusZ;
}

void add_edges(const LineOptions& lines, const GrowingArray<uint32_t>& ends, PreparedModel& prepared) {
  if (lines.edges == Edges::kSharp)
    prepared.mesh.edge_positions = sharp_edges(prepared.mesh, lines.edge_angle.value_or(kDefaultCreaseAngle));
  for (size_t i = 0; lines.edges == Edges::kAll && i < ends.size(); ++i)
    prepared.mesh.edge_positions.append(&prepared.frame.positions[3 * size_t(ends[i])], 3);
}

// From stored values to light.
void decode_colors(Mesh& mesh, std::vector<Material>& materials) {
  for (Material& material : materials)
    for (float* color : {material.ambient, material.diffuse, material.specular, material.emission})
      for (size_t i = 0; i < 3; ++i) color[i] = from_srgb(color[i]);
  for (GrowingArray<float>* colors : {&mesh.colors, &mesh.segment_colors, &mesh.point_colors})
    for (size_t i = 0; i < colors->size(); ++i)
      if (i % 4 < 3) (*colors)[i] = from_srgb((*colors)[i]); // alpha is none
}

} // namespace

std::string_view first_lines(const SourceText& text, std::string_view format) {
  return format == "STL" ? "# STL" : std::string_view(text.begin(), std::min<size_t>(text.size(), 4096));
}

void paint_over(const MaterialOptions& chosen, LoadedModel& loaded) {
  if (chosen.color || chosen.ambient || chosen.diffuse) loaded.model.colors.release();
  if (chosen.color)
    for (Material& material : loaded.library.materials()) {
      replace(chosen.color, material.ambient);
      replace(chosen.color, material.diffuse);
      for (float& value : material.emission) value = 0;
      material.diffuse_map = {};
      material.opacity_map = {};
      material.opacity = 1;
    }
  override_reflectances(chosen, loaded.library.materials());
}

MeshOptions mesh_options_for(const ProgramOptions& options, const ModelReport& report) {
  MeshOptions mesh;
  mesh.flat = options.render.lighting.shading == Shading::kFlat;
  const bool uv = std::find(options.passes.begin(), options.passes.end(), Pass::kUv) != options.passes.end();
  mesh.with_texcoords = uv || (report.textures > 0 && !options.materials.color);
  return mesh;
}

void override_reflectances(const MaterialOptions& chosen, std::vector<Material>& materials) {
  for (Material& material : materials) {
    replace(chosen.ambient, material.ambient);
    replace(chosen.diffuse, material.diffuse);
    replace(chosen.specular, material.specular);
    material.shininess = chosen.shininess.value_or(material.shininess);
  }
}

void note_bounds(const ModelFrame& frame, ModelReport& report) {
  for (int axis = 0; axis < 3; ++axis) {
    report.low[axis] = frame.low[axis];
    report.high[axis] = frame.high[axis];
  }
}

ReadModel read_model(const std::string& path, const ProgramOptions& options, unsigned threads,
                     Warnings& warnings, Warnings& notes) {
  ReadModel read{open_text(path, options.limits.input_bytes), RemarkList(), LoadedModel(), path};
  read.loaded = load_model(read.text, threads, read.remarks, warnings, notes, options.limits.load,
                           options.render.lines.edges == Edges::kAll);
  return read;
}

PreparedModel prepare_model(ReadModel& read, const ModelBounds& bounds, const ProgramOptions& options,
                            Warnings& warnings) {
  LoadedModel& loaded = read.loaded;
  ObjModel& model = loaded.model;
  paint_over(options.materials, loaded);
  const MeshOptions mesh_options = mesh_options_for(options, loaded.report);
  PreparedModel prepared;
  prepared.name = read.text.name();
  prepared.frame = frame_model(model, bounds);
  note_bounds(prepared.frame, loaded.report);
  if (options.verbose) loaded.report.area = surface_area(model);
  if (!mesh_options.flat) generate_normals(model, prepared.frame, options.normals);
  prepared.mesh = build_mesh(model, prepared.frame, loaded.library, mesh_options, read.remarks);
  warnings.add(read.remarks, read.text);
  prepared.up = options.views.front().camera.up;
  prepared.report = std::move(loaded.report);
  prepared.files = loaded.library.files();
  prepared.files.push_back(read.path);
  prepared.materials = std::move(loaded.library.materials());
  return prepared;
}

PreparedModel prepare_model(const std::string& path, const ProgramOptions& options, unsigned threads,
                            Warnings& warnings, Warnings& notes, RunTimes& times) {
  const auto start = Clock::now();
  ReadModel read = read_model(path, options, threads, warnings, notes);
  times.read += seconds_since(start);
  const auto prepare_start = Clock::now();
  PreparedModel prepared = prepare_model(read, bounds_of(read.loaded.model), options, warnings);
  if (prepared.up == UpAxis::kAuto) prepared.up = guess_up_axis(prepared, read.text, warnings, notes);
  notes.add(prepared.name, std::string("up is ") + name_of(prepared.up));
  add_edges(options.render.lines, read.loaded.edges, prepared);
  if (options.render.srgb) decode_colors(prepared.mesh, prepared.materials);
  prepared.frame.positions.release(); // the mesh has its own
  times.prepare += seconds_since(prepare_start);
  return prepared;
}

} // namespace softgl::cli
