// The same scenes into float buffers: what 8 bits would round away must be equal, too.
#include <catch2/catch.hpp>

#include <algorithm>

#include "support/environment.h"
#include "support/runner.h"

using namespace softgl::test;

namespace {

// Interpolates between a texel and 1 minus the primary color by the same primary color as GL_PREVIOUS.
void draw_interpolation(Stage& s, bool color_of_vertices) {
  const Gl& gl = s.gl;
  GLubyte ramp[64];
  for (int i = 0; i < 64; ++i) ramp[i] = GLubyte(4 * i + 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 64, 1, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, ramp);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
  const GLenum source[3] = {GL_PRIMARY_COLOR, GL_TEXTURE, GL_PREVIOUS};
  for (GLenum i = 0; i < 3; ++i) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + i, GLint(source[i]));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i, i ? GL_SRC_COLOR : GL_ONE_MINUS_SRC_COLOR);
  }
  if (!color_of_vertices) gl.Color3f(0.887f, 0.314f, 0.129f);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    if (color_of_vertices) gl.Color3f(0.887f, 0.314f, 0.129f);
    gl.TexCoord2f(float(i & 1), 0);
    gl.Vertex2f(i & 1 ? 1 : -1, i & 2 ? 1 : -1);
  }
  gl.End();
}
void color_of_vertices(Stage& s) { draw_interpolation(s, true); }
void color_of_draw(Stage& s) { draw_interpolation(s, false); }

// Repeats a base level of 11x16 texels, far from the origin, where level 0 has 46x66.
void draw_upper_levels(Stage& s) {
  const Gl& gl = s.gl;
  std::vector<GLubyte> texels(46 * 66 * 4);
  for (GLubyte& t : texels) t = GLubyte(s.random.bits() >> 40);
  for (int level = 0; level < 7; ++level)
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA16, std::max(46 >> level, 1), std::max(66 >> level, 1), 0,
                  GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 4; ++i) {
    gl.TexCoord2f(i & 1 ? -25.06f : -36.4f,
                  i & 2 ? -31.971f : -31.998f); // 16 t - 1/2 passes -512 and loses a bit
    gl.Vertex2f(i & 1 ? 1 : -1, i & 2 ? 1 : -1);
  }
  gl.End();
}

// Lit by a light nearby and flat: the provoking vertex is the last one of a quadrilateral, the first of a
// polygon.
void draw_rectangle(Stage& s) {
  const Gl& gl = s.gl;
  const float position[4] = {-0.8f, -0.7f, 0.5f, 1};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHTING);
  gl.ShadeModel(GL_FLAT);
  gl.Normal3f(0, 0, 1);
  gl.Rectf(-0.75f, -0.8f, 0.9f, 0.6f);
}

} // namespace

TEST_CASE("a rectangle is cut as a quadrilateral", "[osmesa]") {
  fix_environment();
  const Scene scene{.name = "rectangle", .draw = draw_rectangle, .floats = true};
  const Difference difference = compare(draw(softgl_library(), scene, 0), draw(osmesa_library(), scene, 0));
  INFO(difference.text);
  CHECK_FALSE(difference.any());
}

TEST_CASE("the size of level 0 decides how coordinates repeat on other base levels", "[osmesa]") {
  fix_environment();
  const Scene scene{.name = "upper_levels", .draw = draw_upper_levels, .floats = true};
  const Difference difference = compare(draw(softgl_library(), scene, 0), draw(osmesa_library(), scene, 0));
  INFO(difference.text);
  CHECK_FALSE(difference.any());
}

TEST_CASE("a color that is constant over a draw is combined like one that every vertex sets",
          "[osmesa][deviation]") {
  fix_environment();
  const Scene varying{.name = "color_of_vertices", .draw = color_of_vertices, .floats = true};
  const Scene constant{.name = "color_of_draw", .draw = color_of_draw, .floats = true};
  const Picture ours = draw(softgl_library(), varying, 0);
  CHECK(compare(ours, draw(osmesa_library(), varying, 0)).floats == 0);
  CHECK(compare(ours, draw(softgl_library(), constant, 0)).floats == 0);
  CHECK(compare(ours, draw(osmesa_library(), constant, 0)).floats > 0);
}

TEST_CASE("scenes have OSMesa's floats", "[osmesa][lighting][slow]") {
  fix_environment();
  for (const char* name : {"lit", "normals", "materials", "clip", "triangles", "fog", "lines", "points",
                           "texture", "texture_units"}) {
    const Scene* found = find_scene(name);
    REQUIRE(found);
    Scene scene = *found;
    scene.floats = true;
    size_t drawn = 0;
    for (uint64_t seed = 0; seed < 12; ++seed) {
      const Picture ours = draw(softgl_library(), scene, seed), theirs = draw(osmesa_library(), scene, seed);
      for (size_t i = 0; i < ours.floats.size(); ++i) drawn += ours.floats[i] != ours.floats[i & 3];
      const Difference difference = compare(ours, theirs);
      INFO(name << " seed " << seed << ": " << difference.text);
      CHECK_FALSE(difference.any());
    }
    CHECK(drawn > 5000);
  }
}
