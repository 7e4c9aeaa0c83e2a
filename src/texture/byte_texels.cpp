#include "texture/byte_texels.h"

#include <algorithm>
#include <cstring>

#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"
#include "texture/texel_format.h"

namespace softgl {

bool ByteTexels::find(const TexelFormat& to, const PixelFormat& from) {
  if (to.layout != TexelLayout::Rgba8 || from.channel != PixelChannel::UnsignedByte) return false;
  components_ = from.components;
  // Two pixels of different bytes tell.
  uint8_t pixel[2][4], texel[2][4];
  for (int k = 0; k < components_; ++k)
    pixel[0][k] = uint8_t(37 + 50 * k), pixel[1][k] = uint8_t(216 - 53 * k);
  for (int i = 0; i < 2; ++i) store_texels(to, texel[i], from, pixel[i], 1, false, PixelTransfer::none());
  taken_ = fixed_ = 0;
  for (int b = 0; b < 4; ++b) {
    int k = 0;
    while (k < components_ && (texel[0][b] != pixel[0][k] || texel[1][b] != pixel[1][k])) ++k;
    if (k < components_) {
      source_[b] = uint8_t(k);
      taken_ |= 0xffu << (8 * b);
    } else if (texel[0][b] == texel[1][b] && (texel[0][b] == 0 || texel[0][b] == 255)) {
      source_[b] = uint8_t(std::min(b, components_ - 1));
      fixed_ |= uint32_t(texel[0][b]) << (8 * b);
    } else {
      return false;
    }
  }
  return true;
}

namespace {

constexpr uint32_t repeated(uint32_t byte) { return byte | byte << 8 | byte << 16 | byte << 24; }

template <int kBytes> uint32_t load(const uint8_t* pixel) {
  uint32_t word = 0;
  std::memcpy(&word, pixel, kBytes);
  return word;
}

/// Sets the texels to what `texel_of` makes of the pixels' words; their bytes behind the pixel may be any.
template <int kBytes, class Make>
void convert(uint32_t* texels, const uint8_t* pixels, int count, Make texel_of) {
  if constexpr (kBytes == 3) { // all but the last one have a byte behind them
    for (int i = 0; i < count - 1; ++i) texels[i] = texel_of(load<4>(pixels + 3 * i));
    if (count > 0) texels[count - 1] = texel_of(load<3>(pixels + 3 * (count - 1)));
  } else {
    for (int i = 0; i < count; ++i) texels[i] = texel_of(load<kBytes>(pixels + kBytes * i));
  }
}

template <int kBytes> void convert_any(uint32_t* texels, const uint8_t* pixels, int count,
                                       const uint8_t* source, uint32_t taken, uint32_t fixed) {
  const auto is = [&](int r, int g, int b, int a) { // of the bytes that are taken
    const int s[4] = {r, g, b, a};
    for (int i = 0; i < 4; ++i)
      if ((taken >> (8 * i) & 1) && source[i] != s[i]) return false;
    return true;
  };
  if (is(0, 0, 0, 0))
    return convert<kBytes>(texels, pixels, count,
                           [=](uint32_t v) { return (repeated(v & 255) & taken) | fixed; });
  if (is(0, 0, 0, 1))
    return convert<kBytes>(texels, pixels, count, [=](uint32_t v) {
      return (((repeated(v & 255) & 0xffffffu) | (v & 0xff00u) << 16) & taken) | fixed;
    });
  if (is(0, 1, 2, 3))
    return convert<kBytes>(texels, pixels, count, [=](uint32_t v) { return (v & taken) | fixed; });
  if (is(2, 1, 0, 3))
    return convert<kBytes>(texels, pixels, count, [=](uint32_t v) {
      return (((v & 0xff00ff00u) | (v >> 16 & 255) | (v & 255) << 16) & taken) | fixed;
    });
  const int s[4] = {8 * source[0], 8 * source[1], 8 * source[2], 8 * source[3]};
  convert<kBytes>(texels, pixels, count, [=](uint32_t v) {
    const uint32_t word =
        (v >> s[0] & 255) | (v >> s[1] & 255) << 8 | (v >> s[2] & 255) << 16 | (v >> s[3] & 255) << 24;
    return (word & taken) | fixed;
  });
}

} // namespace

void ByteTexels::store(uint32_t* texels, const uint8_t* pixels, int count) const {
  switch (components_) {
  case 1: return convert_any<1>(texels, pixels, count, source_, taken_, fixed_);
  case 2: return convert_any<2>(texels, pixels, count, source_, taken_, fixed_);
  case 3: return convert_any<3>(texels, pixels, count, source_, taken_, fixed_);
  default: return convert_any<4>(texels, pixels, count, source_, taken_, fixed_);
  }
}

} // namespace softgl
