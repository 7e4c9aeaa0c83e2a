#include "obj/model_assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/program_error.h"

namespace softgl::cli {

ModelAssembly::ModelAssembly(RemarkList& remarks, bool has_texcoords, bool has_normals)
    : remarks_(remarks), has_texcoords_(has_texcoords), has_normals_(has_normals) {}

void ModelAssembly::add_vertex(const double* xyz) {
  double* out = model_.positions.extend(3);
  const bool finite = std::fabs(xyz[0]) <= 1e100 && std::fabs(xyz[1]) <= 1e100 && std::fabs(xyz[2]) <= 1e100;
  for (int i = 0; i < 3; ++i) out[i] = finite ? xyz[i] : std::numeric_limits<double>::quiet_NaN();
  if (!finite)
    remarks_.add("vertex that is not a finite place", nullptr,
                 "a vertex is not a finite place; faces that use it are skipped");
}

void ModelAssembly::add_texcoord(float u, float v) {
  float* out = model_.texcoords.extend(2);
  out[0] = std::isfinite(u) ? u : 0;
  out[1] = std::isfinite(v) ? v : 0;
}

void ModelAssembly::add_normal(const float* xyz) {
  const bool good = std::isfinite(xyz[0] + xyz[1] + xyz[2]) && (xyz[0] != 0 || xyz[1] != 0 || xyz[2] != 0);
  for (int i = 0; i < 3; ++i) model_.normals.append(good ? xyz[i] : 0);
}

void ModelAssembly::add_color(const float* rgb) {
  for (int i = 0; i < 3; ++i)
    model_.colors.append(std::isfinite(rgb[i]) ? std::clamp(rgb[i], 0.0f, 1.0f) : 1.0f);
}

bool ModelAssembly::usable(int64_t vertex) const {
  return vertex >= 0 && uint64_t(vertex) < vertex_count() &&
         !std::isnan(model_.positions[3 * size_t(vertex)]);
}

void ModelAssembly::add_face(const int64_t* vertices, size_t count) {
  if (count < 3) {
    remarks_.add("face with fewer than three corners skipped", nullptr,
                 "a face needs three corners; skipped");
    return;
  }
  if (!std::all_of(vertices, vertices + count, [this](int64_t vertex) { return usable(vertex); })) {
    remarks_.add("face skipped: a vertex does not exist or is not finite", nullptr,
                 "a face names a vertex that does not exist or is not finite (the file has " +
                     std::to_string(vertex_count()) + "); skipped");
    return;
  }
  if (count != 3 && chunk_.face_sizes.empty()) chunk_.face_sizes.fill(chunk_.face_count, 3);
  if (count != 3 || !chunk_.face_sizes.empty()) chunk_.face_sizes.append(uint32_t(count));
  ++chunk_.face_count;
  for (size_t i = 0; i < count; ++i) {
    const auto vertex = int32_t(vertices[i]);
    chunk_.corner_vertices.values.append(vertex);
    if (!has_texcoords_ && !has_normals_) continue;
    chunk_.corner_texcoords.values.append(has_texcoords_ ? vertex : kAbsent);
    const float* n = has_normals_ ? &model_.normals[3 * size_t(vertex)] : nullptr;
    chunk_.corner_normals.values.append(n && (n[0] != 0 || n[1] != 0 || n[2] != 0) ? vertex : kAbsent);
  }
}

ObjModel ModelAssembly::take(const SourceText& text) {
  if (vertex_count() >= 0x7ffffff0 || chunk_.corner_vertices.values.size() >= 0x7ffffff0)
    throw ProgramError(kCannotRead, text.name() + ": more than two thousand million vertices or corners");
  model_.position_count = vertex_count();
  model_.texcoord_count = model_.texcoords.size() / 2;
  model_.normal_count = model_.normals.size() / 3;
  model_.face_count = chunk_.face_count;
  chunk_.begin = chunk_.end = text.end();
  model_.chunks.push_back(std::move(chunk_));
  return std::move(model_);
}

} // namespace softgl::cli
