// The end of a fragment: stencil, depth, blending, logic operation, masks. Works on arrays of up to 64 fragments, no two of
// the same pixel, whose destination pixels have been gathered.
#pragma once

#include "fragment_stages.inl"
#include "raster_setup.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Source fragments and the pixels under them. Colours of Rgba8 and Rgb565 surfaces are RGBA8 words here.
struct alignas(64) MergeBlock {
  int32_t lanes; // a multiple of 16
  uint32_t live[kLanes];
  uint32_t depth[kLanes], color[kLanes]; // source
  uint32_t depth_stencil[kLanes], target[kLanes]; // destination, in and out
};

SOFTGL_INLINE void keep_compared(Compare function, uint32_t* live, const uint32_t* value, const uint32_t* other, int lanes) {
  // Depths have at most 24 bits, so signed comparison serves.
  switch (function) {
  case Compare::Never: for (int i = 0; i < lanes; ++i) live[i] = 0; break;
  case Compare::Less: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) < int32_t(other[i]))); break;
  case Compare::Equal: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) == int32_t(other[i]))); break;
  case Compare::LessEqual: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) <= int32_t(other[i]))); break;
  case Compare::Greater: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) > int32_t(other[i]))); break;
  case Compare::NotEqual: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) != int32_t(other[i]))); break;
  case Compare::GreaterEqual: for (int i = 0; i < lanes; ++i) live[i] &= uint32_t(mask_of(int32_t(value[i]) >= int32_t(other[i]))); break;
  case Compare::Always: break;
  }
}

/// GL 1.5, 4.1.5: replaces the stencil values where `where` is set.
SOFTGL_INLINE void stencil_operation(StencilOperation operation, const FragmentConstants& k, const uint32_t* where,
                                     uint32_t* stencil, int lanes) {
  if (operation == StencilOperation::Keep) return;
  const uint32_t reference = k.stencil_reference, write = k.stencil_write_mask;
  for (int i = 0; i < lanes; ++i) {
    const uint32_t s = stencil[i];
    uint32_t n = s;
    switch (operation) {
    case StencilOperation::Keep: break;
    case StencilOperation::Zero: n = 0; break;
    case StencilOperation::Replace: n = reference; break;
    case StencilOperation::Increment: n = s < 255 ? s + 1 : 255; break;
    case StencilOperation::Decrement: n = s > 0 ? s - 1 : 0; break;
    case StencilOperation::Invert: n = ~s & 255; break;
    case StencilOperation::IncrementWrap: n = (s + 1) & 255; break;
    case StencilOperation::DecrementWrap: n = (s - 1) & 255; break;
    }
    const uint32_t mask = write & where[i];
    stencil[i] = (s & ~mask) | (n & mask);
  }
}

/// Stencil and depth test with their writes; live lanes are left in m.live.
static void merge_depth_stencil(const FragmentProgram& program, MergeBlock& m) {
  const FragmentKey& key = program.key;
  const FragmentConstants& k = *program.constants;
  const int lanes = m.lanes;
  const Compare depth_function = Compare(key.depth_function);
  if (depth_function == Compare::Always && !key.depth_write && !key.stencil) return;
  alignas(64) uint32_t depth[kLanes];
  for (int i = 0; i < lanes; ++i) depth[i] = m.depth_stencil[i] & 0xffffff;
  if (key.stencil) {
    alignas(64) uint32_t stencil[kLanes], masked[kLanes], pass[kLanes], part[kLanes];
    const uint32_t value_mask = k.stencil_value_mask, reference = k.stencil_reference & value_mask;
    for (int i = 0; i < lanes; ++i) stencil[i] = m.depth_stencil[i] >> 24, masked[i] = reference, part[i] = stencil[i] & value_mask;
    for (int i = 0; i < lanes; ++i) pass[i] = m.live[i];
    keep_compared(Compare(key.stencil_function), pass, masked, part, lanes);
    for (int i = 0; i < lanes; ++i) part[i] = m.live[i] & ~pass[i];
    stencil_operation(StencilOperation(key.stencil_fail), k, part, stencil, lanes);
    for (int i = 0; i < lanes; ++i) m.live[i] = pass[i];
    keep_compared(depth_function, m.live, m.depth, depth, lanes);
    for (int i = 0; i < lanes; ++i) part[i] = pass[i] & ~m.live[i];
    stencil_operation(StencilOperation(key.stencil_depth_fail), k, part, stencil, lanes);
    stencil_operation(StencilOperation(key.stencil_pass), k, m.live, stencil, lanes);
    for (int i = 0; i < lanes; ++i) m.depth_stencil[i] = depth[i] | stencil[i] << 24;
  } else {
    keep_compared(depth_function, m.live, m.depth, depth, lanes);
  }
  if (key.depth_write)
    for (int i = 0; i < lanes; ++i) {
      const uint32_t where = m.live[i] & 0xffffff;
      m.depth_stencil[i] = (m.depth_stencil[i] & ~where) | (m.depth[i] & where);
    }
}

typedef uint16_t Channel[kLanes];

/// a * b / 255 as OSMesa 22.3.6 rounds it.
SOFTGL_INLINE uint16_t multiply_8(uint16_t a, uint16_t b) {
  const uint16_t p = uint16_t(a * b);
  return uint16_t(uint16_t(p + uint16_t(p >> 8) + 128) >> 8);
}

/// The factor of one channel (3 = alpha) into out.
static void blend_factor(BlendFactor factor, int channel, const Channel* s, const Channel* d, const uint8_t* constant,
                         uint16_t* out, int lanes) {
  auto copy = [&](const uint16_t* from) { for (int i = 0; i < lanes; ++i) out[i] = from[i]; };
  auto inverse = [&](const uint16_t* from) { for (int i = 0; i < lanes; ++i) out[i] = uint16_t(255 - from[i]); };
  auto fill = [&](int v) { for (int i = 0; i < lanes; ++i) out[i] = uint16_t(v); };
  switch (factor) {
  case BlendFactor::Zero: fill(0); break;
  case BlendFactor::One: fill(255); break;
  case BlendFactor::SourceColor: copy(s[channel]); break;
  case BlendFactor::OneMinusSourceColor: inverse(s[channel]); break;
  case BlendFactor::SourceAlpha: copy(s[3]); break;
  case BlendFactor::OneMinusSourceAlpha: inverse(s[3]); break;
  case BlendFactor::DestinationAlpha: copy(d[3]); break;
  case BlendFactor::OneMinusDestinationAlpha: inverse(d[3]); break;
  case BlendFactor::DestinationColor: copy(d[channel]); break;
  case BlendFactor::OneMinusDestinationColor: inverse(d[channel]); break;
  case BlendFactor::SourceAlphaSaturate:
    if (channel == 3) { fill(255); break; }
    for (int i = 0; i < lanes; ++i) {
      const uint16_t a = s[3][i], b = uint16_t(255 - d[3][i]);
      out[i] = a < b ? a : b;
    }
    break;
  case BlendFactor::ConstantColor: fill(constant[channel]); break;
  case BlendFactor::OneMinusConstantColor: fill(255 - constant[channel]); break;
  case BlendFactor::ConstantAlpha: fill(constant[3]); break;
  case BlendFactor::OneMinusConstantAlpha: fill(255 - constant[3]); break;
  }
}

static void blend_8(const FragmentKey& key, const FragmentConstants& k, MergeBlock& m) {
  alignas(64) Channel s[4], d[4], result[4], sf, df;
  const int lanes = m.lanes;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < lanes; ++i) {
      s[c][i] = uint16_t(m.color[i] >> (8 * c) & 255);
      d[c][i] = uint16_t(m.target[i] >> (8 * c) & 255);
    }
  for (int c = 0; c < 4; ++c) {
    const auto equation = BlendEquation(key.blend_equation);
    uint16_t* o = result[c];
    if (equation == BlendEquation::Min) {
      for (int i = 0; i < lanes; ++i) o[i] = s[c][i] < d[c][i] ? s[c][i] : d[c][i];
      continue;
    }
    if (equation == BlendEquation::Max) {
      for (int i = 0; i < lanes; ++i) o[i] = s[c][i] > d[c][i] ? s[c][i] : d[c][i];
      continue;
    }
    blend_factor(BlendFactor(c == 3 ? key.blend_source_alpha : key.blend_source_rgb), c, s, d, k.blend_color_8, sf, lanes);
    blend_factor(BlendFactor(c == 3 ? key.blend_destination_alpha : key.blend_destination_rgb), c, s, d, k.blend_color_8, df, lanes);
    switch (equation) {
    case BlendEquation::Subtract:
      for (int i = 0; i < lanes; ++i) {
        const uint16_t a = multiply_8(s[c][i], sf[i]), b = multiply_8(d[c][i], df[i]);
        o[i] = uint16_t(a > b ? a - b : 0);
      }
      break;
    case BlendEquation::ReverseSubtract:
      for (int i = 0; i < lanes; ++i) {
        const uint16_t a = multiply_8(s[c][i], sf[i]), b = multiply_8(d[c][i], df[i]);
        o[i] = uint16_t(b > a ? b - a : 0);
      }
      break;
    default:
      for (int i = 0; i < lanes; ++i) {
        const uint16_t sum = uint16_t(multiply_8(s[c][i], sf[i]) + multiply_8(d[c][i], df[i]));
        o[i] = sum < 255 ? sum : uint16_t(255);
      }
    }
  }
  for (int i = 0; i < lanes; ++i)
    m.color[i] = uint32_t(result[0][i]) | uint32_t(result[1][i]) << 8 | uint32_t(result[2][i]) << 16 | uint32_t(result[3][i]) << 24;
}

/// GL 1.5, 4.1.9; `operation` counts from GL_CLEAR.
static void logic_8(unsigned operation, MergeBlock& m) {
  const int lanes = m.lanes;
  uint32_t* s = m.color;
  const uint32_t* d = m.target;
  switch (operation) {
  case 0: for (int i = 0; i < lanes; ++i) s[i] = 0; break;
  case 1: for (int i = 0; i < lanes; ++i) s[i] = s[i] & d[i]; break;
  case 2: for (int i = 0; i < lanes; ++i) s[i] = s[i] & ~d[i]; break;
  case 4: for (int i = 0; i < lanes; ++i) s[i] = ~s[i] & d[i]; break;
  case 5: for (int i = 0; i < lanes; ++i) s[i] = d[i]; break;
  case 6: for (int i = 0; i < lanes; ++i) s[i] = s[i] ^ d[i]; break;
  case 7: for (int i = 0; i < lanes; ++i) s[i] = s[i] | d[i]; break;
  case 8: for (int i = 0; i < lanes; ++i) s[i] = ~(s[i] | d[i]); break;
  case 9: for (int i = 0; i < lanes; ++i) s[i] = ~(s[i] ^ d[i]); break;
  case 10: for (int i = 0; i < lanes; ++i) s[i] = ~d[i]; break;
  case 11: for (int i = 0; i < lanes; ++i) s[i] = s[i] | ~d[i]; break;
  case 12: for (int i = 0; i < lanes; ++i) s[i] = ~s[i]; break;
  case 13: for (int i = 0; i < lanes; ++i) s[i] = ~s[i] | d[i]; break;
  case 14: for (int i = 0; i < lanes; ++i) s[i] = ~(s[i] & d[i]); break;
  case 15: for (int i = 0; i < lanes; ++i) s[i] = ~uint32_t(0); break;
  default: break; // GL_COPY
  }
}

/// Everything for surfaces of 8 bits or less: m.color in, m.target and m.depth_stencil out.
static void merge_8(const FragmentProgram& program, MergeBlock& m) {
  const FragmentKey& key = program.key;
  const int lanes = m.lanes;
  merge_depth_stencil(program, m);
  if (key.color_mask == 0) return;
  if (key.logic_op) logic_8(unsigned(key.blend_source_rgb), m);
  else if (key.blend) blend_8(key, *program.constants, m);
  uint32_t mask = 0;
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) mask |= 0xffu << (8 * c);
  for (int i = 0; i < lanes; ++i) {
    const uint32_t where = m.live[i] & mask;
    m.target[i] = (m.target[i] & ~where) | (m.color[i] & where);
  }
}

/// 5-6-5 to RGBA8 and back: bits are repeated one way and cut the other (OSMesa 22.3.6). Alpha reads as 1.
SOFTGL_INLINE uint32_t expand_565(uint32_t v) {
  const uint32_t r = v >> 11 & 31, g = v >> 5 & 63, b = v & 31;
  return (r << 3 | r >> 2) | (g << 2 | g >> 4) << 8 | (b << 3 | b >> 2) << 16 | 0xff000000u;
}
SOFTGL_INLINE uint16_t cut_565(uint32_t c) {
  return uint16_t((c & 0xf8) << 8 | (c >> 5 & 0x7e0) | (c >> 19 & 0x1f));
}

/// Blending of one pixel in float, for 16-bit and float surfaces.
static void blend_float(const FragmentKey& key, const FragmentConstants& k, const float* s, const float* d, float* out) {
  for (int c = 0; c < 4; ++c) {
    auto factor = [&](BlendFactor f) -> float {
      switch (f) {
      case BlendFactor::Zero: return 0;
      case BlendFactor::One: return 1;
      case BlendFactor::SourceColor: return s[c];
      case BlendFactor::OneMinusSourceColor: return 1 - s[c];
      case BlendFactor::SourceAlpha: return s[3];
      case BlendFactor::OneMinusSourceAlpha: return 1 - s[3];
      case BlendFactor::DestinationAlpha: return d[3];
      case BlendFactor::OneMinusDestinationAlpha: return 1 - d[3];
      case BlendFactor::DestinationColor: return d[c];
      case BlendFactor::OneMinusDestinationColor: return 1 - d[c];
      case BlendFactor::SourceAlphaSaturate: return c == 3 ? 1 : s[3] < 1 - d[3] ? s[3] : 1 - d[3];
      case BlendFactor::ConstantColor: return k.blend_color[c];
      case BlendFactor::OneMinusConstantColor: return 1 - k.blend_color[c];
      case BlendFactor::ConstantAlpha: return k.blend_color[3];
      case BlendFactor::OneMinusConstantAlpha: return 1 - k.blend_color[3];
      }
      return 0;
    };
    const auto equation = BlendEquation(key.blend_equation);
    if (equation == BlendEquation::Min) { out[c] = s[c] < d[c] ? s[c] : d[c]; continue; }
    if (equation == BlendEquation::Max) { out[c] = s[c] > d[c] ? s[c] : d[c]; continue; }
    const float a = s[c] * factor(BlendFactor(c == 3 ? key.blend_source_alpha : key.blend_source_rgb));
    const float b = d[c] * factor(BlendFactor(c == 3 ? key.blend_destination_alpha : key.blend_destination_rgb));
    out[c] = equation == BlendEquation::Subtract ? a - b : equation == BlendEquation::ReverseSubtract ? b - a : a + b;
  }
}

SOFTGL_INLINE uint16_t unorm_16(float v) {
  const float c = v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f;
  return uint16_t(_mm_cvtss_si32(_mm_set_ss(c * 65535.0f)));
}

/// One pixel of a 16-bit or float surface.
static void store_wide(const FragmentProgram& program, ColorFormat format, const float source[4], void* color, size_t pixel) {
  const FragmentKey& key = program.key;
  float s[4] = {source[0], source[1], source[2], source[3]}, d[4], out[4];
  uint16_t* narrow = static_cast<uint16_t*>(color) + 4 * pixel;
  float* wide = static_cast<float*>(color) + 4 * pixel;
  if (format == ColorFormat::Rgba16) {
    for (int c = 0; c < 4; ++c) {
      s[c] = s[c] > 0.0f ? (s[c] < 1.0f ? s[c] : 1.0f) : 0.0f;
      d[c] = float(narrow[c]) * (1.0f / 65535.0f);
    }
  } else {
    for (int c = 0; c < 4; ++c) d[c] = wide[c];
  }
  if (key.blend) blend_float(key, *program.constants, s, d, out);
  else for (int c = 0; c < 4; ++c) out[c] = s[c];
  for (int c = 0; c < 4; ++c) {
    if (!(key.color_mask >> c & 1)) continue;
    if (format == ColorFormat::Rgba16) {
      uint16_t v = unorm_16(out[c]);
      if (key.logic_op) {
        const uint16_t t = narrow[c];
        const unsigned op = unsigned(key.blend_source_rgb);
        const uint16_t table[16] = {0, uint16_t(v & t), uint16_t(v & ~t), v, uint16_t(~v & t), t, uint16_t(v ^ t), uint16_t(v | t),
                                    uint16_t(~(v | t)), uint16_t(~(v ^ t)), uint16_t(~t), uint16_t(v | ~t), uint16_t(~v),
                                    uint16_t(~v | t), uint16_t(~(v & t)), 0xffff};
        v = table[op];
      }
      narrow[c] = v;
    } else {
      wide[c] = out[c];
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
