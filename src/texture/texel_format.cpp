#include "texture/texel_format.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"

namespace softgl {

namespace {

constexpr TexelLayout k8 = TexelLayout::Rgba8, k16 = TexelLayout::Rgba16, kDepth = TexelLayout::Depth;
constexpr TexelFormat kRgba8{GL_RGBA, k8, true, {8, 8, 8, 8}}, kRgb8{GL_RGB, k8, true, {8, 8, 8, 0}};
constexpr TexelFormat kAlpha8{GL_ALPHA, k8, true, {0, 0, 0, 8}},
    kLuminance8{GL_LUMINANCE, k8, true, {8, 8, 8, 0}};
constexpr TexelFormat kLuminanceAlpha8{GL_LUMINANCE_ALPHA, k8, true, {8, 8, 8, 8}},
    kIntensity8{GL_INTENSITY, k8, true, {8, 8, 8, 8}};
constexpr TexelFormat kLuminanceAlpha4{GL_LUMINANCE_ALPHA, k8, false, {4, 4, 4, 4}};
constexpr TexelFormat kRgb332{GL_RGB, k8, false, {3, 3, 2, 0}}, kRgb4{GL_RGB, k8, false, {4, 4, 4, 0}};
constexpr TexelFormat kRgb5{GL_RGB, k8, false, {5, 5, 5, 0}}, kRgb565{GL_RGB, k8, false, {5, 6, 5, 0}};
constexpr TexelFormat kRgba4{GL_RGBA, k8, false, {4, 4, 4, 4}}, kRgb5a1{GL_RGBA, k8, false, {5, 5, 5, 1}};
constexpr TexelFormat kRgb10{GL_RGB, k16, false, {10, 10, 10, 0}},
    kRgb10a2{GL_RGBA, k16, false, {10, 10, 10, 2}};
constexpr TexelFormat kRgba16{GL_RGBA, k16, true, {16, 16, 16, 16}},
    kRgb16{GL_RGB, k16, true, {16, 16, 16, 0}};
constexpr TexelFormat kAlpha16{GL_ALPHA, k16, true, {0, 0, 0, 16}},
    kLuminance16{GL_LUMINANCE, k16, true, {16, 16, 16, 0}};
constexpr TexelFormat kLuminanceAlpha16{GL_LUMINANCE_ALPHA, k16, true, {16, 16, 16, 16}};
constexpr TexelFormat kIntensity16{GL_INTENSITY, k16, true, {16, 16, 16, 16}};
constexpr TexelFormat kDepth16{GL_DEPTH_COMPONENT, kDepth, true, {16, 0, 0, 0}},
    kDepth24{GL_DEPTH_COMPONENT, kDepth, true, {24, 0, 0, 0}};
constexpr TexelFormat kDepth32{GL_DEPTH_COMPONENT, kDepth, true, {32, 0, 0, 0}};
constexpr TexelFormat kDepth24Stencil8{GL_DEPTH_STENCIL, kDepth, true, {24, 0, 0, 0}};
constexpr TexelFormat kDepth32f{GL_DEPTH_COMPONENT, kDepth, true, {32, 0, 0, 0}, true};
constexpr TexelFormat kDepth32fStencil8{GL_DEPTH_STENCIL, kDepth, true, {32, 0, 0, 0}, true};
constexpr TexelFormat kDxt1Rgb{GL_RGB, k8, true, {8, 8, 8, 0}, false, BlockFormat::Dxt1Rgb},
    kDxt1Rgba{GL_RGBA, k8, true, {8, 8, 8, 8}, false, BlockFormat::Dxt1Rgba};
constexpr TexelFormat kDxt3{GL_RGBA, k8, true, {8, 8, 8, 8}, false, BlockFormat::Dxt3},
    kDxt5{GL_RGBA, k8, true, {8, 8, 8, 8}, false, BlockFormat::Dxt5};

// Unsized internal formats take the client's own precision where OSMesa has a storage of just that form.
const TexelFormat* match_unsized(GLint internal_format, GLenum format, GLenum type, bool swap_bytes) {
  const bool rgba = format == GL_RGBA || format == GL_BGRA;
  if (!swap_bytes) {
    switch (internal_format) {
    case GL_ALPHA:
      if (format == GL_ALPHA && type == GL_UNSIGNED_SHORT) return &kAlpha16;
      break;
    case GL_LUMINANCE:
      if (format == GL_LUMINANCE && type == GL_UNSIGNED_SHORT) return &kLuminance16;
      break;
    case GL_LUMINANCE_ALPHA:
      if (format == GL_LUMINANCE_ALPHA && type == GL_UNSIGNED_SHORT) return &kLuminanceAlpha16;
      break;
    case GL_RGB:
      if (format == GL_RGB && (type == GL_UNSIGNED_SHORT_5_6_5 || type == GL_UNSIGNED_SHORT_5_6_5_REV))
        return &kRgb565;
      break;
    case GL_RGBA:
      if (rgba && (type == GL_UNSIGNED_SHORT_4_4_4_4 || type == GL_UNSIGNED_SHORT_4_4_4_4_REV))
        return &kRgba4;
      if (rgba && type == GL_UNSIGNED_SHORT_1_5_5_5_REV) return &kRgb5a1;
      if (format == GL_RGBA && type == GL_UNSIGNED_SHORT) return &kRgba16;
      if (rgba && type == GL_UNSIGNED_INT_10_10_10_2) return &kRgb10a2;
      break;
    case GL_DEPTH_COMPONENT:
      if (type == GL_UNSIGNED_SHORT) return &kDepth16;
      if (type == GL_UNSIGNED_INT) return &kDepth32;
      break;
    default: break;
    }
  }
  if (internal_format == GL_RGB && format == GL_RGB &&
      (type == GL_UNSIGNED_BYTE_3_3_2 || type == GL_UNSIGNED_BYTE_2_3_3_REV))
    return &kRgb332;
  if (type == GL_UNSIGNED_INT_2_10_10_10_REV)
    return internal_format == GL_RGB ? &kRgb10 : internal_format == GL_RGBA ? &kRgb10a2 : nullptr;
  if (type == GL_UNSIGNED_SHORT_5_5_5_1)
    return internal_format == GL_RGB ? &kRgb5 : internal_format == GL_RGBA ? &kRgb5a1 : nullptr;
  return nullptr;
}

} // namespace

GLenum base_internal_format(GLint internal_format) {
  const TexelFormat* f = choose_texel_format(internal_format, 0, 0, false);
  return f ? f->base : 0;
}

const TexelFormat* choose_texel_format(GLint internal_format, GLenum format, GLenum type, bool swap_bytes) {
  if (const TexelFormat* f = match_unsized(internal_format, format, type, swap_bytes)) return f;
  switch (internal_format) {
  case 4:
  case GL_RGBA:
  case GL_RGBA8:
  case GL_COMPRESSED_RGBA: return &kRgba8;
  case 3:
  case GL_RGB:
  case GL_RGB8:
  case GL_COMPRESSED_RGB: return &kRgb8;
  case 2:
  case GL_LUMINANCE_ALPHA:
  case GL_LUMINANCE6_ALPHA2:
  case GL_LUMINANCE8_ALPHA8:
  case GL_COMPRESSED_LUMINANCE_ALPHA: return &kLuminanceAlpha8;
  case 1:
  case GL_LUMINANCE:
  case GL_LUMINANCE4:
  case GL_LUMINANCE8:
  case GL_COMPRESSED_LUMINANCE: return &kLuminance8;
  case GL_ALPHA:
  case GL_ALPHA4:
  case GL_ALPHA8:
  case GL_COMPRESSED_ALPHA: return &kAlpha8;
  case GL_INTENSITY:
  case GL_INTENSITY4:
  case GL_INTENSITY8:
  case GL_COMPRESSED_INTENSITY: return &kIntensity8;
  case GL_LUMINANCE4_ALPHA4: return &kLuminanceAlpha4;
  case GL_R3_G3_B2: return &kRgb332;
  case GL_RGB4: return &kRgb4;
  case GL_RGB5: return &kRgb5;
  case GL_RGB10: return &kRgb10;
  case GL_RGB12:
  case GL_RGB16: return &kRgb16;
  case GL_RGBA2:
  case GL_RGBA4: return &kRgba4;
  case GL_RGB5_A1: return &kRgb5a1;
  case GL_RGB10_A2: return &kRgb10a2;
  case GL_RGBA12:
  case GL_RGBA16: return &kRgba16;
  case GL_ALPHA12:
  case GL_ALPHA16: return &kAlpha16;
  case GL_LUMINANCE12:
  case GL_LUMINANCE16: return &kLuminance16;
  case GL_LUMINANCE12_ALPHA4:
  case GL_LUMINANCE12_ALPHA12:
  case GL_LUMINANCE16_ALPHA16: return &kLuminanceAlpha16;
  case GL_INTENSITY12:
  case GL_INTENSITY16: return &kIntensity16;
  case GL_DEPTH_COMPONENT16: return &kDepth16;
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT24: return &kDepth24;
  case GL_DEPTH_COMPONENT32: return &kDepth32;
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8: return &kDepth24Stencil8;
  case GL_DEPTH_COMPONENT32F: return &kDepth32f;
  case GL_DEPTH32F_STENCIL8: return &kDepth32fStencil8;
  case GL_COMPRESSED_RGB_S3TC_DXT1_EXT: return &kDxt1Rgb;
  case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT: return &kDxt1Rgba;
  case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT: return &kDxt3;
  case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT: return &kDxt5;
  default: return nullptr;
  }
}

namespace {

constexpr int kRow = 256; // texels converted at a time

// Red, green, blue, alpha of the client's group to what the base format keeps, spread over the texel
// (table 3.15).
template <class T> void spread(GLenum base, T* v, T absent_one) {
  switch (base) {
  case GL_ALPHA: v[0] = v[1] = v[2] = 0; break;
  case GL_LUMINANCE:
    v[1] = v[2] = v[0];
    v[3] = absent_one;
    break;
  case GL_LUMINANCE_ALPHA: v[1] = v[2] = v[0]; break;
  case GL_INTENSITY: v[1] = v[2] = v[3] = v[0]; break;
  case GL_RGB: v[3] = absent_one; break;
  default: break;
  }
}
// And back: luminance and intensity are returned as red (table 6.1).
template <class T> void gather(GLenum base, T* v, T absent_one) {
  switch (base) {
  case GL_LUMINANCE:
  case GL_INTENSITY:
    v[1] = v[2] = 0;
    v[3] = absent_one;
    break;
  case GL_LUMINANCE_ALPHA: v[1] = v[2] = 0; break;
  case GL_RGB: v[3] = absent_one; break;
  default: break;
  }
}

// Bits repeated until they fill a byte.
uint8_t fill_byte(uint32_t v, int bits) { return uint8_t(convert_unorm(v, bits, 8)); }
int stored_bits(const TexelFormat& f, int k) {
  return f.bits[k] ? f.bits[k] : f.layout == TexelLayout::Rgba8 ? 8 : 0;
}

void store_rgba8(const TexelFormat& to, uint8_t (*texel)[4], const PixelFormat& from, const void* pixels,
                 int count, bool swap, const PixelTransfer& transfer) {
  const bool transfers = transfer.changes_color();
  if (transfers || (!to.array && from.format == GL_RGBA && from.channel == PixelChannel::Float)) {
    float v[kRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    if (transfers) transfer.clamped_color(v, count);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < 4; ++k)
        texel[i][k] = fill_byte(pack_unorm(v[i][k], stored_bits(to, k)), stored_bits(to, k));
  } else {
    unpack_pixels(from, pixels, count, swap, texel);
    if (!to.array)
      for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k)
          texel[i][k] = fill_byte(convert_unorm(texel[i][k], 8, stored_bits(to, k)), stored_bits(to, k));
  }
  if (to.base != GL_RGBA)
    for (int i = 0; i < count; ++i) spread<uint8_t>(to.base, texel[i], 255);
}

void store_rgba16(const TexelFormat& to, uint16_t (*texel)[4], const PixelFormat& from, const void* pixels,
                  int count, bool swap, const PixelTransfer& transfer) {
  const bool transfers = transfer.changes_color();
  const bool bytes = from.format == GL_RGBA && from.channel == PixelChannel::UnsignedByte;
  const bool floats = from.format == GL_RGBA && from.channel == PixelChannel::Float;
  if (to.array && !transfers && !floats) {
    unpack_pixels(from, pixels, count, swap, texel);
  } else if (bytes && !transfers) {
    uint8_t v[kRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < 4; ++k)
        texel[i][k] = uint16_t(to.bits[k] ? convert_unorm(v[i][k], 8, to.bits[k]) : 0);
  } else {
    float v[kRow][4];
    unpack_pixels(from, pixels, count, swap, v);
    if (transfers) transfer.clamped_color(v, count);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < 4; ++k)
        texel[i][k] = uint16_t(to.array || to.bits[k] ? pack_unorm(v[i][k], to.array ? 16 : to.bits[k]) : 0);
  }
  if (to.base != GL_RGBA)
    for (int i = 0; i < count; ++i) spread<uint16_t>(to.base, texel[i], 1);
}

void store_depth(const TexelFormat& to, uint32_t* texel, const PixelFormat& from, const void* pixels,
                 int count, bool swap, const PixelTransfer& transfer) {
  const bool plain = !transfer.changes_depth();
  auto p = static_cast<const unsigned char*>(pixels);
  if (to.floats) {
    float d[kRow];
    unpack_depth(from, pixels, count, swap, d);
    for (int i = 0; i < count; ++i) texel[i] = std::bit_cast<uint32_t>(transfer.depth(d[i]));
    return;
  }
  const int bits = to.bits[0];
  // Integers that need no float on their way.
  if (plain && !swap && from.channel == PixelChannel::UnsignedInt && (bits == 16 || bits == 32)) {
    for (int i = 0; i < count; ++i, p += 4) {
      uint32_t v;
      std::memcpy(&v, p, 4);
      texel[i] = bits == 16 ? v >> 16 : v;
    }
    return;
  }
  if (plain && !swap && from.channel == PixelChannel::UnsignedShort && (bits == 16 || bits == 32)) {
    for (int i = 0; i < count; ++i, p += 2) {
      uint16_t v;
      std::memcpy(&v, p, 2);
      texel[i] = bits == 16 ? v : uint32_t(v) | uint32_t(v) << 16;
    }
    return;
  }
  float d[kRow];
  unpack_depth(from, pixels, count, swap, d);
  for (int i = 0; i < count; ++i) {
    const float v = transfer.depth(d[i]);
    // OSMesa truncates here.
    if (bits == 32)
      texel[i] = uint32_t(std::min(double(v) * 4294967295.0, 4294967295.0));
    else
      texel[i] = uint32_t(v * float((1u << bits) - 1));
  }
}

} // namespace

void store_depth_stencil(const TexelFormat& to, uint32_t* texels, uint8_t* stencils, const PixelFormat& from,
                         const void* pixels, int count, bool swap_bytes, const PixelTransfer& transfer) {
  auto p = static_cast<const unsigned char*>(pixels);
  for (int i = 0; i < count; ++i, p += from.bytes) {
    const DepthStencilPixel v = unpack_depth_stencil(from, p, swap_bytes);
    if (to.floats)
      texels[i] = std::bit_cast<uint32_t>(transfer.depth(v.depth));
    else if (v.integer && !transfer.changes_depth())
      texels[i] = v.bits;
    else
      texels[i] = uint32_t(transfer.depth(v.depth) * 16777215.0f); // OSMesa truncates here
    stencils[i] = uint8_t(transfer.stencil(v.stencil));
  }
}

void load_depth_stencil(const TexelFormat& from, const uint32_t* texels, const uint8_t* stencils,
                        const PixelFormat& to, void* pixels, int count, bool swap_bytes) {
  auto p = static_cast<unsigned char*>(pixels);
  for (int i = 0; i < count; ++i, p += to.bytes) {
    DepthStencilPixel v;
    v.stencil = stencils[i];
    v.integer = !from.floats;
    v.bits = texels[i];
    v.depth = from.floats ? std::bit_cast<float>(texels[i]) : float(double(texels[i]) * (1.0 / 16777215.0));
    pack_depth_stencil(to, v, swap_bytes, p);
  }
}

void store_texels(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels, int count,
                  bool swap_bytes, const PixelTransfer& transfer) {
  auto p = static_cast<const unsigned char*>(pixels);
  auto t = static_cast<unsigned char*>(texels);
  for (int done = 0; done < count; done += kRow) {
    const int n = std::min(kRow, count - done);
    const unsigned char* source = p + size_t(done) * from.bytes;
    unsigned char* target = t + size_t(done) * size_t(to.bytes());
    switch (to.layout) {
    case TexelLayout::Rgba8:
      store_rgba8(to, reinterpret_cast<uint8_t(*)[4]>(target), from, source, n, swap_bytes, transfer);
      break;
    case TexelLayout::Rgba16:
      store_rgba16(to, reinterpret_cast<uint16_t(*)[4]>(target), from, source, n, swap_bytes, transfer);
      break;
    case TexelLayout::Depth:
      store_depth(to, reinterpret_cast<uint32_t*>(target), from, source, n, swap_bytes, transfer);
      break;
    }
  }
}

TexelRows::TexelRows(const TexelFormat& to, const PixelFormat& from, bool swap_bytes,
                     const PixelTransfer& transfer, uint64_t pixels)
    : to_(to), from_(from), swap_bytes_(swap_bytes), transfer_(transfer) {
  // Each byte of a texel is made of one component of its pixel, or of none: so a word for each value of each
  // component tells all. Measured: 16 million luminances take 20 ms in place of 250.
  constexpr uint64_t kWorthATable = 4096;
  if (to.layout != TexelLayout::Rgba8 || from.channel != PixelChannel::UnsignedByte || from.components > 2 ||
      pixels < kWorthATable)
    return;
  unsigned char pixel[256 * 2];
  for (int k = 0; k < from.components; ++k) {
    std::memset(pixel, 0, sizeof pixel);
    for (int v = 0; v < 256; ++v) pixel[v * from.components + k] = uint8_t(v);
    store_texels(to, table_[k], from, pixel, 256, swap_bytes, transfer);
    if (k > 0) // what a pixel of zeros gives is in the first component's words
      for (int v = 255; v >= 0; --v) table_[k][v] ^= table_[k][0];
  }
  table_components_ = from.components;
}

void TexelRows::store(void* texels, const void* pixels, int count) const {
  const auto* p = static_cast<const uint8_t*>(pixels);
  auto* texel = static_cast<uint32_t*>(texels);
  switch (table_components_) {
  case 1:
    for (int i = 0; i < count; ++i) texel[i] = table_[0][p[i]];
    return;
  case 2:
    for (int i = 0; i < count; ++i) texel[i] = table_[0][p[2 * i]] ^ table_[1][p[2 * i + 1]];
    return;
  default: store_texels(to_, texels, from_, pixels, count, swap_bytes_, transfer_);
  }
}

void store_color_indexes(const TexelFormat& to, void* texels, const PixelFormat& from, const void* pixels,
                         int bit_offset, int count, bool swap_bytes, bool lsb_first,
                         const PixelTransfer& transfer) {
  const PixelFormat color = describe_pixel_format(GL_RGBA, GL_UNSIGNED_BYTE); // for wider texels, too
  auto p = static_cast<const unsigned char*>(pixels);
  auto t = static_cast<unsigned char*>(texels);
  for (int done = 0; done < count; done += kRow) {
    const int n = std::min(kRow, count - done);
    uint32_t index[kRow];
    uint8_t rgba[kRow][4];
    unpack_indexes(from, p + size_t(done) * from.bytes,
                   from.channel == PixelChannel::Bitmap ? bit_offset + done : 0, n, swap_bytes, lsb_first,
                   index);
    for (int i = 0; i < n; ++i) {
      float value[4];
      transfer.index_to_color(index[i], value);
      for (int k = 0; k < 4; ++k) rgba[i][k] = uint8_t(float_to_unorm(value[k], 8));
    }
    store_texels(to, t + size_t(done) * size_t(to.bytes()), color, rgba, n, false, PixelTransfer::none());
  }
}

namespace {

bool wide_packed(const PixelFormat& f) { return f.channel == PixelChannel::Packed && f.bits[0] > 8; }
bool wide_or_signed(const PixelFormat& f) {
  if (f.channel == PixelChannel::Packed) return f.bits[0] > 8;
  return f.channel != PixelChannel::UnsignedByte;
}

void load_color(const TexelFormat& from, const unsigned char* texels, const PixelFormat& to, void* pixels,
                int count, bool swap) {
  const bool narrow = from.layout == TexelLayout::Rgba8;
  auto stored = [&](int i, int k) -> uint32_t { // the stored integer
    if (narrow) {
      const uint8_t v = texels[i * 4 + k];
      return from.bits[k] ? v >> (8 - from.bits[k]) : v != 0;
    }
    uint16_t v;
    std::memcpy(&v, texels + i * 8 + k * 2, 2);
    return v;
  };
  const bool exact_bytes = from.array && from.base == GL_RGBA;
  // OSMesa clamps luminance for unsigned types, and does so in floats.
  const bool clamps = to.luminance && to.channel != PixelChannel::Float && to.channel != PixelChannel::Byte &&
                      to.channel != PixelChannel::Short && to.channel != PixelChannel::Int;
  const bool floats = clamps || (from.array ? (narrow ? wide_packed(to) && !exact_bytes : wide_packed(to))
                                            : wide_or_signed(to));
  if (floats) {
    float v[kRow][4];
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < 4; ++k)
        v[i][k] = from.bits[k] ? unorm_to_float(stored(i, k), from.bits[k]) : float(stored(i, k));
      gather<float>(from.base, v[i], 1.0f);
    }
    pack_pixels(to, v, count, swap, pixels);
  } else if (!narrow && from.array) {
    uint16_t v[kRow][4];
    std::memcpy(v, texels, size_t(count) * 8);
    for (int i = 0; i < count; ++i) {
      if (from.bits[3] == 0) v[i][3] = 65535;
      gather<uint16_t>(from.base, v[i], 65535);
    }
    pack_pixels(to, v, count, swap, pixels);
  } else {
    uint8_t v[kRow][4];
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < 4; ++k)
        v[i][k] = narrow ? texels[i * 4 + k]
                         : uint8_t(from.bits[k] ? convert_unorm(stored(i, k), from.bits[k], 8)
                                                : 255 * stored(i, k));
      gather<uint8_t>(from.base, v[i], 255);
    }
    pack_pixels(to, v, count, swap, pixels);
  }
}

} // namespace

void load_texels(const TexelFormat& from, const void* texels, const PixelFormat& to, void* pixels, int count,
                 bool swap_bytes) {
  auto t = static_cast<const unsigned char*>(texels);
  auto p = static_cast<unsigned char*>(pixels);
  for (int done = 0; done < count; done += kRow) {
    const int n = std::min(kRow, count - done);
    const unsigned char* source = t + size_t(done) * size_t(from.bytes());
    unsigned char* target = p + size_t(done) * to.bytes;
    if (from.layout != TexelLayout::Depth) {
      load_color(from, source, to, target, n, swap_bytes);
      continue;
    }
    const int bits = from.bits[0];
    if (!swap_bytes && !from.floats &&
        ((bits == 32 && to.channel == PixelChannel::UnsignedInt) ||
         (bits == 16 && to.channel == PixelChannel::UnsignedShort))) {
      for (int i = 0; i < n; ++i)
        std::memcpy(target + size_t(i) * to.bytes, source + i * 4, to.bytes); // the stored integer itself
      continue;
    }
    float d[kRow];
    for (int i = 0; i < n; ++i) {
      uint32_t v;
      std::memcpy(&v, source + i * 4, 4);
      d[i] = from.floats  ? std::bit_cast<float>(v)
             : bits == 16 ? float(v) * (1.0f / 65535.0f)
                          : float(double(v) * (1.0 / double((uint64_t(1) << bits) - 1)));
    }
    pack_depth(to, d, n, swap_bytes, target);
  }
}

} // namespace softgl
