// From vertex arrays (array of structures) to a block's lanes (structure of arrays). Float attributes go
// through 4x4 transposes of 16-byte loads: measured 0.47 ns a vertex for six floats on every instruction set,
// plain loops 0.6-0.9.
#pragma once

#include <string.h>
#include <xmmintrin.h>

#include "shaders/common/lane_math.h"
#include "shaders/vertex/component_conversion.h"
#include "shaders/vertex/vertex_block.h"

namespace softgl {
namespace SOFTGL_ISA {

static inline void broadcast(float value, float* out, int n) {
  for (int i = 0; i < n; ++i) out[i] = value;
}

/// Vertices below the result may be read with 16-byte loads without touching memory behind the array.
static inline uint32_t safe_end(const AttributeStream& s, uint32_t end) {
  const uint32_t behind = 16u - 4u * s.components;
  if (behind == 0) return end;
  if (s.stride == 0) return 0;
  const uint32_t slack = (behind + s.stride - 1) / s.stride;
  return end > slack ? end - slack : 0;
}

static inline void fetch_floats(const AttributeStream& s, uint32_t first, int count, uint32_t end, int wanted,
                                float (*out)[kLanes]) {
  const unsigned char* p = s.data + size_t(first) * s.stride;
  const size_t stride = s.stride;
  const uint32_t safe = safe_end(s, end);
  const int groups = (count + 3) / 4;
  for (int g = 0; g < groups; ++g, p += 4 * stride) {
    __m128 a, b, c, d;
    if (g * 4 + 4 <= count && first + uint32_t(g) * 4 + 3 < safe) {
      a = _mm_loadu_ps(reinterpret_cast<const float*>(p));
      b = _mm_loadu_ps(reinterpret_cast<const float*>(p + stride));
      c = _mm_loadu_ps(reinterpret_cast<const float*>(p + 2 * stride));
      d = _mm_loadu_ps(reinterpret_cast<const float*>(p + 3 * stride));
    } else {
      alignas(16) float t[4][4] = {};
      for (int i = 0; i < 4 && g * 4 + i < count; ++i)
        memcpy(t[i], p + size_t(i) * stride, 4u * s.components);
      a = _mm_load_ps(t[0]);
      b = _mm_load_ps(t[1]);
      c = _mm_load_ps(t[2]);
      d = _mm_load_ps(t[3]);
    }
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_store_ps(out[0] + 4 * g, a);
    if (wanted > 1) _mm_store_ps(out[1] + 4 * g, b);
    if (wanted > 2) _mm_store_ps(out[2] + 4 * g, c);
    if (wanted > 3) _mm_store_ps(out[3] + 4 * g, d);
  }
}

static inline void fetch_converted(const AttributeStream& s, uint32_t first, int count, int wanted,
                                   float (*out)[kLanes]) {
  const int components = s.components < wanted ? s.components : wanted;
  const unsigned char* p = s.data + size_t(first) * s.stride;
  if (s.type == ComponentType::UnsignedByte && s.normalized) {
    for (int i = 0; i < count; ++i, p += s.stride)
      for (int c = 0; c < components; ++c) out[c][i] = float(p[c]) * (1.0f / 255.0f);
    return;
  }
  for (int i = 0; i < count; ++i, p += s.stride)
    for (int c = 0; c < components; ++c) out[c][i] = convert_component(p, s.type, s.normalized, c);
}

/// Attribute `slot` of vertices [first, first + count) into out[0 .. wanted); n lanes are written.
static inline void fetch_attribute(const VertexJob& job, int slot, uint32_t first, int count, int n,
                                   int wanted, float (*out)[kLanes]) {
  if (!(job.present >> slot & 1)) {
    for (int c = 0; c < wanted; ++c) broadcast(job.constant[slot][c], out[c], n);
    return;
  }
  const AttributeStream& s = job.stream[slot];
  if (count < n)
    for (int c = 0; c < wanted; ++c) memset(out[c] + (count & ~3), 0, size_t(n - (count & ~3)) * 4);
  if (s.type == ComponentType::Float)
    fetch_floats(s, first, count, job.end, wanted, out);
  else
    fetch_converted(s, first, count, wanted, out);
  for (int c = s.components; c < wanted; ++c) broadcast(c == 3 ? 1.0f : 0.0f, out[c], n);
}

} // namespace SOFTGL_ISA
} // namespace softgl
