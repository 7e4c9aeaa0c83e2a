// GL 1.5, 3.6.3: pixel maps, and what they do to pixels that are read and to texels.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

const GLenum kMaps[10] = {GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_S_TO_S, GL_PIXEL_MAP_I_TO_R, GL_PIXEL_MAP_I_TO_G,
                          GL_PIXEL_MAP_I_TO_B, GL_PIXEL_MAP_I_TO_A, GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G,
                          GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_A_TO_A};

/// Where two lists differ first, and by what; empty when they are equal.
template <class T> std::string difference(const std::vector<T>& a, const std::vector<T>& b) {
  for (size_t i = 0; i < a.size(); i++)
    if (a[i] != b[i])
      return "at " + std::to_string(i) + ": " + std::to_string(a[i]) + " and " + std::to_string(b[i]);
  return "";
}

/// Sets a map with random values of a random type, in a list or not.
void random_map(const Gl& gl, Random& r, GLenum map) {
  const bool by_index = map <= GL_PIXEL_MAP_I_TO_A, in_list = r.chance(20);
  const GLsizei size = by_index ? 1 << r.integer(0, 8) : r.integer(1, 256);
  std::vector<GLfloat> f(256);
  std::vector<GLuint> u(256);
  std::vector<GLushort> s(256);
  for (size_t i = 0; i < 256; i++)
    f[i] = r.real(-0.2f, 1.2f), u[i] = GLuint(r.bits()), s[i] = GLushort(r.bits());
  if (map <= GL_PIXEL_MAP_S_TO_S)
    for (size_t i = 0; i < 256; i++) f[i] = GLfloat(r.integer(0, 255)), u[i] &= 0xff, s[i] &= 0xff;
  const int type = r.integer(0, 2);
  if (in_list) gl.NewList(1, GL_COMPILE);
  if (type == 0) gl.PixelMapfv(map, size, f.data());
  if (type == 1) gl.PixelMapuiv(map, size, u.data());
  if (type == 2) gl.PixelMapusv(map, size, s.data());
  if (in_list) gl.EndList(), gl.CallList(1);
}

std::vector<double> all_maps(const Gl& gl) {
  std::vector<double> out;
  for (GLenum map : kMaps) {
    GLint size = 0;
    gl.GetIntegerv(GL_PIXEL_MAP_I_TO_I_SIZE + (map - GL_PIXEL_MAP_I_TO_I), &size);
    out.push_back(size);
    GLfloat f[256] = {};
    GLuint u[256] = {};
    GLushort s[256] = {};
    gl.GetPixelMapfv(map, f);
    if (map > GL_PIXEL_MAP_S_TO_S) gl.GetPixelMapuiv(map, u); // of indexes: below
    gl.GetPixelMapusv(map, s);
    for (int i = 0; i < 256; i++) out.push_back(f[i]), out.push_back(u[i]), out.push_back(s[i]);
  }
  return out;
}

TEST_CASE("Pixel maps keep what OSMesa's keep", "[spec][pixels]") {
  for (unsigned seed = 0; seed < 40; seed++) {
    std::vector<double> maps[2];
    for (int i = 0; i < 2; i++) {
      const Gl& gl = i ? osmesa_library() : softgl_library();
      CurrentContext context(gl);
      Random r(seed);
      for (int k = 0; k < 6; k++) random_map(gl, r, kMaps[r.integer(0, 9)]);
      maps[i] = all_maps(gl);
    }
    INFO("seed " << seed);
    CHECK(difference(maps[0], maps[1]) == "");
  }
}

// Not so in OSMesa (reference/DEVIATIONS.md).
TEST_CASE("glGetPixelMapuiv gives the indexes of a map", "[spec][pixels]") {
  CurrentContext context(softgl_library());
  const GLushort index[2] = {3, 700};
  for (GLenum map : {GL_PIXEL_MAP_I_TO_I, GL_PIXEL_MAP_S_TO_S}) {
    GLuint seen[2] = {};
    softgl_library().PixelMapusv(map, 2, index);
    softgl_library().GetPixelMapuiv(map, seen);
    CHECK(seen[0] == 3);
    CHECK(seen[1] == 700);
  }
}

TEST_CASE("Bad pixel maps raise an error and change nothing", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::vector<double> before = all_maps(gl);
  const GLfloat f[256] = {};
  const auto check = [&](GLenum map, GLsizei size, GLenum error) {
    INFO("map " << map << " size " << size);
    gl.PixelMapfv(map, size, f);
    CHECK(gl.GetError() == error);
    gl.NewList(1, GL_COMPILE);
    gl.PixelMapfv(map, size, f);
    gl.EndList();
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.CallList(1);
    CHECK(gl.GetError() == error);
    CHECK(all_maps(gl) == before);
  };
  for (GLsizei size : {0, -1, 257, 1 << 30}) check(GL_PIXEL_MAP_R_TO_R, size, GL_INVALID_VALUE);
  for (GLsizei size : {3, 255, 6}) check(GL_PIXEL_MAP_I_TO_B, size, GL_INVALID_VALUE);
  check(GL_PIXEL_MAP_S_TO_S, 12, GL_INVALID_VALUE);
  check(GL_PIXEL_MAP_A_TO_A + 1, 4, GL_INVALID_ENUM);
  GLfloat out[256];
  gl.GetPixelMapfv(GL_RED, out);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
}

/// What is read of a random picture, and what a texture keeps of it, through maps, scales and biases.
std::vector<GLubyte> transferred(const Gl& gl, unsigned seed) {
  CurrentContext context(gl);
  Random r(seed);
  for (GLenum map = GL_PIXEL_MAP_R_TO_R; map <= GL_PIXEL_MAP_A_TO_A; map++) random_map(gl, r, map);
  random_map(gl, r, GL_PIXEL_MAP_S_TO_S);
  for (int y = 0; y < 8; y++) {
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(0, y, 64, 1);
    const Float4 c = r.color();
    gl.ClearColor(c[0], c[1], c[2], c[3]);
    gl.ClearStencil(r.integer(0, 255));
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  gl.PixelTransferi(GL_MAP_COLOR, 1);
  gl.PixelTransferi(GL_MAP_STENCIL, r.chance(70));
  gl.PixelTransferi(GL_INDEX_SHIFT, r.integer(-2, 2));
  gl.PixelTransferi(GL_INDEX_OFFSET, r.integer(-9, 9));
  if (r.chance(50)) gl.PixelTransferf(GL_RED_SCALE, r.real(-1, 2));
  if (r.chance(50)) gl.PixelTransferf(GL_BLUE_BIAS, r.real(-0.5f, 0.5f));
  std::vector<GLubyte> out(8 * 8 * 4), texture(8 * 8 * 4), stencil(8 * 8);
  gl.ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
  gl.ReadPixels(0, 0, 8, 8, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
  std::vector<GLubyte> image(8 * 8 * 4);
  for (GLubyte& b : image) b = GLubyte(r.bits());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texture.data());
  CHECK(gl.GetError() == GL_NO_ERROR);
  out.insert(out.end(), texture.begin(), texture.end());
  out.insert(out.end(), stencil.begin(), stencil.end());
  return out;
}

TEST_CASE("Maps change pixels and texels as OSMesa's do", "[spec][pixels]") {
  for (unsigned seed = 0; seed < 100; seed++) {
    INFO("seed " << seed);
    CHECK(difference(transferred(softgl_library(), seed), transferred(osmesa_library(), seed)) == "");
  }
}

// Not so in OSMesa (reference/DEVIATIONS.md).
TEST_CASE("Maps change what a texture takes from the framebuffer", "[spec][pixels]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat inverse[2] = {1, 0};
  gl.PixelMapfv(GL_PIXEL_MAP_G_TO_G, 2, inverse);
  gl.ClearColor(1, 1, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PixelTransferi(GL_MAP_COLOR, 1);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 2, 1, 0);
  GLubyte texel[8];
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  for (int i : {0, 4}) {
    CHECK(texel[i] == 0); // by the red map's only value
    CHECK(texel[i + 1] == 0);
  }
}

} // namespace
} // namespace softgl::test
