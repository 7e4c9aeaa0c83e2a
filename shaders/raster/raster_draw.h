// What set-up and tile kernels know of a draw, and the records that travel in the tiles' lists.
#pragma once

#include "shaders/common/shaded_vertex.h"
#include "shaders/fragment/fragment_program.h"
#include "shaders/raster/raster_constants.h"

namespace softgl {

/// value at pixel (px, py) = gy * py + (gx * px + a), in this order (OSMesa 22.3.6; the origin is the
/// framebuffer's corner, not the triangle's).
struct Plane {
  float a, gx, gy;
};

/// Components first .. of a vertex slot, interpolated into lanes of the fragment block.
struct Varying {
  uint32_t lanes; // where in FragmentBlock the first component's lanes are, in bytes; the others' follow
  int8_t slot, back_slot; // of vertices of front- and of back-facing polygons
  int8_t first, components;
  int8_t plane; // the first component's plane; the others' follow
  bool flat;    // not interpolated but taken from corner 2: flat shading, or the same for all vertices
};
constexpr int kMaxVaryings =
    5 + kMaterialSlots; // fog, coverage, and for the lighting of fragments normal, eye, color, material

/// Derived once per draw and frame.
struct RasterDraw {
  const FragmentProgram* program;
  const RasterConstants* raster;
  ShadedLayout layout;
  // Planes of a primitive: z, 1/w, those of the varyings (the primary color first, unless fragments are
  // lit), then s t r q of texture units; -1: not there.
  uint8_t plane_count, varying_count;
  Varying varying[kMaxVaryings];
  int8_t unit_plane[kMaxTextureUnits];
  uint8_t coverage_numbers; // of the block that are a primitive's constants; their planes are behind all
                            // others
  uint8_t flat_units;       // bit u: the coordinates of texture unit u are the same for all vertices, and not
                            // interpolated
  bool facing;              // the block's `back` is filled
  bool small;               // triangles of few pixels are shaded with lane = fragment; not stippled ones
  bool drops_uncovered;     // else those of very few pixels that cover none are not set up
  bool quads;               // those whose stages look at other pixels of a 2x2 quad: with four lanes = quad
  bool opaque;         // alpha is 1 at all vertices, so it is 1 / w times w everywhere, which rounds to 255
  bool direct;         // no stage runs, RGBA8: blocks of pixels bypass the FragmentBlock
  bool replaces_words; // what is left to do for shaded fragments: to compare depths, and replace RGBA8 words
  bool early_depth;    // a fragment's depth can be tested before its stages run
  bool final_depth;    // and written, too: nothing tests it again
  bool lasting_depth;  // where no depth changes, nothing tests it again
  bool whole_blocks;   // no edge is looked at in blocks that lie inside all of them
  uint32_t color_mask; // of an RGBA8 word
  uint64_t* samples;   // DrawRecord::samples
  const RasterDraw* back_face;                                   // of back-facing polygons; null: as others
  const RasterDraw *smooth_point, *smooth_line, *smooth_polygon; // of antialiased primitives; null: as others
};
constexpr int kPlaneZ = 0, kPlaneW = 1, kPlaneColor = 2;

/// The plane that holds the first of the primitive's coverage numbers.
inline int coverage_plane(const RasterDraw& draw) { return draw.plane_count - draw.coverage_numbers; }

/// The coordinates of a texture unit that is in use; they have no lanes of their own, being divided by q.
inline Varying coordinates_of_unit(const RasterDraw& draw, int unit) {
  return {0, draw.layout.texcoord[unit], draw.layout.texcoord[unit],        0,
          4, draw.unit_plane[unit],      (draw.flat_units >> unit & 1) != 0};
}
// Most planes there are where fragments are lit: normal, eye, materials of both faces (four colors and the
// exponent), fog, coordinates.
constexpr int kMaxPlanes = 2 + 3 + 3 + 2 * (4 * 4 + 1) + 1 + 4 * kMaxTextureUnits + kCoverageNumbers;

/// A set-up triangle, line or point: convex, 3 or 4 edges or, for points, none but the box (unused edges
/// accept all). A pixel is covered iff c - a * px + b * py >= 0 for all edges; a and b are in 1/256 pixel, c
/// = floor((c' - 1) / 256) of the exact edge function c' (with its tie rule), which is the same test because
/// a * 256 * px is a multiple of 256. With multisampling c is c' - 1, and each sample point makes its own c
/// of it.
struct alignas(16) RasterPrimitive {
  int64_t c[4];
  int32_t a[4], b[4];
  int32_t x0, y0, x1, y1; // pixels that may be covered, half open, clipped
  int32_t edges;          // 0, 3 or 4
  float depth_offset;
  bool w_is_one; // the plane of 1/w is exactly 1 everywhere, so the division changes nothing
  bool back;     // a back-facing triangle
  bool round; // with multisampling: a circle around (c[0], c[1]) in 1/256 pixel, whose radius squared is c[2]
  Plane plane[]; // plane_count of them
};

/// A small triangle on its way to a tile that its box touches.
struct SmallTriangle {
  const ShadedVertices::Slot*
      corner[3]; // in the order of set-up: 0 and 1 exchanged where the area was negative
  bool back;     // back-facing
};

/// Finished fragments of tiny triangles.
struct SmallFragments {
  uint16_t* pixel; // pixel_in_tile
  uint32_t* depth; // in the depth buffer's integers
  uint32_t* color; // RGBA8
};

/// The planes of one tile. Where pixels have several samples, those of a pixel lie side by side.
struct TileTarget {
  int32_t x, y; // window position of its first pixel
  void* color;
  uint32_t* depth_stencil;
  bool one_stencil; // all its words have the same bits above depth:
  uint32_t stencil_bits;
  uint64_t* samples = nullptr; // where fragments that pass all tests are counted; null: nowhere
};

} // namespace softgl
