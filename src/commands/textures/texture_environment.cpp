// Texture units: selection, environment and coordinate generation (GL 1.5, 2.7, 2.11.4, 3.8.13) and their
// queries. Texture objects and images are in texture/.
#include "commands/generated/commands.h"
#include "commands/get_conversion.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl::gl {
namespace {

TextureUnitState& active_unit(Context& c) { return c.state.texture.unit[c.state.texture.active_unit]; }

// Enums arrive as floats; what is no small non-negative integer is no enum.
GLenum to_enum(float v) {
  return v >= 0.0f && v < 65536.0f && v == float(GLenum(v)) ? GLenum(v) : 0xffffffffu;
}

bool is_environment_mode(GLenum mode) {
  return mode == GL_MODULATE || mode == GL_BLEND || mode == GL_DECAL || mode == GL_REPLACE ||
         mode == GL_ADD || mode == GL_COMBINE || mode == GL_COMBINE4_NV;
}
bool is_combiner(GLenum function, bool rgb) {
  switch (function) {
  case GL_REPLACE:
  case GL_MODULATE:
  case GL_ADD:
  case GL_ADD_SIGNED:
  case GL_INTERPOLATE:
  case GL_SUBTRACT:
  case GL_MODULATE_ADD_ATI:
  case GL_MODULATE_SIGNED_ADD_ATI:
  case GL_MODULATE_SUBTRACT_ATI: return true;
  case GL_DOT3_RGB:
  case GL_DOT3_RGBA:
  case GL_DOT3_RGB_EXT:
  case GL_DOT3_RGBA_EXT: return rgb;
  default: return false;
  }
}
bool is_source(GLenum source) {
  return source == GL_TEXTURE || source == GL_CONSTANT || source == GL_PRIMARY_COLOR ||
         source == GL_PREVIOUS || source == GL_ZERO || source == GL_ONE ||
         (source >= GL_TEXTURE0 && source < GLenum(GL_TEXTURE0 + kMaxTextureUnits));
}
bool is_operand(GLenum operand, bool rgb) {
  return operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA ||
         (rgb && (operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR));
}

// The enum that a texture environment parameter is kept in; null for parameters of other types.
GLenum* environment_enum(TextureUnitState& unit, GLenum pname) {
  switch (pname) {
  case GL_TEXTURE_ENV_MODE: return &unit.env_mode;
  case GL_COMBINE_RGB: return &unit.combine_rgb;
  case GL_COMBINE_ALPHA: return &unit.combine_alpha;
  case GL_SOURCE0_RGB:
  case GL_SOURCE1_RGB:
  case GL_SOURCE2_RGB:
  case GL_SOURCE3_RGB_NV: return &unit.source_rgb[pname - GL_SOURCE0_RGB];
  case GL_SOURCE0_ALPHA:
  case GL_SOURCE1_ALPHA:
  case GL_SOURCE2_ALPHA:
  case GL_SOURCE3_ALPHA_NV: return &unit.source_alpha[pname - GL_SOURCE0_ALPHA];
  case GL_OPERAND0_RGB:
  case GL_OPERAND1_RGB:
  case GL_OPERAND2_RGB:
  case GL_OPERAND3_RGB_NV: return &unit.operand_rgb[pname - GL_OPERAND0_RGB];
  case GL_OPERAND0_ALPHA:
  case GL_OPERAND1_ALPHA:
  case GL_OPERAND2_ALPHA:
  case GL_OPERAND3_ALPHA_NV: return &unit.operand_alpha[pname - GL_OPERAND0_ALPHA];
  default: return nullptr;
  }
}
bool is_legal(GLenum pname, GLenum value) {
  switch (pname) {
  case GL_TEXTURE_ENV_MODE: return is_environment_mode(value);
  case GL_COMBINE_RGB: return is_combiner(value, true);
  case GL_COMBINE_ALPHA: return is_combiner(value, false);
  case GL_SOURCE0_RGB:
  case GL_SOURCE1_RGB:
  case GL_SOURCE2_RGB:
  case GL_SOURCE3_RGB_NV:
  case GL_SOURCE0_ALPHA:
  case GL_SOURCE1_ALPHA:
  case GL_SOURCE2_ALPHA:
  case GL_SOURCE3_ALPHA_NV: return is_source(value);
  case GL_OPERAND0_RGB:
  case GL_OPERAND1_RGB:
  case GL_OPERAND2_RGB:
  case GL_OPERAND3_RGB_NV: return is_operand(value, true);
  default: return is_operand(value, false);
  }
}
float* environment_scale(TextureUnitState& unit, GLenum pname) {
  return pname == GL_RGB_SCALE ? &unit.rgb_scale : pname == GL_ALPHA_SCALE ? &unit.alpha_scale : nullptr;
}

void set_environment(Context& c, GLenum pname, const float* params) {
  TextureUnitState& unit =
      SOFTGL_FAULT(second_environment_is_first) ? c.state.texture.unit[0] : active_unit(c);
  if (GLenum* member = environment_enum(unit, pname)) {
    GLenum value = to_enum(params[0]);
    if (pname == GL_TEXTURE_ENV_MODE && value == GL_REPLACE_EXT) value = GL_REPLACE;
    if (!is_legal(pname, value)) return set_error(c, GL_INVALID_ENUM, "params");
    *member = value;
  } else if (float* scale = environment_scale(unit, pname)) {
    if (params[0] != 1.0f && params[0] != 2.0f && params[0] != 4.0f)
      return set_error(c, GL_INVALID_VALUE, "params");
    *scale = params[0];
  } else if (pname == GL_TEXTURE_ENV_COLOR) {
    unit.env_color = {params[0], params[1], params[2], params[3]};
  } else {
    return set_error(c, GL_INVALID_ENUM, "pname");
  }
  c.dirty |= kDirtyTexture;
}

/// Of a target and a parameter that do not belong together.
const char* wrong_environment_argument(GLenum target) {
  const bool known =
      target == GL_TEXTURE_ENV || target == GL_TEXTURE_FILTER_CONTROL || target == GL_POINT_SPRITE;
  return known ? "pname" : "target";
}

// The values of a TexEnv query; count 0 and an error if there are none.
struct Answer {
  float v[4];
  int count = 0;
  Conversion conversion = Conversion::Enum;
};
Answer environment(Context& c, GLenum target, GLenum pname) {
  TextureUnitState& unit = active_unit(c);
  if (target == GL_TEXTURE_ENV) {
    if (const GLenum* member = environment_enum(unit, pname)) return {{float(*member)}, 1};
    if (const float* scale = environment_scale(unit, pname)) return {{*scale}, 1, Conversion::Float};
    if (pname == GL_TEXTURE_ENV_COLOR) {
      Answer answer{{}, 4, Conversion::Normal};
      const bool clamp = clamps_queried_colors(c);
      for (int i = 0; i < 4; ++i) {
        const float v = unit.env_color[i];
        answer.v[i] = clamp ? (v > 0.0f ? (v > 1.0f ? 1.0f : v) : 0.0f) : v;
      }
      return answer;
    }
  } else if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS) {
    return {{unit.lod_bias}, 1, Conversion::Float};
  } else if (target == GL_POINT_SPRITE && pname == GL_COORD_REPLACE) {
    return {{float(c.state.point.coord_replace >> c.state.texture.active_unit & 1)}, 1};
  }
  set_error(c, GL_INVALID_ENUM, wrong_environment_argument(target));
  return {};
}

TextureGeneration* generation(Context& c, GLenum coord) {
  const GLenum i = coord - GL_S;
  if (i < 4) return &active_unit(c).generation[i];
  set_error(c, GL_INVALID_ENUM, "coord");
  return nullptr;
}

template <class T> void get_generation(Context& c, GLenum coord, GLenum pname, T* params) {
  const TextureGeneration* g = generation(c, coord);
  if (!g) return;
  const auto convert = [](float v) {
    if constexpr (std::is_same_v<T, GLint>)
      return to_integer(v, Conversion::Float);
    else
      return T(v);
  };
  switch (pname) {
  case GL_TEXTURE_GEN_MODE: params[0] = T(g->mode); break;
  case GL_OBJECT_PLANE:
  case GL_EYE_PLANE:
    for (int i = 0; i < 4; ++i)
      params[i] = convert((pname == GL_EYE_PLANE ? g->eye_plane : g->object_plane)[i]);
    break;
  default: set_error(c, GL_INVALID_ENUM, "pname");
  }
}

} // namespace

void ActiveTexture(Context& c, GLenum texture) {
  if (texture - GL_TEXTURE0 >= GLenum(kMaxTextureUnits)) return set_error(c, GL_INVALID_ENUM, "texture");
  c.state.texture.active_unit = int(texture - GL_TEXTURE0);
}
void TexEnv(Context& c, GLenum target, GLenum pname, const GLfloat* params) {
  const int i = c.state.texture.active_unit;
  if (target == GL_TEXTURE_ENV) {
    set_environment(c, pname, params);
  } else if (target == GL_TEXTURE_FILTER_CONTROL && pname == GL_TEXTURE_LOD_BIAS) {
    active_unit(c).lod_bias = params[0];
    c.dirty |= kDirtyTexture;
  } else if (target == GL_POINT_SPRITE && pname == GL_COORD_REPLACE) {
    if (params[0] != 0.0f && params[0] != 1.0f) return set_error(c, GL_INVALID_VALUE, "params");
    uint32_t& units = edit<&State::point>(c).coord_replace;
    units = (units & ~(1u << i)) | uint32_t(params[0]) << i;
  } else {
    set_error(c, GL_INVALID_ENUM, wrong_environment_argument(target));
  }
}

void GetTexEnvfv(Context& c, GLenum target, GLenum pname, GLfloat* params) {
  const Answer answer = environment(c, target, pname);
  for (int i = 0; i < answer.count; ++i) params[i] = answer.v[i];
}
void GetTexEnviv(Context& c, GLenum target, GLenum pname, GLint* params) {
  const Answer answer = environment(c, target, pname);
  for (int i = 0; i < answer.count; ++i) params[i] = to_integer(answer.v[i], answer.conversion);
}

void TexGen(Context& c, GLenum coord, GLenum pname, const GLfloat* params) {
  TextureGeneration* g = generation(c, coord);
  if (!g) return;
  const auto plane = [&] { return Vec4{params[0], params[1], params[2], params[3]}; }; // a mode has one value
  switch (pname) {
  case GL_TEXTURE_GEN_MODE: {
    const GLenum mode = to_enum(params[0]);
    const bool legal = mode == GL_OBJECT_LINEAR || mode == GL_EYE_LINEAR ||
                       (mode == GL_SPHERE_MAP && coord <= GL_T) ||
                       ((mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP) && coord != GL_Q);
    if (!legal) return set_error(c, GL_INVALID_ENUM, "params");
    g->mode = mode;
    break;
  }
  case GL_OBJECT_PLANE:
    g->object_plane = plane();
    if (SOFTGL_FAULT(object_plane_is_eye_plane)) g->eye_plane = plane();
    break;
  case GL_EYE_PLANE:
    g->eye_plane = SOFTGL_FAULT(eye_plane_not_transformed)
                       ? plane()
                       : transform_plane(plane(), inverse(c.matrices.modelview.top()));
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  c.dirty |= kDirtyTextureGeneration;
}

void GetTexGenfv(Context& c, GLenum coord, GLenum pname, GLfloat* params) {
  get_generation(c, coord, pname, params);
}
void GetTexGendv(Context& c, GLenum coord, GLenum pname, GLdouble* params) {
  get_generation(c, coord, pname, params);
}
void GetTexGeniv(Context& c, GLenum coord, GLenum pname, GLint* params) {
  get_generation(c, coord, pname, params);
}

} // namespace softgl::gl
