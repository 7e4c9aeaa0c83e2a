// Textures as the specification's machine has them (3.8): images, objects, units and environments.
#pragma once

#include <array>
#include <map>

#include "expect/pixel_state.h"
#include "spec/vectors.h"

namespace softgl::suite {

using spec::Vec4;

constexpr int kTextureUnits = 4;
constexpr int kTextureLevels = 9; // images up to 256

/// The targets in the order of what wins if several are enabled (3.8.15).
enum class TextureTarget { OneD, TwoD, ThreeD, Cube };
constexpr int kTextureTargets = 4;

struct TextureImage {
  int dimensions = 2, width = 0, height = 0, depth = 0, border = 0; // sizes are without the border
  GLenum internal_format = 1, base = GL_NONE;
  // Filtered components as table 3.20 gives them, R, G, B and A; a depth stands in red. With the border's
  // texels.
  std::vector<Pixel> texels;
  Pixel& at(int x, int y, int z);
  const Pixel& at(int x, int y, int z) const { return const_cast<TextureImage*>(this)->at(x, y, z); }
};

struct TextureParameters {
  GLenum wrap[3] = {GL_REPEAT, GL_REPEAT, GL_REPEAT};
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
  double border[4] = {0, 0, 0, 0}, min_lod = -1000, max_lod = 1000, priority = 1;
  int base_level = 0, max_level = 1000;
  GLenum depth_mode = GL_LUMINANCE, compare_mode = GL_NONE, compare_function = GL_LEQUAL;
  bool generate_mipmap = false;
};

struct TextureObject {
  TextureTarget target = TextureTarget::TwoD;
  TextureParameters parameters;
  TextureImage images[6][kTextureLevels];
};

struct TextureGeneration {
  bool on = false;
  GLenum mode = GL_EYE_LINEAR;
  Vec4 object_plane{0, 0, 0, 0}, eye_plane{0, 0, 0, 0};
};

struct TextureEnvironment {
  GLenum mode = GL_MODULATE;
  double color[4] = {0, 0, 0, 0}, lod_bias = 0;
  GLenum combine[2] = {GL_MODULATE, GL_MODULATE}; // of RGB and of alpha
  GLenum source[2][3] = {{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}, {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT}};
  GLenum operand[2][3] = {{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
                          {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA}};
  double scale[2] = {1, 1};
};

struct TextureUnit {
  TextureUnit();
  bool on[kTextureTargets] = {};
  GLuint bound[kTextureTargets] = {};
  TextureGeneration generation[4];
  TextureEnvironment environment;
};

/// What GL_TEXTURE_BIT saves, and the objects, of which it saves the parameters of those that are bound.
struct TextureState {
  int active = 0;
  TextureUnit units[kTextureUnits];
  std::map<std::pair<TextureTarget, GLuint>, TextureObject> objects;
  TextureObject& bound(int unit, TextureTarget target);
  const TextureObject* texture_of(int unit) const; // that is enabled and complete, or null
};

/// Coordinates of a pixel, divided by q, and how much they change from one pixel to the next: the greater of
/// two axes.
struct TexturePoint {
  Interval coordinate[3], change[3];
};

bool is_complete(const TextureObject& texture);
/// The base internal format (tables 3.15 and 3.16). Throws std::logic_error for one that the suite does not
/// know.
GLenum base_format(GLenum internal_format);
/// From a color or depth to a texel: table 3.15, and the bits of the internal format.
Pixel texel_of(GLenum internal_format, const Pixel& pixel);
/// The filtered color (3.8.8, 3.8.9, 3.8.14).
Pixel sampled(const TextureObject& texture, const TexturePoint& point, double lod_bias);
/// Fills the levels above the base level by averages of 2x2x2 texels.
void generate_mipmaps(TextureObject& texture);
/// One unit's environment (3.8.13): `color` is what the unit before gave. `texels` of all units are for
/// GL_COMBINE.
void apply_environment(const TextureEnvironment& environment, GLenum base, const Pixel* texels, int unit,
                       const Interval primary[4], Interval color[4], const double step[4]);

} // namespace softgl::suite
