// Automatic mipmap generation (GL 1.5, 3.8.8). OSMesa 22.3.6 draws each level with a linearly filtered,
// edge-clamped texture of the level before; so the arithmetic is that of sampling.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "texture/component_values.h"
#include "texture/drawn_values.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"
#include "texture/texture_object.h"

namespace softgl {

namespace {

/// Two texels and the weight of the second, in 1/256 or as a fraction.
struct Footprint {
  int first, second, weight;
  float fraction;
};

/// Where the texels of a level lie in the one before: a coordinate from 0 to 1 that OSMesa interpolates over
/// two triangles, which has rounding errors. Across it starts at the right end; down, at the bottom in the
/// lower left triangle and at the top in the upper right one. Faces of cube maps are drawn as the layers of a
/// two-dimensional texture.
struct Interpolation {
  float gradient, start;
  Interpolation(int to, int other, bool from_low) {
    gradient = float(other) * (1.0f / (float(to) * float(other)));
    start = from_low ? gradient * 0.5f : 1.0f - gradient * (float(to) - 0.5f);
  }
  float operator()(int i) const { return gradient * float(i) + start; }
};

/// Texel pairs and weights along one axis of `to` texels made from `from`.
template <class Coordinate>
std::vector<Footprint> footprints(int from, int to, bool fixed, Coordinate coordinate) {
  std::vector<Footprint> result{size_t(to)};
  for (int i = 0; i < to; ++i) {
    const float s = coordinate(i);
    Footprint& f = result[size_t(i)];
    if (fixed) {
      const int u = int(std::nearbyintf(s * float(from * 256))) - 128;
      f.weight = u & 255;
      f.first = std::clamp(u >> 8, 0, from - 1);
      f.second = u < 0 ? f.first : std::min(f.first + 1, from - 1);
    } else {
      const float u = std::max(0.0f, std::min(s * float(from), float(from)) - 0.5f);
      f.first = int(u);
      f.fraction = u - float(f.first);
      f.second = std::min(f.first + 1, from - 1);
    }
  }
  return result;
}

struct Footprints {
  std::vector<Footprint> x, z, lower_y, upper_y;
  int width, height;
  Footprints(const TextureImage& from, const TextureImage& to, bool fixed)
      : width(to.width), height(to.height) {
    auto edge = [&](int from_size, int to_size, int other, bool from_low) {
      return footprints(from_size, to_size, fixed, Interpolation(to_size, other, from_low));
    };
    x = edge(from.width, to.width, to.height, false);
    lower_y = edge(from.height, to.height, to.width, false);
    upper_y = edge(from.height, to.height, to.width, true);
    const float step = float(from.depth) / float(to.depth), centre = float(0.5 / to.depth * from.depth);
    z = footprints(from.depth, to.depth, fixed,
                   [&](int i) { return (float(i) * step + centre) / float(from.depth); });
  }
  const Footprint& y(int i, int j) const {
    const bool upper = int64_t(2 * i + 1) * height >= int64_t(2 * j + 1) * width;
    return (upper ? upper_y : lower_y)[size_t(j)];
  }
};

/// The four bytes of a texel, each in 16 bits.
uint64_t spread(const unsigned char* texel) {
  uint32_t word;
  std::memcpy(&word, texel, 4);
  const uint64_t halves = (word | uint64_t(word) << 16) & 0x0000ffff0000ffff;
  return (halves | halves << 8) & 0x00ff00ff00ff00ff;
}
/// a + ((weight * (b - a) + 128) >> 8) of all four, which never needs more than 16 bits.
uint64_t interpolate(int weight, uint64_t a, uint64_t b) {
  const auto w = uint64_t(weight);
  return ((a * (256 - w) + b * w + 0x0080008000800080) >> 8) & 0x00ff00ff00ff00ff;
}

void reduce_rgba8(const TextureImage& from, const Footprints& footprints, TextureImage& to) {
  const TexelFormat& format = *to.format;
  const bool whole =
      std::all_of(format.bits, format.bits + 4, [](int bits) { return bits == 8 || bits == 0; });
  for (int z = 0; z < to.depth; ++z)
    for (int y = 0; y < to.height; ++y) {
      unsigned char* target = to.at(0, y, z);
      const Footprint& fz = footprints.z[size_t(z)];
      for (int x = 0; x < to.width; ++x, target += 4) {
        const Footprint &fx = footprints.x[size_t(x)], &fy = footprints.y(x, y);
        const auto plane = [&](int slice) {
          const auto row = [&](int line) {
            const unsigned char* texels = from.at(0, line, slice);
            return interpolate(fx.weight, spread(texels + 4 * size_t(fx.first)),
                               spread(texels + 4 * size_t(fx.second)));
          };
          return interpolate(fy.weight, row(fy.first), row(fy.second));
        };
        const uint64_t value = fz.first == fz.second
                                   ? plane(fz.first)
                                   : interpolate(fz.weight, plane(fz.first), plane(fz.second));
        for (int k = 0; k < 4; ++k) target[k] = uint8_t(value >> 16 * k);
        if (whole) continue;
        for (int k = 0; k < 4; ++k) target[k] = reduced_byte(target[k], format.bits[k]);
      }
    }
}

float as_float(uint32_t v, int bits) { return wide_to_float(v, bits); }
float as_float(uint16_t v, int bits) { return wide_to_float(v, bits); }
float as_float(int16_t v, int bits) {
  return std::max(float(v) * (1.0f / float((1 << (bits - 1)) - 1)), -1.0f);
}
float as_float(float v, int) { return v; }
template <class T> T from_float(float v, int bits) {
  if constexpr (std::is_same_v<T, float>)
    return v;
  else if constexpr (std::is_same_v<T, int16_t>)
    return T(float_to_snorm(v, bits));
  else
    return T(float_to_wide(v, bits));
}

// The wide formats are filtered in float and rounded back.
template <class T>
void reduce_wide(const TextureImage& from, const Footprints& footprints, TextureImage& to, int channels) {
  const TexelFormat& format = *to.format;
  for (int z = 0; z < to.depth; ++z)
    for (int y = 0; y < to.height; ++y)
      for (int x = 0; x < to.width; ++x) {
        const Footprint &fx = footprints.x[size_t(x)], &fy = footprints.y(x, y),
                        &fz = footprints.z[size_t(z)];
        for (int k = 0; k < channels; ++k) {
          const int bits = format.bits[k];
          auto texel = [&](int i, int j, int l) {
            T v;
            std::memcpy(&v, from.at(i, j, l) + size_t(k) * sizeof(T), sizeof v);
            return v;
          };
          if (bits == 0) {
            const T v = texel(0, 0, 0);
            std::memcpy(to.at(x, y, z) + size_t(k) * sizeof(T), &v, sizeof v);
            continue;
          }
          auto plane = [&](int slice) {
            auto row = [&](int line) {
              const float a = as_float(texel(fx.first, line, slice), bits),
                          b = as_float(texel(fx.second, line, slice), bits);
              return fx.fraction * (b - a) + a;
            };
            const float a = row(fy.first), b = row(fy.second);
            return fy.fraction * (b - a) + a;
          };
          const float a = plane(fz.first);
          const float value = fz.first == fz.second ? a : fz.fraction * (plane(fz.second) - a) + a;
          const T v = from_float<T>(value, bits);
          std::memcpy(to.at(x, y, z) + size_t(k) * sizeof(T), &v, sizeof v);
        }
        if constexpr (std::is_same_v<T, float>)
          format.reduce(reinterpret_cast<float(*)[4]>(to.at(x, y, z)), 1, false);
      }
}

/// The texels of a level from which number i of `to` along one axis is made, of `from`: [first, last).
struct Reach {
  int first, last;
  Reach(int i, int to, int from) {
    if (i < 0 || i >= to) { // of the border
      first = i < 0 ? -1 : from;
      last = first + 1;
    } else {
      first = int(int64_t(i) * from / to);
      last = std::max(first + 1, int(int64_t(i + 1) * from / to));
    }
  }
};

/// The border of a level is that of the level before, reduced along each of its sides (3.8.8: derived arrays
/// have the border of the base level).
void reduce_border(const TextureImage& from, TextureImage& to) {
  const bool depths = to.format->layout == TexelLayout::Depth;
  const PixelFormat client = describe_pixel_format(depths ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT);
  const int components = depths ? 1 : 4;
  const TexelBox box = to.with_border();
  for (int z = box.z; z < box.z + box.depth; ++z)
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x) {
        if (x >= 0 && x < to.width && y >= 0 && y < to.height && z >= 0 && z < to.depth) continue;
        const Reach across(x, to.width, from.width), down(y, to.height, from.height),
            deep(z, to.depth, from.depth);
        double sum[4] = {};
        int count = 0;
        for (int k = deep.first; k < deep.last; ++k)
          for (int j = down.first; j < down.last; ++j)
            for (int i = across.first; i < across.last; ++i, ++count) {
              float texel[4];
              load_texels(*from.format, from.at(i, j, k), client, texel, 1, false);
              for (int n = 0; n < components; ++n) sum[n] += double(texel[n]);
            }
        float mean[4];
        for (int n = 0; n < components; ++n) mean[n] = float(sum[n] / count);
        store_texels(*to.format, to.at(x, y, z), client, mean, 1, false, PixelTransfer::none());
      }
}

} // namespace

void generate_mipmaps(TextureObject& object, int face) {
  const int base = object.base_level(), last = object.max_level();
  if (base < 0 || base >= kMaxTextureLevels || object.target == kTextureRectangle) return;
  std::shared_ptr<TextureImage> from = object.image[face][base];
  if (!from || from->empty()) return;
  for (int level = base + 1; level < kMaxTextureLevels && level <= last; ++level) {
    if (from->width == 1 && from->height == 1 && from->depth == 1) break;
    auto to = make_image(*from->format, from->internal_format, std::max(1, from->width / 2),
                         std::max(1, from->height / 2), std::max(1, from->depth / 2), from->border);
    const Footprints footprints(*from, *to, from->format->layout == TexelLayout::Rgba8);
    switch (from->format->layout) {
    case TexelLayout::Rgba8: reduce_rgba8(*from, footprints, *to); break;
    case TexelLayout::Rgba16: reduce_wide<uint16_t>(*from, footprints, *to, 4); break;
    case TexelLayout::Signed16: reduce_wide<int16_t>(*from, footprints, *to, 4); break;
    case TexelLayout::Float: reduce_wide<float>(*from, footprints, *to, 4); break;
    case TexelLayout::Depth:
      if (from->format->floats)
        reduce_wide<float>(*from, footprints, *to, 1);
      else
        reduce_wide<uint32_t>(*from, footprints, *to, 1);
      break;
    }
    if (from->border != ImageBorder{}) reduce_border(*from, *to);
    to->texels_changed();
    object.image[face][level] = to;
    from = to;
  }
}

} // namespace softgl
