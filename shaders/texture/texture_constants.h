// The numbers of one texture unit: an immutable snapshot that a fragment program keeps.
#pragma once

#include <stdint.h>

namespace softgl {

constexpr int kTextureLevelLimit = 15;

/// How a coordinate becomes a texel number; RepeatPowerOfTwo and Repeat differ in rounding, not in meaning.
enum class TextureWrap : uint8_t {
  RepeatPowerOfTwo,
  Repeat,
  ClampToEdge,
  Clamp,
  ClampToBorder,
  MirroredRepeat
};
enum class TextureMip : uint8_t { None, Nearest, Linear };
/// What a texel is made of: 4 bytes, 4 uint16_t, 4 int16_t, 4 floats, 4 bytes of which the first three are
/// not linear, or one depth: uint32_t or float.
enum class TextureTexel : uint8_t { Rgba8, Rgba16, Signed16, Float, Srgb8, Depth, DepthFloat };
constexpr bool is_depth(TextureTexel t) { return t >= TextureTexel::Depth; }
enum class TextureShape : uint8_t { OneD, TwoD, ThreeD, Cube };

/// One image. Row and slice strides count texels; rows are one texel longer and slices one row longer than
/// the image.
struct TextureLevel {
  const unsigned char* face[6]; // face 0 only, unless it is a cube map
  int32_t width, height, depth;
  int32_t row, slice;
};

struct TextureUnitConstants {
  TextureLevel level[kTextureLevelLimit]; // level[0] is the base level
  int32_t last_level;
  TextureShape shape;
  TextureTexel texel;
  TextureWrap wrap[3];
  bool counts_texels; // coordinates are not fractions of the size (GL_ARB_texture_rectangle)
  bool bordered;      // the images have a border of one texel, in front of `face` and behind each row
  bool min_linear, mag_linear;
  bool seamless; // a linear filter takes texels across the edges of a cube map's faces
  bool no_alpha; // the base format has none: it is 1, whatever the weights of texels come to
  TextureMip mip;
  // Level of detail. adjusts_lod: bias or limits are in force, which selects another formula (see
  // texture_lod.inl).
  bool adjusts_lod, constant_lod, has_min_lod, has_max_lod;
  float lod_bias, min_lod, max_lod;
  // Up to where a texture is magnified: the constant c of 3.8.9, and the scale factor there; squared, but of
  // one-dimensional textures.
  float magnified_lod, magnified_rho;
  // Texels under an ellipse are taken instead (texture_anisotropic.inl). level[0] is number first_level of
  // the texture, and level 0 has or had the size zero_width x zero_height.
  bool anisotropic;
  int32_t first_level, zero_width, zero_height;
  float border[4];  // what a border texel looks like in this base format
  uint8_t shift[4]; // stored component >> shift is the integer that scale turns into [0,1]
  float scale[4];
  // Depth textures: comparison of r with the texel (3.8.14), and where the result goes.
  bool compares;
  uint8_t compare_function; // GL_NEVER .. GL_ALWAYS as 0 .. 7
  uint8_t depth_components; // bit k: component k is the depth; those that are not are 0, alpha is 1
  float color[4];           // of the environment

  /// Sampling reads the differences of coordinates across a 2x2 quad, to find a level or a filter.
  bool reads_differences() const { return mip != TextureMip::None || mixes_filters() || anisotropic; }
  /// Sampling looks at the other pixels of a 2x2 quad, whose lanes of a cube map may lie on several faces.
  bool reads_quads() const {
    return shape == TextureShape::Cube && (mixes_filters() || seamless || anisotropic);
  }
  bool mixes_filters() const { return min_linear != mag_linear; }
};

} // namespace softgl
