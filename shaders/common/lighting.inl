// The lighting kernel (GL 1.5, 2.14.1) with the operation order of OSMesa 22.3.6's vertex program on llvmpipe
// without FMA: dot products are (z + y) + x, a light adds ambient, then diffuse, then specular, and nothing
// is clamped here. Stages are short loops on purpose: one loop per light costs 1.4 times as much (register
// pressure, long chains).
#pragma once

#include "shaders/common/lighting_vectors.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// The material parameters that vary; `lanes_of` gives the four components of a slot as lanes.
template <class LanesOf>
static inline MaterialLanes material_lanes(const LightingConstants& k, LanesOf lanes_of) {
  MaterialLanes lanes = {};
  for (int parameter = 0; parameter < kMaterialParameters; ++parameter)
    for (int face = 0; face <= int(k.two_sided); ++face) {
      const int slot = k.material_source[parameter][face];
      if (slot < 0) continue;
      const float(*from)[kLanes] = lanes_of(slot);
      for (int c = 0; c < 4; ++c) lanes.component[parameter][face][c] = from[c];
    }
  return lanes;
}

/// c = model ambient * ambient + emission, alpha of diffuse.
static inline void light_scene_color(LightingBlock& b, const LightingConstants& k, const MaterialLanes& lanes,
                                     int face, int n) {
  for (int c = 0; c < 3; ++c) {
    float* out = b.color[face][c];
    const float* ambient = lanes.component[kMaterialAmbient][face][c];
    const float* emission = lanes.component[kMaterialEmission][face][c];
    const float model = k.model_ambient[c];
    const float constant_ambient = k.material[kMaterialAmbient][face][c],
                constant_emission = k.material[kMaterialEmission][face][c];
    if (!ambient && !emission) {
      const float scene = k.scene[face][c];
      SOFTGL_FOR_LANES(i, n) out[i] = scene;
    } else if (!emission) {
      SOFTGL_FOR_LANES(i, n) out[i] = model * ambient[i] + constant_emission;
    } else if (!ambient) {
      SOFTGL_FOR_LANES(i, n) out[i] = model * constant_ambient + emission[i];
    } else {
      SOFTGL_FOR_LANES(i, n) out[i] = model * ambient[i] + emission[i];
    }
    if (k.separate_specular) {
      float* secondary = b.secondary[face][c];
      SOFTGL_FOR_LANES(i, n) secondary[i] = 0.0f;
    }
  }
  float* out = b.color[face][3];
  const float* alpha = lanes.component[kMaterialDiffuse][face][3];
  if (alpha) {
    SOFTGL_FOR_LANES(i, n) out[i] = alpha[i];
  } else {
    const float constant =
        k.material[SOFTGL_FAULT(alpha_of_ambient) ? kMaterialAmbient : kMaterialDiffuse][face][3];
    SOFTGL_FOR_LANES(i, n) out[i] = constant;
  }
}

/// diffuse[0] = n.L (not clamped yet), specular[0] = n.h where it is wanted.
static inline void light_dots(LightingBlock& b, const LightConstants& l, bool infinite_half, bool highlight,
                              int n) {
  const float *nx = b.normal[0], *ny = b.normal[1], *nz = b.normal[2];
  float* nl = b.diffuse[0];
  if (l.positional) {
    const float *vx = b.light_vector[0], *vy = b.light_vector[1], *vz = b.light_vector[2];
    SOFTGL_FOR_LANES(i, n) nl[i] = dot3(nx[i], ny[i], nz[i], vx[i], vy[i], vz[i]);
  } else {
    const float x = l.position[0], y = l.position[1], z = l.position[2];
    SOFTGL_FOR_LANES(i, n) nl[i] = dot3(nx[i], ny[i], nz[i], x, y, z);
  }
  if (!highlight) return;
  float* nh = b.specular[0];
  if (infinite_half) {
    const float x = l.half_vector[0], y = l.half_vector[1], z = l.half_vector[2];
    SOFTGL_FOR_LANES(i, n) nh[i] = dot3(nx[i], ny[i], nz[i], x, y, z);
  } else {
    const float *hx = b.half_vector[0], *hy = b.half_vector[1], *hz = b.half_vector[2];
    SOFTGL_FOR_LANES(i, n) nh[i] = dot3(nx[i], ny[i], nz[i], hx[i], hy[i], hz[i]);
  }
}

/// The exponent zero where zero_powers is set: n.h = 0 gives 1, too, which pow_lane makes 0 as OSMesa does.
static inline void light_zero_exponents(LightingBlock& b, const LightingConstants& k,
                                        const MaterialLanes& lanes, int n) {
  const float* nl = b.diffuse[0];
  float* nh = b.specular[0];
  for (int face = 0; face <= int(k.two_sided); ++face) {
    const float *shininess = lanes.component[kMaterialShininess][face][0],
                constant = k.material[kMaterialShininess][face][0], one = face ? -1.0f : 1.0f;
    if (!shininess && constant != 0.0f) continue;
    SOFTGL_FOR_LANES(i, n) {
      const int32_t zero = mask_of((shininess ? shininess[i] : constant) == 0.0f),
                    lit = mask_of(nl[i] * one > 0.0f);
      nh[i] = select(zero & lit, one, nh[i]);
    }
  }
}

/// specular[0] = v.r of the front face, -v.r where the back face is lit, as n.h would be: r = 2 (n.s) n - s
/// is the vector s to the light mirrored at the unit normal, v points to the viewer. v.r is the same for n
/// and -n.
static inline void light_reflection(LightingBlock& b, bool local_viewer, int n) {
  const float *nx = b.normal[0], *ny = b.normal[1], *nz = b.normal[2];
  const float *sx = b.light_vector[0], *sy = b.light_vector[1], *sz = b.light_vector[2];
  const float *ux = b.eye_unit[0], *uy = b.eye_unit[1], *uz = b.eye_unit[2];
  const float* nl = b.diffuse[0];
  float* out = b.specular[0];
  if (local_viewer) { // v = -eye_unit
    SOFTGL_FOR_LANES(i, n) {
      const float nv = -dot3(nx[i], ny[i], nz[i], ux[i], uy[i], uz[i]),
                  sv = -dot3(sx[i], sy[i], sz[i], ux[i], uy[i], uz[i]);
      const float vr = 2.0f * nl[i] * nv - sv;
      out[i] = select(mask_of(nl[i] > 0.0f), vr, -vr);
    }
  } else { // v = (0, 0, 1)
    SOFTGL_FOR_LANES(i, n) {
      const float vr = 2.0f * nl[i] * nz[i] - sz[i];
      out[i] = select(mask_of(nl[i] > 0.0f), vr, -vr);
    }
  }
}

/// Specular factors from n.L and n.h. Front and back highlight are never both lit, so one power serves both.
static inline void light_highlight(LightingBlock& b, const LightingConstants& k, const MaterialLanes& lanes,
                                   int n) {
  const float* nl = b.diffuse[0];
  float *front = b.specular[0], *back = b.specular[1];
  const float* shininess[2] = {lanes.component[kMaterialShininess][0][0],
                               lanes.component[kMaterialShininess][1][0]};
  const float constant[2] = {
      k.material[kMaterialShininess][0][0],
      k.material[kMaterialShininess][SOFTGL_FAULT(back_shininess_of_front) ? 0 : 1][0]};
  const int32_t anywhere = SOFTGL_FAULT(highlight_behind) ? -1 : 0;
  if (!k.two_sided) {
    if (!shininess[0]) {
      const float e = constant[0];
      SOFTGL_FOR_LANES(i, n)
      front[i] = keep(~mask_of(0.0f >= nl[i]) | anywhere, pow_lane(maximum(front[i], 0.0f), e));
    } else {
      const float* e = shininess[0];
      SOFTGL_FOR_LANES(i, n)
      front[i] = keep(~mask_of(0.0f >= nl[i]), pow_lane(maximum(front[i], 0.0f), e[i]));
    }
    return;
  }
  if (!shininess[0] && !shininess[1]) {
    const float e0 = constant[0], e1 = constant[1];
    SOFTGL_FOR_LANES(i, n) {
      const int32_t lit = mask_of(nl[i] > 0.0f);
      const float power = pow_lane(maximum(select(lit, front[i], -front[i]), 0.0f), select(lit, e0, e1));
      front[i] = keep(~mask_of(0.0f >= nl[i]), power);
      back[i] = keep(~mask_of(nl[i] >= 0.0f), power);
    }
    return;
  }
  alignas(64) float e0[kLanes], e1[kLanes];
  SOFTGL_FOR_LANES(i, n) e0[i] = shininess[0] ? shininess[0][i] : constant[0];
  SOFTGL_FOR_LANES(i, n) e1[i] = shininess[1] ? shininess[1][i] : constant[1];
  SOFTGL_FOR_LANES(i, n) {
    const int32_t lit = mask_of(nl[i] > 0.0f);
    const float power = pow_lane(maximum(select(lit, front[i], -front[i]), 0.0f), select(lit, e0[i], e1[i]));
    front[i] = keep(~mask_of(0.0f >= nl[i]), power);
    back[i] = keep(~mask_of(nl[i] >= 0.0f), power);
  }
}

/// Exponent zero: 1 where the face is lit. With an attenuated light OSMesa raises the n.L to the power n.L
/// instead, where zero_powers is not set.
static inline void light_zero_highlight(LightingBlock& b, bool two_sided, bool attenuated, int n) {
  const float* nl = b.diffuse[0];
  float *front = b.specular[0], *back = b.specular[1];
  if (!attenuated) {
    const float one = SOFTGL_FAULT(zero_shininess_dark) ? 0.0f : 1.0f;
    SOFTGL_FOR_LANES(i, n) front[i] = keep(mask_of(0.0f < nl[i]), one);
    if (two_sided) SOFTGL_FOR_LANES(i, n) back[i] = keep(mask_of(nl[i] < 0.0f), 1.0f);
    return;
  }
  SOFTGL_FOR_LANES(i, n) {
    const float q = absolute(nl[i]);
    const float power = pow_lane(maximum(q, 0.0f), minimum(q, 128.0f));
    front[i] = keep(~mask_of(0.0f >= nl[i]), power);
    back[i] = keep(~mask_of(nl[i] >= 0.0f), power);
  }
}

/// diffuse[1] = max(-n.L, 0), diffuse[0] = max(n.L, 0), and both factors times the attenuation.
static inline void light_factors(LightingBlock& b, bool two_sided, bool attenuated, int n) {
  float *front = b.diffuse[0], *back = b.diffuse[1];
  const float* att = b.attenuation;
  if (SOFTGL_FAULT(diffuse_absolute)) SOFTGL_FOR_LANES(i, n) front[i] = absolute(front[i]);
  if (two_sided) SOFTGL_FOR_LANES(i, n) back[i] = maximum(-front[i], 0.0f);
  if (SOFTGL_FAULT(back_normal_not_turned)) SOFTGL_FOR_LANES(i, n) back[i] = maximum(front[i], 0.0f);
  SOFTGL_FOR_LANES(i, n) front[i] = maximum(front[i], 0.0f);
  if (!attenuated) return;
  for (int face = 0; face <= int(two_sided); ++face) {
    float *diffuse = b.diffuse[face], *specular = b.specular[face];
    if (!SOFTGL_FAULT(diffuse_not_attenuated)) SOFTGL_FOR_LANES(i, n) diffuse[i] = diffuse[i] * att[i];
    if (!SOFTGL_FAULT(specular_not_attenuated)) SOFTGL_FOR_LANES(i, n) specular[i] = specular[i] * att[i];
  }
}

/// Adds one light's three terms to a face's colors, material constant over the draw.
static inline void light_add_constant(LightingBlock& b, const LightingConstants& k, const LightConstants& l,
                                      int face, bool attenuated, int n) {
  const float *diffuse = b.diffuse[face], *specular = b.specular[face], *att = b.attenuation;
  for (int c = 0; c < 3; ++c) {
    float* color = b.color[face][c];
    const float amb = l.ambient_product[face][c], dif = l.diffuse_product[face][c],
                spe = l.specular_product[face][c];
    if (k.separate_specular) {
      float* secondary = b.secondary[face][c];
      if (attenuated) {
        SOFTGL_FOR_LANES(i, n) color[i] = diffuse[i] * dif + (att[i] * amb + color[i]);
      } else {
        SOFTGL_FOR_LANES(i, n) color[i] = diffuse[i] * dif + (amb + color[i]);
      }
      SOFTGL_FOR_LANES(i, n) secondary[i] = specular[i] * spe + secondary[i];
    } else if (attenuated) {
      SOFTGL_FOR_LANES(i, n) color[i] = specular[i] * spe + (diffuse[i] * dif + (att[i] * amb + color[i]));
    } else {
      SOFTGL_FOR_LANES(i, n) color[i] = specular[i] * spe + (diffuse[i] * dif + (amb + color[i]));
    }
  }
}

/// The same where some of the face's material parameters are lanes.
static inline void light_add_varying(LightingBlock& b, const LightingConstants& k, const MaterialLanes& lanes,
                                     const LightConstants& l, int face, bool attenuated, int n) {
  alignas(64) float amb[kLanes], dif[kLanes], spe[kLanes];
  const float *diffuse = b.diffuse[face], *specular = b.specular[face], *att = b.attenuation;
  for (int c = 0; c < 3; ++c) {
    const struct {
      const float* lane;
      float light, product;
      float* out;
    } term[3] = {
        {lanes.component[kMaterialAmbient][face][c], l.ambient[c], l.ambient_product[face][c], amb},
        {lanes.component[kMaterialDiffuse][face][c], l.diffuse[c], l.diffuse_product[face][c], dif},
        {lanes.component[kMaterialSpecular][face][c], l.specular[c], l.specular_product[face][c], spe}};
    for (const auto& t : term) {
      float* out = t.out;
      const float *lane = t.lane, light = t.light, product = t.product;
      if (lane) {
        SOFTGL_FOR_LANES(i, n) out[i] = light * lane[i];
      } else {
        SOFTGL_FOR_LANES(i, n) out[i] = product;
      }
    }
    float* color = b.color[face][c];
    if (attenuated) {
      SOFTGL_FOR_LANES(i, n) color[i] = att[i] * amb[i] + color[i];
    } else {
      SOFTGL_FOR_LANES(i, n) color[i] = amb[i] + color[i];
    }
    float* target = k.separate_specular ? b.secondary[face][c] : color;
    SOFTGL_FOR_LANES(i, n) color[i] = diffuse[i] * dif[i] + color[i];
    SOFTGL_FOR_LANES(i, n) target[i] = specular[i] * spe[i] + target[i];
  }
}

/// Lights the block: b.color and b.secondary from b.normal, b.eye, b.eye_unit and the material.
static inline void light_block(LightingBlock& b, const LightingConstants& k, const MaterialLanes& lanes) {
  const int n = b.lanes & ~(kStripLanes - 1);
  const bool two_sided = k.two_sided, shininess_zero = k.shininess_zero;
  for (int face = 0; face <= int(two_sided); ++face) light_scene_color(b, k, lanes, face, n);
  for (int j = 0; j < k.light_count; ++j) {
    const LightConstants& l = k.light[j];
    const bool attenuated = l.spot || (l.positional && l.attenuated);
    const bool infinite_half = !l.positional && !k.local_viewer;
    if (l.positional)
      (k.for_fragments ? light_fragment_vector : light_positional_vector)(b, l, n);
    else if (l.spot || k.local_viewer || k.reflection)
      light_directional_vector(b, l, n);
    if (l.spot) light_spot(b, l, k.zero_powers, n);
    const bool half = !shininess_zero && !k.reflection;
    if (half && !infinite_half) light_half_vector(b, k.local_viewer, n);
    light_dots(b, l, infinite_half, half, n);
    if (k.reflection) light_reflection(b, k.local_viewer, n);
    if (shininess_zero) {
      light_zero_highlight(b, two_sided, attenuated && !k.zero_powers, n);
    } else {
      if (k.zero_powers && !k.reflection) light_zero_exponents(b, k, lanes, n);
      light_highlight(b, k, lanes, n);
    }
    light_factors(b, two_sided, attenuated, n);
    const bool weakens = attenuated && !SOFTGL_FAULT(ambient_not_attenuated);
    if (SOFTGL_FAULT(last_light_wins) && j > 0)
      for (int face = 0; face <= int(two_sided); ++face) light_scene_color(b, k, lanes, face, n);
    for (int face = 0; face <= int(two_sided); ++face) {
      if (k.varies[face])
        light_add_varying(b, k, lanes, l, face, weakens, n);
      else
        light_add_constant(b, k, l, face, weakens, n);
    }
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
