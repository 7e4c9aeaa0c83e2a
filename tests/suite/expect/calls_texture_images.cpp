// Texture images: from the client's memory and from the framebuffer (3.8.1, 3.8.2).
#include <algorithm>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

// The arguments of the commands that specify images or parts of them.
struct ImageCall {
  GLenum target = GL_NONE;
  int level = 0, dimensions = 2, border = 0;
  GLenum internal_format = GL_NONE; // of a whole image
  int offset[3] = {0, 0, 0}, size[3] = {1, 1, 1};
  int source[2] = {0, 0}; // in the framebuffer
  bool copies = false;
  size_t data = 0; // which argument the memory is; format and type stand before it

  bool whole() const { return internal_format != GL_NONE; }
};

ImageCall whole_image(const Call& call, int dimensions) {
  ImageCall c{call.e(0), int(call.n(1)), dimensions};
  c.internal_format = call.e(2);
  for (int i = 0; i < dimensions; i++) c.size[i] = int(call.n(size_t(3 + i)));
  c.border = int(call.n(size_t(3 + dimensions))), c.data = size_t(6 + dimensions);
  return c;
}
ImageCall part_of_image(const Call& call, int dimensions) {
  ImageCall c{call.e(0), int(call.n(1)), dimensions};
  for (int i = 0; i < dimensions; i++)
    c.offset[i] = int(call.n(size_t(2 + i))), c.size[i] = int(call.n(size_t(2 + dimensions + i)));
  c.data = size_t(4 + 2 * dimensions);
  return c;
}
ImageCall copied_image(const Call& call, int dimensions) {
  ImageCall c{call.e(0), int(call.n(1)), dimensions};
  c.internal_format = call.e(2), c.copies = true;
  for (int i = 0; i < 2; i++) c.source[i] = int(call.n(size_t(3 + i)));
  for (int i = 0; i < dimensions; i++) c.size[i] = int(call.n(size_t(5 + i)));
  c.border = int(call.n(size_t(5 + dimensions)));
  return c;
}
ImageCall copied_part(const Call& call, int dimensions) {
  ImageCall c{call.e(0), int(call.n(1)), dimensions};
  c.copies = true;
  for (int i = 0; i < dimensions; i++) c.offset[i] = int(call.n(size_t(2 + i)));
  for (int i = 0; i < 2; i++) c.source[i] = int(call.n(size_t(2 + dimensions + i)));
  for (int i = 0; i < std::min(dimensions, 2); i++) c.size[i] = int(call.n(size_t(4 + dimensions + i)));
  return c;
}

bool is_proxy(GLenum target) {
  return target == GL_PROXY_TEXTURE_1D || target == GL_PROXY_TEXTURE_2D || target == GL_PROXY_TEXTURE_3D ||
         target == GL_PROXY_TEXTURE_CUBE_MAP;
}

} // namespace

TextureTarget texture_target(GLenum target, int* face) {
  *face = 0;
  switch (target) {
  case GL_TEXTURE_1D: return TextureTarget::OneD;
  case GL_TEXTURE_2D: return TextureTarget::TwoD;
  case GL_TEXTURE_3D: return TextureTarget::ThreeD;
  case GL_TEXTURE_CUBE_MAP: return TextureTarget::Cube;
  }
  if (target < GL_TEXTURE_CUBE_MAP_POSITIVE_X || target > GL_TEXTURE_CUBE_MAP_NEGATIVE_Z)
    throw std::logic_error("a texture target that the machine does not know");
  *face = int(target - GL_TEXTURE_CUBE_MAP_POSITIVE_X);
  return TextureTarget::Cube;
}

bool Machine::play_texture_images(const Call& call) {
  ImageCall c;
  switch (call.command) {
  case Command::TexImage1D: c = whole_image(call, 1); break;
  case Command::TexImage2D: c = whole_image(call, 2); break;
  case Command::TexImage3D: c = whole_image(call, 3); break;
  case Command::TexSubImage1D: c = part_of_image(call, 1); break;
  case Command::TexSubImage2D: c = part_of_image(call, 2); break;
  case Command::TexSubImage3D: c = part_of_image(call, 3); break;
  case Command::CopyTexImage1D: c = copied_image(call, 1); break;
  case Command::CopyTexImage2D: c = copied_image(call, 2); break;
  case Command::CopyTexSubImage1D: c = copied_part(call, 1); break;
  case Command::CopyTexSubImage2D: c = copied_part(call, 2); break;
  case Command::CopyTexSubImage3D: c = copied_part(call, 3); break;
  default: return play_compressed_images(call);
  }
  if (is_proxy(c.target)) return true;
  int face = 0;
  TextureObject& texture = state_.texture.bound(state_.texture.active, texture_target(c.target, &face));
  TextureImage& image = texture.images[face][c.level];
  if (c.whole()) {
    image = {};
    int* sizes[3] = {&image.width, &image.height, &image.depth};
    for (int i = 0; i < 3; i++) *sizes[i] = c.size[i] - (i < c.dimensions ? 2 * c.border : 0);
    image.dimensions = c.dimensions, image.border = c.border;
    image.internal_format = c.internal_format, image.base = base_format(c.internal_format);
    image.texels.resize(size_t(c.size[0] * c.size[1] * c.size[2]));
  }
  if (image.texels.empty()) {
    if (c.whole()) return true; // no texels: as if it had never been specified
    throw std::logic_error("a part of an image that is not there");
  }
  PixelImage pixels;
  if (c.copies)
    pixels = raster_.read(c.source[0], c.source[1], c.size[0], c.size[1],
                          image.base == GL_DEPTH_COMPONENT ? PixelKind::Depth : PixelKind::Color);
  else
    pixels = unpack(state_.unpack, call.arguments[c.data], call.e(c.data - 2), call.e(c.data - 1), c.size[0],
                    c.size[1], c.size[2]);
  transfer(state_.pixel.transfer, pixels, true);
  const int start = c.whole() ? -c.border : 0; // offsets count from the first texel inside
  size_t next = 0;
  for (int z = 0; z < c.size[2]; z++)
    for (int y = 0; y < c.size[1]; y++)
      for (int x = 0; x < c.size[0]; x++)
        image.at(x + c.offset[0] + start, y + c.offset[1] + (c.dimensions > 1 ? start : 0),
                 z + c.offset[2] + (c.dimensions > 2 ? start : 0)) =
            texel_of(image.internal_format, pixels.pixels[next++]);
  if (texture.parameters.generate_mipmap && c.level == texture.parameters.base_level)
    generate_mipmaps(texture);
  return true;
}

} // namespace softgl::suite
