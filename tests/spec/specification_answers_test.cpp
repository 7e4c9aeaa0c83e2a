// SOFTGL_ANSWERS=specification: where OSMesa leaves the specification of OpenGL 1.5, softgl does not. Here is
// what softgl-conformance does not draw.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "spec/specification_context.h"

namespace softgl::test {
namespace {

constexpr int kSize = SpecificationContext::kSize;

/// A square over the whole window, with texture coordinates from `low` to `high`.
void draw_square(const Gl& gl, float low = 0, float high = 1, float r = 0) {
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    gl.TexCoord3f(x ? high : low, y ? high : low, r);
    gl.Vertex2f(x ? 1.0f : -1.0f, y ? 1.0f : -1.0f);
  }
  gl.End();
}

void set_light(const Gl& gl, GLenum parameter, std::initializer_list<float> v) {
  std::array<float, 4> values{};
  std::copy(v.begin(), v.end(), values.begin());
  gl.Lightfv(GL_LIGHT0, parameter, values.data());
}

void set_material(const Gl& gl, GLenum face, GLenum parameter, float v) {
  const float color[4] = {v, v, v, 1};
  gl.Materialfv(face, parameter, color);
}

} // namespace

// Who asks.

TEST_CASE("an attribute and the environment ask for the specification's answers", "[spec][answers]") {
  const Gl& gl = softgl_library();
  const auto keeps_borders = [&](std::vector<int> attributes) {
    attributes.push_back(0);
    void* context = gl.OSMesaCreateContextAttribs(attributes.data(), nullptr);
    REQUIRE(context);
    std::vector<GLubyte> buffer(16 * 16 * 4);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16));
    gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    GLint border = -1;
    gl.GetTexLevelParameteriv(GL_TEXTURE_1D, 0, GL_TEXTURE_BORDER, &border);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
    return border == 1;
  };
  CHECK_FALSE(keeps_borders({}));
  CHECK(keeps_borders({SOFTGL_SPECIFICATION_ANSWERS, 1}));
  setenv("SOFTGL_ANSWERS", "specification", 1);
  CHECK(keeps_borders({}));
  CHECK_FALSE(keeps_borders({SOFTGL_SPECIFICATION_ANSWERS, 0}));
  setenv("SOFTGL_ANSWERS", "osmesa", 1);
  CHECK_FALSE(keeps_borders({}));
  unsetenv("SOFTGL_ANSWERS");
  const int wrong[] = {SOFTGL_SPECIFICATION_ANSWERS, 2, 0};
  CHECK(gl.OSMesaCreateContextAttribs(wrong, nullptr) == nullptr);
}

// Lighting (2.14.1).

TEST_CASE("a highlight of shininess 0 is 1 wherever the face is lit", "[spec][answers]") {
  // At vertices and at fragments; the shininess of the draw or one of each vertex; both faces; n.h = 0, too.
  const GLenum models[] = {GL_SMOOTH, GL_PHONG_WIN};
  for (GLenum model : models)
    for (const bool varies : {false, true})
      for (const bool back : {false, true})
        for (const bool across : {false, true}) {
          INFO("model " << model << ", varies " << varies << ", back " << back << ", n.h = 0 " << across);
          const SpecificationContext a;
          const Gl& gl = a.gl;
          gl.ShadeModel(model);
          gl.Enable(GL_LIGHTING);
          gl.Enable(GL_LIGHT0);
          gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
          set_material(gl, GL_FRONT_AND_BACK, GL_AMBIENT, 0);
          set_material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, 0);
          set_material(gl, GL_FRONT, GL_SPECULAR, 0.8f);
          set_material(gl, GL_BACK, GL_SPECULAR, 0.4f);
          set_light(gl, GL_SPECULAR, {1, 1, 1, 1});
          set_light(gl, GL_CONSTANT_ATTENUATION, {2});
          // l and h are (1, 0, 0) and (1, 0, 1) as seen from far away, and n is (1, 0, -1).
          if (across)
            set_light(gl, GL_POSITION, {1, 0, 0, 1e-12f});
          else
            set_light(gl, GL_POSITION, {0.3f, 0.2f, 2, 1});
          gl.Begin(GL_QUADS);
          const float side = back ? -1.0f : 1.0f;
          for (int i = 0; i < 4; ++i) {
            const int corner = back ? 3 - i : i;
            if (varies) gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 0);
            if (across)
              gl.Normal3f(side * std::sqrt(0.5f), 0, side * -std::sqrt(0.5f));
            else
              gl.Normal3f(0, 0, side);
            gl.Vertex2f(corner == 1 || corner == 2 ? 1.0f : -1.0f, corner >= 2 ? 1.0f : -1.0f);
          }
          gl.End();
          CHECK(std::abs(a.red_in_the_middle() - (back ? 51 : 102)) <= 1);
        }
}

TEST_CASE("the border of a spot's cone belongs to it", "[spec][answers]") {
  // cos 90 is 0 = s: spot_i is s to the power of 0, which is 1.
  for (const bool specification : {false, true}) {
    const SpecificationContext a(specification);
    const Gl& gl = a.gl;
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    set_light(gl, GL_POSITION, {0, 0, 0, 1});
    set_light(gl, GL_SPOT_DIRECTION, {0, 0, -1});
    set_light(gl, GL_SPOT_CUTOFF, {90});
    set_material(gl, GL_FRONT, GL_AMBIENT, 0);
    set_material(gl, GL_FRONT, GL_DIFFUSE, 1);
    gl.Normal3f(-1, 0, 0);
    gl.PointSize(9);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(0.015625f, 0); // a pixel's center
    gl.End();
    CHECK(int(a.red_in_the_middle()) == (specification ? 255 : 0));
  }
}

// Color sum (3.9).

TEST_CASE("the color sum is clamped before the fog, whatever is drawn", "[spec][answers]") {
  struct Case {
    const char* name;
    std::function<void(const Gl&)> draw;
  };
  const auto points = [](const Gl& gl) {
    gl.PointSize(9);
    gl.Begin(GL_POINTS);
    gl.Vertex2f(0.01f, 0.01f);
    gl.End();
  };
  const auto textured = [](const Gl& gl, GLint environment) {
    const GLubyte white[4] = {255, 255, 255, 255};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, white);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environment);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE); // the weight of the texture is 0
    gl.Enable(GL_TEXTURE_2D);
    draw_square(gl);
  };
  const auto lit = [](const Gl& gl, GLenum model) {
    gl.ShadeModel(model);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    set_material(gl, GL_FRONT, GL_AMBIENT, 0);
    set_material(gl, GL_FRONT, GL_DIFFUSE, 0.8f);
    set_material(gl, GL_FRONT, GL_SPECULAR, 0.6f);
    gl.Normal3f(0, 0, 1);
    draw_square(gl);
  };
  const Case cases[] = {
      {"triangles", [](const Gl& gl) { draw_square(gl); }},
      {"points", points},
      {"smooth points", [&](const Gl& gl) { gl.Enable(GL_POINT_SMOOTH), points(gl); }},
      {"lines",
       [](const Gl& gl) {
         gl.LineWidth(9);
         gl.Begin(GL_LINES);
         gl.Vertex2f(-1, 0.01f);
         gl.Vertex2f(1, 0.01f);
         gl.End();
       }},
      {"a modulated texture", [&](const Gl& gl) { textured(gl, GL_MODULATE); }},
      {"a blended texture", [&](const Gl& gl) { textured(gl, GL_COMBINE); }},
      {"lit vertices", [&](const Gl& gl) { lit(gl, GL_SMOOTH); }},
      {"lit fragments", [&](const Gl& gl) { lit(gl, GL_PHONG_WIN); }},
      {"pixels",
       [](const Gl& gl) {
         std::vector<GLubyte> image(16 * 16 * 3, 204);
         gl.WindowPos2i(24, 24);
         gl.DrawPixels(16, 16, GL_RGB, GL_UNSIGNED_BYTE, image.data());
       }},
      {"a bitmap",
       [](const Gl& gl) {
         const std::vector<GLubyte> image(16 * 4, 255);
         gl.WindowPos2i(24, 24);
         gl.Bitmap(16, 16, 0, 0, 0, 0, image.data());
       }},
  };
  for (const Case& test : cases)
    for (const bool specification : {false, true}) {
      INFO(test.name << ", specification " << specification);
      const SpecificationContext a(specification);
      const Gl& gl = a.gl;
      gl.Enable(GL_COLOR_SUM);
      gl.Enable(GL_FOG);
      gl.Fogi(GL_FOG_MODE, GL_LINEAR);
      gl.Fogf(GL_FOG_START, 0);
      gl.Fogf(GL_FOG_END, 1);
      gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
      gl.FogCoordf(0.5f);
      gl.Color3f(0.8f, 0.8f, 0.8f);
      gl.SecondaryColor3f(0.6f, 0.6f, 0.6f);
      test.draw(gl);
      // 1.4 or 1, half of it. That of lit fragments is clamped in any case.
      const bool clamped = specification || std::string(test.name) == "lit fragments";
      CHECK(std::abs(a.red_in_the_middle() - (clamped ? 128 : 178)) <= 1);
    }
}

TEST_CASE("the color of the fog is clamped", "[spec][answers]") {
  for (const bool specification : {false, true}) {
    const SpecificationContext a(specification);
    const Gl& gl = a.gl;
    const GLfloat bright[4] = {2, 2, 2, 2};
    gl.Fogfv(GL_FOG_COLOR, bright);
    gl.Enable(GL_FOG);
    gl.Fogi(GL_FOG_MODE, GL_LINEAR);
    gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
    gl.FogCoordf(0.5f);
    gl.Color3f(0, 0, 0);
    draw_square(gl);
    CHECK(std::abs(a.red_in_the_middle() - 128) <= 1); // OSMesa clamps it, too
  }
}

TEST_CASE("the value of GL_MULT is clamped", "[spec][answers]") {
  for (const int specification : {0, 1}) {
    const Gl& gl = softgl_library();
    const int attributes[] = {0x32 /* OSMESA_ACCUM_BITS */, 16, SOFTGL_SPECIFICATION_ANSWERS, specification,
                              0};
    void* context = gl.OSMesaCreateContextAttribs(attributes, nullptr);
    REQUIRE(context);
    std::vector<GLubyte> buffer(16 * 16 * 4);
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 16, 16));
    gl.ClearColor(0.25f, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Accum(GL_LOAD, 1);
    gl.Accum(GL_MULT, 2);
    gl.Accum(GL_RETURN, 1);
    gl.Finish();
    CHECK(std::abs(buffer[0] - (specification ? 64 : 128)) <= 1);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
  }
}

// The level of detail (3.8.8, 3.8.9).

TEST_CASE("magnification ends at 0.5 for all targets, after bias and limits", "[spec][answers]") {
  struct Case {
    GLenum filter;
    float texels, bias, unit_bias, least, most; // `texels`: of level 0, that a pixel is wide
    bool magnified;
  };
  const Case cases[] = {
      {GL_NEAREST_MIPMAP_NEAREST, 1.3f, 0, 0, -1000, 1000, true},
      {GL_NEAREST_MIPMAP_LINEAR, 1.3f, 0, 0, -1000, 1000, true},
      {GL_NEAREST_MIPMAP_NEAREST, 1.5f, 0, 0, -1000, 1000, false},
      {GL_NEAREST_MIPMAP_NEAREST, 1.3f, 0.25f, 0, -1000, 1000, false},
      {GL_NEAREST_MIPMAP_NEAREST, 1.3f, 0, 0.25f, -1000, 1000, false},
      {GL_NEAREST_MIPMAP_LINEAR, 1.9f, -0.5f, 0, -1000, 1000, true},
      {GL_NEAREST_MIPMAP_NEAREST, 3.7f, 0, 0, -1000, 0.4f, true},
      {GL_NEAREST_MIPMAP_NEAREST, 0.2f, 0, 0, 0.6f, 1000, false},
      {GL_NEAREST, 1.3f, 0, 0, -1000, 1000, false},
  };
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP})
    for (const Case& test : cases) {
      INFO("target " << target << ", filter " << test.filter << ", " << test.texels << " texels, bias "
                     << test.bias << " " << test.unit_bias << ", limits " << test.least << " " << test.most);
      const SpecificationContext a;
      const Gl& gl = a.gl;
      // Columns of 0 and 255 on every level: only a linear filter gives what lies between.
      for (int level = 0, size = 64; size > 0; ++level, size /= 2) {
        const int depth = target == GL_TEXTURE_3D ? size : 1, height = target == GL_TEXTURE_1D ? 1 : size;
        std::vector<GLubyte> texels(size_t(size * height * depth));
        for (size_t i = 0; i < texels.size(); ++i) texels[i] = i & 1 && size > 1 ? 255 : 0;
        const auto image = [&](GLenum face) {
          if (target == GL_TEXTURE_1D)
            gl.TexImage1D(face, level, GL_LUMINANCE8, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
          else if (target == GL_TEXTURE_3D)
            gl.TexImage3D(face, level, GL_LUMINANCE8, size, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                          texels.data());
          else
            gl.TexImage2D(face, level, GL_LUMINANCE8, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                          texels.data());
        };
        if (target == GL_TEXTURE_CUBE_MAP)
          for (GLenum face = 0; face < 6; ++face) image(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
        else
          image(target);
      }
      gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
      gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GLint(test.filter));
      gl.TexParameterf(target, GL_TEXTURE_LOD_BIAS, test.bias);
      gl.TexParameterf(target, GL_TEXTURE_MIN_LOD, test.least);
      gl.TexParameterf(target, GL_TEXTURE_MAX_LOD, test.most);
      gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, test.unit_bias);
      gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
      gl.Enable(target);
      // 8 pixels of the window, so that the coordinates stay within a face.
      gl.Viewport(28, 28, 8, 8);
      const float wide = test.texels / 64 * 8;
      gl.Begin(GL_QUADS);
      for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        // s runs along x alone, from its middle; t and r do not change. -z is the axis of the cube's face.
        const float s = x * wide / 2 + 0.003f;
        if (target == GL_TEXTURE_CUBE_MAP)
          gl.TexCoord3f(2 * s, 0.01f, -1);
        else
          gl.TexCoord3f(s + 0.5f, 0.51f, 0.51f);
        gl.Vertex2f(x, y);
      }
      gl.End();
      const auto red = a.red();
      int between = 0;
      for (int x = 29; x < 35; ++x) between += red[32 * kSize + x] % 255 != 0;
      CHECK((between > 0) == test.magnified);
    }
}

TEST_CASE("a cube map's face is sampled with the wrap modes", "[spec][answers]") {
  for (const bool specification : {false, true}) {
    const SpecificationContext a(specification);
    const Gl& gl = a.gl;
    const std::vector<GLubyte> white(4 * 4, 255);
    for (GLenum face = 0; face < 6; ++face)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_LUMINANCE8, 4, 4, 0, GL_LUMINANCE,
                    GL_UNSIGNED_BYTE, white.data());
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.Enable(GL_TEXTURE_CUBE_MAP);
    draw_square(gl, -1, 1, 1);
    const auto red = a.red();
    CHECK(int(red[32 * kSize]) < (specification ? 140 : 256)); // half of it is the black border color
    CHECK((int(red[32 * kSize]) < 255) == specification);
    CHECK(int(red[32]) == 255);
    CHECK(int(red[32 * kSize + 32]) == 255);
  }
}

} // namespace softgl::test
