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

TEST_CASE("Generic compressed formats are stored uncompressed", "[texture][deviation]") {
  TextureContext c(softgl_library());
  std::vector<unsigned char> texels(16 * 16 * 3), back(texels.size());
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = (unsigned char)(i * 37);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  GLint compressed = 1;
  c.gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
  CHECK(compressed == 0);
  GLint format = 0;
  c.gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
  CHECK(format == GL_RGB); // the base format takes the place of the generic one
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

namespace {

/// What a texture holds that was made of 40 x 3 color indexes.
std::vector<unsigned char> texels_of_indexes(const Gl& gl, GLenum type, GLenum internal_format,
                                             bool sub_image, int shift, int offset) {
  TextureContext c(gl);
  for (GLenum map = GL_PIXEL_MAP_I_TO_R; map <= GL_PIXEL_MAP_I_TO_A; ++map) {
    float values[64];
    for (int i = 0; i < 64; ++i) values[i] = float((i * 37 + int(map) * 11) % 64) / 63;
    gl.PixelMapfv(map, 64, values);
  }
  gl.PixelTransferi(GL_INDEX_SHIFT, shift);
  gl.PixelTransferi(GL_INDEX_OFFSET, offset);
  gl.PixelTransferf(GL_RED_SCALE, 0.5f); // not of indexes
  std::vector<float> memory(40 * 3);
  unsigned char* bytes = reinterpret_cast<unsigned char*>(memory.data());
  for (size_t i = 0; i < memory.size() * 4; ++i) bytes[i] = (unsigned char)(i * 73 + 5);
  if (type == GL_FLOAT)
    for (size_t i = 0; i < memory.size(); ++i) memory[i] = float(i) + 0.75f;
  gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(internal_format), 40, 3, 0, GL_COLOR_INDEX, type,
                sub_image ? nullptr : memory.data());
  if (sub_image) gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 40, 3, GL_COLOR_INDEX, type, memory.data());
  CHECK(gl.GetError() == GL_NO_ERROR);
  std::vector<unsigned char> texels(40 * 3 * 8);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_SHORT, texels.data());
  return texels;
}

} // namespace

TEST_CASE("Color indexes become the texels of OSMesa", "[texture]") {
  for (GLenum type : {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_INT, GL_FLOAT})
    for (GLenum format :
         {GL_RGBA8, GL_RGBA, GL_RGB, GL_RGBA16, GL_RGB10_A2, GL_RGBA4, GL_LUMINANCE, GL_ALPHA})
      for (bool sub_image : {false, true})
        for (int shift : {0, 2, -1}) {
          INFO(type << " " << format << " " << sub_image << " " << shift);
          CHECK((texels_of_indexes(softgl_library(), type, format, sub_image, shift, shift * 3) ==
                 texels_of_indexes(osmesa_library(), type, format, sub_image, shift, shift * 3)));
        }
}

// OSMesa reads the bits of all rows as one row.
TEST_CASE("Each row of a bitmap begins in a byte of its own", "[texture][deviation]") {
  TextureContext c(softgl_library());
  const float red[2] = {0.2f, 1};
  c.gl.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, red);
  const unsigned char rows[12] = {0xA5, 0xff, 0xff, 0xff, 0x3C, 0xff, 0xff, 0xff, 0x80};
  for (bool lsb_first : {false, true}) {
    c.gl.PixelStorei(GL_UNPACK_LSB_FIRST, lsb_first);
    for (int skip : {0, 2}) {
      c.gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, skip);
      c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 3, 0, GL_COLOR_INDEX, GL_BITMAP, rows);
      unsigned char texels[3][4] = {};
      c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, texels);
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) {
          const int bit = x + skip;
          CHECK(texels[y][x] == (rows[4 * y] >> (lsb_first ? bit : 7 - bit) & 1 ? 255 : 51));
        }
    }
  }
  CHECK(c.gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("The border of an image is left out", "[texture][deviation]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    TextureContext c(*gl);
    std::vector<unsigned char> texels(6 * 6 * 4);
    for (size_t i = 0; i < texels.size(); ++i) texels[i] = (unsigned char)i;
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    GLint width = 0, border = 7;
    gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER, &border);
    CHECK(width == 4);
    CHECK(border == 0);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, -1, -1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    CHECK(gl->GetError() == GL_INVALID_VALUE);
    std::vector<unsigned char> inside(6 * 6 * 4, 7);
    gl->GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, inside.data());
    CHECK(inside[0] == texels[(6 + 1) * 4]);
    CHECK(inside[4 * 4 * 4] == 7);
  }
}
