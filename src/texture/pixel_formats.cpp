#include "texture/pixel_formats.h"

#include "shaders/common/seeded_faults.h"
#include "texture/pixel_state.h"

namespace softgl {

namespace {

int packed_components(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE_3_3_2:
  case GL_UNSIGNED_BYTE_2_3_3_REV:
  case GL_UNSIGNED_SHORT_5_6_5:
  case GL_UNSIGNED_SHORT_5_6_5_REV: return 3;
  case GL_UNSIGNED_SHORT_4_4_4_4:
  case GL_UNSIGNED_SHORT_4_4_4_4_REV:
  case GL_UNSIGNED_SHORT_5_5_5_1:
  case GL_UNSIGNED_SHORT_1_5_5_5_REV:
  case GL_UNSIGNED_INT_8_8_8_8:
  case GL_UNSIGNED_INT_8_8_8_8_REV:
  case GL_UNSIGNED_INT_10_10_10_2:
  case GL_UNSIGNED_INT_2_10_10_10_REV: return 4;
  default: return 0;
  }
}

/// Bits of the components, first component first, and whether the first one is the least significant.
struct PackedType {
  uint8_t bytes, bits[4];
  bool reversed;
};
PackedType packed_type(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE_3_3_2: return {1, {3, 3, 2, 0}, false};
  case GL_UNSIGNED_BYTE_2_3_3_REV: return {1, {3, 3, 2, 0}, true};
  case GL_UNSIGNED_SHORT_5_6_5: return {2, {5, 6, 5, 0}, false};
  case GL_UNSIGNED_SHORT_5_6_5_REV: return {2, {5, 6, 5, 0}, true};
  case GL_UNSIGNED_SHORT_4_4_4_4: return {2, {4, 4, 4, 4}, false};
  case GL_UNSIGNED_SHORT_4_4_4_4_REV: return {2, {4, 4, 4, 4}, true};
  case GL_UNSIGNED_SHORT_5_5_5_1: return {2, {5, 5, 5, 1}, false};
  case GL_UNSIGNED_SHORT_1_5_5_5_REV: return {2, {5, 5, 5, 1}, true};
  case GL_UNSIGNED_INT_8_8_8_8: return {4, {8, 8, 8, 8}, false};
  case GL_UNSIGNED_INT_8_8_8_8_REV: return {4, {8, 8, 8, 8}, true};
  case GL_UNSIGNED_INT_10_10_10_2: return {4, {10, 10, 10, 2}, false};
  default: return {4, {10, 10, 10, 2}, true}; // GL_UNSIGNED_INT_2_10_10_10_REV
  }
}

bool depth_stencil_type(GLenum type) {
  return type == GL_UNSIGNED_INT_24_8 || type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV;
}

bool plain_type(GLenum type) {
  switch (type) {
  case GL_UNSIGNED_BYTE:
  case GL_BYTE:
  case GL_UNSIGNED_SHORT:
  case GL_SHORT:
  case GL_UNSIGNED_INT:
  case GL_INT:
  case GL_FLOAT:
  case GL_HALF_FLOAT: return true;
  default: return false;
  }
}

} // namespace

Refusal check_pixel_format(GLenum format, GLenum type) {
  constexpr Refusal kFine, kWrongType{GL_INVALID_ENUM, "type"}, kMismatch{GL_INVALID_OPERATION};
  int components;
  switch (format) {
  case GL_COLOR_INDEX:
  case GL_STENCIL_INDEX:
  case GL_DEPTH_COMPONENT:
  case GL_RED:
  case GL_GREEN:
  case GL_BLUE:
  case GL_ALPHA:
  case GL_LUMINANCE: components = 1; break;
  case GL_LUMINANCE_ALPHA:
  case GL_RG: components = 2; break;
  case GL_RGB:
  case GL_BGR: components = 3; break;
  case GL_RGBA:
  case GL_BGRA:
  case GL_ABGR_EXT: components = 4; break;
  case GL_DEPTH_STENCIL: return depth_stencil_type(type) ? kFine : kWrongType;
  default: return {GL_INVALID_ENUM, "format"};
  }
  if (depth_stencil_type(type)) return kMismatch;
  if (type == GL_BITMAP) return format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX ? kFine : kWrongType;
  if (plain_type(type)) return kFine;
  if (type == GL_UNSIGNED_INT_10F_11F_11F_REV) return format == GL_RGB ? kFine : kMismatch;
  if (type == GL_UNSIGNED_INT_5_9_9_9_REV) return format == GL_RGB ? kFine : kWrongType;
  const int packed = packed_components(type);
  if (packed == 0) return kWrongType;
  if (packed != components || format == GL_BGR) return kMismatch;
  if (format == GL_ABGR_EXT) { // OSMesa: with components of one size only
    switch (type) {
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_INT_8_8_8_8:
    case GL_UNSIGNED_INT_8_8_8_8_REV: break;
    default: return kMismatch;
    }
  }
  return kFine;
}

PixelFormat describe_pixel_format(GLenum format, GLenum type) {
  PixelFormat f{};
  f.format = format;
  f.type = type;
  f.components = 1;
  switch (format) {
  case GL_GREEN: f.target[0] = 1; break;
  case GL_BLUE: f.target[0] = 2; break;
  case GL_ALPHA: f.target[0] = 3; break;
  case GL_LUMINANCE: f.luminance = true; break;
  case GL_LUMINANCE_ALPHA:
    f.luminance = true;
    f.components = 2;
    f.target[1] = 3;
    break;
  case GL_RG:
    f.components = 2;
    f.target[1] = 1;
    break;
  case GL_RGB:
    f.components = 3;
    f.target[1] = 1;
    f.target[2] = 2;
    break;
  case GL_BGR:
    f.components = 3;
    f.target[0] = 2;
    f.target[1] = 1;
    break;
  case GL_RGBA:
    f.components = 4;
    f.target[1] = 1;
    f.target[2] = 2;
    f.target[3] = 3;
    break;
  case GL_BGRA:
    f.components = 4;
    f.target[0] = SOFTGL_FAULT(bgra_is_rgba) ? 0 : 2;
    f.target[1] = 1;
    if (SOFTGL_FAULT(bgra_is_rgba)) f.target[2] = 2;
    f.target[3] = 3;
    break;
  case GL_ABGR_EXT:
    f.components = 4;
    f.target[0] = 3;
    f.target[1] = 2;
    f.target[2] = 1;
    break;
  default: break; // red, indices, depth
  }
  switch (type) {
  case GL_UNSIGNED_BYTE:
    f.channel = PixelChannel::UnsignedByte;
    f.element_bytes = 1;
    break;
  case GL_BYTE:
    f.channel = PixelChannel::Byte;
    f.element_bytes = 1;
    break;
  case GL_UNSIGNED_SHORT:
    f.channel = PixelChannel::UnsignedShort;
    f.element_bytes = 2;
    break;
  case GL_SHORT:
    f.channel = PixelChannel::Short;
    f.element_bytes = 2;
    break;
  case GL_UNSIGNED_INT:
  case GL_UNSIGNED_INT_24_8: // of GL_DEPTH_STENCIL
    f.channel = PixelChannel::UnsignedInt;
    f.element_bytes = 4;
    break;
  case GL_INT:
    f.channel = PixelChannel::Int;
    f.element_bytes = 4;
    break;
  case GL_FLOAT:
  case GL_FLOAT_32_UNSIGNED_INT_24_8_REV: // of GL_DEPTH_STENCIL
    f.channel = PixelChannel::Float;
    f.element_bytes = 4;
    break;
  case GL_HALF_FLOAT:
    f.channel = PixelChannel::Half;
    f.element_bytes = 2;
    break;
  case GL_UNSIGNED_INT_10F_11F_11F_REV:
  case GL_UNSIGNED_INT_5_9_9_9_REV:
    f.channel = PixelChannel::PackedFloat;
    f.element_bytes = f.bytes = 4;
    return f;
  case GL_BITMAP:
    f.channel = PixelChannel::Bitmap;
    f.element_bytes = 1;
    break;
  default: {
    const PackedType p = packed_type(type);
    f.channel = PixelChannel::Packed;
    f.element_bytes = f.bytes = p.bytes;
    int used = 0;
    for (int i = 0; i < f.components; ++i) {
      f.bits[i] = p.bits[i];
      f.shift[i] =
          uint8_t(p.reversed && !SOFTGL_FAULT(reversed_ignored) ? used : p.bytes * 8 - used - p.bits[i]);
      used += p.bits[i];
    }
    return f;
  }
  }
  f.bytes = type == GL_BITMAP ? 0 : uint8_t(f.components * f.element_bytes);
  if (type == GL_FLOAT_32_UNSIGNED_INT_24_8_REV) f.bytes = 8; // a word of stencil values behind the float
  return f;
}

ImageLayout layout_image(const PixelStore& store, int dimensions, int width, int height,
                         const PixelFormat& format) {
  ImageLayout layout{};
  const size_t row_pixels =
      size_t(store.row_length > 0 && !SOFTGL_FAULT(row_length_ignored) ? store.row_length : width);
  const size_t rows = size_t(dimensions == 3 && store.image_height > 0 ? store.image_height : height);
  const size_t alignment = SOFTGL_FAULT(alignment_ignored) ? 1 : size_t(store.alignment);
  if (format.channel == PixelChannel::Bitmap) {
    layout.row_stride = ((row_pixels + 7) / 8 + alignment - 1) / alignment * alignment;
    layout.bit_offset = store.skip_pixels % 8;
    layout.offset = size_t(store.skip_pixels / 8);
    layout.row_bytes = (size_t(width) + size_t(layout.bit_offset) + 7) / 8;
  } else {
    layout.row_stride = (row_pixels * format.bytes + alignment - 1) / alignment * alignment;
    layout.offset = SOFTGL_FAULT(skip_pixels_ignored) ? 0 : size_t(store.skip_pixels) * format.bytes;
    layout.row_bytes = size_t(width) * format.bytes;
  }
  layout.image_stride = layout.row_stride * rows;
  layout.inverted = store.invert ? height : 0;
  if (dimensions >= 2 && !SOFTGL_FAULT(skip_rows_ignored))
    layout.offset += size_t(store.skip_rows) * layout.row_stride;
  if (dimensions == 3) layout.offset += size_t(store.skip_images) * layout.image_stride;
  return layout;
}

} // namespace softgl
