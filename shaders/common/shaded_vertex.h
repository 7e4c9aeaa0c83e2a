// What the vertex program hands to clipping and rasterization: an array of structures in 16-byte slots,
// because an index points at it (measured: a gather from separate arrays costs three times the transposing
// loads).
#pragma once

#include <stdint.h>

#include "shaders/common/limits.h"
#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// Which slot of a shaded vertex holds what; -1 = the draw does not need it. Slot 0 is always the window
/// position x, y (down), z, 1/w. Colors are clamped to [0,1] unless the key says otherwise (OSMesa clamps at
/// the vertex).
struct ShadedLayout {
  int8_t color = -1;      // front primary color r g b a
  int8_t secondary = -1;  // front secondary color r g b, and the fog coordinate (not negative) in the 4th
  int8_t back_color = -1; // present when lighting is two-sided
  int8_t back_secondary = -1;
  int8_t point = -1; // point size after attenuation and clamping, in the 1st
  int8_t texcoord[kMaxTextureUnits] = {-1, -1, -1, -1, -1, -1, -1, -1}; // s t r q of each enabled unit
  // Where fragments are lit there are no colors, but what lighting reads: the normal and the position in eye
  // coordinates, the vertex color (not clamped) that feeds the material, and material parameters of the
  // vertices.
  int8_t normal = -1, eye = -1, tracked = -1;
  int8_t material[kMaterialSlots] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
  uint8_t slots = 1; // slots per vertex, stride = 16 * slots bytes
};

/// Clip mask of a shaded vertex: bits of violated planes, in the order in which clipping visits them.
enum ClipBit : uint16_t {
  kClipRight = 1,
  kClipLeft = 2,
  kClipTop = 4,
  kClipBottom = 8,
  kClipNear = 16,
  kClipFar = 32,
  kClipUser0 = 64 // .. kClipUser0 << 7
};

/// Shaded vertices of a draw: vertex i (first <= i < first + count) begins at slot[(i - first) *
/// layout.slots].
struct ShadedVertices {
  struct alignas(16) Slot {
    float v[4];
  };
  Slot* slot;
  uint16_t* clip_mask;
  uint32_t first, count;
  bool clipped = false; // all of them by one plane: then only their masks are set
};

} // namespace softgl
