// Constants of lights and materials (GL 1.5, 2.14.1), rounded where OSMesa rounds them.
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "base/trigonometry.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

void normalize(float v[3]) {
  const float length2 = (v[0] * v[0] + v[1] * v[1]) + v[2] * v[2];
  if (length2 == 0) return;
  const float scale = 1.0f / std::sqrt(length2);
  for (int i = 0; i < 3; ++i) v[i] *= scale;
}

void copy3(float out[3], const float* in) {
  for (int i = 0; i < 3; ++i) out[i] = in[i];
}
/// A color of a term; black where the term is left out.
void copy_term(float out[3], const Vec4& in, const LightingState& lighting, uint32_t term) {
  for (int i = 0; i < 3; ++i) out[i] = lighting.terms & term ? in[i] : 0.0f;
}

/// Position, half vector and cone of a light, in eye or object space. `whole_cone`: its border belongs to it,
/// which OSMesa leaves out.
void place_light(LightConstants& k, const Light& light, const Matrix& modelview, bool eye_space,
                 bool whole_cone) {
  float position[4];
  const float* m = modelview.data();
  if (eye_space) {
    std::memcpy(position, &light.position, sizeof position);
  } else {
    const float* inverted = &modelview.inverted[0][0];
    const Vec4 p = light.position;
    for (int i = 0; i < 4; ++i)
      position[i] =
          ((inverted[i] * p.x + inverted[4 + i] * p.y) + inverted[8 + i] * p.z) + inverted[12 + i] * p.w;
  }
  k.positional = light.position.w != 0;
  copy3(k.position, position);
  if (k.positional) {
    const float scale = 1.0f / position[3];
    for (float& p : k.position) p *= SOFTGL_FAULT(position_not_divided) ? 1.0f : scale;
  } else {
    if (!SOFTGL_FAULT(direction_not_unit)) normalize(k.position);
    for (int i = 0; i < 3; ++i) {
      // The eye's z axis; in object space a row of the modelview.
      const float z_axis = eye_space ? (i == 2 ? 1.0f : 0.0f) : m[4 * i + 2];
      k.half_vector[i] = k.position[i] + (SOFTGL_FAULT(infinite_half_is_light) ? 0.0f : z_axis);
    }
    if (!SOFTGL_FAULT(infinite_half_not_unit)) normalize(k.half_vector);
  }
  k.attenuated =
      light.constant_attenuation != 1 || light.linear_attenuation != 0 || light.quadratic_attenuation != 0;
  k.attenuation[0] = light.constant_attenuation;
  k.attenuation[1] = light.linear_attenuation;
  k.attenuation[2] = light.quadratic_attenuation;
  if (SOFTGL_FAULT(constant_attenuation_forgotten)) k.attenuation[0] = 0;
  if (SOFTGL_FAULT(distance_squared)) k.attenuation[2] += k.attenuation[1], k.attenuation[1] = 0;
  k.spot = light.spot_cutoff != 180 && !(SOFTGL_FAULT(cutoff_90_is_none) && light.spot_cutoff == 90);
  if (k.spot) { // implies eye space
    copy3(k.spot_direction, &light.spot_direction[0]);
    if (!SOFTGL_FAULT(spot_direction_not_unit)) normalize(k.spot_direction);
    if (!SOFTGL_FAULT(spot_direction_not_unit)) normalize(k.spot_direction); // twice, as OSMesa
    const double degrees = double(light.spot_cutoff) / (SOFTGL_FAULT(cutoff_is_whole_angle) ? 2 : 1);
    const float cosine_of_cutoff = cosine(float(degrees * M_PI / 180.0));
    k.spot_cosine = cosine_of_cutoff < 0 ? 0 : cosine_of_cutoff;
    // Kernels compare with "greater".
    if (whole_cone) k.spot_cosine = k.spot_cosine > 0 ? std::nextafter(k.spot_cosine, 0.0f) : -FLT_MIN;
    k.spot_exponent = light.spot_exponent;
  }
}

/// Does glColorMaterial's parameter include this material parameter?
bool tracks(GLenum color_material, int parameter) {
  switch (color_material) {
  case GL_AMBIENT: return parameter == kMaterialAmbient;
  case GL_DIFFUSE: return parameter == kMaterialDiffuse;
  case GL_SPECULAR: return parameter == kMaterialSpecular;
  case GL_EMISSION: return parameter == kMaterialEmission;
  default: return parameter == kMaterialAmbient || parameter == kMaterialDiffuse;
  }
}

bool is_tracked(const LightingState& l, int parameter, int face) {
  if (!l.color_material_enabled || !tracks(l.color_material_parameter, parameter)) return false;
  if (SOFTGL_FAULT(color_material_ignored) || (SOFTGL_FAULT(color_material_one_face) && face == 1))
    return false;
  return l.color_material_face == GL_FRONT_AND_BACK || (l.color_material_face == GL_FRONT) == (face == 0);
}

} // namespace

void find_material_sources(const Context& c, uint32_t present, int8_t source[5][2]) {
  const LightingState& l = c.state.lighting;
  // What a term that is left out would read need not be fetched; alpha is the diffuse material's in any case.
  const bool wanted[5] = {
      (l.terms & GL_AMBIENT_TERM_BIT_SOFTGL) != 0, true, (l.terms & GL_SPECULAR_TERM_BIT_SOFTGL) != 0,
      (l.terms & GL_EMISSION_TERM_BIT_SOFTGL) != 0, (l.terms & GL_SPECULAR_TERM_BIT_SOFTGL) != 0};
  for (int parameter = 0; parameter < kMaterialParameters; ++parameter)
    for (int face = 0; face < 2; ++face) {
      const int slot = material_slot(MaterialParameter(parameter), face);
      int from = -1;
      if (is_tracked(l, parameter, face))
        from = present >> kColor & 1 ? kColor : -1;
      else if (present >> slot & 1)
        from = slot;
      source[parameter][face] = int8_t(wanted[parameter] ? from : -1);
    }
}

const LightingConstants* make_lighting(const Context& c, const int8_t source[5][2], const float color[4],
                                       bool eye_space, bool for_fragments, Arena& arena) {
  const LightingState& l = c.state.lighting;
  int enabled = 0;
  for (const Light& light : l.light) enabled += light.enabled;
  // Only the enabled lights take memory.
  void* memory =
      arena.allocate(offsetof(LightingConstants, light) + size_t(enabled) * sizeof(LightConstants));
  auto& k = *static_cast<LightingConstants*>(memory);
  k.two_sided = l.two_side;
  k.separate_specular = l.color_control == GL_SEPARATE_SPECULAR_COLOR;
  k.local_viewer = l.local_viewer;
  k.for_fragments = for_fragments;
  k.zero_powers = for_fragments || c.specification_answers;
  k.light_count = enabled;
  std::memcpy(k.material_source, source, sizeof k.material_source);
  k.reflection = l.specular_vector == GL_REFLECTION_VECTOR_SOFTGL;
  copy_term(k.model_ambient, l.model_ambient, l, GL_AMBIENT_TERM_BIT_SOFTGL);

  for (int face = 0; face < 2; ++face) {
    k.varies[face] = false;
    for (int parameter = 0; parameter < kMaterialParameters; ++parameter) {
      const float* value = &c.state.current.slot[material_slot(MaterialParameter(parameter), face)][0];
      std::memcpy(k.material[parameter][face], is_tracked(l, parameter, face) ? color : value,
                  sizeof(float[4]));
      if (parameter != kMaterialShininess) k.varies[face] |= source[parameter][face] >= 0;
    }
    if (!(l.terms & GL_EMISSION_TERM_BIT_SOFTGL))
      std::memset(k.material[kMaterialEmission][face], 0, sizeof(float[4]));
    for (int i = 0; i < 3; ++i)
      k.scene[face][i] =
          k.model_ambient[i] *
              (SOFTGL_FAULT(scene_without_material) ? 1 : k.material[kMaterialAmbient][face][i]) +
          (SOFTGL_FAULT(emission_forgotten) ? 0 : k.material[kMaterialEmission][face][i]);
    k.scene[face][3] = k.material[kMaterialDiffuse][face][3];
  }
  auto shines = [&](int face) {
    return source[kMaterialShininess][face] >= 0 || k.material[kMaterialShininess][face][0] != 0;
  };
  // The reflection vector has no rule of its own for it: (v.r)^0 is 1.
  k.shininess_zero = !shines(0) && !(k.two_sided && shines(1)) && !k.reflection;

  LightConstants* out = k.light;
  for (const Light& light : l.light) {
    if (!light.enabled) continue;
    if (SOFTGL_FAULT(last_light_forgotten) && &light == &l.light[kMaxLights - 1]) continue;
    place_light(*out, light, c.matrices.modelview.top(), eye_space, c.specification_answers);
    copy_term(out->ambient, light.ambient, l, GL_AMBIENT_TERM_BIT_SOFTGL);
    copy_term(out->diffuse, light.diffuse, l, GL_DIFFUSE_TERM_BIT_SOFTGL);
    copy_term(out->specular, light.specular, l, GL_SPECULAR_TERM_BIT_SOFTGL);
    if (SOFTGL_FAULT(light_ambient_forgotten)) out->ambient[0] = out->ambient[1] = out->ambient[2] = 0;
    if (SOFTGL_FAULT(light_diffuse_of_ambient)) copy3(out->diffuse, out->ambient);
    if (SOFTGL_FAULT(attenuated_at_infinity) && !out->positional)
      for (int i = 0; i < 3; ++i) out->diffuse[i] /= light.constant_attenuation;
    for (int face = 0; face <= int(k.two_sided); ++face)
      for (int i = 0; i < 3; ++i) {
        const int from = SOFTGL_FAULT(back_terms_of_front) ? 0 : face;
        const int shiny = SOFTGL_FAULT(specular_of_diffuse) ? kMaterialDiffuse : kMaterialSpecular;
        out->ambient_product[face][i] = out->ambient[i] * k.material[kMaterialAmbient][from][i];
        out->diffuse_product[face][i] = out->diffuse[i] * k.material[kMaterialDiffuse][from][i];
        out->specular_product[face][i] = out->specular[i] * k.material[shiny][from][i];
      }
    ++out;
  }
  if (SOFTGL_FAULT(last_light_forgotten)) k.light_count = int(out - k.light);
  return &k;
}

} // namespace softgl
