// Framebuffer objects and renderbuffers (GL_ARB_framebuffer_object, 4.4).
#pragma once

#include <memory>
#include <string>

#include "base/gl_types.h"
#include "surface/framebuffer.h"
#include "surface/render_plane.h"
#include "texture/texture_object.h"

namespace softgl {

struct Context;

constexpr int kMaxColorAttachments = 8;
constexpr int kMaxRenderbufferSize = 16384;

struct Renderbuffer {
  explicit Renderbuffer(GLuint name) : name(name) {}
  GLuint name;
  std::string label; // GL_KHR_debug
  GLenum internal_format = GL_RGBA;
  int width = 0, height = 0, samples = 1; // samples: 1 or kSamples
  RenderFormat format;
  std::shared_ptr<RenderPlane> plane; // null before glRenderbufferStorage
};

/// One attachment point: a renderbuffer, an image of a texture, or nothing.
struct Attachment {
  std::shared_ptr<Renderbuffer> renderbuffer;
  std::shared_ptr<TextureObject> texture;
  int face = 0, level = 0, layer = 0;

  bool empty() const { return !renderbuffer && !texture; }
  bool same_image(const Attachment& a) const {
    return renderbuffer == a.renderbuffer && texture == a.texture && face == a.face && level == a.level &&
           layer == a.layer;
  }
  /// The image of the texture; null if there is none.
  TextureImage* image() const { return texture ? texture->image[face][level].get() : nullptr; }
  /// Kind::None for nothing, and for images that are missing or cannot be drawn to.
  RenderFormat format() const;
  int width() const, height() const, samples() const;
};

struct FramebufferObject {
  explicit FramebufferObject(GLuint name) : name(name) {}
  GLuint name;
  std::string label; // GL_KHR_debug
  Attachment color[kMaxColorAttachments], depth, stencil;
  GLenum draw_buffer = GL_COLOR_ATTACHMENT0, read_buffer = GL_COLOR_ATTACHMENT0;

  /// Calls visit(attachment) for all attachment points.
  template <class Visit> void for_each(Visit&& visit) {
    for (Attachment& a : color) visit(a);
    visit(depth);
    visit(stencil);
  }
  /// The color attachment that a draw or read buffer names; null for GL_NONE.
  const Attachment* color_of(GLenum buffer) const {
    return buffer == GL_NONE ? nullptr : &color[buffer - GL_COLOR_ATTACHMENT0];
  }
  /// GL_FRAMEBUFFER_COMPLETE, or which rule is broken (4.4.4.2; not those of draw and read buffers, which
  /// GL_ARB_ES2_compatibility took back).
  GLenum status() const;
  bool complete() const { return status() == GL_FRAMEBUFFER_COMPLETE; }
  /// Samples of a pixel of a complete framebuffer.
  int samples() const;
};

/// The surface of a framebuffer object, and its planes, which it keeps alive.
struct AssembledTarget : RenderTarget {
  std::shared_ptr<RenderPlane> color, depth_stencil;
};

/// What of State is bound where (glBindFramebuffer, glBindRenderbuffer). Null: the window, or none.
struct FramebufferBindings {
  std::shared_ptr<FramebufferObject> draw, read;
  std::shared_ptr<Renderbuffer> renderbuffer;
  AssembledTarget draw_target, read_target;        // of the objects; made by prepare_draw_target()
  bool draw_current = false, read_current = false; // they are those of the objects as they are now
};

/// Bits of a component (0 to 3: red, green, blue, alpha) of what is drawn to.
int bits_of_color(const RenderTarget& target, int component);
inline bool is_float(const Surface& surface) { return surface.color_format == ColorFormat::RgbaFloat; }
/// False where the draw or read buffer is GL_NONE, or names nothing that is attached.
bool draws_color(const Context& c);
bool reads_color(const Context& c);
/// The draw and read buffers of what is bound.
GLenum draw_buffer(const Context& c);
GLenum read_buffer(const Context& c);

} // namespace softgl
