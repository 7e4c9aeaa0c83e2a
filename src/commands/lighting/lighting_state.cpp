// Lights, light model, material, color material and shade model (GL 1.5, 2.14), and the queries of them
// (6.1.3).
#include "commands/lighting/color_material.h"
#include "commands/vertices/vertex_stream.h"

#include "commands/generated/commands.h"
#include "commands/get_conversion.h"
#include "commands/vertices/attribute_doors.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {

uint32_t material_slots(GLenum face, GLenum parameter) {
  uint32_t parameters = 0; // bit i = MaterialParameter i
  switch (parameter) {
  case GL_AMBIENT: parameters = 1u << kMaterialAmbient; break;
  case GL_DIFFUSE: parameters = 1u << kMaterialDiffuse; break;
  case GL_SPECULAR: parameters = 1u << kMaterialSpecular; break;
  case GL_EMISSION:
    parameters = 1u << (SOFTGL_FAULT(emission_is_ambient) ? kMaterialAmbient : kMaterialEmission);
    break;
  case GL_SHININESS: parameters = 1u << kMaterialShininess; break;
  case GL_AMBIENT_AND_DIFFUSE:
    parameters = 1u << kMaterialAmbient;
    if (!SOFTGL_FAULT(ambient_and_diffuse_is_ambient)) parameters |= 1u << kMaterialDiffuse;
    break;
  default: return 0;
  }
  uint32_t front = 0;
  for (int i = 0; i < kMaterialSlots / 2; ++i)
    if (parameters >> i & 1) front |= 1u << (material_slot(MaterialParameter(i), 0) - kMaterial0);
  switch (face) {
  case GL_FRONT: return front;
  case GL_BACK: return SOFTGL_FAULT(back_material_is_front) ? front : front << 1;
  case GL_FRONT_AND_BACK: return SOFTGL_FAULT(both_faces_front_only) ? front : front | front << 1;
  default: return 0;
  }
}

void track_color_material(Context& c) {
  const uint32_t slots = tracked_material_slots(c.state.lighting);
  if (slots == 0 || SOFTGL_FAULT(tracked_color_lost)) return;
  Vec4* slot = c.state.current.slot;
  for (int i = 0; i < kMaterialSlots; ++i)
    if (slots >> i & 1) slot[kMaterial0 + i] = slot[kColor];
  c.dirty |= kDirtyMaterial | kDirtyCurrent;
}

namespace gl {
namespace {

softgl::Light* find_light(Context& c, GLenum light) {
  const GLenum i = light - GL_LIGHT0;
  if (i < GLenum(kMaxLights)) return &c.state.lighting.light[i];
  set_error(c, GL_INVALID_ENUM, "light");
  return nullptr;
}

/// The argument that leaves no material to set or to get.
const char* wrong_material_argument(GLenum face) {
  return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK ? "pname" : "face";
}

Vec4 vector4(const float* v) { return {v[0], v[1], v[2], v[3]}; }

// A light parameter's address and how GetLightiv converts it; null for an unknown one.
struct LightParameter {
  const float* values = nullptr;
  int count = 0;
  Conversion conversion = Conversion::Float;
};
LightParameter light_parameter(const softgl::Light& light, GLenum pname) {
  switch (pname) {
  case GL_AMBIENT: return {&light.ambient.x, 4, Conversion::Normal};
  case GL_DIFFUSE: return {&light.diffuse.x, 4, Conversion::Normal};
  case GL_SPECULAR: return {&light.specular.x, 4, Conversion::Normal};
  case GL_POSITION: return {&light.position.x, 4};
  case GL_SPOT_DIRECTION: return {&light.spot_direction.x, 3};
  case GL_SPOT_EXPONENT: return {&light.spot_exponent, 1};
  case GL_SPOT_CUTOFF: return {&light.spot_cutoff, 1};
  case GL_CONSTANT_ATTENUATION: return {&light.constant_attenuation, 1};
  case GL_LINEAR_ATTENUATION: return {&light.linear_attenuation, 1};
  case GL_QUADRATIC_ATTENUATION: return {&light.quadratic_attenuation, 1};
  default: return {};
  }
}

} // namespace

void Light(Context& c, GLenum name, GLenum pname, const float* params) {
  softgl::Light* light = find_light(c, name);
  if (!light) return;
  const float v = params[0];
  switch (pname) {
  case GL_AMBIENT: light->ambient = vector4(params); break;
  case GL_DIFFUSE: light->diffuse = vector4(params); break;
  case GL_SPECULAR: light->specular = vector4(params); break;
  case GL_POSITION: {
    const float* m = c.matrices.modelview.top().data();
    for (int i = 0; i < 4; ++i)
      light->position[i] = m[i] * params[0] + m[4 + i] * params[1] + m[8 + i] * params[2] +
                           m[12 + i] * (SOFTGL_FAULT(direction_translated) ? 1.0f : params[3]);
    if (SOFTGL_FAULT(direction_translated)) light->position.w = params[3];
    if (SOFTGL_FAULT(position_not_transformed)) light->position = vector4(params);
    break;
  }
  case GL_SPOT_DIRECTION: {
    Matrix& modelview = c.matrices.modelview.top();
    settle_history(modelview);
    const float* m = modelview.data();
    for (int i = 0; i < 3; ++i)
      light->spot_direction[i] = params[0] * m[i] + params[1] * m[4 + i] + params[2] * m[8 + i];
    for (int i = 0; i < 3 && SOFTGL_FAULT(spot_direction_not_transformed); ++i)
      light->spot_direction[i] = params[i];
    for (int i = 0; i < 3 && SOFTGL_FAULT(spot_direction_translated); ++i)
      light->spot_direction[i] += m[12 + i];
    break;
  }
  case GL_SPOT_EXPONENT:
    if (v < 0.0f || v > 128.0f) return set_error(c, GL_INVALID_VALUE, "params");
    if (!SOFTGL_FAULT(spot_exponent_not_stored)) light->spot_exponent = v;
    break;
  case GL_SPOT_CUTOFF:
    if ((v < 0.0f || v > 90.0f) && v != 180.0f) return set_error(c, GL_INVALID_VALUE, "params");
    light->spot_cutoff = v;
    break;
  case GL_CONSTANT_ATTENUATION:
  case GL_LINEAR_ATTENUATION:
  case GL_QUADRATIC_ATTENUATION:
    if (v < 0.0f) return set_error(c, GL_INVALID_VALUE, "params");
    (pname == GL_CONSTANT_ATTENUATION                                      ? light->constant_attenuation
     : pname == GL_LINEAR_ATTENUATION || SOFTGL_FAULT(quadratic_is_linear) ? light->linear_attenuation
                                                                           : light->quadratic_attenuation) =
        v;
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  c.dirty |= kDirtyLights;
}

void GetLightfv(Context& c, GLenum name, GLenum pname, float* params) {
  const softgl::Light* light = find_light(c, name);
  if (!light) return;
  const LightParameter p = light_parameter(*light, pname);
  if (p.count == 0) return set_error(c, GL_INVALID_ENUM, "pname");
  for (int i = 0; i < p.count; ++i) params[i] = p.values[i];
}

void GetLightiv(Context& c, GLenum name, GLenum pname, GLint* params) {
  const softgl::Light* light = find_light(c, name);
  if (!light) return;
  const LightParameter p = light_parameter(*light, pname);
  if (p.count == 0) return set_error(c, GL_INVALID_ENUM, "pname");
  for (int i = 0; i < p.count; ++i) params[i] = to_integer(p.values[i], p.conversion);
}

void LightModel(Context& c, GLenum pname, const float* params) {
  LightingState& lighting = c.state.lighting;
  switch (pname) {
  case GL_LIGHT_MODEL_AMBIENT: lighting.model_ambient = vector4(params); break;
  case GL_LIGHT_MODEL_LOCAL_VIEWER:
    lighting.local_viewer = params[0] != 0.0f && !SOFTGL_FAULT(local_viewer_not_stored);
    break;
  case GL_LIGHT_MODEL_TWO_SIDE:
    lighting.two_side = params[0] != 0.0f && !SOFTGL_FAULT(two_side_not_stored);
    break;
  case GL_LIGHT_MODEL_COLOR_CONTROL:
    if (params[0] != float(GL_SINGLE_COLOR) && params[0] != float(GL_SEPARATE_SPECULAR_COLOR))
      return set_error(c, GL_INVALID_ENUM, "params");
    if (!SOFTGL_FAULT(separate_specular_not_stored)) lighting.color_control = GLenum(params[0]);
    break;
  case GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL:
    if (params[0] != float(GL_HALF_VECTOR_SOFTGL) && params[0] != float(GL_REFLECTION_VECTOR_SOFTGL))
      return set_error(c, GL_INVALID_ENUM, "params");
    lighting.specular_vector = GLenum(params[0]);
    break;
  case GL_LIGHT_MODEL_TERMS_SOFTGL:
    if (!(params[0] >= 0.0f && params[0] <= float(GL_ALL_TERM_BITS_SOFTGL)) ||
        params[0] != float(uint32_t(params[0])))
      return set_error(c, GL_INVALID_VALUE, "params");
    lighting.terms = uint32_t(params[0]);
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  c.dirty |= kDirtyLighting;
}

void Material(Context& c, GLenum face, GLenum pname, const float* params) {
  if (pname == GL_COLOR_INDEXES) {
    if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK)
      return set_error(c, GL_INVALID_ENUM, "face");
    const Vec3 indexes(params[0], params[1], params[2]);
    if (face != GL_BACK) c.state.lighting.material_indexes[0] = indexes;
    if (face != GL_FRONT) c.state.lighting.material_indexes[1] = indexes;
    return;
  }
  const uint32_t slots = material_slots(face, pname);
  if (slots == 0) return set_error(c, GL_INVALID_ENUM, wrong_material_argument(face));
  Vec4 value(params[0], 0, 0, 1);
  if (pname == GL_SHININESS) {
    if (params[0] < 0.0f || params[0] > 128.0f) return set_error(c, GL_INVALID_VALUE, "params");
    if (SOFTGL_FAULT(shininess_not_stored)) return;
  } else {
    value = vector4(params);
  }
  const bool inside = c.builder.inside();
  if (!inside && (c.guard & kRunPending)) close_run(c);
  for (int i = 0; i < kMaterialSlots; ++i) {
    if (!(slots >> i & 1)) continue;
    if (inside)
      set_attribute4(c, kMaterial0 + i, value.x, value.y, value.z, value.w);
    else
      set_current(c, kMaterial0 + i, &value.x);
  }
}

namespace {

// The slot that GetMaterial reads, or -1 with the error set.
int queried_material_slot(Context& c, GLenum face, GLenum pname) {
  const uint32_t slots =
      face == GL_FRONT_AND_BACK || pname == GL_AMBIENT_AND_DIFFUSE ? 0 : material_slots(face, pname);
  if (slots == 0) {
    set_error(c, GL_INVALID_ENUM, face == GL_FRONT_AND_BACK ? "face" : wrong_material_argument(face));
    return -1;
  }
  track_color_material(c);
  return kMaterial0 + __builtin_ctz(slots);
}
const Vec3* queried_material_indexes(Context& c, GLenum face) {
  if (face == GL_FRONT) return &c.state.lighting.material_indexes[0];
  if (face == GL_BACK) return &c.state.lighting.material_indexes[1];
  set_error(c, GL_INVALID_ENUM, "face");
  return nullptr;
}

} // namespace

void GetMaterialfv(Context& c, GLenum face, GLenum pname, float* params) {
  if (pname == GL_COLOR_INDEXES) {
    if (const Vec3* v = queried_material_indexes(c, face))
      for (int i = 0; i < 3; ++i) params[i] = (*v)[i];
    return;
  }
  const int slot = queried_material_slot(c, face, pname);
  if (slot < 0) return;
  const int count = pname == GL_SHININESS ? 1 : 4;
  for (int i = 0; i < count; ++i) params[i] = c.state.current.slot[slot][i];
}

void GetMaterialiv(Context& c, GLenum face, GLenum pname, GLint* params) {
  if (pname == GL_COLOR_INDEXES) {
    if (const Vec3* v = queried_material_indexes(c, face))
      for (int i = 0; i < 3; ++i) params[i] = to_integer((*v)[i], Conversion::Float);
    return;
  }
  const int slot = queried_material_slot(c, face, pname);
  if (slot < 0) return;
  const bool shininess = pname == GL_SHININESS;
  for (int i = 0; i < (shininess ? 1 : 4); ++i)
    params[i] = to_integer(c.state.current.slot[slot][i], shininess ? Conversion::Float : Conversion::Normal);
}

void ColorMaterial(Context& c, GLenum face, GLenum mode) {
  if (material_slots(face, GL_AMBIENT) == 0) return set_error(c, GL_INVALID_ENUM, "face");
  if (mode == GL_SHININESS || material_slots(face, mode) == 0) return set_error(c, GL_INVALID_ENUM, "mode");
  track_color_material(c); // what was followed so far keeps its last value
  c.state.lighting.color_material_face = face;
  c.state.lighting.color_material_parameter = mode;
  track_color_material(c);
  c.dirty |= kDirtyMaterial | kDirtyCurrent;
}

void ShadeModel(Context& c, GLenum mode) {
  if (mode != GL_FLAT && mode != GL_SMOOTH && mode != GL_PHONG_WIN)
    return set_error(c, GL_INVALID_ENUM, "mode");
  const bool smooth = SOFTGL_FAULT(phong_is_smooth) && mode == GL_PHONG_WIN;
  c.state.lighting.shade_model = smooth ? GL_SMOOTH : mode;
  c.dirty |= kDirtyLighting;
}

void ProvokingVertex(Context& c, GLenum mode) {
  if (mode != GL_FIRST_VERTEX_CONVENTION && mode != GL_LAST_VERTEX_CONVENTION)
    return set_error(c, GL_INVALID_ENUM, "mode");
  c.state.lighting.provoking_vertex = mode; // each draw asks for it (submit())
}

} // namespace gl
} // namespace softgl
