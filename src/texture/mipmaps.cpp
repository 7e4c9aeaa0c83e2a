// Automatic mipmap generation (GL 1.5, 3.8.8). OSMesa 22.3.6 draws each level with a linearly filtered, edge-clamped
// texture of the level before; so the arithmetic is that of sampling.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "texture/pixel_formats.h"
#include "texture/texture_object.h"

namespace softgl {

namespace {

struct Footprint { int first, second; int weight; float fraction; };

// Texel pairs and weights along one axis of `to` texels made from `from`.
std::vector<Footprint> footprints(int from, int to) {
  std::vector<Footprint> result{size_t(to)};
  for (int i = 0; i < to; ++i) {
    const float coordinate = (float(i) + 0.5f) / float(to);
    const int u = int(std::nearbyintf(coordinate * float(from * 256))) - 128;
    const float scaled = std::max(0.0f, coordinate * float(from) - 0.5f), whole = std::floor(scaled);
    Footprint& f = result[size_t(i)];
    f.first = std::clamp(u >> 8, 0, from - 1);
    f.second = u >> 8 < 0 || u >> 8 >= from - 1 ? f.first : f.first + 1;
    f.weight = u & 255;
    f.fraction = scaled - whole;
  }
  return result;
}

// 8 bits to the stored bits, filled to a byte again: 4 bits round, 5 and 6 drop the rest, fewer round (llvmpipe's scale_bits).
uint8_t restore(uint32_t value, int bits) {
  if (bits == 0 || bits == 8) return uint8_t(value);
  return uint8_t(convert_unorm(bits == 5 || bits == 6 ? value >> (8 - bits) : convert_unorm(value, 8, bits), bits, 8));
}

int lerp8(int w, int a, int b) { return a + ((w * (b - a) + 128) >> 8); }

void reduce_rgba8(const TextureImage& from, TextureImage& to) {
  const auto xs = footprints(from.width, to.width), ys = footprints(from.height, to.height), zs = footprints(from.depth, to.depth);
  const TexelFormat& format = *to.format;
  for (int z = 0; z < to.depth; ++z)
    for (int y = 0; y < to.height; ++y) {
      unsigned char* target = to.at(0, y, z);
      const Footprint &fy = ys[size_t(y)], &fz = zs[size_t(z)];
      for (int x = 0; x < to.width; ++x, target += 4) {
        const Footprint& fx = xs[size_t(x)];
        for (int k = 0; k < 4; ++k) {
          auto plane = [&](int slice) {
            auto row = [&](int line) { return lerp8(fx.weight, from.at(fx.first, line, slice)[k], from.at(fx.second, line, slice)[k]); };
            return lerp8(fy.weight, row(fy.first), row(fy.second));
          };
          const int value = fz.first == fz.second ? plane(fz.first) : lerp8(fz.weight, plane(fz.first), plane(fz.second));
          target[k] = restore(uint32_t(value), format.bits[k]);
        }
      }
    }
}

// The wide formats are filtered in float and rounded back.
template <class T> void reduce_wide(const TextureImage& from, TextureImage& to, int channels) {
  const auto xs = footprints(from.width, to.width), ys = footprints(from.height, to.height), zs = footprints(from.depth, to.depth);
  const TexelFormat& format = *to.format;
  for (int z = 0; z < to.depth; ++z)
    for (int y = 0; y < to.height; ++y)
      for (int x = 0; x < to.width; ++x) {
        const Footprint &fx = xs[size_t(x)], &fy = ys[size_t(y)], &fz = zs[size_t(z)];
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
              const float a = unorm_to_float(texel(fx.first, line, slice), bits), b = unorm_to_float(texel(fx.second, line, slice), bits);
              return fx.fraction * (b - a) + a;
            };
            const float a = row(fy.first), b = row(fy.second);
            return fy.fraction * (b - a) + a;
          };
          const float a = plane(fz.first);
          const float value = fz.first == fz.second ? a : fz.fraction * (plane(fz.second) - a) + a;
          // 10 bits are the upper ones of 16.
          const T v = T(bits == 10 ? float_to_unorm(value, 16) >> 6 : float_to_unorm(value, bits));
          std::memcpy(to.at(x, y, z) + size_t(k) * sizeof(T), &v, sizeof v);
        }
      }
}

} // namespace

void generate_mipmaps(TextureObject& object, int face) {
  const TextureParameters& p = object.parameters;
  if (p.base_level < 0 || p.base_level >= kMaxTextureLevels || object.target == kTextureRectangle) return;
  std::shared_ptr<TextureImage> from = object.image[face][p.base_level];
  if (!from || from->empty()) return;
  for (int level = p.base_level + 1; level < kMaxTextureLevels && level <= p.max_level; ++level) {
    if (from->width == 1 && from->height == 1 && from->depth == 1) break;
    auto to = make_image(*from->format, from->internal_format, std::max(1, from->width / 2), std::max(1, from->height / 2), std::max(1, from->depth / 2));
    switch (from->format->layout) {
    case TexelLayout::Rgba8: reduce_rgba8(*from, *to); break;
    case TexelLayout::Rgba16: reduce_wide<uint16_t>(*from, *to, 4); break;
    case TexelLayout::Depth: reduce_wide<uint32_t>(*from, *to, 1); break;
    }
    to->repeat_edges();
    object.image[face][level] = to;
    from = to;
  }
}

} // namespace softgl
