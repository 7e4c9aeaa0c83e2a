// The rows of reference/DEVIATIONS.md that are about textures.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "support/gl.h"

using namespace softgl::test;

namespace {

struct TestContext {
  const Gl& gl;
  void* context;
  std::vector<unsigned char> buffer = std::vector<unsigned char>(16 * 16 * 4);
  explicit TestContext(const Gl& library) : gl(library), context(library.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr)) { bind(); }
  ~TestContext() { gl.OSMesaDestroyContext(context); }
  void bind() { REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16)); }
};

std::vector<float> second_level(TestContext& c, GLint internal_format, GLenum format, int width, int height) {
  c.bind();
  std::vector<float> texels(size_t(width * height) * 4), result(size_t(width / 2) * size_t(height / 2) * 4);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = float((i * 2654435761u >> 7) & 1023) / 1023.0f;
  c.gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, GL_FLOAT, texels.data());
  c.gl.GetTexImage(GL_TEXTURE_2D, 1, format, GL_FLOAT, result.data());
  return result;
}

} // namespace

TEST_CASE("Mipmaps of depth, 3-3-2 and odd wide textures agree to one unit of the storage", "[texture][deviation]") {
  TestContext ours(softgl_library()), theirs(osmesa_library());
  struct Case { GLint internal_format; GLenum format; float unit; int width, height; };
  for (const Case& k : {Case{GL_RGBA16, GL_RGBA, 2.0f / 65535, 11, 7}, Case{GL_R3_G3_B2, GL_RGB, 1.0f / 3, 8, 8}, Case{GL_RGB10, GL_RGB, 1.0f / 1023, 10, 6},
                        Case{GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, 4.0f / 16777215, 12, 6}}) {
    const auto a = second_level(ours, k.internal_format, k.format, k.width, k.height), b = second_level(theirs, k.internal_format, k.format, k.width, k.height);
    float worst = 0;
    for (size_t i = 0; i < a.size(); ++i) worst = std::fmax(worst, std::fabs(a[i] - b[i]));
    CAPTURE(k.internal_format);
    CHECK(worst <= k.unit * 1.01f);
  }
}

TEST_CASE("Skipped pixels are skipped when bytes are swapped or colours transferred", "[texture][deviation]") {
  TestContext c(softgl_library());
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

TEST_CASE("A full texel reads back as the largest integer", "[texture][deviation]") {
  TestContext c(softgl_library());
  const unsigned char white = 255;
  c.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 1, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, &white);
  GLuint value = 0;
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_LUMINANCE, GL_UNSIGNED_INT, &value);
  CHECK(value == 0xffffffffu);
}

TEST_CASE("Compressed internal formats are stored uncompressed", "[texture][deviation]") {
  TestContext c(softgl_library());
  std::vector<unsigned char> texels(16 * 16 * 3), back(texels.size());
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = (unsigned char)(i * 37);
  c.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  GLint compressed = 1;
  c.gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED, &compressed);
  CHECK(compressed == 0);
  c.gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, back.data());
  CHECK(back == texels);
}
