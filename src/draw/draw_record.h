// An immutable draw: the call and pointers to snapshots of the state it needs. Nothing behind submit() sees
// Context.
#pragma once

#include "draw/draw_call.h"
#include "shaders/common/shaded_vertex.h"

namespace softgl {

struct VertexProgram;   // geometry/vertex_program.h: key, constants and stages from eye space to shaded
                        // vertices
struct RasterConstants; // shaders/raster_constants.h: culling, offset, scissor, sizes
struct FragmentProgram; // shaders/fragment_program.h: key, constants and stages of the fragments
struct SmoothPrograms;

/// A rectangle of the window whose fragments all have the attributes of one vertex.
struct PixelRectangle {
  const ShadedVertices::Slot* corner;
  WindowBox box;
};

/// The diagonal that cuts a quadrilateral of GL_QUADS into two triangles; GL 1.5, 2.6.1 leaves it open.
/// Unclipped02: from 0 to 2, but from 1 to 3 where a vertex of its batch is clipped.
enum class Diagonal : uint8_t { From0To2, From1To3, Unclipped02 };
/// The vertices of a batch of OSMesa's.
constexpr uint32_t kBatchVertices = 4096;

struct DrawRecord {
  DrawCall call;
  ShadedLayout layout;
  const VertexProgram* vertex;
  const RasterConstants* raster;
  const FragmentProgram* fragment;
  const PixelRectangle* rectangle =
      nullptr;                 // in place of the call's primitives; then there is no vertex program
  uint64_t* samples = nullptr; // where its fragments that pass all tests are counted; null: nowhere
  const SmoothPrograms* smooth = nullptr; // of its antialiased primitives; null: there are none
  Diagonal diagonal = Diagonal::From0To2;
  // Of its back-facing polygons; null: as of the others.
  const FragmentProgram* back_fragment = nullptr;
  const SmoothPrograms* back_smooth = nullptr;
  // Flat colors are those of the first vertex of each primitive, not of the last one
  // (GL_EXT_provoking_vertex).
  bool first_provokes = false;
};

} // namespace softgl
