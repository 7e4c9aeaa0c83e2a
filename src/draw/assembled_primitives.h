// The border between geometry and raster: batches of triangles, lines and points in window space, after
// clipping, before facing and culling.
#pragma once

#include <cstdint>

#include "shaders/common/shaded_vertex.h"

namespace softgl {

struct DrawRecord;

/// 64 or 128 primitives are best for the setup kernels (measured: 256 and more cost 0.3-1.0 ns a triangle,
/// L1).
constexpr int kAssemblyBatch = 64;

/// Triangles in drawing order, corners in the order that set-up wants (as OSMesa 22.3.6 orders them). Corner
/// 2 is the provoking vertex; clipping has already copied flat colors to it. Vertices made by clipping live
/// in the chunk's arena.
struct AssembledTriangles {
  int32_t count = 0;
  uint64_t inner[3] = {}; // bit i of inner[k]: the edge of triangle i that begins at corner k lies inside its
                          // polygon; known where polygons are antialiased
  const ShadedVertices::Slot* corner[3][kAssemblyBatch];
};

/// Lines from corner 0 to corner 1; corner 1 is the provoking vertex. Already cut by the line stipple.
struct AssembledLines {
  int32_t count = 0;
  uint64_t back = 0;   // bit i: line i is an edge of a back-facing polygon
  uint64_t begins = 0; // bit i: the stipple begins anew with line i (feedback wants to know)
  const ShadedVertices::Slot* corner[2][kAssemblyBatch];
};

struct AssembledPoints {
  int32_t count = 0;
  uint64_t back = 0; // bit i: point i is a corner of a back-facing polygon
  const ShadedVertices::Slot* corner[kAssemblyBatch];
};

/// Takes assembled primitives in drawing order: the tile binner, or feedback and selection. The virtual call
/// is once per batch.
class PrimitiveSink {
public:
  virtual ~PrimitiveSink() = default;
  virtual void triangles(const DrawRecord& draw, const AssembledTriangles& batch) = 0;
  virtual void lines(const DrawRecord& draw, const AssembledLines& batch) = 0;
  virtual void points(const DrawRecord& draw, const AssembledPoints& batch) = 0;
};

} // namespace softgl
