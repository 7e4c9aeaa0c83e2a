// Position: object to clip to window coordinates, the clip mask, eye position and normal
// (GL 1.5, 2.11, 2.12), in the operation order of OSMesa 22.3.6 without FMA.
#pragma once

#include "shaders/common/lighting.inl"
#include "shaders/vertex/vertex_block.h"

namespace softgl {
namespace SOFTGL_ISA {

/// ((x*col0 + y*col1) + z*col2) + w*col3.
static inline void transform_points(const float (*in)[kLanes], const float* m, float (*out)[kLanes], int n) {
  const float *x = in[0], *y = in[1], *z = in[2], *w = in[3];
  for (int r = 0; r < 4; ++r) {
    const float a = m[r], b = m[4 + r], c = m[8 + r], d = m[12 + r];
    float* o = out[r];
    SOFTGL_FOR_LANES(i, n) o[i] = ((x[i] * a + y[i] * b) + z[i] * c) + w[i] * d;
  }
}

/// A plane's dot product as llvmpipe expands DP4: ((w + z) + y) + x.
static inline void dot4_lanes(const float (*in)[kLanes], float px, float py, float pz, float pw, float* out,
                              int n) {
  const float *x = in[0], *y = in[1], *z = in[2], *w = in[3];
  SOFTGL_FOR_LANES(i, n) out[i] = ((w[i] * pw + z[i] * pz) + y[i] * py) + x[i] * px;
}

static inline void normalize_lanes(const float (*in)[kLanes], float (*out)[kLanes], int n) {
  SOFTGL_FOR_LANES(i, n) {
    const float x = in[0][i], y = in[1][i], z = in[2][i];
    const float r = reciprocal_root(dot3(x, y, z, x, y, z));
    out[0][i] = x * r;
    out[1][i] = y * r;
    out[2][i] = z * r;
  }
}

static inline void transform_normals(VertexBlock& b, const VertexProgram& p, int n) {
  float(*normal)[kLanes] = b.lighting.normal;
  const TransformConstants& k = *p.transform;
  if (p.normal_to_eye) {
    const float m00 = k.normal_matrix[0][0], m01 = k.normal_matrix[0][1], m02 = k.normal_matrix[0][2];
    const float m10 = k.normal_matrix[1][0], m11 = k.normal_matrix[1][1], m12 = k.normal_matrix[1][2];
    const float m20 = k.normal_matrix[2][0], m21 = k.normal_matrix[2][1], m22 = k.normal_matrix[2][2];
    SOFTGL_FOR_LANES(i, n) {
      const float x = normal[0][i], y = normal[1][i], z = normal[2][i];
      normal[0][i] = dot3(x, y, z, m00, m01, m02);
      normal[1][i] = dot3(x, y, z, m10, m11, m12);
      normal[2][i] = dot3(x, y, z, m20, m21, m22);
    }
  }
  if (p.unit_normal) {
    unit_lanes(normal, normal, n);
  } else if (p.normalize && !SOFTGL_FAULT(normalize_ignored)) {
    normalize_lanes(normal, normal, n);
  } else if (k.normal_scale != 1.0f) {
    const float scale = k.normal_scale;
    for (int c = 0; c < 3; ++c) SOFTGL_FOR_LANES(i, n) normal[c][i] = normal[c][i] * scale;
  }
}

/// Bits of violated planes; a coordinate that is not a number is outside.
static inline void clip_masks(VertexBlock& b, const VertexProgram& p, int n) {
  const ClipPlaneConstants* planes = p.clip_planes;
  const int32_t clipped = p.depth_clamp ? ~(kClipNear | kClipFar) : ~0;
  const float *x = b.clip[0], *y = b.clip[1], *z = b.clip[2], *w = b.clip[3];
  int32_t* mask = b.mask;
  SOFTGL_FOR_LANES(i, n) {
    mask[i] = ((~mask_of(x[i] <= w[i]) & kClipRight) | (~mask_of(x[i] + w[i] >= 0.0f) & kClipLeft) |
               (~mask_of(y[i] <= w[i]) & kClipTop) | (~mask_of(y[i] + w[i] >= 0.0f) & kClipBottom) |
               (SOFTGL_FAULT(near_plane_at_eye) ? ~mask_of(w[i] >= 0.0f) & kClipNear
                                                : ~mask_of(z[i] + w[i] >= 0.0f) & kClipNear) |
               (~mask_of(z[i] <= w[i]) & kClipFar)) &
              clipped;
  }
  if (p.depths_from_zero && !p.depth_clamp)
    SOFTGL_FOR_LANES(i, n) mask[i] = (mask[i] & ~kClipNear) | (~mask_of(z[i] >= 0.0f) & kClipNear);
  if (!planes) return;
  for (int j = 0; j < planes->count; ++j) {
    const float px = planes->plane[j][0], py = planes->plane[j][1], pz = planes->plane[j][2],
                pw = planes->plane[j][3];
    const int32_t bit = kClipUser0 << planes->index[j];
    SOFTGL_FOR_LANES(i, n) {
      const float distance = pw * w[i] + (pz * z[i] + (py * y[i] + px * x[i]));
      mask[i] |= ~mask_of(distance >= 0.0f) & bit;
    }
  }
}

/// Window coordinates, y down, and 1/w.
static inline void window_positions(VertexBlock& b, const TransformConstants& k, int n) {
  const float *x = b.clip[0], *y = b.clip[1], *z = b.clip[2], *w = b.clip[3];
  const float sx = k.window_scale[0], sy = k.window_scale[1], sz = k.window_scale[2];
  const float tx = k.window_offset[0], ty = k.window_offset[1], tz = k.window_offset[2];
  SOFTGL_FOR_LANES(i, n) {
    const float oow = 1.0f / w[i];
    b.window[0][i] = (x[i] * oow) * sx + tx;
    b.window[1][i] = (y[i] * oow) * sy + ty;
    b.window[2][i] = (z[i] * oow) * sz + tz;
    b.window[3][i] = oow;
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
