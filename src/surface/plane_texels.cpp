#include "surface/plane_texels.h"

#include <algorithm>
#include <cstring>

#include "shaders/common/color_encoding.h"
#include "texture/base_format.h"
#include "texture/component_values.h"

namespace softgl {
namespace {

uint16_t to_565(const unsigned char* texel) {
  return uint16_t((texel[0] & 0xf8) << 8 | (texel[1] & 0xfc) << 3 | texel[2] >> 3);
}
void from_565(uint32_t v, unsigned char* texel) {
  texel[0] = uint8_t(convert_unorm(v >> 11 & 31, 5, 8));
  texel[1] = uint8_t(convert_unorm(v >> 5 & 63, 6, 8));
  texel[2] = uint8_t(convert_unorm(v & 31, 5, 8));
  texel[3] = 255;
}

/// Calls convert(numbers of a color) for colors that are copied from `from` to `to`.
template <class T, class Convert> void copy_colors(const void* from, void* to, int count, Convert convert) {
  auto p = static_cast<const unsigned char*>(from);
  auto t = static_cast<unsigned char*>(to);
  for (int i = 0; i < count; ++i, p += 4 * sizeof(T), t += 4 * sizeof(T)) {
    T v[4];
    std::memcpy(v, p, sizeof v);
    convert(v);
    std::memcpy(t, v, sizeof v);
  }
}

/// Texels of 16 bits hold the integer itself, pixels fill their bits with it; an absent alpha is 1 there.
int integer_bits(const TexelFormat& f, int k) { return f.bits[k] ? f.bits[k] : 16; }
uint16_t pixel_one(const TexelFormat& f) {
  if (f.layout == TexelLayout::Rgba16) return 0xffff;
  return *std::max_element(f.bits, f.bits + 4) == 8 ? 127 : 32767;
}

} // namespace

void pixels_to_texels(const TexelFormat& f, ColorFormat storage, const void* pixels, int count,
                      void* texels) {
  switch (storage) {
  case ColorFormat::Rgb565: {
    auto p = static_cast<const unsigned char*>(pixels);
    for (int i = 0; i < count; ++i) {
      uint16_t v;
      std::memcpy(&v, p + 2 * i, 2);
      from_565(v, static_cast<unsigned char*>(texels) + 4 * i);
    }
    return;
  }
  case ColorFormat::Rgba8:
    if (f.base == GL_RGBA || f.base == GL_RGB) {
      std::memcpy(texels, pixels, 4 * size_t(count));
      return;
    }
    return copy_colors<uint8_t>(pixels, texels, count, [&](uint8_t* v) { spread<uint8_t>(f.base, v, 255); });
  case ColorFormat::Rgba16:
    return copy_colors<uint16_t>(pixels, texels, count, [&](uint16_t* v) {
      if (f.layout == TexelLayout::Rgba16)
        for (int k = 0; k < 4; ++k) v[k] = uint16_t(v[k] >> (16 - integer_bits(f, k)));
      spread<uint16_t>(f.base, v, 1);
    });
  case ColorFormat::RgbaFloat:
    return copy_colors<float>(pixels, texels, count, [&](float* v) { spread<float>(f.base, v, 1); });
  }
}

void texels_to_pixels(const TexelFormat& f, ColorFormat storage, const void* texels, int count,
                      void* pixels) {
  switch (storage) {
  case ColorFormat::Rgb565:
    for (int i = 0; i < count; ++i) {
      const uint16_t v = to_565(static_cast<const unsigned char*>(texels) + 4 * i);
      std::memcpy(static_cast<unsigned char*>(pixels) + 2 * i, &v, 2);
    }
    return;
  case ColorFormat::Rgba8:
    return copy_colors<uint8_t>(texels, pixels, count, [&](uint8_t* v) { gather<uint8_t>(f.base, v, 255); });
  case ColorFormat::Rgba16:
    return copy_colors<uint16_t>(texels, pixels, count, [&](uint16_t* v) {
      gather<uint16_t>(f.base, v, pixel_one(f));
      if (f.layout != TexelLayout::Rgba16) return;
      for (int k = 0; k < 4; ++k)
        if (f.bits[k]) v[k] = uint16_t(fill_bits(v[k], f.bits[k], 16));
    });
  case ColorFormat::RgbaFloat:
    return copy_colors<float>(texels, pixels, count, [&](float* v) { gather<float>(f.base, v, 1); });
  }
}

} // namespace softgl
