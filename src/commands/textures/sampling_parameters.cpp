#include "commands/textures/sampling_parameters.h"

#include <algorithm>
#include <cmath>

#include "base/unit_range.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {

namespace {

bool wrap_allowed(GLenum mode, bool rectangle) {
  switch (mode) {
  case GL_CLAMP:
  case GL_CLAMP_TO_EDGE:
  case GL_CLAMP_TO_BORDER: return true;
  default: return !rectangle && repeats(mode);
  }
}

bool is_filter(GLenum filter) { return filter == GL_NEAREST || filter == GL_LINEAR; }
bool is_mipmap_filter(GLenum filter) {
  return filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR;
}

GLint to_int(float v) { return GLint(std::clamp(std::nearbyint(double(v)), -2147483648.0, 2147483647.0)); }
// Colors and priorities as integers: [-1,1] to the whole range (6.1.2).
GLint color_to_int(float v) { return GLint(2147483647.0 * double(std::clamp(v, -1.0f, 1.0f))); }

} // namespace

Refusal set_sampling_parameter(SamplingParameters& p, GLenum pname, const GLfloat* params, bool rectangle) {
  const float value = params[0];
  const GLenum token = value >= 0 && value < 65536 ? GLenum(value) : 0xffffffffu;
  bool good = true; // the token is one of the parameter's
  switch (pname) {
  case GL_TEXTURE_WRAP_S:
  case GL_TEXTURE_WRAP_T:
  case GL_TEXTURE_WRAP_R:
    good = wrap_allowed(token, rectangle);
    if (good)
      p.wrap[pname == GL_TEXTURE_WRAP_S                                ? 0
             : pname == GL_TEXTURE_WRAP_T || SOFTGL_FAULT(wrap_r_is_t) ? 1
                                                                       : 2] = token;
    break;
  case GL_TEXTURE_MIN_FILTER:
    good = is_filter(token) || (!rectangle && is_mipmap_filter(token));
    if (good) p.min_filter = token;
    break;
  case GL_TEXTURE_MAG_FILTER:
    good = is_filter(token);
    if (good) p.mag_filter = token;
    break;
  case GL_TEXTURE_BORDER_COLOR:
    p.border_color = {params[0], params[1], params[2], params[3]}; // clamped when it is used
    break;
  case GL_TEXTURE_SRGB_DECODE_EXT:
    good = token == GL_DECODE_EXT || token == GL_SKIP_DECODE_EXT;
    if (good) p.srgb_decode = token;
    break;
  case GL_TEXTURE_MIN_LOD: p.min_lod = value; break;
  case GL_TEXTURE_MAX_LOD: p.max_lod = value; break;
  case GL_TEXTURE_LOD_BIAS: p.lod_bias = value; break;
  case GL_TEXTURE_MAX_ANISOTROPY_EXT:
    if (!(value >= 1)) return {GL_INVALID_VALUE, "params"};
    p.max_anisotropy = std::min(value, kMaxAnisotropy);
    break;
  case GL_TEXTURE_COMPARE_MODE:
    good = token == GL_NONE || token == GL_COMPARE_R_TO_TEXTURE;
    if (good) p.compare_mode = token;
    break;
  case GL_TEXTURE_COMPARE_FUNC:
    good = token >= GL_NEVER && token <= GL_ALWAYS;
    if (good) p.compare_function = token;
    break;
  default: return {GL_INVALID_ENUM, "pname"};
  }
  return good ? Refusal{} : Refusal{GL_INVALID_ENUM, "params"};
}

void ParameterValues::store(GLfloat* params) const { std::copy_n(v, count, params); }

void ParameterValues::store(GLint* params) const {
  for (int i = 0; i < count; ++i) params[i] = color ? color_to_int(v[i]) : to_int(v[i]);
}

ParameterValues get_sampling_parameter(const Context& c, const SamplingParameters& p, GLenum pname) {
  switch (pname) {
  case GL_TEXTURE_WRAP_S: return ParameterValues(p.wrap[0]);
  case GL_TEXTURE_WRAP_T: return ParameterValues(p.wrap[1]);
  case GL_TEXTURE_WRAP_R: return ParameterValues(p.wrap[2]);
  case GL_TEXTURE_MIN_FILTER: return ParameterValues(p.min_filter);
  case GL_TEXTURE_MAG_FILTER: return ParameterValues(p.mag_filter);
  case GL_TEXTURE_BORDER_COLOR: {
    ParameterValues values;
    values.count = 4;
    values.color = true;
    const bool clamped = clamps_queried_colors(c);
    for (int i = 0; i < 4; ++i) values.v[i] = clamped ? unit_range(p.border_color[i]) : p.border_color[i];
    return values;
  }
  case GL_TEXTURE_MIN_LOD: return ParameterValues(p.min_lod);
  case GL_TEXTURE_MAX_LOD: return ParameterValues(p.max_lod);
  case GL_TEXTURE_LOD_BIAS: return ParameterValues(p.lod_bias);
  case GL_TEXTURE_MAX_ANISOTROPY_EXT: return ParameterValues(p.max_anisotropy);
  case GL_TEXTURE_SRGB_DECODE_EXT: return ParameterValues(p.srgb_decode);
  case GL_TEXTURE_COMPARE_MODE: return ParameterValues(p.compare_mode);
  case GL_TEXTURE_COMPARE_FUNC: return ParameterValues(p.compare_function);
  default: return {};
  }
}

} // namespace softgl
