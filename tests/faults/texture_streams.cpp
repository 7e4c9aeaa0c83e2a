// Textures: images of all kinds, parts of them, copies, mipmaps, several units, deletion while a frame waits.
#include "faults/streams.h"

namespace softgl::test {
namespace {

std::vector<unsigned char> noise(Player& p, size_t bytes) {
  std::vector<unsigned char> all(bytes);
  for (auto& x : all) x = static_cast<unsigned char>(p.random.integer(0, 255));
  return all;
}

void square(const Gl& gl, float depth) {
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const float x = float(i == 1 || i == 2), y = float(i > 1);
    gl.TexCoord3f(2 * x, 2 * y, depth);
    gl.MultiTexCoord2f(GL_TEXTURE1, y, x);
    gl.Vertex3f(2 * x - 1, 2 * y - 1, depth);
  }
  gl.End();
}

void images(Player& p) {
  const Gl& gl = p.gl;
  const auto data = noise(p, 64 * 64 * 16);
  GLuint names[6] = {};
  gl.GenTextures(6, names);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  const struct {
    GLint internal;
    GLenum format, type;
  } formats[] = {{GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE},
                 {GL_LUMINANCE, GL_LUMINANCE, GL_UNSIGNED_BYTE},
                 {GL_RGB8, GL_BGR, GL_UNSIGNED_SHORT},
                 {GL_INTENSITY, GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
                 {GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GL_FLOAT},
                 {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_RGBA, GL_UNSIGNED_BYTE}};
  int i = 0;
  for (const auto& f : formats) {
    gl.BindTexture(GL_TEXTURE_2D, names[i]);
    gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, i % 2);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, i % 2 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    gl.TexImage2D(GL_TEXTURE_2D, 0, f.internal, 32, 64, 0, f.format, f.type, data.data());
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 8, 8, 12, f.format, f.type, data.data() + 100);
    p.check();
    gl.Enable(GL_TEXTURE_2D);
    square(gl, 0.1f * float(i));
    // The frame waits: what it draws must not change.
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 16, 16, f.format, f.type, data.data() + 500);
    square(gl, 0.1f * float(i));
    gl.Disable(GL_TEXTURE_2D);
    p.check();
    ++i;
  }
  gl.DeleteTextures(6, names);
  p.check();
  p.picture();
}

void targets(Player& p) {
  const Gl& gl = p.gl;
  const auto data = noise(p, 16 * 16 * 16 * 4);
  GLuint names[3] = {};
  gl.GenTextures(3, names);
  gl.BindTexture(GL_TEXTURE_1D, names[0]);
  gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  gl.TexSubImage1D(GL_TEXTURE_1D, 0, 7, 20, GL_RGB, GL_UNSIGNED_BYTE, data.data());
  gl.Enable(GL_TEXTURE_1D);
  square(gl, 0.5f);
  gl.BindTexture(GL_TEXTURE_3D, names[1]);
  gl.TexParameteri(GL_TEXTURE_3D, GL_GENERATE_MIPMAP, 1);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 16, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  gl.TexSubImage3D(GL_TEXTURE_3D, 0, 1, 2, 3, 4, 5, 6, GL_LUMINANCE, GL_UNSIGNED_BYTE, data.data());
  gl.Enable(GL_TEXTURE_3D);
  square(gl, 0.3f);
  p.check();
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, names[2]);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  for (GLenum face = 0; face < 6; ++face)
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  data.data() + 1024 * face);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  square(gl, 0.2f);
  p.check();
  gl.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLint width = 0;
  gl.GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
  p.check();
  std::vector<unsigned char> read(16 * 16 * 16 * 4);
  gl.GetTexImage(GL_TEXTURE_3D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  p.check();
  p.add(read.data(), read.size());
  gl.DeleteTextures(3, names);
  p.picture();
}

void copies(Player& p) {
  const Gl& gl = p.gl;
  const auto data = noise(p, 64 * 64 * 4);
  GLuint names[2] = {};
  gl.GenTextures(2, names);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 60; ++i) {
    const Float4 c = p.random.color();
    gl.Color4fv(c.data());
    const float x = p.random.real(-1, 1), y = p.random.real(-1, 1);
    gl.Vertex2f(x, y);
  }
  gl.End();
  for (int i = 0; i < 2; ++i) {
    gl.ActiveTexture(GL_TEXTURE0 + GLenum(i));
    gl.BindTexture(GL_TEXTURE_2D, names[i]);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.CopyTexImage2D(GL_TEXTURE_2D, 0, i ? GL_RGBA : GL_LUMINANCE, 2, 2, 32, 32, 0);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 20, 20, 8, 8);
    p.check();
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, i ? GL_COMBINE : GL_MODULATE);
    gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    if (i) gl.Enable(GL_TEXTURE_GEN_S);
    gl.Enable(GL_TEXTURE_2D);
  }
  gl.ActiveTexture(GL_TEXTURE0);
  square(gl, 0.4f);
  gl.DeleteTextures(1, names);
  square(gl, 0.3f);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, data.data());
  gl.BindTexture(GL_TEXTURE_2D, 0);
  p.check();
  p.picture();
  gl.DeleteTextures(2, names);
}

} // namespace

const std::vector<Stream>& texture_streams() {
  static const std::vector<Stream> streams = {
      {"textures.images", images}, {"textures.targets", targets}, {"textures.copies", copies}};
  return streams;
}

} // namespace softgl::test
