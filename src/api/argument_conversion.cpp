#include "api/argument_conversion.h"

namespace softgl {
namespace {

bool is_color(CountTable table, GLenum pname) {
  switch (table) {
  case kCountOf_material:
    return pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR || pname == GL_EMISSION ||
           pname == GL_AMBIENT_AND_DIFFUSE;
  case kCountOf_light: return pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR;
  case kCountOf_light_model: return pname == GL_LIGHT_MODEL_AMBIENT;
  case kCountOf_texture: return pname == GL_TEXTURE_BORDER_COLOR;
  case kCountOf_texture_environment: return pname == GL_TEXTURE_ENV_COLOR;
  case kCountOf_fog: return pname == GL_FOG_COLOR;
  default: return false;
  }
}

} // namespace

size_t count_of(CountTable table, GLenum pname) {
  if (is_color(table, pname)) return 4;
  switch (table) {
  case kCountOf_material: return pname == GL_SHININESS ? 1 : pname == GL_COLOR_INDEXES ? 3 : 0;
  case kCountOf_light:
    switch (pname) {
    case GL_POSITION: return 4;
    case GL_SPOT_DIRECTION: return 3;
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION: return 1;
    default: return 0;
    }
  case kCountOf_light_model:
    return pname == GL_LIGHT_MODEL_LOCAL_VIEWER || pname == GL_LIGHT_MODEL_TWO_SIDE ||
           pname == GL_LIGHT_MODEL_COLOR_CONTROL || pname == GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL ||
           pname == GL_LIGHT_MODEL_TERMS_SOFTGL;
  case kCountOf_point:
    switch (pname) {
    case GL_POINT_DISTANCE_ATTENUATION: return 3;
    case GL_POINT_SIZE_MIN:
    case GL_POINT_SIZE_MAX:
    case GL_POINT_FADE_THRESHOLD_SIZE:
    case GL_POINT_SPRITE_COORD_ORIGIN: return 1;
    default: return 0;
    }
  case kCountOf_texture:
    switch (pname) {
    case GL_TEXTURE_MIN_FILTER:
    case GL_TEXTURE_MAG_FILTER:
    case GL_TEXTURE_WRAP_S:
    case GL_TEXTURE_WRAP_T:
    case GL_TEXTURE_WRAP_R:
    case GL_TEXTURE_PRIORITY:
    case GL_TEXTURE_MIN_LOD:
    case GL_TEXTURE_MAX_LOD:
    case GL_TEXTURE_BASE_LEVEL:
    case GL_TEXTURE_MAX_LEVEL:
    case GL_TEXTURE_LOD_BIAS:
    case GL_DEPTH_TEXTURE_MODE:
    case GL_TEXTURE_COMPARE_MODE:
    case GL_TEXTURE_COMPARE_FUNC:
    case GL_GENERATE_MIPMAP:
    case GL_TEXTURE_MAX_ANISOTROPY_EXT:
    case GL_TEXTURE_SRGB_DECODE_EXT:
    case GL_TEXTURE_COMPARE_FAIL_VALUE_ARB: return 1;
    default: return 0;
    }
  case kCountOf_texture_environment:
    switch (pname) {
    case GL_TEXTURE_ENV_MODE:
    case GL_TEXTURE_LOD_BIAS:
    case GL_COMBINE_RGB:
    case GL_COMBINE_ALPHA:
    case GL_SOURCE0_RGB:
    case GL_SOURCE1_RGB:
    case GL_SOURCE2_RGB:
    case GL_SOURCE3_RGB_NV:
    case GL_SOURCE0_ALPHA:
    case GL_SOURCE1_ALPHA:
    case GL_SOURCE2_ALPHA:
    case GL_SOURCE3_ALPHA_NV:
    case GL_OPERAND0_RGB:
    case GL_OPERAND1_RGB:
    case GL_OPERAND2_RGB:
    case GL_OPERAND3_RGB_NV:
    case GL_OPERAND0_ALPHA:
    case GL_OPERAND1_ALPHA:
    case GL_OPERAND2_ALPHA:
    case GL_OPERAND3_ALPHA_NV:
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE:
    case GL_COORD_REPLACE: return 1;
    default: return 0;
    }
  case kCountOf_texture_generation:
    return pname == GL_TEXTURE_GEN_MODE ? 1 : pname == GL_OBJECT_PLANE || pname == GL_EYE_PLANE ? 4 : 0;
  case kCountOf_fog:
    switch (pname) {
    case GL_FOG_MODE:
    case GL_FOG_DENSITY:
    case GL_FOG_START:
    case GL_FOG_END:
    case GL_FOG_INDEX:
    case GL_FOG_COORDINATE_SOURCE:
    case GL_FOG_DISTANCE_MODE_NV: return 1;
    default: return 0;
    }
  }
  return 0;
}

Parameters vector_parameters(CountTable table, GLenum pname, const GLint* values) {
  Parameters p{{0, 0, 0, 0}, true};
  const size_t count = values ? count_of(table, pname) : 0;
  const bool color = is_color(table, pname);
  for (size_t i = 0; i < count; ++i) p.v[i] = color ? normalized(values[i]) : GLfloat(values[i]);
  return p;
}

Parameters vector_parameters(CountTable table, GLenum pname, const GLdouble* values) {
  Parameters p{{0, 0, 0, 0}, true};
  const size_t count = values ? count_of(table, pname) : 0;
  for (size_t i = 0; i < count; ++i) p.v[i] = GLfloat(values[i]);
  return p;
}

Parameters scalar_parameter(CountTable table, GLenum pname, float value) {
  return {{value, 0, 0, 0}, count_of(table, pname) <= 1};
}

} // namespace softgl
