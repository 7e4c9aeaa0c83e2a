// Textures on plain geometry: two large triangles, so that nothing but sampling and environments decides the
// picture.
#include <algorithm>
#include <cstring>

#include "conformance/families/common.h"
#include "conformance/families/environments.h"

namespace softgl::test {

namespace {

struct TexelOptions {
  bool one_dimensional = false, three_dimensional = false, cube = false, several_units = false, depth = false,
       anisotropic = false;
};

void image(Stage& s, GLenum target, GLint internal_format, int level, int w, int h, int d) {
  Random& r = s.random;
  const bool depth = internal_format == GL_DEPTH_COMPONENT || internal_format == GL_DEPTH_COMPONENT16 ||
                     internal_format == GL_DEPTH_COMPONENT24 || internal_format == GL_DEPTH_COMPONENT32F;
  std::vector<uint8_t> pixels(size_t(w) * size_t(h) * size_t(d) * 4 + 16);
  const bool smooth = r.chance(30);
  for (size_t i = 0; i < pixels.size(); ++i)
    pixels[i] = smooth ? uint8_t(i * 3 + (i & 3) * 70) : uint8_t(r.bits() >> 24);
  const GLenum format = depth ? GL_DEPTH_COMPONENT : GL_RGBA;
  const GLenum type = depth ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
  if (target == GL_TEXTURE_1D)
    s.gl.TexImage1D(target, level, internal_format, w, 0, format, type, pixels.data());
  else if (target == GL_TEXTURE_3D)
    s.gl.TexImage3D(target, level, internal_format, w, h, d, 0, format, type, pixels.data());
  else
    s.gl.TexImage2D(target, level, internal_format, w, h, 0, format, type, pixels.data());
}

void one_texture(Stage& s, GLenum target, const TexelOptions& o) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(target, name);
  const bool odd = r.chance(30);
  const int largest = target == GL_TEXTURE_3D ? 4 : 6;
  auto size = [&] { return odd ? r.integer(1, (1 << largest) + 5) : 1 << r.integer(0, largest); };
  int w = size(), h = size(), d = size();
  if (target == GL_TEXTURE_CUBE_MAP) h = w;
  if (target == GL_TEXTURE_1D) h = 1;
  if (target != GL_TEXTURE_3D) d = 1;
  const GLint format =
      o.depth
          ? r.pick({GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F})
          : r.pick({GL_RGBA8,
                    GL_RGBA8,
                    GL_RGBA,
                    GL_RGB,
                    GL_LUMINANCE,
                    GL_LUMINANCE_ALPHA,
                    GL_ALPHA,
                    GL_INTENSITY,
                    GL_RGB5,
                    GL_RGBA4,
                    GL_RGB5_A1,
                    GL_R3_G3_B2,
                    GL_RGB4,
                    GL_LUMINANCE4_ALPHA4,
                    GL_RGB10,
                    GL_RGB10_A2,
                    GL_RGBA16,
                    GL_RGB16,
                    GL_ALPHA16,
                    GL_LUMINANCE16,
                    GL_LUMINANCE16_ALPHA16,
                    GL_INTENSITY16});
  const bool mipmaps = r.chance(60);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                   mipmaps ? r.pick({GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR})
                           : r.pick({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    gl.TexParameteri(target, axis,
                     r.pick({GL_REPEAT, GL_REPEAT, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_EDGE, GL_CLAMP,
                             GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
  const Float4 border = r.color();
  gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, border.data());
  if (o.depth) {
    gl.TexParameteri(target, GL_DEPTH_TEXTURE_MODE, r.pick({GL_LUMINANCE, GL_INTENSITY, GL_ALPHA, GL_RED}));
    gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, r.pick({GL_NONE, GL_COMPARE_R_TO_TEXTURE}));
    gl.TexParameteri(
        target, GL_TEXTURE_COMPARE_FUNC,
        r.pick({GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER}));
  }
  const bool generate = mipmaps && r.chance(40);
  gl.TexParameteri(target, GL_GENERATE_MIPMAP, generate);
  const int faces = target == GL_TEXTURE_CUBE_MAP ? 6 : 1;
  for (int face = 0; face < faces; ++face) {
    const GLenum t = faces == 6 ? GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face) : target;
    int lw = w, lh = h, ld = d;
    for (int level = 0;; ++level) {
      image(s, t, format, level, lw, lh, ld);
      if (!mipmaps || generate || (lw == 1 && lh == 1 && ld == 1)) break;
      lw = std::max(1, lw / 2), lh = std::max(1, lh / 2), ld = std::max(1, ld / 2);
    }
  }
  if (mipmaps && r.chance(20)) gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, r.integer(0, 4));
  if (mipmaps && r.chance(20)) gl.TexParameteri(target, GL_TEXTURE_BASE_LEVEL, r.integer(0, 2));
  if (r.chance(20)) gl.TexParameterf(target, GL_TEXTURE_MIN_LOD, r.real(-1, 3));
  if (r.chance(20)) gl.TexParameterf(target, GL_TEXTURE_MAX_LOD, r.real(0, 4));
  if (r.chance(20)) gl.TexParameterf(target, GL_TEXTURE_LOD_BIAS, r.real(-2, 2));
  if (o.anisotropic)
    gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, r.pick({1.5f, 2.0f, 4.0f, 16.0f, 100.0f}));
  gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, r.chance(15) ? r.real(-2, 2) : 0.0f);
  gl.Enable(target);
}

void draw_with(Stage& s, const TexelOptions& o) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const int units = o.several_units ? r.integer(2, 4) : 1;
  for (int u = 0; u < units; ++u) {
    gl.ActiveTexture(GLenum(GL_TEXTURE0 + u));
    one_texture(s,
                o.one_dimensional     ? GL_TEXTURE_1D
                : o.three_dimensional ? GL_TEXTURE_3D
                : o.cube              ? GL_TEXTURE_CUBE_MAP
                                      : GL_TEXTURE_2D,
                o);
    random_environment(s, units, false); // a texture may be incomplete
  }
  gl.ActiveTexture(GL_TEXTURE0);
  const float scale = r.pick({0.6f, 1.0f, 2.0f, 8.0f, o.anisotropic ? 4.0f : 40.0f});
  const bool projective = r.chance(30), perspective = r.chance(50);
  gl.Begin(GL_TRIANGLES);
  for (int triangle = 0; triangle < 2; ++triangle)
    for (int i = 0; i < 3; ++i) {
      const float x = (i + triangle) % 3 == 1 ? 0.9f : -0.9f, y = (i + triangle) % 3 == 2 ? 0.9f : -0.9f,
                  w = perspective ? r.real(0.5f, 2) : 1.0f;
      const Float4 c = r.color();
      gl.Color4fv(c.data());
      for (int u = 0; u < units; ++u) {
        const Float4 t{r.real(-scale, scale), r.real(-scale, scale), r.real(-scale, scale),
                       projective ? r.real(0.5f, 1.5f) : 1.0f};
        gl.MultiTexCoord4fv(GLenum(GL_TEXTURE0 + u), t.data());
      }
      const float flip = triangle ? -1.0f : 1.0f;
      gl.Vertex4f(x * flip * w, y * flip * w, 0, w);
    }
  gl.End();
}

void draw_texels(Stage& s) { draw_with(s, {}); }
void draw_texels_1d(Stage& s) {
  TexelOptions o;
  o.one_dimensional = true;
  draw_with(s, o);
}
void draw_texels_3d(Stage& s) {
  TexelOptions o;
  o.three_dimensional = true;
  draw_with(s, o);
}
/// GL_ARB_seamless_cube_map: magnified faces show the texels of their neighbors, and corners.
void draw_texels_seamless(Stage& s) {
  s.gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  TexelOptions o;
  o.cube = true;
  draw_with(s, o);
}
void draw_texels_cube(Stage& s) {
  TexelOptions o;
  o.cube = true;
  draw_with(s, o);
}
void draw_texels_depth(Stage& s) {
  TexelOptions o;
  o.depth = true;
  draw_with(s, o);
}
/// Scales are small: an ellipse may be as long as the texture is repeated.
void draw_anisotropic(Stage& s) {
  TexelOptions o;
  o.anisotropic = true;
  const int shape = s.random.integer(0, 5);
  o.three_dimensional = shape == 0, o.cube = shape == 1;
  if (s.random.chance(50)) s.gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  draw_with(s, o);
}
void draw_units(Stage& s) {
  TexelOptions o;
  o.several_units = true;
  draw_with(s, o);
}

SceneRegistration texels{{"texels", draw_texels, true}}, one{{"texels_1d", draw_texels_1d, true}},
    several{{"texture_units", draw_units, true}}, anisotropic{{"anisotropy", draw_anisotropic, true}};
SceneRegistration three{{"texels_3d", draw_texels_3d, true}}, cube{{"texels_cube", draw_texels_cube, true}},
    seamless{{"texels_seamless", draw_texels_seamless, true}},
    depth{{"texels_depth", draw_texels_depth, true}};

} // namespace

} // namespace softgl::test
