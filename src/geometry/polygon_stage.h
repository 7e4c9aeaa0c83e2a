// Polygons between assembly and raster: glPolygonMode (GL 1.5, 3.5.4), and culling, two-sided colors and
// offset with it.
#pragma once

#include <array>
#include <span>

#include "base/arena.h"
#include "draw/assembled_primitives.h"
#include "geometry/clipping.h"
#include "geometry/line_stipple.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

/// A triangle that a polygon was cut into, after clipping.
struct PolygonTriangle {
  const ShadedVertices::Slot* corner[3]; // corner 2 is the provoking vertex
  uint32_t boundary; // bit k: the edge from corner k to the next one, and the point at corner k, are drawn
  bool begins;       // the line stipple begins anew
};

/// Culls, colors and offsets the triangles of a draw, and hands over what their modes leave of them, in
/// drawing order. All that with the exact order of operations of OSMesa 22.3.6, whose draw module does it in
/// window coordinates that are not snapped.
class PolygonStage {
public:
  PolygonStage(const DrawRecord& draw, Arena& arena, PrimitiveSink& sink);
  void triangle(const PolygonTriangle& triangle);
  /// A polygon that was cut as a whole; the line stipple begins anew. `provoking` has its flat colors.
  void polygon(std::span<const PolygonCorner> corners, const ShadedVertices::Slot* provoking);
  /// What follows is only counted for the line stipple, and not drawn.
  void count_only(bool only) { counting_ = only; }
  /// True where triangles in front of those that are drawn have to be counted.
  bool stipples() const {
    return draw_.vertex->line_stipple &&
           (constants_.mode[0] == PolygonMode::Line || constants_.mode[1] == PolygonMode::Line);
  }
  /// True where polygons are filled whichever way they face: then nobody asks which edges have a flag.
  bool fills() const {
    return constants_.mode[0] == PolygonMode::Fill && constants_.mode[1] == PolygonMode::Fill;
  }
  /// Hands over what is left.
  void finish();

private:
  using Slot = ShadedVertices::Slot;
  enum class Pending { None, Triangles, Lines, Points };
  /// A triangle, or the largest one of a polygon, relative to its last corner.
  struct Plane {
    float e[3], f[3], determinant;
    const Slot* corner[3];
  };
  static Plane plane_of(const Slot* a, const Slot* b, const Slot* c);
  /// How a polygon of this area is drawn; false if it is culled.
  bool look_at(float determinant, PolygonMode& mode);
  /// Gives corners the colors and the offset of their polygon.
  void finish_corners(std::span<const Slot*> corners, const Slot* provoking, PolygonMode mode,
                      const Plane& plane);
  void fill(const std::array<const Slot*, 3>& corner, uint32_t boundary);
  void point(const Slot* vertex);
  const Slot* own_copy(const Slot* vertex, const Slot* provoking, bool back, const float* offset);
  void begin(Pending kind, int32_t count);
  void line(const Slot* a, const Slot* b);

  const DrawRecord& draw_;
  const PolygonConstants& constants_;
  Arena& arena_;
  PrimitiveSink& sink_;
  const uint32_t slots_;
  LineStipple stipple_;
  bool counting_ = false, back_ = false, line_begins_ = false;
  Pending pending_ = Pending::None;
  AssembledTriangles triangles_;
  AssembledLines lines_;
  AssembledPoints points_;
};

} // namespace softgl
