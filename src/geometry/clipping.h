// Clipping to the view volume and the user's planes, in clip coordinates (GL 1.5, 2.12).
#pragma once

#include <span>

#include "base/arena.h"
#include "draw/draw_record.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

/// Gives a vertex the primary and secondary colors of another one, those of both faces.
void copy_flat_colors(const ShadedLayout& layout, ShadedVertices::Slot* to, const ShadedVertices::Slot* from);

/// A corner of a polygon.
struct PolygonCorner {
  const ShadedVertices::Slot* vertex;
  bool boundary; // the edge that begins here, and the point here, are drawn (GL 1.5, 2.6.2)
};

/// Clips the primitives of one draw. Shaded vertices carry no clip coordinates (few need them): they are
/// computed again from the draw's source, with the vertex program's arithmetic.
class Clipper {
public:
  using Slot = ShadedVertices::Slot;
  static constexpr int kMaxPlanes = 14;
  static constexpr int kMaxPolygon = 3 + kMaxPlanes;

  Clipper(const DrawRecord& draw, const ShadedVertices& vertices, Arena& arena);

  /// Clips triangle v (vertex numbers); `mask` is the union of its vertices' clip masks. Returns the number
  /// of vertices of the polygon, or 0. Flat colors of v[2] are in polygon[0], which stays the provoking
  /// vertex. Bit i of `edges`: the edge that begins at vertex i is one of the polygon that the triangle was
  /// cut from. As in OSMesa 22.3.6 edges along the user's clip planes are, those along the view volume are
  /// not, unless PolygonConstants::whole.
  int triangle(const uint32_t v[3], uint32_t mask, const Slot* polygon[kMaxPolygon], uint32_t& edges);
  /// Clips a polygon with the vertices v as a whole; `corners` say which edges are boundaries. What is left
  /// of it, in the arena: nothing, or three corners at least.
  std::span<const PolygonCorner> polygon(const uint32_t* v, uint32_t mask,
                                         std::span<const PolygonCorner> corners);
  /// Clips a line; both ends carry the flat colors of v[1]. False when nothing is left.
  bool line(const uint32_t v[2], const Slot* end[2]);

private:
  struct Vertex {
    float clip[4];
    const Slot* shaded; // what was made by clipping is in the arena
    bool edge;          // the edge that begins here is one of the polygon
  };
  /// A polygon while it is cut.
  struct Cut {
    Vertex **vertex, **other; // lists of `most` vertices, and of one more
    int count, most;
    Vertex* pool; // `made` vertices, of `most_made`
    int made, most_made;
  };
  void load(uint32_t vertex, Vertex& out) const;
  float distance(const Vertex& v, int plane) const;
  /// Returns the slots of `out`.
  Slot* interpolate(Vertex& out, float t, const Vertex& from, const Vertex& to);
  /// Cuts by the planes of the mask. False when nothing is left.
  bool cut(Cut& polygon, uint32_t mask);
  const Slot* shaded(uint32_t vertex) const {
    return vertices_.slot + size_t(vertex - vertices_.first) * slots_;
  }

  const DrawRecord& draw_;
  const ShadedVertices& vertices_;
  Arena& arena_;
  const TransformConstants& transform_;
  const int slots_;
  const bool flat_;
  const int first_boundary_; // the first plane along which edges of polygons are boundaries
  float plane_[kMaxPlanes][4];
};

} // namespace softgl
