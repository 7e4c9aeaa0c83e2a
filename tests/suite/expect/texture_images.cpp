// Texture images: internal formats, completeness, mipmaps (3.8.1, 3.8.8, 3.8.10).
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "expect/texture_state.h"

namespace softgl::suite {
namespace {

struct InternalFormat {
  GLenum name, base;
  int bits[4]; // of red, green, blue and alpha, or of L, I, A alone; 0 where the GL chooses
};

const InternalFormat& internal_format(GLenum name) {
  static const InternalFormat formats[] = {
      {GL_ALPHA, GL_ALPHA, {}},
      {GL_ALPHA4, GL_ALPHA, {0, 0, 0, 4}},
      {GL_ALPHA8, GL_ALPHA, {0, 0, 0, 8}},
      {1, GL_LUMINANCE, {}},
      {GL_LUMINANCE, GL_LUMINANCE, {}},
      {GL_LUMINANCE4, GL_LUMINANCE, {4, 4, 4}},
      {GL_LUMINANCE8, GL_LUMINANCE, {8, 8, 8}},
      {2, GL_LUMINANCE_ALPHA, {}},
      {GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, {}},
      {GL_LUMINANCE4_ALPHA4, GL_LUMINANCE_ALPHA, {4, 4, 4, 4}},
      {GL_LUMINANCE6_ALPHA2, GL_LUMINANCE_ALPHA, {6, 6, 6, 2}},
      {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, {8, 8, 8, 8}},
      {GL_INTENSITY, GL_INTENSITY, {}},
      {GL_INTENSITY4, GL_INTENSITY, {4, 4, 4, 4}},
      {GL_INTENSITY8, GL_INTENSITY, {8, 8, 8, 8}},
      {3, GL_RGB, {}},
      {GL_RGB, GL_RGB, {}},
      {GL_R3_G3_B2, GL_RGB, {3, 3, 2}},
      {GL_RGB4, GL_RGB, {4, 4, 4}},
      {GL_RGB5, GL_RGB, {5, 5, 5}},
      {GL_RGB8, GL_RGB, {8, 8, 8}},
      {GL_RGB12, GL_RGB, {12, 12, 12}},
      {4, GL_RGBA, {}},
      {GL_RGBA, GL_RGBA, {}},
      {GL_RGBA2, GL_RGBA, {2, 2, 2, 2}},
      {GL_RGBA4, GL_RGBA, {4, 4, 4, 4}},
      {GL_RGB5_A1, GL_RGBA, {5, 5, 5, 1}},
      {GL_RGBA8, GL_RGBA, {8, 8, 8, 8}},
      {GL_RGB10_A2, GL_RGBA, {10, 10, 10, 2}},
      {GL_RGBA16, GL_RGBA, {16, 16, 16, 16}},
      {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_RGB, {}},
      {GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, GL_RGBA, {}},
      {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, GL_RGBA, {}},
      {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_RGBA, {}},
      {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, {16}},
      {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, {16}},
      {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, {16}},
  };
  for (const InternalFormat& f : formats)
    if (f.name == name) return f;
  throw std::logic_error("an internal format that the suite does not know");
}

bool needs_mipmaps(const TextureParameters& p) {
  return p.min_filter != GL_NEAREST && p.min_filter != GL_LINEAR;
}

bool same_shape(const TextureImage& a, const TextureImage& b) {
  return a.width == b.width && a.height == b.height && a.depth == b.depth && a.border == b.border &&
         a.internal_format == b.internal_format;
}

} // namespace

GLenum base_format(GLenum name) { return internal_format(name).base; }

Pixel texel_of(GLenum name, const Pixel& pixel) {
  const InternalFormat& f = internal_format(name);
  Pixel from = pixel, texel;
  for (int i = 0; i < 4; i++) {
    // "As closely as possible": bits of the internal format or more, but never better than 8 bits are asked
    // for.
    const int bits = f.bits[i] ? std::min(f.bits[i], f.base == GL_DEPTH_COMPONENT ? 16 : 8) : 8;
    const double steps = std::ldexp(1, bits) - 1;
    Interval v = spec::clamped(from.c[i], 0, 1);
    const double whole = v.low * steps, off = std::abs(whole - std::round(whole));
    const bool exact = v.low == v.high && (bits == 8 ? off < 1e-6 : v.low == 0 || v.low == 1);
    from.c[i] = exact ? v : spec::clamped(spec::widened(v, bits == 8 ? 0.5 / steps : 1 / steps), 0, 1);
  }
  const Interval &r = from.c[0], &a = from.c[3];
  switch (f.base) { // tables 3.15 and 3.20
  case GL_ALPHA: texel = {{0, 0, 0, a}}; break;
  case GL_LUMINANCE: texel = {{r, r, r, 1}}; break;
  case GL_LUMINANCE_ALPHA: texel = {{r, r, r, a}}; break;
  case GL_INTENSITY: texel = {{r, r, r, r}}; break;
  case GL_RGB: texel = from, texel.c[3] = 1; break;
  case GL_RGBA: texel = from; break;
  case GL_DEPTH_COMPONENT: texel = {{r, r, r, 1}}; break;
  }
  return texel;
}

Pixel& TextureImage::at(int x, int y, int z) {
  // A border goes round the dimensions that the target has.
  const int by = dimensions > 1 ? border : 0, bz = dimensions > 2 ? border : 0;
  const int line = width + 2 * border, plane = line * (height + 2 * by);
  return texels.at(size_t((z + bz) * plane + (y + by) * line + x + border));
}

bool is_complete(const TextureObject& t) {
  const TextureParameters& p = t.parameters;
  const int faces = t.target == TextureTarget::Cube ? 6 : 1;
  if (p.base_level >= kTextureLevels) return false;
  const TextureImage& base = t.images[0][p.base_level];
  if (base.texels.empty()) return false;
  for (int face = 0; face < faces; face++) {
    if (faces == 6 && (base.width != base.height || !same_shape(base, t.images[face][p.base_level])))
      return false;
    if (!needs_mipmaps(p)) continue;
    if (p.base_level > p.max_level) return false;
    TextureImage expected = base;
    for (int level = p.base_level; level <= p.max_level; level++) {
      const TextureImage& image = t.images[face][level];
      if (image.texels.empty() || !same_shape(image, expected)) return false;
      if (expected.width == 1 && expected.height == 1 && expected.depth == 1) break;
      expected.width = std::max(1, expected.width / 2), expected.height = std::max(1, expected.height / 2);
      expected.depth = std::max(1, expected.depth / 2);
    }
  }
  return true;
}

void generate_mipmaps(TextureObject& t) {
  for (int face = 0; face < (t.target == TextureTarget::Cube ? 6 : 1); face++)
    for (int level = t.parameters.base_level; level < t.parameters.max_level; level++) {
      const TextureImage& from = t.images[face][level];
      if (from.width <= 1 && from.height <= 1 && from.depth <= 1) break;
      if (from.border) throw std::logic_error("mipmaps of an image with a border");
      TextureImage& to = t.images[face][level + 1];
      to = from;
      to.width = std::max(1, from.width / 2), to.height = std::max(1, from.height / 2);
      to.depth = std::max(1, from.depth / 2);
      to.texels.assign(size_t(to.width * to.height * to.depth), {});
      for (int z = 0; z < to.depth; z++)
        for (int y = 0; y < to.height; y++)
          for (int x = 0; x < to.width; x++)
            for (int c = 0; c < 4; c++) {
              Interval sum;
              for (int k = 0; k < 8; k++) {
                const auto index = [](int to_index, int bit, int size) {
                  return std::min(2 * to_index + bit, size - 1);
                };
                sum = sum + from.at(index(x, k & 1, from.width), index(y, k >> 1 & 1, from.height),
                                    index(z, k >> 2, from.depth))
                                .c[c];
              }
              to.at(x, y, z).c[c] = spec::clamped(spec::widened(sum * 0.125, 0.5 / 255), 0, 1);
            }
    }
}

TextureUnit::TextureUnit() {
  generation[0].object_plane = generation[0].eye_plane = {1, 0, 0, 0};
  generation[1].object_plane = generation[1].eye_plane = {0, 1, 0, 0};
}

TextureObject& TextureState::bound(int unit, TextureTarget target) {
  TextureObject& object = objects[{target, units[unit].bound[int(target)]}];
  object.target = target;
  return object;
}

const TextureObject* TextureState::texture_of(int unit) const {
  for (int target = kTextureTargets - 1; target >= 0; target--) {
    if (!units[unit].on[target]) continue;
    const auto found = objects.find({TextureTarget(target), units[unit].bound[target]});
    return found != objects.end() && is_complete(found->second) ? &found->second : nullptr;
  }
  return nullptr;
}

} // namespace softgl::suite
