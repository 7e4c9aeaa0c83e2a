// What both ways through a tile share: 8x8 blocks of pixels and planes at their columns.
#pragma once

#include "shaders/fragment/fragment_encode.inl"
#include "shaders/raster/raster_coverage.inl"
#include "shaders/raster/raster_interpolate.inl"

namespace softgl {
namespace SOFTGL_ISA {

SOFTGL_INLINE FloatV row_of_eight(int i) { // x offsets of the lanes of vector i of a strip
  alignas(64) static const float offset[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
  return load(offset + (i * kWidth & 7));
}
SOFTGL_INLINE FloatV row_number(int i) {
  alignas(64) static const float row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  return kWidth == 16 ? load(row) : splat(float(i * kWidth >> 3));
}

/// y of the lanes of a vector that begins at row `row` of a block.
SOFTGL_INLINE FloatV row_coordinates(float block_y, int row) {
  const FloatV y = splat(block_y + float(row));
  return kWidth == 16 ? y + row_number(0) : y;
}

/// Planes of a primitive with the x part at the columns of a block: a + gx * px.
struct BlockPlane {
  FloatV column[kWidth < 8 ? 2 : 1];
  FloatV gy;
};
/// `x`: of the first column.
SOFTGL_INLINE BlockPlane block_plane(const Plane& p, float x) {
  BlockPlane b;
  for (int i = 0; i < (kWidth < 8 ? 2 : 1); ++i)
    b.column[i] = splat(p.gx) * (splat(x) + row_of_eight(i)) + splat(p.a);
  b.gy = splat(p.gy);
  return b;
}

/// The records of a tile's primitives were written by another phase and lie in no near cache.
SOFTGL_INLINE void prefetch(const RasterPrimitive* const* primitive, int32_t i, int32_t count) {
  if (i + 4 >= count) return;
  const char* p = reinterpret_cast<const char*>(primitive[i + 4]);
  __builtin_prefetch(p), __builtin_prefetch(p + 64), __builtin_prefetch(p + 128);
}

} // namespace SOFTGL_ISA
} // namespace softgl
