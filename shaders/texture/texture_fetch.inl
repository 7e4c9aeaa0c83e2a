// Texels as floats.
#pragma once

#include "shaders/common/lane_math.h"
#include "shaders/common/srgb.h"
#include "shaders/fragment/fragment_block.h"
#include "shaders/texture/texture_constants.h"
#include "shaders/texture/texture_cube.inl"

namespace softgl {
namespace SOFTGL_ISA {

/// Two texel numbers and the weight of the second. Numbers outside the image mean the border.
struct FloatAxis {
  alignas(64) int32_t first[kLanes], second[kLanes];
  alignas(64) float weight[kLanes];
};

struct FloatTexels {
  alignas(64) float v[4][kLanes];
};

/// What is the same for all lanes.
template <class T> struct SameForAll {
  T value;
  SOFTGL_MEMBER T operator[](int32_t) const { return value; }
  SOFTGL_MEMBER T& operator[](int32_t) { return value; }
};

/// Images that lanes look at: the texels and the size of each lane's. Views, to be passed by value: then the
/// compiler sees that no store changes a size.
struct OneImage {
  SameForAll<const unsigned char*> texels;
  SameForAll<int32_t> width, height, depth, row, slice;

  explicit OneImage(const TextureLevel& l)
      : texels{l.face[0]}, width{l.width}, height{l.height}, depth{l.depth}, row{l.row}, slice{l.slice} {}
};
struct ImageOfEach {
  const unsigned char* const* texels;
  const int32_t *width, *height, *depth, *row, *slice;
};

/// The images that a block's lanes look at, one a lane.
struct LevelImages {
  const TextureLevel* level[kLanes];
  const unsigned char* texels[kLanes]; // of the lane's face
  alignas(64) int32_t width[kLanes], height[kLanes], depth[kLanes];
  alignas(64) int32_t row[kLanes], slice[kLanes];

  void set(int lane, const TextureLevel& l, int face) {
    level[lane] = &l;
    texels[lane] = l.face[face];
    width[lane] = l.width, height[lane] = l.height, depth[lane] = l.depth;
    row[lane] = l.row, slice[lane] = l.slice;
  }
  ImageOfEach view() const { return {texels, width, height, depth, row, slice}; }
};

/// Level `number` or, if there are not so many, the last one.
static inline const TextureLevel& level_number(const TextureUnitConstants& t, int32_t number) {
  return t.level[number > t.last_level ? t.last_level : number];
}

/// The level that all live lanes look at, which is the usual case; or -1. Lanes that are dead follow them.
static inline int32_t level_of_all(const FragmentBlock& block, const int32_t* levels) {
  int first = 0;
  while (first < block.lanes - 1 && block.live[first] == 0) ++first;
  const int32_t reference = levels[first];
  int32_t differs = 0;
  SOFTGL_FOR_LANES(block, i) differs |= (levels[i] ^ reference) & int32_t(block.live[i]);
  return differs == 0 ? reference : -1;
}

/// Level `levels` + `add` of each lane, or of all, `level`, unless that is -1.
static inline void find_images(const FragmentBlock& block, const BlockCoordinates& c,
                               const TextureUnitConstants& t, int32_t level, const int32_t* levels, int add,
                               LevelImages& out) {
  const bool cube = t.shape == TextureShape::Cube;
  if (level >= 0) {
    const TextureLevel& image = level_number(t, level + add);
    SOFTGL_FOR_LANES(block, i) out.set(i, image, 0);
    for (int32_t i = 0; cube && i < block.lanes; ++i) out.texels[i] = image.face[face_of(c, i)];
  } else {
    for (int32_t i = 0; i < block.lanes; ++i)
      out.set(i, level_number(t, levels[i] + add), cube ? face_of(c, i) : 0);
  }
}

/// 32 bits do not fit a float: OSMesa keeps the upper 23.
static inline __attribute__((always_inline)) float wide_depth(uint32_t v) {
  return (bits_float(int32_t((v >> 9) | 0x3f800000u)) - 1.0f) * 1.00000011920930376163766f;
}

/// Rows of a block's images: the number of the first texel of each, and a mask: is there such a row?
struct TexelRows {
  alignas(64) uint32_t index[kLanes];
  alignas(64) int32_t inside[kLanes];
};

/// Rows (y, z); both are null where the shape of the texture has no such axis.
template <class Lanes, class Images> static inline void
find_rows(const Lanes& block, Images images, const int32_t* y, const int32_t* z, TexelRows& out) {
  if (y) {
    SOFTGL_FOR_LANES(block, i) {
      out.inside[i] = mask_of(uint32_t(y[i]) < uint32_t(images.height[i]));
      out.index[i] = uint32_t(y[i]) * uint32_t(images.row[i]);
    }
  } else {
    SOFTGL_FOR_LANES(block, i) out.index[i] = 0, out.inside[i] = -1;
  }
  if (z) SOFTGL_FOR_LANES(block, i) {
      out.inside[i] &= mask_of(uint32_t(z[i]) < uint32_t(images.depth[i]));
      out.index[i] += uint32_t(z[i]) * uint32_t(images.slice[i]);
    }
}

/// Which texels a block's lanes take: number `index` of their images. Those outside their image are the
/// border.
struct TexelPlaces {
  alignas(64) uint32_t index[kLanes];
  alignas(64) int32_t inside[kLanes];
};

/// Texels x of rows.
template <class Lanes, class Images>
static inline void find_texels(const Lanes& block, Images images, const TexelRows& rows,
                               const int32_t* __restrict x, TexelPlaces& out) {
  SOFTGL_FOR_LANES(block, i) {
    const int32_t inside = mask_of(uint32_t(x[i]) < uint32_t(images.width[i])) & rows.inside[i];
    out.inside[i] = inside;
    out.index[i] = (rows.index[i] + uint32_t(x[i])) & uint32_t(inside);
  }
}

/// The words of texels that have one.
template <class Lanes, class Images> static inline void
fetch_words(const Lanes& block, Images images, const TexelPlaces& at, int32_t* __restrict word) {
  for (int32_t i = 0; i < block.lanes; i += kWidth) {
    const auto place = [&](int k) __attribute__((always_inline)) {
      return images.texels[i + k] + size_t(at.index[i + k]) * 4;
    };
    store(word + i, load_words(place));
  }
}

/// The depths of texels; the border outside.
template <class Lanes, class Images>
static inline void fetch_depths(const Lanes& block, const TextureUnitConstants& t, Images images,
                                const TexelPlaces& at, float* __restrict out) {
  alignas(64) int32_t word[kLanes];
  fetch_words(block, images, at, word);
  const float border = t.border[0];
  const auto decode = [&](auto depth) {
    SOFTGL_FOR_LANES(block, i) out[i] = select(at.inside[i], depth(uint32_t(word[i])), border);
  };
  if (t.texel == TextureTexel::DepthFloat)
    decode([](uint32_t v) { return bits_float(int32_t(v)); });
  else if (t.shift[0] == 32)
    decode([](uint32_t v) { return wide_depth(v); });
  else
    decode([scale = t.scale[0]](uint32_t v) { return float(int32_t(v)) * scale; });
}

/// Component k of texels of four bytes: decoder(k)(byte).
template <class Lanes, class Images, class Decoder> static inline void
fetch_bytes(const Lanes& block, Images images, const TexelPlaces& at, FloatTexels& out, Decoder decoder) {
  alignas(64) int32_t word[kLanes];
  fetch_words(block, images, at, word);
  for (int k = 0; k < 4; ++k) {
    const auto decode = decoder(k);
    SOFTGL_FOR_LANES(block, i) out.v[k][i] = decode(int32_t(uint32_t(word[i]) >> 8 * k & 255));
  }
}

/// Component k of texels of four halves: decoder(k)(half as it is in the lower 16 bits).
template <class Lanes, class Images, class Decoder> static inline void
fetch_halves(const Lanes& block, Images images, const TexelPlaces& at, FloatTexels& out, Decoder decoder) {
  alignas(64) int32_t word[2][kLanes];
  for (int32_t i = 0; i < block.lanes; i += kWidth) {
    IntV first, second;
    const auto place = [&](int k) __attribute__((always_inline)) {
      return images.texels[i + k] + size_t(at.index[i + k]) * 8;
    };
    load_pairs(place, first, second);
    store(word[0] + i, first), store(word[1] + i, second);
  }
  for (int k = 0; k < 4; ++k) {
    const auto decode = decoder(k);
    SOFTGL_FOR_LANES(block, i) out.v[k][i] = decode(uint32_t(word[k >> 1][i]) >> 16 * (k & 1));
  }
}

/// The texels as floats; the border outside.
template <class Lanes, class Images>
static inline void fetch_texels(const Lanes& block, const TextureUnitConstants& t, Images images,
                                const TexelPlaces& at, FloatTexels& out) {
  switch (t.texel) {
  case TextureTexel::Rgba8:
    fetch_bytes(block, images, at, out, [&](int k) {
      return [shift = t.shift[k], scale = t.scale[k]](int32_t v) { return float(v >> shift) * scale; };
    });
    break;
  case TextureTexel::Srgb8:
    fetch_bytes(block, images, at, out, [&](int k) {
      return [linear = k == 3, scale = t.scale[3]](int32_t v) {
        return linear ? float(v) * scale : srgb_to_linear(float(v));
      };
    });
    break;
  case TextureTexel::Rgba16:
    fetch_halves(block, images, at, out, [&](int k) {
      return [scale = t.scale[k]](uint32_t v) { return float(int32_t(v & 0xffff)) * scale; };
    });
    break;
  case TextureTexel::Signed16:
    fetch_halves(block, images, at, out, [&](int k) {
      return
          [scale = t.scale[k]](uint32_t v) { return maximum(float(int32_t(v << 16) >> 16) * scale, -1.0f); };
    });
    break;
  case TextureTexel::Float:
    for (int32_t i = 0; i < block.lanes; i += kWidth) {
      FloatV v[4];
      const auto place = [&](int k) __attribute__((always_inline)) {
        return reinterpret_cast<const float*>(images.texels[i + k]) + size_t(at.index[i + k]) * 4;
      };
      load_transposed(place, v);
      for (int k = 0; k < 4; ++k) store(out.v[k] + i, v[k]);
    }
    break;
  default:
    fetch_depths(block, t, images, at, out.v[0]);
    for (int k = 1; k < 4; ++k) SOFTGL_FOR_LANES(block, i) out.v[k][i] = k < 3 ? out.v[0][i] : 1.0f;
  }
  int32_t outside = 0;
  SOFTGL_FOR_LANES(block, i) outside |= ~at.inside[i];
  if (outside == 0) return;
  for (int k = 0; k < 4; ++k) {
    const float border = t.border[k];
    SOFTGL_FOR_LANES(block, i) out.v[k][i] = select(at.inside[i], out.v[k][i], border);
  }
}

} // namespace SOFTGL_ISA
} // namespace softgl
