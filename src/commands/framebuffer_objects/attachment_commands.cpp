// What is attached to framebuffer objects (GL_ARB_framebuffer_object, 4.4.2.2, 4.4.2.3 and 6.1.15).
#include <memory>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "commands/textures/texture_targets.h"
#include "context/context.h"
#include "snapshot/render_targets.h"

namespace softgl {
namespace {

/// The object bound to a target; false, and an error, for no target.
bool bound_object(Context& c, GLenum target, FramebufferObject*& object) {
  if (target != GL_FRAMEBUFFER && target != GL_DRAW_FRAMEBUFFER && target != GL_READ_FRAMEBUFFER)
    return set_error(c, GL_INVALID_ENUM, "target"), false;
  object = (target == GL_READ_FRAMEBUFFER ? c.bindings.read : c.bindings.draw).get();
  return true;
}

/// The attachment points that a name means, at most two; false for no name.
struct Points {
  Attachment* point[2] = {};
  bool valid() const { return point[0] != nullptr; }
};
Points points_of(FramebufferObject& f, GLenum attachment) {
  if (attachment == GL_DEPTH_ATTACHMENT) return {{&f.depth, nullptr}};
  if (attachment == GL_STENCIL_ATTACHMENT) return {{&f.stencil, nullptr}};
  if (attachment == GL_DEPTH_STENCIL_ATTACHMENT) return {{&f.depth, &f.stencil}};
  const GLenum i = attachment - GL_COLOR_ATTACHMENT0;
  if (i < GLenum(kMaxColorAttachments)) return {{&f.color[i], nullptr}};
  return {};
}

void attach(Context& c, const Points& points, const Attachment& image) {
  draw_what_waits(c);
  for (Attachment* point : points.point)
    if (point) *point = image;
  framebuffers_changed(c);
}

/// The points to attach to; not valid, and an error, if the arguments are wrong.
Points points_to_attach(Context& c, GLenum target, GLenum attachment) {
  FramebufferObject* object = nullptr;
  if (!bound_object(c, target, object)) return {};
  if (!object) return set_error(c, GL_INVALID_OPERATION), Points{};
  const Points points = points_of(*object, attachment);
  if (!points.valid()) set_error(c, GL_INVALID_ENUM, "attachment");
  return points;
}

/// `dimensions`: of glFramebufferTexture1D to 3D. `layer_argument`: what the command calls the layer.
void attach_texture(Context& c, GLenum target, GLenum attachment, int dimensions, GLenum textarget,
                    GLuint name, GLint level, GLint layer = 0, const char* layer_argument = nullptr) {
  const Points points = points_to_attach(c, target, attachment);
  if (!points.valid()) return;
  if (name == 0) return attach(c, points, {});
  const ImageTarget image = image_target(textarget, dimensions);
  if (!any_image_target(textarget).valid()) return set_error(c, GL_INVALID_ENUM, "textarget");
  const auto texture = c.shared->textures.find(name);
  if (!texture || !image.valid() || image.proxy || texture->target != image.target)
    return set_error(c, GL_INVALID_OPERATION);
  if (level < 0 || level >= max_texture_levels(image.target)) return set_error(c, GL_INVALID_VALUE, "level");
  if (layer < 0 || layer >= kMax3DTextureSize) return set_error(c, GL_INVALID_VALUE, layer_argument);
  attach(c, points, {nullptr, texture, image.face, level, layer});
}

/// Bits of a component of an attached image.
GLint component_bits(const RenderFormat& f, GLenum pname) {
  switch (pname) {
  case GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE: return f.bits[0];
  case GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE: return f.bits[1];
  case GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE: return f.bits[2];
  case GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE: return f.bits[3];
  case GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE: return f.depth_bits;
  default: return f.stencil_bits;
  }
}

/// What the components are, stencil values apart.
GLint component_type(const RenderFormat& f) {
  if (!f.texels && f.kind == RenderFormat::Kind::None) return GL_NONE; // without storage
  if (!f.texels) return f.has_floats() ? GL_FLOAT : GL_UNSIGNED_NORMALIZED;
  switch (f.encoding.numbers) {
  case ColorNumbers::Float: return GL_FLOAT;
  case ColorNumbers::Signed: return GL_SIGNED_NORMALIZED;
  default: return GL_UNSIGNED_NORMALIZED;
  }
}

bool is_component_size(GLenum pname) {
  return pname >= GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE && pname <= GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE;
}

/// Of the window: its buffers have formats but no names.
void get_window_parameter(Context& c, GLenum attachment, GLenum pname, GLint* params) {
  const Framebuffer& f = c.framebuffer;
  RenderFormat format;
  bool exists = false, color = false;
  switch (attachment) {
  case GL_FRONT_LEFT:
  case GL_BACK_LEFT: // the front buffer where there is but one, as for glDrawBuffer (OSMesa 22.3.6)
    exists = color = true;
    for (int i = 0; i < 4; ++i) format.bits[i] = uint8_t(bits_of_color(f, i));
    break;
  case GL_FRONT_RIGHT:
  case GL_BACK_RIGHT:
  case GL_AUX0:
  case GL_AUX1:
  case GL_AUX2:
  case GL_AUX3: break;
  case GL_DEPTH:
    exists = f.depth_bits > 0;
    format.depth_bits = uint8_t(f.depth_bits);
    break;
  case GL_STENCIL:
    exists = f.stencil_bits > 0;
    format.stencil_bits = uint8_t(f.stencil_bits);
    break;
  default: return set_error(c, GL_INVALID_ENUM, "attachment");
  }
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE)
    *params = exists ? GL_FRAMEBUFFER_DEFAULT : GL_NONE;
  else if (!exists && pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)
    *params = 0;
  else if (!exists)
    set_error(c, GL_INVALID_OPERATION);
  else if (is_component_size(pname))
    *params = component_bits(format, pname);
  else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE)
    *params = attachment == GL_STENCIL       ? GL_INDEX
              : color && is_float(f.surface) ? GL_FLOAT
                                             : GL_UNSIGNED_NORMALIZED;
  else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING)
    *params = GL_LINEAR;
  else
    set_error(c, GL_INVALID_ENUM, "pname");
}

void get_texture_parameter(Context& c, const Attachment& a, GLenum pname, GLint* params) {
  switch (pname) {
  case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL: *params = a.level; return;
  case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE:
    *params = a.texture->target == kTextureCube ? GLint(GL_TEXTURE_CUBE_MAP_POSITIVE_X) + a.face : 0;
    return;
  case GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER: *params = a.layer; return;
  default: set_error(c, GL_INVALID_ENUM, "pname");
  }
}

} // namespace

namespace gl {

void FramebufferRenderbuffer(Context& c, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                             GLuint renderbuffer) {
  const Points points = points_to_attach(c, target, attachment);
  if (!points.valid()) return;
  if (renderbuffer == 0) return attach(c, points, {});
  if (renderbuffertarget != GL_RENDERBUFFER) return set_error(c, GL_INVALID_ENUM, "renderbuffertarget");
  const auto object = c.shared->renderbuffers.find(renderbuffer);
  if (!object) return set_error(c, GL_INVALID_OPERATION);
  attach(c, points, {object, nullptr});
}

void FramebufferTexture1D(Context& c, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                          GLint level) {
  attach_texture(c, target, attachment, 1, textarget, texture, level);
}
void FramebufferTexture2D(Context& c, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                          GLint level) {
  attach_texture(c, target, attachment, 2, textarget, texture, level);
}
void FramebufferTexture3D(Context& c, GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                          GLint level, GLint zoffset) {
  attach_texture(c, target, attachment, 3, textarget, texture, level, zoffset, "zoffset");
}
void FramebufferTextureLayer(Context& c, GLenum target, GLenum attachment, GLuint texture, GLint level,
                             GLint layer) {
  attach_texture(c, target, attachment, 3, GL_TEXTURE_3D, texture, level, layer, "layer");
}

void GetFramebufferAttachmentParameteriv(Context& c, GLenum target, GLenum attachment, GLenum pname,
                                         GLint* params) {
  FramebufferObject* object = nullptr;
  if (!bound_object(c, target, object)) return;
  if (!object) return get_window_parameter(c, attachment, pname, params);
  const Points points = points_of(*object, attachment);
  if (!points.valid()) return set_error(c, GL_INVALID_ENUM, "attachment");
  const Attachment& a = *points.point[0];
  if (points.point[1] && !a.same_image(*points.point[1])) return set_error(c, GL_INVALID_OPERATION);
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) {
    *params = a.renderbuffer ? GL_RENDERBUFFER : a.texture ? GL_TEXTURE : GL_NONE;
    return;
  }
  if (pname == GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) {
    *params = GLint(a.renderbuffer ? a.renderbuffer->name : a.texture ? a.texture->name : 0);
    return;
  }
  if (a.empty()) return set_error(c, GL_INVALID_OPERATION);
  const RenderFormat format = a.format();
  if (is_component_size(pname)) {
    *params = component_bits(format, pname);
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) {
    if (attachment == GL_DEPTH_STENCIL_ATTACHMENT) return set_error(c, GL_INVALID_OPERATION);
    *params = attachment == GL_STENCIL_ATTACHMENT ? GL_INDEX : component_type(format);
  } else if (pname == GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) {
    *params = format.encoding.srgb ? GL_SRGB : GL_LINEAR;
  } else if (a.texture) {
    get_texture_parameter(c, a, pname, params);
  } else {
    set_error(c, GL_INVALID_ENUM, "pname");
  }
}

} // namespace gl
} // namespace softgl
