// Textures of random blocks of GL_3DFX_texture_compression_FXT1, and what is read of them.
#include <algorithm>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

std::vector<GLubyte> random_blocks(Stage& s, int width, int height) {
  Random& r = s.random;
  std::vector<GLubyte> blocks(size_t((width + 7) / 8) * size_t((height + 3) / 4) * 16);
  for (GLubyte& byte : blocks) byte = GLubyte(r.bits() >> 24);
  const int kind = r.integer(0, 4); // one of the four, or any
  static const GLubyte modes[] = {0x00, 0x40, 0x60, 0x80};
  for (size_t i = 15; i < blocks.size() && kind < 4; i += 16)
    blocks[i] = GLubyte((blocks[i] & (kind == 0 ? 0x3f : kind == 3 ? 0x7f : 0x1f)) | modes[kind]);
  return blocks;
}

void draw_fxt1(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  const GLenum format = r.chance(50) ? GL_COMPRESSED_RGB_FXT1_3DFX : GL_COMPRESSED_RGBA_FXT1_3DFX;
  const int width = r.integer(1, 40), height = r.integer(1, 40);
  const std::vector<GLubyte> blocks = random_blocks(s, width, height);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, r.pick({GL_NEAREST, GL_LINEAR}));
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GLsizei(blocks.size()), blocks.data());
  if (r.chance(30)) {
    const int x = 8 * r.integer(0, (width - 1) / 8), y = 4 * r.integer(0, (height - 1) / 4);
    const int w = std::min(8 * r.integer(1, 3), width - x), h = std::min(4 * r.integer(1, 3), height - y);
    const std::vector<GLubyte> part = random_blocks(s, w, h);
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, x, y, w, h, format, GLsizei(part.size()), part.data());
  }
  if (r.chance(30)) { // what is read becomes a texture that is not compressed
    std::vector<GLubyte> pixels(size_t(width) * size_t(height) * 4), read(blocks.size());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, read.data());
    for (size_t i = 0; i < read.size() && i < pixels.size(); ++i) pixels[i] ^= read[i];
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  const float scale = r.pick({1.0f, 1.0f, 2.0f});
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    gl.TexCoord2f(i & 1 ? scale : 0, i & 2 ? scale : 0);
    gl.Vertex2f(i & 1 ? 0.95f : -0.95f, i & 2 ? 0.95f : -0.95f);
  }
  gl.End();
}

SceneRegistration fxt1{{"fxt1_textures", draw_fxt1, true}};

} // namespace
} // namespace softgl::test
