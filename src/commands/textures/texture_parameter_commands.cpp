// TexParameter and the queries of parameters and of levels (GL 1.5, 3.8.4, 6.1.3, 6.1.4).
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/unit_range.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_targets.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "context/texture_bindings.h"

namespace softgl::gl {

namespace {

bool wrap_allowed(GLenum mode, TextureTarget target) {
  switch (mode) {
  case GL_CLAMP:
  case GL_CLAMP_TO_EDGE:
  case GL_CLAMP_TO_BORDER: return true;
  case GL_REPEAT:
  case GL_MIRRORED_REPEAT: return target != kTextureRectangle;
  default: return false;
  }
}

bool compare_function(GLenum f) { return f >= GL_NEVER && f <= GL_ALWAYS; }

GLint to_int(float v) { return GLint(std::clamp(std::nearbyint(double(v)), -2147483648.0, 2147483647.0)); }
// What is given as a float for an integer: halves away from 0, as in OSMesa.
GLint nearest(float v) {
  return v != v ? 0 : GLint(std::clamp(std::round(double(v)), -2147483648.0, 2147483647.0));
}
// Colors and priorities as integers: [-1,1] to the whole range (6.1.2).
GLint color_to_int(float v) { return GLint(2147483647.0 * double(std::clamp(v, -1.0f, 1.0f))); }

} // namespace

void TexParameter(Context& c, GLenum target, GLenum pname, const GLfloat* params) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return set_error(c, GL_INVALID_ENUM, "target");
  const auto object = bound_texture(c, c.state.texture.active_unit, t);
  TextureParameters& p = object->parameters;
  const float value = params[0];
  const GLenum token = value >= 0 && value < 65536 ? GLenum(value) : 0xffffffffu;
  switch (pname) {
  case GL_TEXTURE_WRAP_S:
  case GL_TEXTURE_WRAP_T:
  case GL_TEXTURE_WRAP_R:
    if (!wrap_allowed(token, t)) return set_error(c, GL_INVALID_ENUM, "params");
    p.wrap[pname == GL_TEXTURE_WRAP_S ? 0 : pname == GL_TEXTURE_WRAP_T ? 1 : 2] = token;
    break;
  case GL_TEXTURE_MIN_FILTER:
    if (token != GL_NEAREST && token != GL_LINEAR &&
        (t == kTextureRectangle || token < GL_NEAREST_MIPMAP_NEAREST || token > GL_LINEAR_MIPMAP_LINEAR))
      return set_error(c, GL_INVALID_ENUM, "params");
    p.min_filter = token;
    break;
  case GL_TEXTURE_MAG_FILTER:
    if (token != GL_NEAREST && token != GL_LINEAR) return set_error(c, GL_INVALID_ENUM, "params");
    p.mag_filter = token;
    break;
  case GL_TEXTURE_BORDER_COLOR:
    p.border_color = {params[0], params[1], params[2], params[3]}; // clamped when it is used
    break;
  case GL_TEXTURE_PRIORITY: p.priority = unit_range(value); break;
  case GL_TEXTURE_SRGB_DECODE_EXT:
    if (token != GL_DECODE_EXT && token != GL_SKIP_DECODE_EXT) return set_error(c, GL_INVALID_ENUM, "params");
    p.srgb_decode = token;
    break;
  case GL_TEXTURE_MIN_LOD: p.min_lod = value; break;
  case GL_TEXTURE_MAX_LOD: p.max_lod = value; break;
  case GL_TEXTURE_LOD_BIAS: p.lod_bias = value; break;
  case GL_TEXTURE_MAX_ANISOTROPY_EXT:
    if (!(value >= 1)) return set_error(c, GL_INVALID_VALUE, "params");
    p.max_anisotropy = std::min(value, kMaxAnisotropy);
    break;
  case GL_TEXTURE_BASE_LEVEL:
    if (nearest(value) < 0 || (t == kTextureRectangle && nearest(value) != 0))
      return set_error(c, GL_INVALID_VALUE, "params");
    p.base_level = object->level_within(nearest(value), 0);
    break;
  case GL_TEXTURE_MAX_LEVEL:
    if (nearest(value) < 0) return set_error(c, GL_INVALID_VALUE, "params");
    p.max_level = object->level_within(nearest(value), p.base_level);
    break;
  case GL_GENERATE_MIPMAP: p.generate_mipmap = value != 0; break;
  case GL_DEPTH_TEXTURE_MODE:
    if (token != GL_LUMINANCE && token != GL_INTENSITY && token != GL_ALPHA && token != GL_RED)
      return set_error(c, GL_INVALID_ENUM, "params");
    p.depth_mode = token;
    break;
  case GL_TEXTURE_COMPARE_MODE:
    if (token != GL_NONE && token != GL_COMPARE_R_TO_TEXTURE) return set_error(c, GL_INVALID_ENUM, "params");
    p.compare_mode = token;
    break;
  case GL_TEXTURE_COMPARE_FUNC:
    if (!compare_function(token)) return set_error(c, GL_INVALID_ENUM, "params");
    p.compare_function = token;
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
  c.dirty |= kDirtyTextureObjects;
}

namespace {

const char* wrong_query_argument(GLenum target) {
  return binding_target(target) == kTextureTargets ? "target" : "pname";
}

/// Number of values, 0 for an unknown name. Colors are marked, because they scale as integers.
int get_parameter(Context& c, GLenum target, GLenum pname, float* v, bool& color) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return 0;
  const auto object = bound_texture(c, c.state.texture.active_unit, t);
  const TextureParameters& p = object->parameters;
  color = false;
  switch (pname) {
  case GL_TEXTURE_WRAP_S: v[0] = float(p.wrap[0]); return 1;
  case GL_TEXTURE_WRAP_T: v[0] = float(p.wrap[1]); return 1;
  case GL_TEXTURE_WRAP_R: v[0] = float(p.wrap[2]); return 1;
  case GL_TEXTURE_MIN_FILTER: v[0] = float(p.min_filter); return 1;
  case GL_TEXTURE_MAG_FILTER: v[0] = float(p.mag_filter); return 1;
  case GL_TEXTURE_BORDER_COLOR:
    color = true;
    for (int i = 0; i < 4; ++i)
      v[i] = clamps_queried_colors(c) ? unit_range(p.border_color[i]) : p.border_color[i];
    return 4;
  case GL_TEXTURE_PRIORITY:
    color = true;
    v[0] = p.priority;
    return 1;
  case GL_TEXTURE_RESIDENT: v[0] = 1; return 1;
  case GL_TEXTURE_IMMUTABLE_FORMAT: v[0] = object->immutable_levels != 0; return 1;
  case GL_TEXTURE_MIN_LOD: v[0] = p.min_lod; return 1;
  case GL_TEXTURE_MAX_LOD: v[0] = p.max_lod; return 1;
  case GL_TEXTURE_LOD_BIAS: v[0] = p.lod_bias; return 1;
  case GL_TEXTURE_MAX_ANISOTROPY_EXT: v[0] = p.max_anisotropy; return 1;
  case GL_TEXTURE_BASE_LEVEL: v[0] = float(p.base_level); return 1;
  case GL_TEXTURE_MAX_LEVEL: v[0] = float(p.max_level); return 1;
  case GL_GENERATE_MIPMAP: v[0] = p.generate_mipmap; return 1;
  case GL_TEXTURE_SRGB_DECODE_EXT: v[0] = float(p.srgb_decode); return 1;
  case GL_DEPTH_TEXTURE_MODE: v[0] = float(p.depth_mode); return 1;
  case GL_TEXTURE_COMPARE_MODE: v[0] = float(p.compare_mode); return 1;
  case GL_TEXTURE_COMPARE_FUNC: v[0] = float(p.compare_function); return 1;
  default: return 0;
  }
}

/// False after an error.
bool get_level_parameter(Context& c, GLenum target, GLint level, GLenum pname, GLint& value) {
  const ImageTarget t = any_image_target(target);
  if (!t.valid()) return set_error(c, GL_INVALID_ENUM, "target"), false;
  if (level < 0 || level >= max_texture_levels(t.target))
    return set_error(c, GL_INVALID_VALUE, "level"), false;
  const auto object = target_object(c, t);
  const TextureImage* image = object->image[t.face][level].get();
  const TexelFormat* f = image ? image->format : nullptr;
  const GLenum base = f ? f->base : 0;
  const bool compressed = f && f->block != BlockFormat::None,
             s3tc = compressed && f->block < BlockFormat::Red;
  const bool fxt1 = compressed && block_width(f->block) == 8;
  // OSMesa 22.3.6 says 4 of the components of S3TC and FXT1, and 1 of FXT1's alpha.
  auto bits = [&](bool has, int k) {
    if (!f || !has || !f->bits[k]) return 0;
    return fxt1 && k == 3 ? 1 : s3tc || fxt1 ? 4 : GLint(f->bits[k]);
  };
  const bool rgb = base == GL_RGB || base == GL_RGBA || base == GL_RED || base == GL_RG;
  const GLint kind = !f                                             ? GL_NONE
                     : f->layout == TexelLayout::Float || f->floats ? GL_FLOAT
                     : f->layout == TexelLayout::Signed16           ? GL_SIGNED_NORMALIZED
                                                                    : GL_UNSIGNED_NORMALIZED;
  auto type = [&](GLint size) { return size ? kind : GLint(GL_NONE); };
  const GLint alpha_bits = bits(base == GL_RGBA || base == GL_ALPHA || base == GL_LUMINANCE_ALPHA, 3),
              luminance_bits = bits(base == GL_LUMINANCE || base == GL_LUMINANCE_ALPHA, 0),
              depth_bits = bits(f && f->layout == TexelLayout::Depth, 0);
  switch (pname) {
  case GL_TEXTURE_WIDTH: value = image ? image->width : 0; return true;
  case GL_TEXTURE_HEIGHT: value = image ? image->height : 0; return true;
  case GL_TEXTURE_DEPTH: value = image ? image->depth : 0; return true;
  case GL_TEXTURE_BORDER: value = image ? image->border : 0; return true;
  case GL_TEXTURE_INTERNAL_FORMAT: value = image ? image->internal_format : 1; return true;
  case GL_TEXTURE_RED_SIZE: value = bits(rgb, 0); return true;
  case GL_TEXTURE_GREEN_SIZE: value = bits(rgb, 1); return true;
  case GL_TEXTURE_BLUE_SIZE: value = bits(rgb, 2); return true;
  case GL_TEXTURE_ALPHA_SIZE: value = alpha_bits; return true;
  case GL_TEXTURE_LUMINANCE_SIZE: value = luminance_bits; return true;
  case GL_TEXTURE_INTENSITY_SIZE: value = bits(base == GL_INTENSITY, 0); return true;
  case GL_TEXTURE_DEPTH_SIZE: value = depth_bits; return true;
  case GL_TEXTURE_RED_TYPE: value = type(bits(rgb, 0)); return true;
  case GL_TEXTURE_GREEN_TYPE: value = type(bits(rgb, 1)); return true;
  case GL_TEXTURE_BLUE_TYPE: value = type(bits(rgb, 2)); return true;
  case GL_TEXTURE_ALPHA_TYPE: value = type(alpha_bits); return true;
  case GL_TEXTURE_LUMINANCE_TYPE_ARB: value = type(luminance_bits); return true;
  case GL_TEXTURE_INTENSITY_TYPE_ARB: value = type(bits(base == GL_INTENSITY, 0)); return true;
  case GL_TEXTURE_DEPTH_TYPE: value = type(depth_bits); return true;
  case GL_TEXTURE_STENCIL_SIZE: value = base == GL_DEPTH_STENCIL ? 8 : 0; return true;
  case GL_TEXTURE_COMPRESSED: value = compressed; return true;
  case GL_TEXTURE_SHARED_SIZE: value = bits(true, 0) == 9 ? 5 : 0; return true;
  case GL_TEXTURE_COMPRESSED_IMAGE_SIZE:
    if (!compressed || t.proxy) return set_error(c, GL_INVALID_OPERATION), false;
    value = GLint(image->blocks.size());
    return true;
  default: return set_error(c, GL_INVALID_ENUM, "pname"), false;
  }
}

} // namespace

void GetTexParameterfv(Context& c, GLenum target, GLenum pname, GLfloat* params) {
  float v[4];
  bool color;
  const int n = get_parameter(c, target, pname, v, color);
  if (n == 0) return set_error(c, GL_INVALID_ENUM, wrong_query_argument(target));
  std::copy_n(v, n, params);
}

void GetTexParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  float v[4];
  bool color;
  const int n = get_parameter(c, target, pname, v, color);
  if (n == 0) return set_error(c, GL_INVALID_ENUM, wrong_query_argument(target));
  for (int i = 0; i < n; ++i) params[i] = color ? color_to_int(v[i]) : to_int(v[i]);
}

void GetTexLevelParameteriv(Context& c, GLenum target, GLint level, GLenum pname, GLint* params) {
  GLint value;
  if (get_level_parameter(c, target, level, pname, value)) *params = value;
}

void GetTexLevelParameterfv(Context& c, GLenum target, GLint level, GLenum pname, GLfloat* params) {
  GLint value;
  if (get_level_parameter(c, target, level, pname, value)) *params = float(value);
}

} // namespace softgl::gl
