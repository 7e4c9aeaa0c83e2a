// GL_3DFX_texture_compression_FXT1, appendix. Bits count from the first byte's lowest one. The texels of the
// left half of a block, 4x4, come before those of the right half.
#include "texture/fxt1_blocks.h"

#include <algorithm>
#include <cstring>

#include "texture/color_axis.h"

namespace softgl {

namespace {

constexpr int kTexels = 32, kHalf = 16;

/// Where texel `t` of the block's order lies in rows of eight.
int place_of(int t) { return t % kHalf / 4 * 8 + t % 4 + (t < kHalf ? 0 : 4); }

/// The bits of a block.
class Bits {
public:
  Bits() = default;
  explicit Bits(const uint8_t* block) { std::memcpy(word_, block, sizeof word_); }
  void store(uint8_t* block) const { std::memcpy(block, word_, sizeof word_); }

  int get(int at, int count) const {
    int value = 0;
    for (int i = 0; i < count; ++i) value |= int(word_[(at + i) / 64] >> ((at + i) % 64) & 1) << i;
    return value;
  }
  void put(int at, int count, int value) {
    for (int i = 0; i < count; ++i) word_[(at + i) / 64] |= uint64_t(value >> i & 1) << ((at + i) % 64);
  }

private:
  uint64_t word_[2] = {};
};

struct Fxt1Color {
  int v[4]; // red, green, blue, alpha
};

/// OSMesa 22.3.6: the nearest byte; the specification repeats the upper bits.
int widened(int value, int bits) {
  const int most = (1 << bits) - 1;
  return (value * 255 * 2 + most) / (2 * most);
}

/// 5 bits of red, green and blue; blue comes first. `green` is a sixth bit below the green ones, if there is
/// one.
Fxt1Color color_at(const Bits& bits, int at, int green = -1) {
  const int g = bits.get(at + 5, 5);
  return {{widened(bits.get(at + 10, 5), 5), green < 0 ? widened(g, 5) : widened(g << 1 | green, 6),
           widened(bits.get(at, 5), 5), 255}};
}

/// `k` of `n` equal steps from `a` to `b`, to nearest.
Fxt1Color step_between(const Fxt1Color& a, const Fxt1Color& b, int k, int n) {
  Fxt1Color c;
  for (int i = 0; i < 4; ++i) c.v[i] = ((n - k) * a.v[i] + k * b.v[i] + n / 2) / n;
  return c;
}

/// The colors that the codes of the texels of a half name, and how many bits a code has.
struct Fxt1Palette {
  Fxt1Color color[8];
  int code_bits;
};

void between(Fxt1Palette& p, const Fxt1Color& first, const Fxt1Color& last, int steps) {
  for (int k = 0; k <= steps; ++k) p.color[k] = step_between(first, last, k, steps);
}

/// Two colors for the whole block, five between them, and transparent black.
Fxt1Palette palette_high(const Bits& bits) {
  Fxt1Palette p{{}, 3};
  between(p, color_at(bits, 96), color_at(bits, 111), 6);
  return p;
}
/// Four colors.
Fxt1Palette palette_chroma(const Bits& bits) {
  Fxt1Palette p{{}, 2};
  for (int i = 0; i < 4; ++i) p.color[i] = color_at(bits, 64 + 15 * i);
  return p;
}
/// Two colors for each half, with one or two between them.
Fxt1Palette palette_mixed(const Bits& bits, int half) {
  Fxt1Palette p{{}, 2};
  const int at = half ? 94 : 64, green = bits.get(half ? 126 : 125, 1);
  const Fxt1Color last = color_at(bits, at + 15, green);
  if (bits.get(124, 1)) {
    p.color[0] = color_at(bits, at);
    for (int i = 0; i < 4; ++i) p.color[1].v[i] = (p.color[0].v[i] + last.v[i]) / 2;
    p.color[2] = last;
    return p;
  }
  between(p, color_at(bits, at, green ^ bits.get(half ? 33 : 1, 1)), last, 3);
  return p;
}
/// Three colors with alpha and transparent black; or one color for each half, and one for both.
Fxt1Palette palette_alpha(const Bits& bits, int half) {
  Fxt1Color color[3];
  for (int i = 0; i < 3; ++i) {
    color[i] = color_at(bits, 64 + 15 * i);
    color[i].v[3] = widened(bits.get(109 + 5 * i, 5), 5);
  }
  Fxt1Palette p{{}, 2};
  if (bits.get(124, 1))
    between(p, color[half ? 2 : 0], color[1], 3);
  else
    std::copy_n(color, 3, p.color);
  return p;
}

Fxt1Palette palette_of(const Bits& bits, int half) {
  const int mode = bits.get(125, 3);
  if (mode >= 4) return palette_mixed(bits, half);
  return mode == 3 ? palette_alpha(bits, half) : mode == 2 ? palette_chroma(bits) : palette_high(bits);
}

} // namespace

void decode_fxt1_block(const uint8_t* block, bool alpha, uint8_t (*rgba)[4]) {
  const Bits bits(block);
  const Fxt1Palette palette[2] = {palette_of(bits, 0), palette_of(bits, 1)};
  for (int t = 0; t < kTexels; ++t) {
    const Fxt1Palette& p = palette[t / kHalf];
    const Fxt1Color& c = p.color[bits.get(p.code_bits * t, p.code_bits)];
    uint8_t* texel = rgba[place_of(t)];
    for (int i = 0; i < 4; ++i) texel[i] = uint8_t(c.v[i]);
    if (!alpha) texel[3] = 255;
  }
}

namespace {

/// Encodes in several ways, and keeps what is nearest.
class Encoder {
public:
  Encoder(const uint8_t (*rgba)[4], bool alpha) : alpha_(alpha) {
    for (int t = 0; t < kTexels; ++t) {
      std::copy_n(rgba[place_of(t)], 4, texel_[t]);
      if (!alpha) texel_[t][3] = 255;
      opaque_ = opaque_ && texel_[t][3] == 255;
      shown_[t] = texel_[t][3] >= 128;
    }
  }

  void encode(uint8_t* block) {
    high();
    opaque_ ? mixed() : with_alpha();
    best_.store(block);
  }

private:
  static int narrowed(double value, int bits) { return int(value * ((1 << bits) - 1) / 255 + 0.5); }
  static void put_color(Bits& bits, int at, const double* rgb) {
    bits.put(at, 5, narrowed(rgb[2], 5));
    bits.put(at + 5, 5, narrowed(rgb[1], 5));
    bits.put(at + 10, 5, narrowed(rgb[0], 5));
  }

  int distance(int t, const Fxt1Color& c) const {
    int sum = 0;
    for (int i = 0; i < 4; ++i) sum += (texel_[t][i] - c.v[i]) * (texel_[t][i] - c.v[i]);
    return sum;
  }
  int nearest(int t, const Fxt1Palette& p) const {
    int best = 0;
    for (int code = 1; code < 1 << p.code_bits; ++code)
      if (distance(t, p.color[code]) < distance(t, p.color[best])) best = code;
    return best;
  }
  /// Gives texels first .. end - 1 their codes.
  void put_codes(Bits& bits, const Fxt1Palette& p, int first, int end) const {
    for (int t = first; t < end; ++t) bits.put(p.code_bits * t, p.code_bits, nearest(t, p));
  }

  void keep_if_nearer(const Bits& bits) {
    uint8_t block[16], decoded[kTexels][4];
    bits.store(block);
    decode_fxt1_block(block, alpha_, decoded);
    int error = 0;
    for (int t = 0; t < kTexels; ++t) {
      const uint8_t* d = decoded[place_of(t)];
      error += distance(t, {{d[0], d[1], d[2], d[3]}});
    }
    if (error >= error_) return;
    error_ = error;
    best_ = bits;
  }

  void high() {
    double low[4], high[4];
    ends_of_axis(texel_, shown_, kTexels, low, high);
    Bits bits;
    put_color(bits, 96, low);
    put_color(bits, 111, high);
    put_codes(bits, palette_high(bits), 0, kTexels);
    keep_if_nearer(bits);
  }

  /// The lowest bit of the first color's green is not stored: the highest bit of the first texel's code
  /// tells it.
  void mixed() {
    Bits bits;
    bits.put(127, 1, 1);
    for (int half = 0; half < 2; ++half) {
      double low[4], high[4];
      ends_of_axis(texel_ + kHalf * half, shown_ + kHalf * half, kHalf, low, high);
      int error = 1 << 30;
      Bits best;
      for (int swapped = 0; swapped < 2; ++swapped) {
        const double *first = swapped ? high : low, *last = swapped ? low : high;
        const int green[2] = {narrowed(first[1], 6), narrowed(last[1], 6)},
                  differs = (green[0] ^ green[1]) & 1;
        Bits trial = bits;
        const int at = half ? 94 : 64;
        const double rest[2][3] = {{first[0], widened(green[0] >> 1, 5) * 1.0, first[2]},
                                   {last[0], widened(green[1] >> 1, 5) * 1.0, last[2]}};
        put_color(trial, at, rest[0]);
        put_color(trial, at + 15, rest[1]);
        trial.put(half ? 126 : 125, 1, green[1] & 1);
        Bits told = trial; // the palette with the bit as it is meant
        told.put(half ? 33 : 1, 1, differs);
        const Fxt1Palette p = palette_mixed(told, half);
        put_codes(trial, p, kHalf * half, kHalf * half + kHalf);
        // Where the first code says otherwise, the palette is a little different.
        const Fxt1Palette real = palette_mixed(trial, half);
        int sum = 0;
        for (int t = kHalf * half; t < kHalf * half + kHalf; ++t)
          sum += distance(t, real.color[trial.get(2 * t, 2)]);
        if (sum < error) error = sum, best = trial;
      }
      bits = best;
    }
    keep_if_nearer(bits);
  }

  /// The same two ends for both halves.
  void with_alpha() {
    bool all[kTexels];
    std::fill_n(all, kTexels, true);
    double low[4], high[4];
    ends_of_axis(texel_, all, kTexels, low, high);
    Bits bits;
    bits.put(125, 3, 3);
    bits.put(124, 1, 1);
    for (int i = 0; i < 3; ++i) {
      const double* color = i == 1 ? high : low;
      put_color(bits, 64 + 15 * i, color);
      bits.put(109 + 5 * i, 5, narrowed(color[3], 5));
    }
    for (int half = 0; half < 2; ++half)
      put_codes(bits, palette_alpha(bits, half), kHalf * half, kHalf * half + kHalf);
    keep_if_nearer(bits);
  }

  bool alpha_, opaque_ = true, shown_[kTexels];
  int texel_[kTexels][4], error_ = 0x7fffffff;
  Bits best_;
};

} // namespace

void encode_fxt1_block(const uint8_t (*rgba)[4], bool alpha, uint8_t* block) {
  Encoder(rgba, alpha).encode(block);
}

} // namespace softgl
