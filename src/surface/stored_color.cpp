#include "surface/stored_color.h"

#include <algorithm>
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

float srgb_byte(float v) {
  const float curve = v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
  return std::nearbyint(curve * 255.0f);
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
