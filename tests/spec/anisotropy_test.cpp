// GL_EXT_texture_filter_anisotropic: the parameter, and textures whose filter stays as it is.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

void give_image(const Gl& gl, GLenum target, GLenum format) {
  std::vector<GLubyte> texels(size_t(32) * 32 * 4);
  for (size_t i = 0; i < texels.size(); ++i) texels[i] = GLubyte(i * 71 + (i >> 5) * 13);
  if (target == GL_TEXTURE_1D)
    gl.TexImage1D(target, 0, GLint(format), 32, 0, format, GL_UNSIGNED_BYTE, texels.data());
  else
    gl.TexImage2D(target, 0, GLint(format), 32, 32, 0, format, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(target);
}

/// A square whose coordinates go to `s` and `t`.
void square(const Gl& gl, float s, float t) {
  gl.Begin(GL_QUADS);
  gl.TexCoord3f(0, 0, 0.2f), gl.Vertex2f(-1, -1);
  gl.TexCoord3f(s, 0, 0.4f), gl.Vertex2f(1, -1);
  gl.TexCoord3f(s, t, 0.6f), gl.Vertex2f(1, 1);
  gl.TexCoord3f(0, t, 0.8f), gl.Vertex2f(-1, 1);
  gl.End();
}

/// The picture of a squeezed texture.
std::vector<uint8_t> squeezed(GLenum target, GLenum format, float anisotropy, float t,
                              GLint wrap = GL_REPEAT) {
  if (target == GL_TEXTURE_RECTANGLE) wrap = GL_CLAMP_TO_EDGE;
  const Scene scene{"squeezed", [&](Stage& s) {
                      give_image(s.gl, target, format);
                      s.gl.TexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
                      s.gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
                      s.gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
                      if (format == GL_DEPTH_COMPONENT)
                        s.gl.TexParameteri(target, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
                      square(s.gl, target == GL_TEXTURE_RECTANGLE ? 32.0f : 1.0f, t);
                    }};
  return draw(softgl_library(), scene, 0).color;
}

} // namespace

REFUSAL_TEST_CASE("The greatest anisotropy is from 1 to 16", "[spec][errors][textures][anisotropy]") {
  // clang-format off
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5f)),
      BAD(INVALID_VALUE, TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0)),
      BAD(INVALID_VALUE, TexParameterf(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAX_ANISOTROPY_EXT, -4)),
  };
  // clang-format on
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    const StateSnapshot before = take_snapshot(*gl, false);
    expect_refused(*gl, calls, [&] { CHECK(compare_snapshots(before, take_snapshot(*gl, false)) == ""); });
    GLfloat most = 0;
    gl->GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    CHECK(most == 1);
    gl->PushAttrib(GL_TEXTURE_BIT);
    for (const float given : {3.5f, 16.0f, 100.0f}) {
      gl->TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, given);
      gl->GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &most);
      CHECK(most == std::min(given, 16.0f));
    }
    gl->PopAttrib();
    gl->GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    CHECK(most == 1);
  }
}

TEST_CASE("Anisotropy changes no filter of one dimension, rectangles and comparisons",
          "[spec][textures][anisotropy][deviation]") {
  for (const auto& [target, format] : {std::pair<GLenum, GLenum>{GL_TEXTURE_1D, GL_RGBA},
                                       {GL_TEXTURE_RECTANGLE, GL_RGBA},
                                       {GL_TEXTURE_2D, GL_DEPTH_COMPONENT}}) {
    INFO("target " << target << ", format " << format);
    const bool same = squeezed(target, format, 16, 20) == squeezed(target, format, 1, 20);
    CHECK(same);
  }
  const auto plain = squeezed(GL_TEXTURE_2D, GL_RGBA, 1, 20);
  const bool below_two = squeezed(GL_TEXTURE_2D, GL_RGBA, 1.5f, 20) != plain,
             two = squeezed(GL_TEXTURE_2D, GL_RGBA, 2, 20) != plain;
  CHECK(!below_two);
  CHECK(two);
}

TEST_CASE("Ellipses of more than 65536 texels are filtered without anisotropy",
          "[spec][textures][anisotropy][deviation]") {
  // Without anisotropy bytes that are mirrored are filtered in floats, too.
  const auto picture = [](float anisotropy, float t) {
    return squeezed(GL_TEXTURE_2D, GL_RGBA, anisotropy, t, GL_MIRRORED_REPEAT);
  };
  for (const float huge : {1e7f, 1e30f, INFINITY}) {
    const bool same = picture(16, huge) == picture(1, huge);
    INFO(huge);
    CHECK(same);
  }
}

TEST_CASE("Filters without mipmaps read the base level only, whatever the anisotropy is",
          "[spec][textures][anisotropy][deviation]") {
  for (const GLint minify : {GL_NEAREST, GL_LINEAR})
    for (const GLint magnify : {GL_NEAREST, GL_LINEAR}) {
      INFO("filters " << minify << " and " << magnify);
      const Scene scene{"red_mipmaps", [&](Stage& s) {
                          give_image(s.gl, GL_TEXTURE_2D, GL_RGBA);
                          for (GLint level = 0, size = 32; size; ++level, size /= 2) {
                            const GLubyte red = level ? 255 : 0;
                            const std::vector<GLubyte> texels(size_t(size) * size_t(size), red);
                            s.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
                            s.gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RED,
                                            GL_UNSIGNED_BYTE, texels.data());
                          }
                          s.gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 16);
                          s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
                          s.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
                          square(s.gl, 30, 60);
                        }};
      const std::vector<uint8_t> color = draw(softgl_library(), scene, 0).color;
      bool any_red = false;
      for (size_t i = 0; i < color.size(); i += 4) any_red = any_red || color[i];
      CHECK(!any_red);
    }
}

} // namespace softgl::test
