// Texture coordinates: generation and matrix (GL 1.5, 2.11.4), the fog coordinate and the point size.
#pragma once

#include <string.h>

#include "shaders/vertex/vertex_transform.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// z in eye coordinates, in the expression OSMesa has at hand: the eye position if an earlier stage made it.
static inline void eye_z(const VertexBlock& b, const VertexProgram& p, bool have_eye, float* out, int n) {
  if (have_eye) {
    SOFTGL_FOR_LANES(i, n) out[i] = b.lighting.eye[2][i];
    return;
  }
  const float* m = p.transform->modelview;
  dot4_lanes(b.position, m[2], m[6], m[10], m[14], out, n);
}

/// The fog coordinate |eye z|.
static inline void eye_depth(const VertexBlock& b, const VertexProgram& p, bool have_eye, float* out, int n) {
  eye_z(b, p, have_eye, out, n);
  SOFTGL_FOR_LANES(i, n) out[i] = absolute(out[i]);
}

/// The distance from the eye, whose position an earlier stage made.
static inline void eye_distance(const VertexBlock& b, float* out, int n) {
  const float *x = b.lighting.eye[0], *y = b.lighting.eye[1], *z = b.lighting.eye[2];
  SOFTGL_FOR_LANES(i, n) out[i] = __builtin_sqrtf(dot3(x[i], y[i], z[i], x[i], y[i], z[i]));
}

/// GL 1.5, 3.10, and GL_NV_fog_distance.
static inline void fog_distances(VertexBlock& b, const VertexProgram& p, int n) {
  float* out = b.fog;
  switch (p.fog_distance) {
  case FogDistance::PlaneAbsolute: return eye_depth(b, p, p.eye_position, out, n);
  case FogDistance::Plane: return eye_z(b, p, p.eye_position, out, n);
  case FogDistance::Radial: return eye_distance(b, out, n);
  }
}

/// r = u - 2 (n.u) n with u the normalized eye position; out[3] = rz + 1. Where rz is of no other use
/// (`z_is_read`: it is, in any unit), OSMesa's compiler adds the 1 first.
static inline void reflection(const VertexBlock& b, bool z_is_read, float (*out)[kLanes], int n) {
  const float(*u)[kLanes] = b.lighting.eye_unit;
  const float(*normal)[kLanes] = b.lighting.normal;
  SOFTGL_FOR_LANES(i, n) {
    const float d = dot3(normal[0][i], normal[1][i], normal[2][i], u[0][i], u[1][i], u[2][i]);
    const float d2 = d + d;
    out[0][i] = -d2 * normal[0][i] + u[0][i];
    out[1][i] = -d2 * normal[1][i] + u[1][i];
    out[2][i] = -d2 * normal[2][i] + u[2][i];
    out[3][i] = z_is_read ? out[2][i] + 1.0f : (-d2 * normal[2][i] + 1.0f) + u[2][i];
  }
}

static inline void generate_coordinates(VertexBlock& b, const CoordinateConstants& k, bool reflection_z,
                                        float (*coordinate)[kLanes], int n) {
  alignas(64) float r[4][kLanes];
  bool have_reflection = false;
  for (int c = 0; c < 4; ++c) {
    float* out = coordinate[c];
    const float* plane = k.plane[c];
    switch (k.mode[c]) {
    case TexGen::None: break;
    case TexGen::ObjectLinear: dot4_lanes(b.position, plane[0], plane[1], plane[2], plane[3], out, n); break;
    case TexGen::EyeLinear: dot4_lanes(b.lighting.eye, plane[0], plane[1], plane[2], plane[3], out, n); break;
    case TexGen::NormalMap:
      if (c < 3) memcpy(out, b.lighting.normal[c], sizeof(float) * size_t(n));
      break;
    case TexGen::SphereMap:
    case TexGen::ReflectionMap:
      if (!have_reflection) reflection(b, reflection_z, r, n);
      have_reflection = true;
      if (k.mode[c] == TexGen::ReflectionMap) {
        if (c < 3) memcpy(out, r[c], sizeof(float) * size_t(n));
      } else {
        const float* rc = r[c < 2 ? c : 0];
        SOFTGL_FOR_LANES(i, n) {
          const float x = r[0][i], y = r[1][i], z = r[3][i];
          out[i] = rc[i] * (reciprocal_root(dot3(x, y, z, x, y, z)) * 0.5f) + 0.5f;
        }
      }
      break;
    }
  }
  if (k.transform) {
    for (int c = 0; c < 4; ++c) memcpy(r[c], coordinate[c], sizeof(float) * size_t(n));
    transform_points(r, k.matrix, coordinate, n);
  }
}

/// size * rsq(a + d*(b + d*c)), d = |eye z| or the distance from the eye, clamped (GL 1.5, 3.3).
static inline void point_sizes(VertexBlock& b, const VertexProgram& p, bool have_eye, int n) {
  const PointConstants& k = p.point;
  float* size = b.point;
  if (!p.point_attenuated) {
    const float s = k.size;
    SOFTGL_FOR_LANES(i, n) size[i] = s;
    return;
  }
  if (p.from_eye)
    eye_distance(b, size, n);
  else
    eye_depth(b, p, have_eye, size, n);
  const float ka = k.attenuation[0], kb = k.attenuation[1], kc = k.attenuation[2];
  const float s = k.size, low = k.minimum, high = k.maximum;
  SOFTGL_FOR_LANES(i, n) {
    const float d = size[i];
    const float scaled = reciprocal_root(d * (d * kc + kb) + ka) * s;
    size[i] = minimum(maximum(scaled, low), high);
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
