#include "surface/stored_color.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/unit_range.h"
#include "shaders/common/color_encoding.h"
#include "shaders/common/srgb.h"
#include "texture/small_floats.h"

namespace softgl {
namespace {

float halves_up(float v) { return std::floor(v + 0.5f); }
float halves_away(float v) { return v < 0 ? -halves_up(-v) : halves_up(v); }

/// A float of [0, 1] as an integer of `bits`, which fills `wide` ones.
float unsigned_number(float v, int bits, int wide, bool drawn) {
  const auto one = [](int n) { return float((1u << n) - 1); };
  if (drawn) return float(drawn_number(uint32_t(std::nearbyint(v * one(wide))), bits, wide));
  const float number = bits == 8 ? std::nearbyint(v * one(bits)) : halves_up(v * one(bits));
  return float(fill_bits(uint32_t(number), bits, wide));
}

float signed_number(float v, int bits, bool drawn) {
  const float one = float((1 << (bits - 1)) - 1);
  const float scaled = std::clamp(v, drawn && bits == 8 ? -128.0f / one : -1.0f, 1.0f) * one;
  return drawn ? std::nearbyint(scaled) : halves_away(scaled);
}

float float_number(float v, int bits, bool drawn) {
  if (drawn || bits == 32) return drawn_float(v, bits);
  if (bits == 16) return half_to_float(float_to_half_towards_zero(v));
  return unsigned_float(to_unsigned_float(v, bits - 5), bits - 5);
}

/// The least linear numbers of the bytes 1 to 255 of sRGB in a clear of all: measured of OSMesa 22.3.6, which
/// is within 0.05 of the curve. The upper 20 bits of the floats, less 0x39000.
// clang-format off
constexpr uint16_t kSrgbBytes[255] = {
    0x01ed, 0x0eed, 0x146f, 0x18b3, 0x1b32, 0x1dae, 0x2014, 0x2153, 0x2291, 0x23cf, 0x250d, 0x2660,
    0x27c4, 0x289d, 0x2963, 0x2a31, 0x2b09, 0x2bed, 0x2cdb, 0x2dd4, 0x2ed6, 0x2fe3, 0x307f, 0x310f,
    0x31a7, 0x3244, 0x32e5, 0x338f, 0x343b, 0x34ee, 0x35a9, 0x3668, 0x372e, 0x37f9, 0x3866, 0x38d1,
    0x3941, 0x39b3, 0x3a27, 0x3aa0, 0x3b1a, 0x3b9a, 0x3c1c, 0x3ca2, 0x3d2a, 0x3db6, 0x3e45, 0x3ed7,
    0x3f6e, 0x4002, 0x4052, 0x40a2, 0x40f2, 0x4147, 0x419d, 0x41f2, 0x424c, 0x42a7, 0x4302, 0x4362,
    0x43c1, 0x4423, 0x4487, 0x44ec, 0x4554, 0x45bd, 0x4628, 0x4695, 0x4703, 0x4775, 0x47e7, 0x482e,
    0x486a, 0x48a6, 0x48e2, 0x4921, 0x4961, 0x49a1, 0x49e1, 0x4a23, 0x4a67, 0x4aab, 0x4aef, 0x4b36,
    0x4b7d, 0x4bc5, 0x4c0d, 0x4c59, 0x4ca4, 0x4cef, 0x4d3d, 0x4d8c, 0x4ddb, 0x4e2b, 0x4e7d, 0x4ecf,
    0x4f22, 0x4f78, 0x4fcd, 0x5011, 0x503e, 0x506b, 0x5098, 0x50c5, 0x50f2, 0x5122, 0x5152, 0x5182,
    0x51b2, 0x51e2, 0x5213, 0x5246, 0x5279, 0x52ac, 0x52de, 0x5313, 0x5348, 0x537e, 0x53b4, 0x53e9,
    0x5421, 0x5459, 0x5491, 0x54ca, 0x5502, 0x553d, 0x5578, 0x55b3, 0x55ee, 0x562b, 0x5668, 0x56a6,
    0x56e3, 0x5722, 0x5762, 0x57a2, 0x57e2, 0x5811, 0x5833, 0x5854, 0x5876, 0x5898, 0x58b9, 0x58db,
    0x58fd, 0x5921, 0x5945, 0x5968, 0x598c, 0x59b0, 0x59d4, 0x59f8, 0x5a1e, 0x5a44, 0x5a6b, 0x5a91,
    0x5ab7, 0x5add, 0x5b04, 0x5b2c, 0x5b54, 0x5b7c, 0x5ba5, 0x5bcd, 0x5bf5, 0x5c1f, 0x5c49, 0x5c73,
    0x5c9d, 0x5cc7, 0x5cf2, 0x5d1d, 0x5d4a, 0x5d76, 0x5da2, 0x5dce, 0x5dfa, 0x5e28, 0x5e56, 0x5e84,
    0x5eb2, 0x5ee0, 0x5f0f, 0x5f3f, 0x5f6f, 0x5f9f, 0x5fcf, 0x5ffe, 0x6017, 0x6031, 0x604a, 0x6063,
    0x607c, 0x6096, 0x60af, 0x60c8, 0x60e1, 0x60fb, 0x6116, 0x6130, 0x614b, 0x6166, 0x6181, 0x619c,
    0x61b7, 0x61d2, 0x61ed, 0x6209, 0x6225, 0x6242, 0x625e, 0x627b, 0x6298, 0x62b4, 0x62d1, 0x62ed,
    0x630b, 0x6329, 0x6347, 0x6365, 0x6383, 0x63a1, 0x63bf, 0x63de, 0x63fc, 0x641b, 0x643b, 0x645a,
    0x647a, 0x649a, 0x64b9, 0x64d9, 0x64f9, 0x6519, 0x653a, 0x655b, 0x657d, 0x659e, 0x65bf, 0x65e0,
    0x6601, 0x6624, 0x6646, 0x6669, 0x668b, 0x66ae, 0x66d0, 0x66f3, 0x6716, 0x673a, 0x675e, 0x6782,
    0x67a6, 0x67c9, 0x67ed,
};
// clang-format on

float srgb_byte(float v) {
  const auto number = int32_t(std::bit_cast<uint32_t>(v) >> 12) - 0x39000;
  return float(std::upper_bound(kSrgbBytes, kSrgbBytes + 255, number) - kSrgbBytes);
}

float number_565(float v, int component, bool drawn) {
  if (!drawn) return halves_up(v * (component == 1 ? 63.0f : 31.0f));
  const auto byte = int(std::nearbyint(v * 255.0f));
  return float(component == 1 ? byte >> 2 : byte >> 3);
}

} // namespace

ColorEncoding whole_encoding(ColorFormat format, bool has_alpha) {
  ColorEncoding e;
  if (format == ColorFormat::RgbaFloat) e.numbers = ColorNumbers::Float;
  const uint8_t bits = format == ColorFormat::RgbaFloat ? 32 : format == ColorFormat::Rgba16 ? 16 : 8;
  for (uint8_t& b : e.bits) b = bits;
  if (!has_alpha) e.bits[3] = 0;
  return e;
}

void fill_alpha(ColorFormat format, const ColorEncoding& e, void* memory, size_t bytes) {
  if (format == ColorFormat::Rgba16) {
    const bool narrow = *std::max_element(e.bits, e.bits + 4) == 8;
    const uint16_t one = e.numbers == ColorNumbers::Unsigned ? 0xffff : narrow ? 127 : 32767;
    for (size_t i = 0; i < bytes / 8; ++i) static_cast<uint16_t*>(memory)[4 * i + 3] = one;
  }
  if (format == ColorFormat::RgbaFloat)
    for (size_t i = 0; i < bytes / 16; ++i) static_cast<float*>(memory)[4 * i + 3] = 1.0f;
}

namespace {

/// The numbers of a color.
void store_color(ColorFormat format, const ColorEncoding& e, bool srgb, const float* rgba, bool drawn,
                 float* value) {
  for (int i = 0; i < 4; ++i) {
    const int bits = e.bits[i];
    value[i] = i == 3 ? 255.0f : 0.0f; // of bytes
    if (bits == 0 && format != ColorFormat::Rgb565) continue;
    const float v = unit_range(rgba[i]);
    switch (format) {
    case ColorFormat::Rgba8:
      if (srgb && i < 3)
        value[i] = drawn ? std::nearbyint(linear_to_srgb(v)) : srgb_byte(v);
      else
        value[i] = unsigned_number(v, bits, 8, drawn);
      break;
    case ColorFormat::Rgb565: value[i] = number_565(v, i, drawn); break;
    case ColorFormat::Rgba16:
      value[i] = e.numbers == ColorNumbers::Signed ? signed_number(rgba[i], bits, drawn)
                                                   : unsigned_number(v, bits, 16, drawn);
      break;
    case ColorFormat::RgbaFloat: value[i] = float_number(rgba[i], bits, drawn); break;
    }
  }
}

} // namespace

void store_clear_color(const Surface& s, bool srgb, const float* rgba, bool drawn, float (&value)[4]) {
  store_color(s.color_format, s.encoding, srgb, rgba, drawn, value);
}

void store_drawn_colors(ColorFormat format, const ColorEncoding& e, const float (*rgba)[4], int count,
                        void* pixels) {
  auto p = static_cast<unsigned char*>(pixels);
  for (int i = 0; i < count; ++i, p += bytes_per_pixel(format)) {
    float v[4];
    store_color(format, e, false, rgba[i], true, v);
    if (format == ColorFormat::RgbaFloat) {
      std::memcpy(p, v, sizeof v);
    } else if (format == ColorFormat::Rgb565) {
      const auto word = uint16_t(int(v[0]) << 11 | int(v[1]) << 5 | int(v[2]));
      std::memcpy(p, &word, sizeof word);
    } else if (format == ColorFormat::Rgba16) {
      uint16_t numbers[4];
      for (int k = 0; k < 4; ++k) numbers[k] = uint16_t(int32_t(v[k]));
      std::memcpy(p, numbers, sizeof numbers);
    } else {
      for (int k = 0; k < 4; ++k) p[k] = uint8_t(v[k]);
    }
  }
}

} // namespace softgl
