// Rows of pixels are converted in steps and by chunks; a pixel must not notice (GL 1.5, 3.6.4 and 4.3.2).
#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "texture/component_values.h"
#include "texture/pixel_formats.h"
#include "texture/small_floats.h"

using namespace softgl;

namespace {

constexpr GLenum kFormats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                               GL_RG,  GL_RGB,   GL_BGR,  GL_RGBA,  GL_BGRA,      GL_ABGR_EXT};
constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE,
                             GL_BYTE,
                             GL_UNSIGNED_SHORT,
                             GL_SHORT,
                             GL_UNSIGNED_INT,
                             GL_INT,
                             GL_FLOAT,
                             GL_HALF_FLOAT,
                             GL_UNSIGNED_BYTE_3_3_2,
                             GL_UNSIGNED_BYTE_2_3_3_REV,
                             GL_UNSIGNED_SHORT_5_6_5,
                             GL_UNSIGNED_SHORT_5_6_5_REV,
                             GL_UNSIGNED_SHORT_4_4_4_4,
                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                             GL_UNSIGNED_SHORT_5_5_5_1,
                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                             GL_UNSIGNED_INT_8_8_8_8,
                             GL_UNSIGNED_INT_8_8_8_8_REV,
                             GL_UNSIGNED_INT_10_10_10_2,
                             GL_UNSIGNED_INT_2_10_10_10_REV,
                             GL_UNSIGNED_INT_10F_11F_11F_REV,
                             GL_UNSIGNED_INT_5_9_9_9_REV};

/// Calls f(format) for every format and type that go together.
template <class F> void for_each_format(F f) {
  for (GLenum format : kFormats)
    for (GLenum type : kTypes)
      if (!check_pixel_format(format, type)) f(describe_pixel_format(format, type));
}

constexpr int kPixels = 300; // more than two chunks

std::vector<unsigned char> random_bytes(size_t count) {
  std::mt19937 random(7);
  std::vector<unsigned char> bytes(count);
  for (unsigned char& b : bytes) b = static_cast<unsigned char>(random());
  return bytes;
}

/// Memory that ends with the row, so that a look behind it is found by ASan.
template <class T> struct Row {
  std::vector<T> v;
  T (*colors())[4] { return reinterpret_cast<T(*)[4]>(v.data()); }
  explicit Row(int pixels) : v(size_t(pixels) * 4) {}
};

/// 0 to 1 in bytes, shorts, floats, as pack_pixels takes them.
template <class T> T some_component(std::mt19937& random) {
  if constexpr (std::is_same_v<T, float>)
    return float(random() % 4097) / 2048.0f - 0.5f; // beyond [0, 1], too
  else
    return T(random());
}

template <class T> void unpacks_alike() {
  for_each_format([](const PixelFormat& f) {
    const std::vector<unsigned char> bytes = random_bytes(size_t(kPixels) * f.bytes);
    for (bool swap : {false, true})
      for (int count : {1, 2, 3, 127, 128, 129, kPixels}) {
        const std::vector<unsigned char> exact(bytes.begin(), bytes.begin() + ptrdiff_t(count) * f.bytes);
        Row<T> row(count), one(1);
        unpack_pixels(f, exact.data(), count, swap, row.colors());
        for (int i = 0; i < count; ++i) {
          const unsigned char* pixel = exact.data() + size_t(i) * f.bytes;
          const std::vector<unsigned char> alone(pixel, pixel + f.bytes);
          unpack_pixels(f, alone.data(), 1, swap, one.colors());
          if (std::memcmp(one.v.data(), row.v.data() + size_t(i) * 4, 4 * sizeof(T)) != 0)
            FAIL("pixel " << i << " of " << count << ", format " << std::hex << f.format << ", type "
                          << f.type);
        }
      }
    SUCCEED();
  });
}

template <class T> void packs_alike() {
  std::mt19937 random(9);
  Row<T> row(kPixels);
  for (T& v : row.v) v = some_component<T>(random);
  for_each_format([&](const PixelFormat& f) {
    for (bool swap : {false, true})
      for (int count : {1, 2, 3, 4, 5, 127, 128, 129, kPixels}) {
        std::vector<unsigned char> packed(size_t(count) * f.bytes), alone(f.bytes);
        pack_pixels(f, row.colors(), count, swap, packed.data());
        for (int i = 0; i < count; ++i) {
          pack_pixels(f, row.colors() + i, 1, swap, alone.data());
          if (std::memcmp(alone.data(), packed.data() + size_t(i) * f.bytes, f.bytes) != 0)
            FAIL("pixel " << i << " of " << count << ", format " << std::hex << f.format << ", type "
                          << f.type);
        }
      }
    SUCCEED();
  });
}

bool same(float a, float b) { return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b); }

} // namespace

TEST_CASE("A pixel is unpacked alike alone and in a row", "[pixels]") {
  unpacks_alike<uint8_t>();
  unpacks_alike<uint16_t>();
  unpacks_alike<float>();
  unpacks_alike<int8_t>();
  unpacks_alike<int16_t>();
}

TEST_CASE("A pixel is packed alike alone and in a row", "[pixels]") {
  packs_alike<uint8_t>();
  packs_alike<uint16_t>();
  packs_alike<float>();
  packs_alike<int8_t>();
  packs_alike<int16_t>();
}

TEST_CASE("Bytes that are packed as they were unpacked come back", "[pixels]") {
  for_each_format([](const PixelFormat& f) {
    if (f.element_bytes != 1 && !(f.channel == PixelChannel::Packed && f.bits[0] == 8)) return;
    if (f.channel == PixelChannel::Byte) return;
    const std::vector<unsigned char> bytes = random_bytes(size_t(kPixels) * f.bytes);
    std::vector<unsigned char> back(bytes.size());
    Row<uint8_t> row(kPixels);
    unpack_pixels(f, bytes.data(), kPixels, true, row.colors());
    pack_pixels(f, row.colors(), kPixels, true, back.data());
    INFO(std::hex << "format " << f.format << " type " << f.type);
    REQUIRE(bytes == back);
  });
}

TEST_CASE("Reversed packed types have their components where table 3.8 says", "[pixels]") {
  const uint32_t word = 0x11223344u;
  const auto unpacked = [&](GLenum format, GLenum type) {
    uint8_t rgba[1][4];
    unpack_pixels(describe_pixel_format(format, type), &word, 1, false, rgba);
    return std::vector<int>(rgba[0], rgba[0] + 4);
  };
  CHECK(unpacked(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8) == std::vector<int>{0x11, 0x22, 0x33, 0x44});
  CHECK(unpacked(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV) == std::vector<int>{0x44, 0x33, 0x22, 0x11});
  CHECK(unpacked(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8) == std::vector<int>{0x33, 0x22, 0x11, 0x44});
  CHECK(unpacked(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV) == std::vector<int>{0x22, 0x33, 0x44, 0x11});
  CHECK(unpacked(GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8) == std::vector<int>{0x44, 0x33, 0x22, 0x11});
  CHECK(unpacked(GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8_REV) == std::vector<int>{0x11, 0x22, 0x33, 0x44});
}

TEST_CASE("Rows of floats are reduced as one float is", "[pixels]") {
  // Every sign, exponent and upper mantissa, with lower bits around the middle of two halves.
  std::vector<float> value;
  for (uint32_t upper = 0; upper < 0x10000; upper += 3)
    for (uint32_t lower : {0u, 1u, 0x0fffu, 0x1000u, 0x1001u, 0x8000u, 0xffffu})
      value.push_back(std::bit_cast<float>(upper << 16 | lower));
  std::vector<float> cut = value, rounded = value;
  reduce_to_halves(cut.data(), int(cut.size()));
  round_to_halves(rounded.data(), int(rounded.size()));
  for (size_t i = 0; i < value.size(); ++i) {
    const float v = value[i];
    bool all = same(cut[i], half_to_float(float_to_half_towards_zero(v))) &&
               same(rounded[i], half_to_float(float_to_half(v)));
    for (int mantissa : {5, 6})
      all = all && same(reduce_to_unsigned_float(v, mantissa),
                        unsigned_float(to_unsigned_float(v, mantissa), mantissa));
    if (!all) FAIL(std::hex << std::bit_cast<uint32_t>(v));
  }
  SUCCEED();
}

TEST_CASE("Components are rounded as their definitions say", "[pixels]") {
  std::mt19937 random(11);
  for (int n = 0; n < 200000; ++n) {
    const float x = n < 70000 ? float(n) / 65535.0f : std::bit_cast<float>(uint32_t(random()));
    const double clamped = x > 0 ? std::min(double(x), 1.0) : 0.0;
    bool all = true;
    for (int bits : {1, 2, 3, 4, 5, 6, 8, 10, 16}) {
      const float max = float((1 << bits) - 1);
      all = all && float_to_unorm(x, bits) == uint32_t(std::nearbyint(float(clamped) * max));
      all = all && (bits == 8 || pack_unorm(x, bits) == uint32_t(float(clamped) * max + 0.5f));
    }
    for (int bits : {8, 16}) {
      const float max = float((1 << (bits - 1)) - 1);
      all = all &&
            (x != x || float_to_snorm(x, bits) == int32_t(std::nearbyint(std::clamp(x, -1.0f, 1.0f) * max)));
    }
    if (!all) FAIL(std::hex << std::bit_cast<uint32_t>(x));
  }
  for (uint32_t x = 0; x < 65536; ++x)
    for (int to : {1, 4, 5, 8, 10})
      if (convert_unorm(x, 16, to) != (uint64_t(x) * ((1u << to) - 1) + 32767) / 65535)
        FAIL(x << " in " << to << " bits");
  SUCCEED();
}
