// Directions of lighting (GL 1.5, 2.14.1): from a vertex or fragment to a light, the attenuation by distance
// and spot cone, and the half vector.
#pragma once

#include "shaders/common/exp_log.inl"
#include "shaders/common/lighting.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace SOFTGL_ISA {

#define SOFTGL_FOR_LANES(i, n) _Pragma("GCC ivdep") for (int i = 0; i < (n); ++i)

static inline __attribute__((always_inline)) float dot3(float ax, float ay, float az, float bx, float by,
                                                        float bz) {
  return (az * bz + ay * by) + ax * bx;
}

/// v / |v|. A vector whose squared length is not a positive finite number has no direction and becomes zero:
/// the zero vector, what is not finite, and what lies beyond 1e-19 and 1.8e19, where squares leave the range
/// of a float.
static inline void unit_lanes(const float (*in)[kLanes], float (*out)[kLanes], int n) {
  SOFTGL_FOR_LANES(i, n) {
    const float x = in[0][i], y = in[1][i], z = in[2][i];
    const float length2 = dot3(x, y, z, x, y, z);
    const int32_t directed = mask_of(length2 > 0.0f) & mask_of(length2 < bits_float(0x7f800000));
    const float r = reciprocal_root(length2);
    out[0][i] = keep(directed, x * r);
    out[1][i] = keep(directed, y * r);
    out[2][i] = keep(directed, z * r);
  }
}

/// Vector to a positional light, and the distance attenuation 1/(k0 + k1 d + k2 d^2).
static inline void light_positional_vector(LightingBlock& b, const LightConstants& l, int n) {
  const float px = l.position[0], py = l.position[1], pz = l.position[2];
  float *vx = b.light_vector[0], *vy = b.light_vector[1], *vz = b.light_vector[2];
  const float *ex = b.eye[0], *ey = b.eye[1], *ez = b.eye[2];
  float* att = b.attenuation;
  if (l.attenuated) {
    const float k0 = l.attenuation[0], k1 = l.attenuation[1], k2 = l.attenuation[2];
    SOFTGL_FOR_LANES(i, n) {
      const float x = px - ex[i], y = py - ey[i], z = pz - ez[i];
      const float d2 = dot3(x, y, z, x, y, z);
      const float d = __builtin_sqrtf(d2), r = 1.0f / d;
      vx[i] = x * r;
      vy[i] = y * r;
      vz[i] = z * r;
      att[i] = 1.0f / ((k2 * d2 + k1 * d) + k0 * (r * d));
    }
  } else {
    SOFTGL_FOR_LANES(i, n) {
      const float x = px - ex[i], y = py - ey[i], z = pz - ez[i];
      const float r = reciprocal_root(dot3(x, y, z, x, y, z));
      vx[i] = x * r;
      vy[i] = y * r;
      vz[i] = z * r;
    }
  }
}

/// The same for fragments, which have no bytes of OSMesa's to match, only a color to give: a light that is
/// at the fragment itself, or not a finite way off, shines from nowhere (unit_lanes) and leaves its ambient
/// term. Without a constant part in the attenuation that would be infinite; the limit keeps products with any
/// color finite, and saturates any that is not black.
static inline void light_fragment_vector(LightingBlock& b, const LightConstants& l, int n) {
  constexpr float kBrightest = 1e18f, kFarthest2 = 3e38f;
  const float *ex = b.eye[0], *ey = b.eye[1], *ez = b.eye[2];
  float(*v)[kLanes] = b.light_vector;
  const float px = l.position[0], py = l.position[1], pz = l.position[2];
  SOFTGL_FOR_LANES(i, n) {
    v[0][i] = px - ex[i];
    v[1][i] = py - ey[i];
    v[2][i] = pz - ez[i];
  }
  if (l.attenuated) {
    const float k0 = l.attenuation[0], k1 = l.attenuation[1], k2 = l.attenuation[2];
    float* att = b.attenuation;
    SOFTGL_FOR_LANES(i, n) {
      const float x = v[0][i], y = v[1][i], z = v[2][i];
      const float d2 = minimum(dot3(x, y, z, x, y, z), kFarthest2);
      att[i] = minimum(1.0f / ((k2 * d2 + k1 * __builtin_sqrtf(d2)) + k0), kBrightest);
    }
  }
  unit_lanes(v, v, n);
}

static inline void light_directional_vector(LightingBlock& b, const LightConstants& l, int n) {
  for (int c = 0; c < 3; ++c) {
    const float v = l.position[c];
    float* out = b.light_vector[c];
    SOFTGL_FOR_LANES(i, n) out[i] = v;
  }
}

/// Attenuation by the spot cone; multiplies the distance attenuation where there is one. `power`: of the
/// cosine.
template <class Power>
static inline void light_spot(LightingBlock& b, const LightConstants& l, Power power, int n) {
  const float sx = l.spot_direction[0], sy = l.spot_direction[1], sz = l.spot_direction[2];
  const float cosine = l.spot_cosine;
  const int32_t outside = SOFTGL_FAULT(spot_test_inverted) ? -1 : 0,
                anywhere = SOFTGL_FAULT(spot_no_cutoff) ? -1 : 0;
  const float *vx = b.light_vector[0], *vy = b.light_vector[1], *vz = b.light_vector[2];
  float* att = b.attenuation;
  if (l.positional && l.attenuated && !SOFTGL_FAULT(spot_without_attenuation)) {
    SOFTGL_FOR_LANES(i, n) {
      const float s = dot3(-vx[i], -vy[i], -vz[i], sx, sy, sz);
      att[i] = att[i] * keep((mask_of(cosine < s) ^ outside) | anywhere, power(absolute(s)));
    }
  } else {
    SOFTGL_FOR_LANES(i, n) {
      const float s = dot3(-vx[i], -vy[i], -vz[i], sx, sy, sz);
      att[i] = keep((mask_of(cosine < s) ^ outside) | anywhere, power(absolute(s)));
    }
  }
}

static inline void light_spot(LightingBlock& b, const LightConstants& l, bool zero_powers, int n) {
  const float exponent = SOFTGL_FAULT(spot_exponent_ignored) ? 0.0f : l.spot_exponent;
  if (zero_powers && exponent == 0.0f)
    light_spot(
        b, l, [](float) { return 1.0f; }, n);
  else
    light_spot(
        b, l, [exponent](float s) __attribute__((always_inline)) { return pow_lane(s, exponent); }, n);
}

/// Half vector with a local viewer: nrm(L - nrm(eye)), or towards +z for a positional light seen from
/// infinity.
static inline void light_half_vector(LightingBlock& b, bool local_viewer, int n) {
  const float *vx = b.light_vector[0], *vy = b.light_vector[1], *vz = b.light_vector[2];
  float *hx = b.half_vector[0], *hy = b.half_vector[1], *hz = b.half_vector[2];
  if (local_viewer) {
    const float *ux = b.eye_unit[0], *uy = b.eye_unit[1], *uz = b.eye_unit[2];
    SOFTGL_FOR_LANES(i, n) {
      const float x = vx[i] - ux[i], y = vy[i] - uy[i], z = vz[i] - uz[i];
      const float r = SOFTGL_FAULT(local_half_not_unit) ? 1.0f : reciprocal_root(dot3(x, y, z, x, y, z));
      hx[i] = x * r;
      hy[i] = y * r;
      hz[i] = z * r;
    }
  } else {
    SOFTGL_FOR_LANES(i, n) {
      const float x = vx[i] + 0.0f, y = vy[i] + 0.0f, z = vz[i] + 1.0f;
      const float r = SOFTGL_FAULT(half_not_unit) ? 1.0f : reciprocal_root(dot3(x, y, z, x, y, z));
      hx[i] = x * r;
      hy[i] = y * r;
      hz[i] = z * r;
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
