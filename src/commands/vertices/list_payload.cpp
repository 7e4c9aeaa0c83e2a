#include "commands/vertices/list_payload.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "texture/pixel_formats.h"

namespace softgl {
namespace {

/// The control points of a map, one behind the other; null where an argument is bad.
template <class T> const T* keep_points(Context& c, int components, GLint ustride, GLint uorder,
                                        GLint vstride, GLint vorder, const T* points) {
  const auto fits = [&](GLint stride, GLint order) {
    return stride >= components && order >= 1 && order <= kMaxEvaluatorOrder;
  };
  if (components == 0 || !fits(ustride, uorder) || !fits(vstride, vorder)) return nullptr;
  std::vector<T> tight;
  tight.reserve(size_t(uorder) * size_t(vorder) * size_t(components));
  for (ptrdiff_t i = 0; i < uorder; ++i)
    for (ptrdiff_t j = 0; j < vorder; ++j) {
      const T* point = points + i * ustride + j * vstride;
      tight.insert(tight.end(), point, point + components);
    }
  return static_cast<const T*>(keep(c, tight.data(), tight.size() * sizeof(T)));
}

template <class Arguments, class T>
Arguments keep_map1(Context& c, GLenum target, T u1, T u2, GLint stride, GLint order, const T* points) {
  const int k = map_components(target, 1);
  const T* tight = keep_points(c, k, stride, order, k, 1, points);
  return {target, u1, u2, tight ? k : stride, order, tight};
}

template <class Arguments, class T> Arguments keep_map2(Context& c, GLenum target, T u1, T u2, GLint ustride,
                                                        GLint uorder, T v1, T v2, GLint vstride, GLint vorder,
                                                        const T* points) {
  const int k = map_components(target, 2);
  const T* tight = keep_points(c, k, ustride, uorder, vstride, vorder, points);
  return {target, u1, u2, tight ? vorder * k : ustride, uorder, v1, v2, tight ? k : vstride, vorder, tight};
}

} // namespace

const void* keep_bytes(Context& c, const void* data, size_t bytes) {
  return data && bytes ? keep(c, data, bytes) : nullptr;
}

Map1fArguments keep_map(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
                        const GLfloat* points) {
  return keep_map1<Map1fArguments>(c, target, u1, u2, stride, order, points);
}
Map1dArguments keep_map(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
                        const GLdouble* points) {
  return keep_map1<Map1dArguments>(c, target, u1, u2, stride, order, points);
}
Map2fArguments keep_map(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder,
                        GLfloat v1, GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points) {
  return keep_map2<Map2fArguments>(c, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}
Map2dArguments keep_map(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                        GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points) {
  return keep_map2<Map2dArguments>(c, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points);
}

const void* keep_image(Context& c, int dimensions, GLsizei width, GLsizei height, GLsizei depth,
                       GLenum format, GLenum type, const void* pixels) {
  if (width <= 0 || height <= 0 || depth <= 0) return nullptr;
  if (check_pixel_format(format, type)) return nullptr; // the command raises the error
  const PixelStore& store = c.client.pixel_store.unpack;
  const PixelFormat pixel = describe_pixel_format(format, type);
  const ImageLayout from = layout_image(store, dimensions, width, height, pixel);
  if (!find_unpack_memory(c, pixels, image_span(store, from, height, depth, pixel)) || !pixels)
    return nullptr;
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
