#include "framebuffer/pixel_format.h"

#include <utility>

namespace softgl {
namespace {

struct PackedType { GLenum type; uint32_t bytes, components; };
constexpr PackedType kPackedTypes[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, 3},       {GL_UNSIGNED_BYTE_2_3_3_REV, 1, 3},
    {GL_UNSIGNED_SHORT_5_6_5, 2, 3},      {GL_UNSIGNED_SHORT_5_6_5_REV, 2, 3},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, 4},    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, 4},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, 4},    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, 4},
    {GL_UNSIGNED_INT_8_8_8_8, 4, 4},      {GL_UNSIGNED_INT_8_8_8_8_REV, 4, 4},
    {GL_UNSIGNED_INT_10_10_10_2, 4, 4},   {GL_UNSIGNED_INT_2_10_10_10_REV, 4, 4}};

uint32_t type_bytes(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE: case GL_BYTE: case GL_BITMAP: return 1;
    case GL_UNSIGNED_SHORT: case GL_SHORT: return 2;
    case GL_UNSIGNED_INT: case GL_INT: case GL_FLOAT: return 4;
    default: return 0;
  }
}

} // namespace

uint32_t format_components(GLenum format) {
  switch (format) {
    case GL_COLOR_INDEX: case GL_STENCIL_INDEX: case GL_DEPTH_COMPONENT: case GL_RED: case GL_GREEN: case GL_BLUE:
    case GL_ALPHA: case GL_LUMINANCE: case GL_INTENSITY: return 1;
    case GL_LUMINANCE_ALPHA: return 2;
    case GL_RGB: case GL_BGR: return 3;
    case GL_RGBA: case GL_BGRA: case GL_ABGR_EXT: return 4;
    default: return 0;
  }
}

PixelLayout pixel_layout(GLenum format, GLenum type) {
  const uint32_t components = format == GL_INTENSITY ? 0 : format_components(format);
  if (components == 0) return {};
  for (const PackedType& p : kPackedTypes)
    if (p.type == type) {
      const bool fits = p.components == 3 ? format == GL_RGB : format == GL_RGBA || format == GL_BGRA || format == GL_ABGR_EXT;
      return fits ? PixelLayout{p.bytes, components, p.bytes, true, false} : PixelLayout{};
    }
  if (type == GL_BITMAP) {
    if (format != GL_COLOR_INDEX && format != GL_STENCIL_INDEX) return {};
    return {1, 1, 1, false, true};
  }
  const uint32_t bytes = type_bytes(type);
  if (bytes == 0) return {};
  return {bytes * components, components, bytes, false, false};
}

GLenum check_pixel_format(GLenum format, GLenum type) {
  if (format == GL_INTENSITY || format_components(format) == 0) return GL_INVALID_ENUM;
  bool packed = false;
  for (const PackedType& p : kPackedTypes) packed = packed || p.type == type;
  if (!packed && type_bytes(type) == 0) return GL_INVALID_ENUM;
  if (pixel_layout(format, type).bytes != 0) return GL_NO_ERROR;
  return type == GL_BITMAP ? GL_INVALID_ENUM : GL_INVALID_OPERATION;
}

ImageAddressing::ImageAddressing(const PixelStore& store, const PixelLayout& layout, GLsizei width, GLsizei height) {
  const size_t length = size_t(store.row_length > 0 ? store.row_length : width);
  const size_t rows = size_t(store.image_height > 0 ? store.image_height : height);
  const size_t alignment = size_t(store.alignment);
  const auto align = [alignment](size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; };
  if (layout.bitmap) {
    row_stride = align((length + 7) / 8);
    first_bit = size_t(store.skip_pixels);
  } else {
    row_stride = layout.element_bytes >= alignment ? length * layout.bytes : align(length * layout.bytes);
    start = size_t(store.skip_pixels) * layout.bytes;
  }
  image_stride = row_stride * rows;
  start += size_t(store.skip_rows) * row_stride + size_t(store.skip_images) * image_stride;
}

void swap_bytes(unsigned char* data, size_t bytes, uint32_t element_bytes) {
  if (element_bytes < 2) return;
  for (size_t i = 0; i + element_bytes <= bytes; i += element_bytes)
    for (uint32_t k = 0; k < element_bytes / 2; ++k) std::swap(data[i + k], data[i + element_bytes - 1 - k]);
}

} // namespace softgl
