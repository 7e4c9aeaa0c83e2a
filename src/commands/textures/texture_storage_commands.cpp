// TexStorage (GL_ARB_texture_storage): all levels of a texture at once, whose sizes and format stay.
#include <algorithm>
#include <vector>

#include "commands/generated/commands.h"
#include "commands/textures/texture_images.h"
#include "context/context.h"

namespace softgl {
namespace {

/// A target of BindTexture, or a proxy.
ImageTarget storage_target(GLenum target, int dimensions) {
  const TextureTarget t = binding_target(target);
  if (t == kTextureTargets) {
    const ImageTarget proxy = image_target(target, dimensions);
    return proxy.proxy ? proxy : ImageTarget{};
  }
  const int needed = t == kTexture1D ? 1 : t == kTexture3D ? 3 : 2;
  return needed == dimensions ? ImageTarget{t, 0, false} : ImageTarget{};
}

/// The storage of a format that names the sizes of its components, or its way of compression; else null.
const TexelFormat* sized_format(GLenum internal_format) {
  switch (internal_format) {
  case 1:
  case 2:
  case 3:
  case 4:
  case GL_ALPHA:
  case GL_LUMINANCE:
  case GL_LUMINANCE_ALPHA:
  case GL_INTENSITY:
  case GL_RED:
  case GL_RG:
  case GL_RGB:
  case GL_RGBA:
  case GL_SRGB:
  case GL_SRGB_ALPHA:
  case GL_SLUMINANCE:
  case GL_SLUMINANCE_ALPHA:
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_STENCIL: return nullptr;
  default: break;
  }
  if (granted_format(GLint(internal_format)) != GLint(internal_format)) return nullptr;
  return choose_texel_format(GLint(internal_format), 0, 0, false);
}

struct Size {
  GLsizei width, height, depth;
};

Size size_of_level(const ImageTarget& t, const Size& s, int level) {
  const auto smaller = [&](GLsizei size) { return std::max(1, size >> level); };
  return {smaller(s.width), t.target == kTexture1D ? 1 : smaller(s.height),
          t.target == kTexture3D ? smaller(s.depth) : 1};
}

/// The error of arguments that no texture could have.
Refusal check(const ImageTarget& t, const TexelFormat* format, GLsizei levels, const Size& s) {
  if (!t.valid()) return {GL_INVALID_ENUM, "target"};
  if (!format || !takes_target(*format, t.target)) return {GL_INVALID_ENUM, "internalformat"};
  if (const char* wrong = first_wrong(
          {{"levels", levels < 1}, {"width", s.width < 1}, {"height", s.height < 1}, {"depth", s.depth < 1}}))
    return {GL_INVALID_VALUE, wrong};
  int most = 1;
  for (int size = std::max({s.width, s.height, s.depth}); size > 1; size >>= 1) ++most;
  if (levels > std::min(most, max_texture_levels(t.target))) return {GL_INVALID_OPERATION};
  if (format->layout == TexelLayout::Depth && t.target == kTexture3D) return {GL_INVALID_OPERATION};
  return {};
}

void describe_proxy(Context& c, const ImageTarget& t, GLsizei levels, const TexelFormat& format,
                    GLenum internal_format, const Size& s, bool fits) {
  const auto object = target_object(c, t);
  for (int level = 0; level < max_texture_levels(t.target); ++level) {
    object->image[0][level] = nullptr;
    if (!fits || level >= levels) continue;
    const Size size = size_of_level(t, s, level);
    object->image[0][level] =
        describe_image(format, GLint(internal_format), size.width, size.height, size.depth);
  }
}

void store(Context& c, int dimensions, GLenum target, GLsizei levels, GLenum internal_format, const Size& s) {
  const ImageTarget t = storage_target(target, dimensions);
  const TexelFormat* format = sized_format(internal_format);
  if (const Refusal refusal = check(t, format, levels, s)) return set_error(c, refusal);
  const Refusal wrong_size = check_image_size(t, 0, s.width, s.height, s.depth, 0);
  const bool fits = !wrong_size && image_bytes(*format, s.width, s.height, s.depth) <= kMaxImageBytes;
  if (t.proxy) return describe_proxy(c, t, levels, *format, internal_format, s, fits);
  const auto object = target_object(c, t);
  if (object->name == 0 || object->immutable_levels) return set_error(c, GL_INVALID_OPERATION);
  if (wrong_size) return set_error(c, wrong_size);
  if (!fits) return set_error(c, GL_OUT_OF_MEMORY);
  std::vector<std::shared_ptr<TextureImage>> made;
  const int faces = t.target == kTextureCube ? 6 : 1;
  for (int face = 0; face < faces; ++face)
    for (int level = 0; level < levels; ++level) {
      const Size size = size_of_level(t, s, level);
      made.push_back(make_image(*format, GLint(internal_format), size.width, size.height, size.depth));
      made.back()->fill_absent_alpha();
    }
  mark_images(c, *object);
  for (int face = 0; face < faces; ++face)
    for (int level = 0; level < levels; ++level)
      object->image[face][level] = std::move(made[size_t(face) * size_t(levels) + size_t(level)]);
  object->immutable_levels = levels;
}

} // namespace

namespace gl {

void TexStorage1D(Context& c, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width) {
  store(c, 1, target, levels, internalformat, {width, 1, 1});
}
void TexStorage2D(Context& c, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                  GLsizei height) {
  store(c, 2, target, levels, internalformat, {width, height, 1});
}
void TexStorage3D(Context& c, GLenum target, GLsizei levels, GLenum internalformat, GLsizei width,
                  GLsizei height, GLsizei depth) {
  store(c, 3, target, levels, internalformat, {width, height, depth});
}

} // namespace gl
} // namespace softgl
