// The numbers that depth and color are stored as, as OSMesa 22.3.6 rounds them.
#pragma once

#include "shaders/common/simd.h"
#include "shaders/fragment/fragment_key.h"

namespace softgl {
namespace SOFTGL_ISA {

SOFTGL_INLINE float depth_scale(const FragmentKey& key) {
  return float(largest_depth(DepthFormat(key.depth_format)));
}
SOFTGL_INLINE IntV depth_bits(FloatV z, float scale) { return round_to_int(unit_range(z) * scale); }
/// The same of floats, whose bits compare as integers do.
SOFTGL_INLINE IntV depth_float(FloatV z) { return (IntV)unit_range(z); }
SOFTGL_INLINE IntV color_byte(FloatV c) { return round_to_int(unit_range(c) * 255.0f); }
/// An RGBA8 word; `a` is a byte in each lane.
SOFTGL_INLINE IntV pack_bytes(FloatV r, FloatV g, FloatV b, IntV a) {
#if defined(__AVX2__)
  // Saturating packs clamp below: not a number and everything too negative become the most negative integer,
  // then 0.
  const FloatV one = splat(1.0f);
  const IntV ri = round_to_int(min_(one, r) * 255.0f), gi = round_to_int(min_(one, g) * 255.0f),
             bi = round_to_int(min_(one, b) * 255.0f);
  return interleave_bytes(ri, gi, bi, a);
#else
  return color_byte(r) | (color_byte(g) << 8) | (color_byte(b) << 16) | (a << 24);
#endif
}
SOFTGL_INLINE IntV pack_color(FloatV r, FloatV g, FloatV b, FloatV a) {
  return pack_bytes(r, g, b, color_byte(a));
}
SOFTGL_INLINE IntV pack_opaque(FloatV r, FloatV g, FloatV b) { return pack_bytes(r, g, b, splat(255)); }

} // namespace SOFTGL_ISA
} // namespace softgl
