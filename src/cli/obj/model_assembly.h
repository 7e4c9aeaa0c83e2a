// Builds a model vertex by vertex and face by face, for readers of formats that have no chunks to be parsed
// in parallel.
#pragma once

#include "obj/obj_reader.h"

namespace softgl::cli {

class ModelAssembly {
public:
  // `has_texcoords`, `has_normals`: each vertex has its own, in the order of the vertices.
  ModelAssembly(RemarkList& remarks, bool has_texcoords, bool has_normals);

  void add_vertex(const double* xyz);
  void add_texcoord(float u, float v);
  void add_normal(const float* xyz);
  void add_color(const float* rgb); // 0 to 1; either for all vertices or for none
  // Numbers of vertices from 0, which may be any; a face that is of no use is skipped with a remark.
  void add_face(const int64_t* vertices, size_t count);
  size_t vertex_count() const { return model_.positions.size() / 3; }

  // The faces lead to vertices that exist and are finite. Throws ProgramError if there are too many.
  ObjModel take(const SourceText& text);

private:
  bool usable(int64_t vertex) const;

  RemarkList& remarks_;
  const bool has_texcoords_, has_normals_;
  ObjModel model_;
  ObjChunk chunk_;
};

} // namespace softgl::cli
