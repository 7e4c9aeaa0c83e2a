// The model as GL wants it: one array of vertices, triangles by material.
#pragma once

#include <optional>
#include <vector>

#include "mesh/model_frame.h"
#include "obj/material_library.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

struct Batch {
  uint32_t material;
  uint32_t first, count; // in triangle indices, segment vertices or points
};

struct Mesh {
  GrowingArray<float> positions; // x y z
  GrowingArray<float> normals;   // x y z, unit
  GrowingArray<float> texcoords; // u v; empty if no triangle has any
  GrowingArray<float> colors;    // r g b and the material's opacity; empty without vertex colors
  GrowingArray<uint32_t> triangles;
  std::vector<Batch> triangle_batches; // one per material in use

  GrowingArray<float> edge_positions; // two places each, where edges are to be drawn

  GrowingArray<float> segment_positions, segment_colors; // two vertices each, opaque
  std::vector<Batch> segment_batches;
  GrowingArray<float> point_positions, point_colors;
  std::vector<Batch> point_batches;

  bool empty() const { return triangles.empty() && segment_positions.empty() && point_positions.empty(); }
};

struct MeshOptions {
  bool flat = false; // each triangle with its own normal
  bool with_texcoords = true;
  // Where this is a stretch of a file: what the whole file has.
  std::optional<bool> has_texcoords;
  bool names_materials = false;
};

// `library` resolves usemtl; unknown names become material 0 with a remark. The corners of the model's faces
// are freed as they are used.
Mesh build_mesh(ObjModel& model, const ModelFrame& frame, const MaterialLibrary& library,
                const MeshOptions& options, RemarkList& remarks);

} // namespace softgl::cli
