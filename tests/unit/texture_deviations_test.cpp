// The rows of reference/DEVIATIONS.md that are about textures.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <vector>

#include "texture_context.h"

using namespace softgl::test;

TEST_CASE("Skipped pixels are skipped when bytes are swapped or colors transferred", "[texture][deviation]") {
  TextureContext c(softgl_library());
  const unsigned short texels[4] = {0x0100, 0x0200, 0x0304, 0xffff};
  c.gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 2);
  c.gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE16, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_SHORT, texels);
  unsigned short value = 0;
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_SHORT, &value);
  CHECK(value == 0x0403);
  c.gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
  c.gl.PixelTransferf(GL_RED_SCALE, 0.5f);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE16, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_SHORT, texels);
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_SHORT, &value);
  CHECK(value == 0x0182);
}

TEST_CASE("Colors are scaled on their way from the framebuffer into a texture", "[texture][deviation]") {
  TextureContext c(softgl_library());
  c.gl.Enable(GL_SCISSOR_TEST);
  for (int row = 0; row < 4; ++row) {
    c.gl.Scissor(0, row, 2, 1);
    c.gl.ClearColor(0.2f * float(row), 0.4f, 1, 1);
    c.gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  c.gl.PixelTransferf(GL_RED_SCALE, 0.5f);
  c.gl.PixelTransferf(GL_GREEN_BIAS, 0.2f);
  c.gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, 2, 4, 0);
  c.gl.PixelTransferf(GL_RED_SCALE, 1);
  c.gl.PixelTransferf(GL_GREEN_BIAS, 0);
  unsigned char texels[4][2][4] = {};
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (int row = 0; row < 4; ++row)
    for (const auto& texel : texels[row]) {
      CHECK(std::abs(texel[0] - 51 * row / 2) <= 1);
      CHECK(texel[1] == 153);
      CHECK(texel[2] == 255);
    }
}

TEST_CASE("A full texel reads back as the largest integer", "[texture][deviation]") {
  TextureContext c(softgl_library());
  const unsigned char white = 255;
  c.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &white);
  GLuint value = 0;
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_INT, &value);
  CHECK(value == 0xffffffffu);
}

TEST_CASE("Compressed internal formats are stored uncompressed", "[texture][deviation]") {
  TextureContext c(softgl_library());
  std::vector<unsigned char> texels(16 * 16 * 3), back(texels.size());
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = (unsigned char)(i * 37);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  GLint compressed = 1;
  c.gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
  CHECK(compressed == 0);
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, back.data());
  CHECK(back == texels);
}

// Three levels of one internal format, each with pixels of another form; gives the color that each level is
// drawn with.
static std::vector<GLuint> draw_levels(const Gl& gl, bool smallest_first) {
  TextureContext c(gl);
  const GLubyte bytes[4] = {51, 102, 204, 255};
  const GLushort shorts[4] = {0x1111, 0x2222, 0x8888, 0xffff};
  const GLfloat floats[4] = {0.6f, 0.2f, 0.8f, 1};
  for (int i = 0; i < 3; ++i) {
    const int level = smallest_first ? 2 - i : i, size = 4 >> level;
    std::vector<GLubyte> image;
    const auto fill = [&](const auto& texel) {
      for (int k = 0; k < size * size; ++k)
        image.insert(image.end(), reinterpret_cast<const GLubyte*>(texel),
                     reinterpret_cast<const GLubyte*>(texel) + sizeof texel);
    };
    level == 0 ? fill(shorts) : level == 1 ? fill(bytes) : fill(floats);
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA,
                  level == 0   ? GL_UNSIGNED_SHORT
                  : level == 1 ? GL_UNSIGNED_BYTE
                               : GL_FLOAT,
                  image.data());
  }
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  std::vector<GLuint> colors;
  for (int level = 0; level < 3; ++level) {
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, GLfloat(level));
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, GLfloat(level));
    gl.Rectf(-1, -1, 1, 1);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &colors.emplace_back());
  }
  return colors;
}

TEST_CASE(
    "Levels of one internal format fit together, whatever form their pixels have and whichever comes first",
    "[texture][deviation]") {
  const std::vector<GLuint> colors = {0xff882211, 0xffcc6633, 0xffcc3399};
  CHECK(draw_levels(softgl_library(), false) == colors);
  CHECK(draw_levels(softgl_library(), true) == colors);
  CHECK(draw_levels(osmesa_library(), false) == colors);
  CHECK(draw_levels(osmesa_library(), true) != colors);
}

// A rectangle of black and white texels, one drawn as four pixels or four as one: the number of greys.
static int greys_of_rectangle(const Gl& gl, GLenum minify, GLenum magnify, float texels) {
  TextureContext c(gl);
  std::vector<GLubyte> image(64 * 64);
  for (size_t i = 0; i < image.size(); ++i) image[i] = (i ^ i / 64) & 1 ? 255 : 0;
  gl.TexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_LUMINANCE8, 64, 64, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                image.data());
  gl.TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GLint(minify));
  gl.TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MAG_FILTER, GLint(magnify));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_RECTANGLE);
  gl.Begin(GL_QUADS);
  for (int k = 0; k < 4; ++k) {
    const bool right = k == 1 || k == 2, upper = k > 1;
    gl.TexCoord2f(right ? texels : 0, upper ? texels : 0);
    gl.Vertex2f(right ? 1.0f : -1.0f, upper ? 1.0f : -1.0f);
  }
  gl.End();
  GLubyte pixels[16][16];
  gl.ReadPixels(0, 0, 16, 16, GL_RED, GL_UNSIGNED_BYTE, pixels);
  int greys = 0;
  for (const auto& row : pixels)
    for (const GLubyte v : row) greys += v != 0 && v != 255;
  return greys;
}

TEST_CASE("Rectangles are magnified when a texel covers more than a pixel", "[texture][deviation]") {
  for (const bool magnified : {false, true}) {
    const float texels = magnified ? 4 : 56;
    CHECK(greys_of_rectangle(softgl_library(), GL_NEAREST, GL_LINEAR, texels) ==
          (magnified ? greys_of_rectangle(softgl_library(), GL_LINEAR, GL_LINEAR, texels) : 0));
    CHECK(greys_of_rectangle(softgl_library(), GL_LINEAR, GL_NEAREST, texels) ==
          (magnified ? 0 : greys_of_rectangle(softgl_library(), GL_LINEAR, GL_LINEAR, texels)));
    CHECK(greys_of_rectangle(softgl_library(), GL_LINEAR, GL_LINEAR, texels) > 0);
  }
  CHECK(greys_of_rectangle(osmesa_library(), GL_NEAREST, GL_LINEAR, 4) == 0); // as if minified
}

TEST_CASE("One minus the texel of a unit that is off is one in all components", "[texture][deviation]") {
  auto draw = [](const Gl& gl) {
    TextureContext c(gl);
    const GLubyte grey[4] = {128, 128, 128, 128};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, grey);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.Enable(GL_TEXTURE_2D);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, GL_TEXTURE3);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_ONE_MINUS_SRC_COLOR);
    gl.Rectf(-1, -1, 1, 1);
    gl.Finish();
    return std::vector<int>{c.buffer[0], c.buffer[1], c.buffer[2]};
  };
  CHECK(draw(softgl_library()) == std::vector<int>{255, 255, 255});
  CHECK(draw(osmesa_library()) == std::vector<int>{255, 0, 0});
}
