#include "texture/block_compression.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "texture/color_axis.h"
#include "texture/fxt1_blocks.h"

namespace softgl {

namespace {

/// `k` of `n` equal steps from `a` to `b`. OSMesa's weight is 255 k / n and its rounding goes down.
int step_between(int a, int b, int k, int n) { return a + ((255 * k / n * (b - a)) >> 8); }

int load16(const uint8_t* p) { return p[0] | p[1] << 8; }
void store16(int v, uint8_t* p) { p[0] = uint8_t(v), p[1] = uint8_t(v >> 8); }

/// 5, 6 and 5 bits of red, green and blue, repeated until they fill a byte.
void expand_565(int color, int* rgb) {
  const int r = color >> 11, g = color >> 5 & 63, b = color & 31;
  rgb[0] = r << 3 | r >> 2, rgb[1] = g << 2 | g >> 4, rgb[2] = b << 3 | b >> 2;
}

/// The four colors that the codes of a block name. Not `four`: the third is the middle of the first two, and
/// the fourth is black.
struct Palette {
  int color[4][3];
  Palette(int first, int second, bool four) {
    expand_565(first, color[0]);
    expand_565(second, color[1]);
    for (int k = 0; k < 3; ++k) {
      const int a = color[0][k], b = color[1][k];
      color[2][k] = four ? step_between(a, b, 1, 3) : (a + b + 1) / 2;
      color[3][k] = four ? step_between(a, b, 2, 3) : 0;
    }
  }
};

/// The eight values that the codes of a block of one component name; T: of which they are.
template <class T> void component_values(int first, int second, int* value) {
  value[0] = first, value[1] = second;
  const int steps = first > second ? 7 : 5;
  for (int k = 1; k < steps; ++k) value[k + 1] = step_between(first, second, k, steps);
  if (steps == 5) value[6] = std::is_signed_v<T> ? -127 : 0, value[7] = std::is_signed_v<T> ? 127 : 255;
}

void decode_color(const uint8_t* block, bool may_have_three, bool transparent, uint8_t (*rgba)[4]) {
  const int first = load16(block), second = load16(block + 2);
  const bool four = !may_have_three || first > second;
  const Palette palette(first, second, four);
  for (int i = 0; i < kBlockTexels; ++i) {
    const int code = block[4 + i / 4] >> (i % 4 * 2) & 3;
    for (int k = 0; k < 3; ++k) rgba[i][k] = uint8_t(palette.color[code][k]);
    rgba[i][3] = transparent && !four && code == 3 ? 0 : 255;
  }
}

/// Component `k` of 16 texels.
template <class T> void decode_component(const uint8_t* block, int k, T (*rgba)[4]) {
  int value[8];
  constexpr bool has_sign = std::is_signed_v<T>;
  component_values<T>(has_sign ? int8_t(block[0]) : block[0], has_sign ? int8_t(block[1]) : block[1], value);
  uint64_t codes = 0;
  std::memcpy(&codes, block + 2, 6);
  for (int i = 0; i < kBlockTexels; ++i) rgba[i][k] = T(value[codes >> (3 * i) & 7]);
}

/// Blocks of one or two components, the others as the format wants them.
template <class T>
void decode_components(BlockFormat format, const uint8_t* block, T absent_one, T (*rgba)[4]) {
  decode_component<T>(block, 0, rgba);
  const bool luminance = format == BlockFormat::Luminance || format == BlockFormat::LuminanceAlpha;
  for (int i = 0; i < kBlockTexels; ++i) {
    rgba[i][1] = rgba[i][2] = luminance ? rgba[i][0] : T(0);
    rgba[i][3] = absent_one;
  }
  if (format == BlockFormat::RedGreen) decode_component<T>(block + 8, 1, rgba);
  if (format == BlockFormat::LuminanceAlpha) decode_component<T>(block + 8, 3, rgba);
}

} // namespace

void decode_block(BlockFormat format, const uint8_t* block, uint8_t (*rgba)[4]) {
  switch (format) {
  case BlockFormat::None: break;
  case BlockFormat::Dxt1Rgb: decode_color(block, true, false, rgba); break;
  case BlockFormat::Dxt1Rgba: decode_color(block, true, true, rgba); break;
  case BlockFormat::Dxt3:
    decode_color(block + 8, false, false, rgba);
    for (int i = 0; i < kBlockTexels; ++i) rgba[i][3] = uint8_t((block[i / 2] >> (i % 2 * 4) & 15) * 17);
    break;
  case BlockFormat::Dxt5:
    decode_color(block + 8, false, false, rgba);
    decode_component<uint8_t>(block, 3, rgba);
    break;
  case BlockFormat::Fxt1Rgb:
  case BlockFormat::Fxt1Rgba: decode_fxt1_block(block, format == BlockFormat::Fxt1Rgba, rgba); break;
  default: decode_components<uint8_t>(format, block, 255, rgba);
  }
}

namespace {

struct Color {
  double v[3];
};

int to_565(const Color& c) {
  const auto bits = [](double x, int max) { return int(std::clamp(x, 0.0, 255.0) * max / 255 + 0.5); };
  return bits(c.v[0], 31) << 11 | bits(c.v[1], 63) << 5 | bits(c.v[2], 31);
}

/// Finds two colors of 5, 6, 5 bits and a code for each of the texels that count.
class ColorEncoder {
public:
  ColorEncoder(const uint8_t (*rgba)[4], bool four) : four_(four) {
    for (int i = 0; i < kBlockTexels; ++i) {
      counts_[i] = four || rgba[i][3] >= 128;
      for (int k = 0; k < 3; ++k) texel_[i][k] = rgba[i][k];
    }
  }

  void encode(uint8_t* block) {
    Color low, high;
    ends_of_axis(texel_, counts_, kBlockTexels, low.v, high.v);
    try_ends(to_565(high), to_565(low));
    for (int round = 0; round < 2; ++round)
      if (fitted_ends(low, high)) try_ends(to_565(low), to_565(high));
    store16(first_, block);
    store16(second_, block + 2);
    for (int row = 0; row < 4; ++row)
      block[4 + row] = uint8_t(code_[4 * row] | code_[4 * row + 1] << 2 | code_[4 * row + 2] << 4 |
                               code_[4 * row + 3] << 6);
  }

private:
  /// Keeps the two colors if their block is nearer to the texels than the one before.
  void try_ends(int first, int second) {
    // Which is the greater number says how many colors there are.
    if (four_ ? first < second : first > second) std::swap(first, second);
    const Palette palette(first, second, four_);
    const int colors = !four_ ? 3 : first == second ? 1 : 4;
    int code[kBlockTexels], error = 0;
    for (int i = 0; i < kBlockTexels; ++i) {
      code[i] = 3; // transparent
      int best = 1 << 30;
      for (int c = 0; c < colors && counts_[i]; ++c) {
        int distance = 0;
        for (int k = 0; k < 3; ++k) {
          const int d = palette.color[c][k] - texel_[i][k];
          distance += d * d;
        }
        if (distance < best) best = distance, code[i] = c;
      }
      if (counts_[i]) error += best;
    }
    if (error >= error_) return;
    error_ = error;
    first_ = first, second_ = second;
    std::copy_n(code, kBlockTexels, code_);
  }

  /// The two colors that come nearest to the texels with the codes as they are: least squares.
  bool fitted_ends(Color& first, Color& second) const {
    const double weights[2][4] = {{0, 1, 0.5, 0}, {0, 1, 1.0 / 3, 2.0 / 3}}; // of the second color
    double aa = 0, ab = 0, bb = 0, a[3] = {}, b[3] = {};
    for (int i = 0; i < kBlockTexels; ++i) {
      if (!counts_[i]) continue;
      const double w = weights[four_][code_[i]], u = 1 - w;
      aa += u * u, ab += u * w, bb += w * w;
      for (int k = 0; k < 3; ++k) a[k] += u * texel_[i][k], b[k] += w * texel_[i][k];
    }
    const double determinant = aa * bb - ab * ab;
    if (determinant < 1e-6) return false; // all codes are one
    for (int k = 0; k < 3; ++k) {
      first.v[k] = (a[k] * bb - b[k] * ab) / determinant;
      second.v[k] = (b[k] * aa - a[k] * ab) / determinant;
    }
    return true;
  }

  bool four_, counts_[kBlockTexels];
  int texel_[kBlockTexels][3];
  int first_ = 0, second_ = 0, code_[kBlockTexels], error_ = 1 << 30;
};

/// The nearest of eight values for component `k` of each texel. Gives the sum of the squared errors.
template <class T> int choose_codes(const int* value, const T (*rgba)[4], int k, uint64_t& codes) {
  int error = 0;
  codes = 0;
  for (int i = 0; i < kBlockTexels; ++i) {
    int best = 1 << 30, code = 0;
    for (int c = 0; c < 8; ++c) {
      const int d = value[c] - rgba[i][k];
      if (d * d < best) best = d * d, code = c;
    }
    error += best;
    codes |= uint64_t(code) << (3 * i);
  }
  return error;
}

template <class T> void encode_component(const T (*rgba)[4], int k, uint8_t* block) {
  // All values lie between two ends; or some are the least and the greatest, and the others lie between.
  constexpr bool has_sign = std::is_signed_v<T>;
  constexpr int kLeast = has_sign ? -127 : 0, kGreatest = has_sign ? 127 : 255;
  int low = kGreatest, high = kLeast, inner_low = kGreatest, inner_high = kLeast;
  for (int i = 0; i < kBlockTexels; ++i) {
    const int v = rgba[i][k];
    low = std::min(low, v), high = std::max(high, v);
    if (v > kLeast && v < kGreatest) inner_low = std::min(inner_low, v), inner_high = std::max(inner_high, v);
  }
  if (inner_low > inner_high) inner_low = inner_high = 0;
  int value[8];
  uint64_t codes[2];
  component_values<T>(high, low, value);
  const int eight_error = choose_codes(value, rgba, k, codes[0]);
  component_values<T>(inner_low, inner_high, value);
  const bool six = choose_codes(value, rgba, k, codes[1]) < eight_error;
  block[0] = uint8_t(six ? inner_low : high);
  block[1] = uint8_t(six ? inner_high : low);
  std::memcpy(block + 2, &codes[six], 6);
}

template <class T> void encode_components(BlockFormat format, const T (*rgba)[4], uint8_t* block) {
  encode_component(rgba, 0, block);
  if (format == BlockFormat::RedGreen) encode_component(rgba, 1, block + 8);
  if (format == BlockFormat::LuminanceAlpha) encode_component(rgba, 3, block + 8);
}

} // namespace

void encode_block(BlockFormat format, const uint8_t (*rgba)[4], uint8_t* block) {
  switch (format) {
  case BlockFormat::None: break;
  case BlockFormat::Dxt1Rgb: ColorEncoder(rgba, true).encode(block); break;
  case BlockFormat::Dxt1Rgba: {
    bool transparent = false;
    for (int i = 0; i < kBlockTexels; ++i) transparent = transparent || rgba[i][3] < 128;
    ColorEncoder(rgba, !transparent).encode(block);
    break;
  }
  case BlockFormat::Dxt3:
    for (int i = 0; i < 8; ++i)
      block[i] = uint8_t((rgba[2 * i][3] + 8) / 17 | (rgba[2 * i + 1][3] + 8) / 17 << 4);
    ColorEncoder(rgba, true).encode(block + 8);
    break;
  case BlockFormat::Dxt5:
    encode_component(rgba, 3, block);
    ColorEncoder(rgba, true).encode(block + 8);
    break;
  case BlockFormat::Fxt1Rgb:
  case BlockFormat::Fxt1Rgba: encode_fxt1_block(rgba, format == BlockFormat::Fxt1Rgba, block); break;
  default: encode_components(format, rgba, block);
  }
}

void decode_signed_block(BlockFormat format, const uint8_t* block, int16_t (*rgba)[4]) {
  decode_components<int16_t>(format, block, 1, rgba);
}

void encode_signed_block(BlockFormat format, const int16_t (*rgba)[4], uint8_t* block) {
  encode_components(format, rgba, block);
}

} // namespace softgl
