// Textures of depths: the components that take the depth (GL 1.5, 3.8.14; GL_ARB_texture_rg), and levels that
// cannot be made because there are stencil values in them.
#include <catch2/catch.hpp>

#include <array>

#include "spec/state_snapshot.h"

namespace softgl::test {

TEST_CASE("GL_DEPTH_TEXTURE_MODE says which components are the depth", "[spec][textures]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat depth = 0.25f;
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  gl.Enable(GL_TEXTURE_2D);
  using Pixel = std::array<GLubyte, 4>;
  struct Case {
    GLint mode;
    Pixel pixel;
  };
  for (const Case& c : {Case{GL_LUMINANCE, {64, 64, 64, 255}}, Case{GL_INTENSITY, {64, 64, 64, 64}},
                        Case{GL_ALPHA, {255, 255, 255, 64}}, Case{GL_RED, {64, 0, 0, 255}}}) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, c.mode);
    gl.Rectf(-1, -1, 1, 1);
    Pixel pixel{};
    gl.ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    INFO(c.mode);
    CHECK(pixel == c.pixel);
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("levels of textures with stencil values are not made", "[spec][errors][textures]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const GLint format : {GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8}) {
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, nullptr);
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.GenerateMipmap(GL_TEXTURE_2D);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    GLint width = -1;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH, &width);
    CHECK(width == 0);
  }
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

} // namespace softgl::test
