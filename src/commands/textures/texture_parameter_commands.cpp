// TexParameter and the queries of parameters and of levels (GL 1.5, 3.8.4, 6.1.3, 6.1.4).
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/unit_range.h"
#include "commands/generated/commands.h"
#include "commands/textures/sampling_parameters.h"
#include "commands/textures/texture_targets.h"
#include "context/context.h"
#include "context/texture_bindings.h"

namespace softgl::gl {

namespace {

// What is given as a float for an integer: halves away from 0, as in OSMesa.
GLint nearest(float v) {
  return v != v ? 0 : GLint(std::clamp(std::round(double(v)), -2147483648.0, 2147483647.0));
}

} // namespace

void TexParameter(Context& c, GLenum target, GLenum pname, const GLfloat* params) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return set_error(c, GL_INVALID_ENUM, "target");
  const auto object = bound_texture(c, c.state.texture.active_unit, t);
  TextureParameters& p = object->parameters;
  const float value = params[0];
  const GLenum token = value >= 0 && value < 65536 ? GLenum(value) : 0xffffffffu;
  switch (pname) {
  case GL_TEXTURE_PRIORITY: p.priority = unit_range(value); break;
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
  default:
    if (const Refusal refusal = set_sampling_parameter(p, pname, params, t == kTextureRectangle))
      return set_error(c, refusal);
  }
  c.dirty |= kDirtyTextureObjects;
}

namespace {

ParameterValues get_parameter(Context& c, GLenum target, GLenum pname) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) return {};
  const auto object = bound_texture(c, c.state.texture.active_unit, t);
  const TextureParameters& p = object->parameters;
  switch (pname) {
  case GL_TEXTURE_PRIORITY: {
    ParameterValues priority(p.priority);
    priority.color = true;
    return priority;
  }
  case GL_TEXTURE_RESIDENT: return ParameterValues(1.0f);
  case GL_TEXTURE_IMMUTABLE_FORMAT: return ParameterValues(float(object->immutable_levels != 0));
  case GL_TEXTURE_BASE_LEVEL: return ParameterValues(float(p.base_level));
  case GL_TEXTURE_MAX_LEVEL: return ParameterValues(float(p.max_level));
  case GL_GENERATE_MIPMAP: return ParameterValues(float(p.generate_mipmap));
  case GL_DEPTH_TEXTURE_MODE: return ParameterValues(p.depth_mode);
  default: return get_sampling_parameter(c, p, pname);
  }
}

template <class T> void get_tex_parameter(Context& c, GLenum target, GLenum pname, T* params) {
  const ParameterValues values = get_parameter(c, target, pname);
  if (values.count == 0)
    return set_error(c, GL_INVALID_ENUM, binding_target(target) == kTextureTargets ? "target" : "pname");
  values.store(params);
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
  case GL_TEXTURE_WIDTH: value = image ? image->with_border().width : 0; return true;
  case GL_TEXTURE_HEIGHT: value = image ? image->with_border().height : 0; return true;
  case GL_TEXTURE_DEPTH: value = image ? image->with_border().depth : 0; return true;
  case GL_TEXTURE_BORDER: value = image ? image->border.x : 0; return true;
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
  get_tex_parameter(c, target, pname, params);
}
void GetTexParameteriv(Context& c, GLenum target, GLenum pname, GLint* params) {
  get_tex_parameter(c, target, pname, params);
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
