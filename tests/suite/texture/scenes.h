// What the texture tests draw: images whose texels differ from each other, and sheets with texture
// coordinates.
#pragma once

#include "run/test.h"

namespace softgl::suite {

constexpr Need kMultitexture{13, "GL_ARB_multitexture"};

/// A row of a chapter.
Test texture_test(const char* name, const char* section, const char* sentence,
                  std::function<void(Script&)> body, Need need = {}, const char* open = "");

/// Bytes for `groups` pixels of so many components.
Memory texel_bytes(int groups, int components, int seed = 0);
/// Bytes of one color for `groups` pixels.
Memory plain_bytes(int groups, V color);

/// An image of bytes for GL_TEXTURE_2D.
void image_2d(Script& s, GLenum internal_format = GL_RGBA, GLenum format = GL_RGBA, int width = 4,
              int height = 4, int level = 0, int seed = 0);
void image_1d(Script& s, int width, int level = 0, int seed = 0);
/// Levels of GL_TEXTURE_1D from `width` to 1, each of a color of its own.
void colored_levels(Script& s, int width, int first_level = 0);
void filters(Script& s, GLenum target, GLenum min_filter, GLenum mag_filter);
void wrap(Script& s, GLenum target, GLenum mode);
void environment(Script& s, GLenum mode);

/// A texture of 4x4 RGBA texels that replaces colors, with the nearest texel.
void replace_scene(Script& s, GLenum target = GL_TEXTURE_2D);
/// Alpha is seen: source alpha, one minus source alpha.
void see_alpha(Script& s);

struct Range {
  double s0 = 0, t0 = 0, s1 = 1, t1 = 1;
};
/// Two triangles over the rectangle, with texture coordinates from corner to corner.
void textured_sheet(Script& s, const Range& range = {}, double left = -1, double bottom = -1,
                    double right = 1, double top = 1, double z = 0);
/// Stripes above each other, in which one pixel is 2^lod texels of a 1D texture of `width` texels.
void stripes(Script& s, int width, const std::vector<double>& lods);
/// Colors that change from pixel to pixel.
void colored_window(Script& s);
/// The coordinate r grows from 0 to 1 with x or with y.
void generate_r(Script& s, double along_x, double along_y);

} // namespace softgl::suite
