// The rows of reference/DEVIATIONS.md that are about textures.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <vector>

#include "texture_context.h"

using namespace softgl::test;

TEST_CASE("Skipped pixels are skipped when bytes are swapped or colours transferred", "[texture][deviation]") {
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

TEST_CASE("Colours are scaled on their way from the framebuffer into a texture", "[texture][deviation]") {
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
