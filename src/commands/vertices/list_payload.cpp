#include "commands/vertices/list_payload.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "texture/pixel_formats.h"

namespace softgl {
namespace {

int map_components(GLenum target) {
  switch (target) {
  case GL_MAP1_INDEX:
  case GL_MAP1_TEXTURE_COORD_1:
  case GL_MAP2_INDEX:
  case GL_MAP2_TEXTURE_COORD_1: return 1;
  case GL_MAP1_TEXTURE_COORD_2:
  case GL_MAP2_TEXTURE_COORD_2: return 2;
  case GL_MAP1_NORMAL:
  case GL_MAP1_TEXTURE_COORD_3:
  case GL_MAP1_VERTEX_3:
  case GL_MAP2_NORMAL:
  case GL_MAP2_TEXTURE_COORD_3:
  case GL_MAP2_VERTEX_3: return 3;
  case GL_MAP1_COLOR_4:
  case GL_MAP1_TEXTURE_COORD_4:
  case GL_MAP1_VERTEX_4:
  case GL_MAP2_COLOR_4:
  case GL_MAP2_TEXTURE_COORD_4:
  case GL_MAP2_VERTEX_4: return 4;
  default: return 0;
  }
}
constexpr int kMaxOrder = 30;

} // namespace

const void* keep_bytes(Context& c, const void* data, size_t bytes) {
  return data && bytes ? keep(c, data, bytes) : nullptr;
}

int64_t map1_bytes(GLenum target, GLint stride, GLint order, int bytes_per_value) {
  const int k = map_components(target);
  if (k == 0 || stride < k || order < 1 || order > kMaxOrder) return 0;
  return (int64_t(stride) * (order - 1) + k) * bytes_per_value;
}

int64_t map2_bytes(GLenum target, GLint ustride, GLint uorder, GLint vstride, GLint vorder,
                   int bytes_per_value) {
  const int k = map_components(target);
  if (k == 0 || ustride < k || vstride < k || uorder < 1 || vorder < 1 || uorder > kMaxOrder ||
      vorder > kMaxOrder)
    return 0;
  return (int64_t(ustride) * (uorder - 1) + int64_t(vstride) * (vorder - 1) + k) * bytes_per_value;
}

const void* keep_image(Context& c, int dimensions, GLsizei width, GLsizei height, GLsizei depth,
                       GLenum format, GLenum type, const void* pixels) {
  if (!pixels || width <= 0 || height <= 0 || depth <= 0) return nullptr;
  if (check_pixel_format(format, type) != GL_NO_ERROR) return nullptr; // the command raises the error
  const PixelStore& store = c.client.pixel_store.unpack;
  const PixelFormat pixel = describe_pixel_format(format, type);
  const ImageLayout from = layout_image(store, dimensions, width, height, pixel);
  const bool bitmap = pixel.channel == PixelChannel::Bitmap;
  const size_t row_bytes = bitmap ? (size_t(width) + 7) / 8 : size_t(width) * pixel.bytes;
  std::vector<unsigned char> image(row_bytes * size_t(height) * size_t(depth));
  unsigned char* out = image.data();
  for (GLsizei z = 0; z < depth; ++z)
    for (GLsizei y = 0; y < height; ++y, out += row_bytes) {
      const unsigned char* row = static_cast<const unsigned char*>(pixels) + from.offset +
                                 size_t(z) * from.image_stride + size_t(y) * from.row_stride;
      if (bitmap) {
        for (size_t x = 0; x < size_t(width); ++x) {
          const size_t bit = x + size_t(from.bit_offset);
          if ((row[bit >> 3] >> (store.lsb_first ? bit & 7 : 7 - (bit & 7))) & 1)
            out[x >> 3] |= uint8_t(0x80 >> (x & 7));
        }
        continue;
      }
      std::memcpy(out, row, row_bytes);
      if (store.swap_bytes)
        for (size_t i = 0; i < row_bytes; i += pixel.element_bytes)
          std::reverse(out + i, out + i + pixel.element_bytes);
    }
  return keep_bytes(c, image.data(), image.size());
}

} // namespace softgl
