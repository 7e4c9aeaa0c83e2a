// GL 1.5, tables 3.20 and 3.22: a texture without alpha has the alpha 1, also where GL_ARB_seamless_cube_map
// weighs the three texels at a corner of a cube map.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {

TEST_CASE("a cube map without alpha leaves alpha as it is at its corners", "[spec][textures]") {
  const Gl& gl = softgl_library();
  for (const GLint format : {GL_RGB, GL_LUMINANCE, GL_R8, GL_RG8, GL_RGB16F}) {
    CurrentContext context(gl);
    const std::vector<GLubyte> white(4 * 4 * 4, 255);
    for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face)
      gl.TexImage2D(face, 0, format, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    gl.Color4f(1, 1, 1, 77.5f / 255.0f); // a little less is another byte
    const GLfloat corner[4][3] = {{1, 0.4f, 0.4f}, {0.4f, 1, 0.4f}, {0.4f, 0.4f, 1}, {0.4f, 0.4f, 0.4f}};
    const auto alphas = [&] {
      gl.Begin(GL_TRIANGLE_FAN);
      for (int i = 0; i < 4; ++i) {
        gl.TexCoord3fv(corner[i]);
        gl.Vertex2f(i == 1 || i == 2 ? 1.0f : -1.0f, i > 1 ? 1.0f : -1.0f);
      }
      gl.End();
      std::vector<GLubyte> p(64 * 64);
      gl.ReadPixels(0, 0, 64, 64, GL_ALPHA, GL_UNSIGNED_BYTE, p.data());
      return p;
    };
    const std::vector<GLubyte> plain = alphas();
    CHECK(plain[0] == 78);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    INFO(format);
    CHECK(alphas() == plain);
  }
}

} // namespace softgl::test
