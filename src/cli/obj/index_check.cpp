#include "obj/index_check.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace softgl::cli {
namespace {

class IndexChecker {
public:
  IndexChecker(ObjModel& model, const ElementCounts& of_file, RemarkList& remarks)
      : model_(model), of_file_(of_file), remarks_(remarks) {
    for (const ObjChunk& chunk : model.chunks) has_unusable_position_ |= chunk.has_unusable_position;
  }

  void check(ObjChunk& chunk) {
    check_attribute(chunk, chunk.corner_texcoords.values, model_.texcoord_count, of_file_.texcoords,
                    "texture coordinate", "texture coordinate that does not exist: left out", "left out");
    check_attribute(chunk, chunk.corner_normals.values, model_.normal_count, of_file_.normals, "normal",
                    "normal that does not exist: generated", "generated");
    forget_zero_normals(chunk);
    if (!all_usable(chunk.corner_vertices.values)) drop_faces(chunk);
    if (!all_usable(chunk.line_vertices.values)) drop_elements(chunk, chunk.line_vertices.values, 2);
    if (!all_usable(chunk.point_vertices.values)) drop_elements(chunk, chunk.point_vertices.values, 1);
  }

private:
  bool usable(int32_t vertex) const {
    return uint32_t(vertex) < model_.position_count &&
           !(has_unusable_position_ && std::isnan(model_.positions[3 * size_t(vertex)]));
  }

  bool all_usable(const GrowingArray<int32_t>& vertices) const {
    const auto count = uint32_t(model_.position_count);
    uint32_t outside = 0;
    for (const int32_t vertex : vertices) outside |= uint32_t(vertex) >= count;
    if (outside) return false;
    if (has_unusable_position_)
      for (const int32_t vertex : vertices)
        if (!usable(vertex)) return false;
    return true;
  }

  // Reading the chunk once more finds the statement of a face; only done for the few remarks that are shown.
  static const char* place_of_face(const ObjChunk& chunk, uint32_t face) {
    ObjChunk again;
    again.begin = chunk.begin;
    again.end = chunk.end;
    return parse_obj_chunk(again, face);
  }

  static uint32_t face_of_corner(const ObjChunk& chunk, size_t corner) {
    if (chunk.face_sizes.empty()) return uint32_t(corner / 3);
    uint32_t face = 0;
    for (size_t first = chunk.face_sizes[0]; first <= corner; first += chunk.face_sizes[++face]) {}
    return face;
  }

  void check_attribute(const ObjChunk& chunk, GrowingArray<int32_t>& indices, uint64_t count,
                       uint64_t of_file, const char* what, const char* kind, const char* consequence) {
    const auto limit = uint32_t(count);
    uint32_t wrong = 0;
    for (const int32_t index : indices) wrong |= (uint32_t(index) >= limit) & (index != kAbsent);
    if (!wrong) return;
    for (size_t corner = 0; corner < indices.size(); ++corner) {
      const int32_t index = indices[corner];
      if (uint32_t(index) < limit || index == kAbsent) continue;
      indices[corner] = kAbsent;
      if (remarks_.count(kind))
        remarks_.describe(kind, place_of_face(chunk, face_of_corner(chunk, corner)),
                          std::string("a corner names a ") + what + " that does not exist (the file has " +
                              std::to_string(of_file) + "); " + consequence);
    }
  }

  void forget_zero_normals(ObjChunk& chunk) {
    for (int32_t& index : chunk.corner_normals.values) {
      if (index == kAbsent) continue;
      const float* n = &model_.normals[3 * size_t(index)];
      if (n[0] == 0 && n[1] == 0 && n[2] == 0) index = kAbsent;
    }
  }

  void remark_face(const ObjChunk& chunk, uint32_t face, const int32_t* corners, uint32_t size) {
    model_.skips_elements = true;
    bool missing = false;
    for (uint32_t i = 0; i < size; ++i) missing |= uint32_t(corners[i]) >= model_.position_count;
    const char* kind =
        missing ? "face skipped: a vertex does not exist" : "face skipped: a vertex is not finite";
    if (!remarks_.count(kind)) return;
    remarks_.describe(kind, place_of_face(chunk, face),
                      missing ? "a corner names a vertex that does not exist (the file has " +
                                    std::to_string(of_file_.positions) + "); face skipped"
                              : "a corner names a vertex that is not a finite place; face skipped");
  }

  void drop_faces(ObjChunk& chunk) {
    GrowingArray<int32_t>* const lists[] = {&chunk.corner_vertices.values, &chunk.corner_texcoords.values,
                                            &chunk.corner_normals.values};
    const uint32_t face_count = chunk.face_count;
    size_t from = 0, to = 0, change = 0;
    uint32_t kept = 0;
    for (uint32_t face = 0; face < face_count; ++face) {
      while (change < chunk.changes.size() && chunk.changes[change].face <= face)
        chunk.changes[change++].face = kept;
      const uint32_t size = chunk.face_sizes.empty() ? 3 : chunk.face_sizes[face];
      const int32_t* corners = chunk.corner_vertices.values.data() + from;
      if (std::all_of(corners, corners + size, [&](int32_t vertex) { return usable(vertex); })) {
        for (GrowingArray<int32_t>* list : lists)
          if (!list->empty()) std::memmove(list->data() + to, list->data() + from, size * sizeof(int32_t));
        if (!chunk.face_sizes.empty()) chunk.face_sizes[kept] = size;
        to += size;
        ++kept;
      } else {
        remark_face(chunk, face, corners, size);
      }
      from += size;
    }
    while (change < chunk.changes.size()) chunk.changes[change++].face = kept;
    for (GrowingArray<int32_t>* list : lists)
      if (!list->empty()) list->truncate(to);
    if (!chunk.face_sizes.empty()) chunk.face_sizes.truncate(kept);
    chunk.face_count = kept;
  }

  void drop_elements(ObjChunk& chunk, GrowingArray<int32_t>& vertices, size_t size) {
    size_t to = 0, change = 0;
    const auto element_of = [&](StateChange& c) -> uint32_t& { return size == 2 ? c.line : c.point; };
    for (size_t from = 0; from < vertices.size(); from += size) {
      while (change < chunk.changes.size() && element_of(chunk.changes[change]) * size <= from)
        element_of(chunk.changes[change++]) = uint32_t(to / size);
      bool good = true;
      for (size_t i = 0; i < size; ++i) good = good && usable(vertices[from + i]);
      if (!good) {
        const char* kind = size == 2 ? "line segment skipped: a vertex does not exist or is not finite"
                                     : "point skipped: its vertex does not exist or is not finite";
        remarks_.add(kind, nullptr, kind);
        model_.skips_elements = true;
        continue;
      }
      for (size_t i = 0; i < size; ++i) vertices[to + i] = vertices[from + i];
      to += size;
    }
    while (change < chunk.changes.size()) element_of(chunk.changes[change++]) = uint32_t(to / size);
    vertices.truncate(to);
  }

  ObjModel& model_;
  const ElementCounts of_file_;
  RemarkList& remarks_;
  bool has_unusable_position_ = false;
};

} // namespace

void check_indices(ObjModel& model, const ElementCounts& of_file, RemarkList& remarks) {
  IndexChecker checker(model, of_file, remarks);
  for (ObjChunk& chunk : model.chunks) {
    checker.check(chunk);
    model.face_count += chunk.face_count;
    model.segment_count += chunk.line_vertices.values.size() / 2;
    model.point_count += chunk.point_vertices.values.size();
  }
}

} // namespace softgl::cli
