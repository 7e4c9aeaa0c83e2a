// GL 1.5, 5.1: evaluators. Their pictures are compared with OSMesa's in the family "evaluators".
#include <catch2/catch.hpp>

#include <functional>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

constexpr GLenum kFirst[2] = {GL_MAP1_COLOR_4, GL_MAP2_COLOR_4};
constexpr int kTargets = 9;
constexpr int kComponents[kTargets] = {4, 1, 3, 1, 2, 3, 4, 3, 4};

constexpr GLfloat kLine[6] = {-0.5f, 0, 0, 0.5f, 0, 0};
constexpr GLdouble kDoubles[16] = {};
constexpr GLfloat kSheet[12] = {-0.5f, -0.5f, 0, -0.5f, 0.5f, 0, 0.5f, -0.5f, 0, 0.5f, 0.5f, 0};

/// All that glGetMap tells of every map.
std::vector<double> all_maps(const Gl& gl) {
  std::vector<double> all;
  for (const GLenum first : kFirst)
    for (int i = 0; i < kTargets; i++) {
      double points[900 * 4] = {}, order[2] = {}, domain[4] = {};
      gl.GetMapdv(first + GLenum(i), GL_COEFF, points);
      gl.GetMapdv(first + GLenum(i), GL_ORDER, order);
      gl.GetMapdv(first + GLenum(i), GL_DOMAIN, domain);
      all.insert(all.end(), points, points + 900 * 4);
      all.insert(all.end(), order, order + 2);
      all.insert(all.end(), domain, domain + 4);
    }
  return all;
}

/// What `draw` feeds back: values of the type GL_3D_COLOR_TEXTURE, 11 a vertex.
std::vector<GLfloat> feedback(const Gl& gl, const std::function<void()>& draw,
                              GLenum type = GL_3D_COLOR_TEXTURE) {
  std::vector<GLfloat> values(1 << 16);
  gl.FeedbackBuffer(GLsizei(values.size()), type, values.data());
  gl.RenderMode(GL_FEEDBACK);
  draw();
  values.resize(size_t(gl.RenderMode(GL_RENDER)));
  return values;
}

void define_line(const Gl& gl) {
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kLine);
  gl.Enable(GL_MAP1_VERTEX_3);
}
void define_sheet(const Gl& gl) {
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, kSheet);
  gl.Enable(GL_MAP2_VERTEX_3);
}

} // namespace

REFUSAL_TEST_CASE("evaluator commands refuse what 5.1 forbids, and change nothing",
                  "[spec][errors][evaluators]") {
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, Map1f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, kLine)),
      BAD(INVALID_ENUM, Map1f(GL_MAP1_VERTEX_4 + 1, 0, 1, 4, 1, kLine)),
      BAD(INVALID_ENUM, Map1d(GL_VERTEX_ARRAY, 0, 1, 3, 2, kDoubles)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 1, 1, 3, 2, kLine)),
      BAD(INVALID_VALUE, Map1d(GL_MAP1_VERTEX_3, 1, 1 + 1e-12, 3, 2, kDoubles)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, kLine)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, kLine)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, kLine)),
      BAD(INVALID_VALUE, Map1f(GL_MAP1_VERTEX_3, 0, 1, -3, 2, kLine)),
      BAD(INVALID_ENUM, Map2f(GL_MAP1_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 2, 2, 6, 2, 0, 1, 3, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 2, 2, 3, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 2, 2, 0, 1, 3, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 2, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 0, 0, 1, 3, 2, kSheet)),
      BAD(INVALID_VALUE, Map2f(GL_MAP2_VERTEX_3, 0, 1, 6, 2, 0, 1, 3, 31, kSheet)),
      BAD(INVALID_VALUE, Map2d(GL_MAP2_VERTEX_3, 0, 1, 6, 31, 0, 1, 3, 2, kDoubles)),
      BAD(INVALID_VALUE, MapGrid1f(0, 0, 1)),
      BAD(INVALID_VALUE, MapGrid1d(-1, 0, 1)),
      BAD(INVALID_VALUE, MapGrid2f(0, 0, 1, 1, 0, 1)),
      BAD(INVALID_VALUE, MapGrid2d(1, 0, 1, 0, 0, 1)),
      BAD(INVALID_ENUM, EvalMesh1(GL_FILL, 0, 1)),
      BAD(INVALID_ENUM, EvalMesh1(GL_LINES, 0, 1)),
      BAD(INVALID_ENUM, EvalMesh2(GL_QUAD_STRIP, 0, 1, 0, 1)),
  };
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  define_line(gl);
  define_sheet(gl);
  const StateSnapshot before = take_snapshot(gl, false);
  const std::vector<double> maps = all_maps(gl);
  expect_refused(gl, calls, [&] {
    CHECK(compare_snapshots(before, take_snapshot(gl, false)) == "");
    CHECK((all_maps(gl) == maps));
  });
  // Evaluators make coordinates of unit 0 only.
  gl.ActiveTexture(GL_TEXTURE1);
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 2, 3, 1, kSheet);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.Map2d(GL_MAP2_VERTEX_3, 0, 2, 3, 1, 0, 1, 3, 1, kDoubles);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  CHECK((all_maps(gl) == maps));
}

TEST_CASE("the queries of maps refuse what they do not know", "[spec][errors][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLfloat f[4] = {77, 77, 77, 77};
  GLdouble d[4] = {77, 77, 77, 77};
  GLint i[4] = {77, 77, 77, 77};
  for (const auto& [target, query] : {std::pair<GLenum, GLenum>{GL_MAP1_VERTEX_3, GL_MAP1_GRID_DOMAIN},
                                      {GL_MAP1_VERTEX_4 + 1, GL_ORDER},
                                      {GL_MAP2_COLOR_4 - 1, GL_COEFF},
                                      {0, GL_DOMAIN}}) {
    gl.GetMapfv(target, query, f);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.GetMapdv(target, query, d);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
    gl.GetMapiv(target, query, i);
    CHECK(gl.GetError() == GL_INVALID_ENUM);
  }
  CHECK(f[0] == 77);
  CHECK(d[0] == 77);
  CHECK(i[0] == 77);
}

TEST_CASE("every map begins with order 1 and the point of table 6.26", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (int dimensions = 1; dimensions <= 2; dimensions++)
    for (int t = 0; t < kTargets; t++) {
      const GLenum target = kFirst[dimensions - 1] + GLenum(t);
      INFO(std::hex << target);
      GLfloat order[3] = {7, 7, 7}, domain[5] = {7, 7, 7, 7, 7}, point[5] = {7, 7, 7, 7, 7};
      gl.GetMapfv(target, GL_ORDER, order);
      gl.GetMapfv(target, GL_DOMAIN, domain);
      gl.GetMapfv(target, GL_COEFF, point);
      for (int k = 0; k < dimensions; k++) CHECK(order[k] == 1);
      CHECK(order[dimensions] == 7);
      for (int k = 0; k < 2 * dimensions; k++) CHECK(domain[k] == float(k & 1));
      CHECK(domain[2 * dimensions] == 7);
      for (int k = 0; k < kComponents[t]; k++)
        CHECK(point[k] == (t < 2 ? 1.0f : t == 2 ? float(k == 2) : float(k == 3)));
      CHECK(point[kComponents[t]] == 7);
      CHECK_FALSE(gl.IsEnabled(target));
    }
  CHECK_FALSE(gl.IsEnabled(GL_AUTO_NORMAL));
}

TEST_CASE("a map is read back as it was given, in tight rows", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (int t = 0; t < kTargets; t++) {
    const int k = kComponents[t], v_stride = k + 2, u_stride = 3 * v_stride + 1;
    std::vector<GLdouble> given(size_t(u_stride) * 2, 1e9), expected;
    for (int i = 0; i < 2; i++)
      for (int j = 0; j < 3; j++)
        for (int n = 0; n < k; n++) {
          const double value = i + 10 * j + 100 * n + 0.75;
          given[size_t(i * u_stride + j * v_stride + n)] = value;
          expected.push_back(value);
        }
    const GLenum target = GL_MAP2_COLOR_4 + GLenum(t);
    gl.Map2d(target, -1, 2.5, u_stride, 2, 7, 3, v_stride, 3, given.data());
    std::vector<GLdouble> out(expected.size());
    gl.GetMapdv(target, GL_COEFF, out.data());
    CHECK(out == expected);
    GLint rounded[4], order[2];
    gl.GetMapiv(target, GL_DOMAIN, rounded);
    CHECK(std::vector<GLint>(rounded, rounded + 4) == std::vector<GLint>{-1, 3, 7, 3});
    gl.GetMapiv(target, GL_ORDER, order);
    CHECK(order[0] == 2);
    CHECK(order[1] == 3);
    std::vector<GLint> integers(expected.size());
    gl.GetMapiv(target, GL_COEFF, integers.data());
    CHECK(integers[0] == 1);
  }
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("grid and enables belong to GL_EVAL_BIT, maps to no group", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.MapGrid1f(3, -1, 2);
  gl.MapGrid2d(4, 0.5, 1, 5, 2, -2);
  gl.Enable(GL_MAP1_INDEX);
  const StateSnapshot before = take_snapshot(gl, false);
  for (const GLbitfield bits : {GLbitfield(GL_EVAL_BIT), GLbitfield(GL_EVAL_BIT | GL_ENABLE_BIT)}) {
    gl.PushAttrib(bits);
    for (const GLenum first : kFirst)
      for (GLenum t = 0; t < kTargets; t++) gl.Enable(first + t);
    gl.Enable(GL_AUTO_NORMAL);
    gl.Disable(GL_MAP1_INDEX);
    gl.MapGrid1d(30, 0, 1);
    gl.MapGrid2f(1, 0, 1, 1, 0, 1);
    define_line(gl);
    gl.PopAttrib();
    CHECK(compare_snapshots(before, take_snapshot(gl, false)) == "");
    GLint order = 0;
    gl.GetMapiv(GL_MAP1_VERTEX_3, GL_ORDER, &order);
    CHECK(order == 2);
  }
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Enable(GL_AUTO_NORMAL);
  gl.Enable(GL_MAP2_TEXTURE_COORD_3);
  gl.MapGrid1f(9, 0, 1);
  gl.PopAttrib();
  CHECK_FALSE(gl.IsEnabled(GL_AUTO_NORMAL));
  CHECK_FALSE(gl.IsEnabled(GL_MAP2_TEXTURE_COORD_3));
  GLint count = 0, most = 0;
  gl.GetIntegerv(GL_MAP1_GRID_SEGMENTS, &count);
  CHECK(count == 9);
  gl.GetIntegerv(GL_MAX_EVAL_ORDER, &most);
  CHECK(most == 30);
}

// OSMesa forgets them (reference/DEVIATIONS.md).
TEST_CASE("what is evaluated does not become current", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  define_sheet(gl);
  for (const GLenum t : {GL_MAP2_COLOR_4, GL_MAP2_INDEX, GL_MAP2_NORMAL, GL_MAP2_TEXTURE_COORD_2})
    gl.Enable(t);
  for (const bool automatic : {false, true})
    for (const bool inside : {false, true}) {
      (automatic ? gl.Enable : gl.Disable)(GL_AUTO_NORMAL);
      const auto set = [&] {
        gl.Color4f(0.1f, 0.2f, 0.3f, 0.4f);
        gl.Normal3f(0.5f, 0.6f, 0.7f);
        gl.TexCoord4f(1, 2, 3, 4);
        gl.Indexf(5);
      };
      gl.Color4f(1, 1, 1, 1);
      if (!inside) set();
      gl.Begin(GL_TRIANGLES);
      gl.EvalCoord2f(0, 0);
      if (inside) set();
      gl.EvalCoord2f(1, 0);
      gl.EvalPoint2(1, 1);
      gl.End();
      GLfloat color[4], normal[3], texture[4], index;
      gl.GetFloatv(GL_CURRENT_COLOR, color);
      gl.GetFloatv(GL_CURRENT_NORMAL, normal);
      gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, texture);
      gl.GetFloatv(GL_CURRENT_INDEX, &index);
      CHECK(color[3] == 0.4f);
      CHECK(normal[0] == 0.5f);
      CHECK(texture[2] == 3);
      CHECK(texture[3] == 4);
      CHECK(index == 5);
    }
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("the map of the most coordinates counts", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat values[4] = {0.25f, 0.5f, 0.75f, 2};
  for (GLenum t = 0; t < 4; t++) {
    gl.Map1f(GL_MAP1_TEXTURE_COORD_1 + t, 0, 1, 4, 1, values);
    gl.Enable(GL_MAP1_TEXTURE_COORD_1 + t);
  }
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 4, 1, values);
  gl.Map1f(GL_MAP1_VERTEX_4, 0, 1, 4, 1, values);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.Enable(GL_MAP1_VERTEX_4);
  const auto point = [&] {
    return feedback(gl, [&] { gl.Begin(GL_POINTS), gl.EvalCoord1f(0.5f), gl.End(); });
  };
  std::vector<GLfloat> p = point();
  REQUIRE(p.size() == 12);
  CHECK(p[1] == 32 + 32 * 0.125f); // x / w
  CHECK(std::vector<GLfloat>(p.begin() + 8, p.end()) == std::vector<GLfloat>{0.25f, 0.5f, 0.75f, 2});
  gl.Disable(GL_MAP1_VERTEX_4);
  for (int left = 3; left >= 0; left--) {
    gl.Disable(GL_MAP1_TEXTURE_COORD_1 + GLenum(left));
    p = point();
    CHECK(p[1] == 32 + 32 * 0.25f);
    for (int k = 0; k < 4; k++) CHECK(p[size_t(8 + k)] == (k < left ? values[k] : k == 3 ? 1.0f : 0.0f));
  }
}

TEST_CASE("without a map of vertices, and outside Begin and End, nothing is evaluated",
          "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Enable(GL_MAP1_COLOR_4);
  gl.Enable(GL_MAP2_COLOR_4);
  gl.Enable(GL_AUTO_NORMAL);
  const auto all = [&] {
    gl.Begin(GL_POINTS);
    gl.EvalCoord1f(0), gl.EvalCoord2d(0, 0), gl.EvalPoint1(0), gl.EvalPoint2(0, 0);
    gl.End();
    gl.EvalMesh1(GL_POINT, 0, 1);
    gl.EvalMesh2(GL_FILL, 0, 1, 0, 1);
  };
  CHECK(feedback(gl, all).empty());
  define_line(gl);
  define_sheet(gl);
  CHECK(feedback(gl, [&] { gl.EvalCoord1f(0), gl.EvalCoord2f(0, 0), gl.EvalPoint1(0); }).empty());
  CHECK(feedback(gl, all).size() == 12 * (4 + 2) + 2 * (2 + 3 * 11));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("a mesh is the loop of 5.1", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  define_line(gl);
  define_sheet(gl);
  gl.MapGrid1f(4, 0, 1);
  gl.MapGrid2f(4, 0, 1, 2, 0, 1);
  const auto points1 = [&](GLenum mode) {
    gl.Begin(mode);
    for (int i = 1; i <= 4; i++) gl.EvalPoint1(i);
    gl.End();
  };
  CHECK(feedback(gl, [&] { gl.EvalMesh1(GL_POINT, 1, 4); }) == feedback(gl, [&] { points1(GL_POINTS); }));
  CHECK(feedback(gl, [&] { gl.EvalMesh1(GL_LINE, 1, 4); }) == feedback(gl, [&] { points1(GL_LINE_STRIP); }));
  CHECK(feedback(gl, [&] { gl.EvalMesh2(GL_POINT, 0, 4, 1, 2); }) == feedback(gl, [&] {
          gl.Begin(GL_POINTS);
          for (int j = 1; j <= 2; j++)
            for (int i = 0; i <= 4; i++) gl.EvalPoint2(i, j);
          gl.End();
        }));
  CHECK(feedback(gl, [&] { gl.EvalMesh2(GL_LINE, 0, 4, 1, 2); }) == feedback(gl, [&] {
          for (int j = 1; j <= 2; j++) {
            gl.Begin(GL_LINE_STRIP);
            for (int i = 0; i <= 4; i++) gl.EvalPoint2(i, j);
            gl.End();
          }
          for (int i = 0; i <= 4; i++) {
            gl.Begin(GL_LINE_STRIP);
            for (int j = 1; j <= 2; j++) gl.EvalPoint2(i, j);
            gl.End();
          }
        }));
  CHECK(feedback(gl, [&] { gl.EvalMesh2(GL_POINT, 1, 0, 0, 1); }).empty());
}

// OSMesa draws triangles (reference/DEVIATIONS.md).
TEST_CASE("a filled mesh is made of strips of quadrilaterals", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  define_sheet(gl);
  gl.MapGrid2f(4, 0, 1, 2, 0, 1);
  const auto mesh = [&] { gl.EvalMesh2(GL_FILL, 0, 4, 0, 2); };
  const auto strips = [&] {
    for (int j = 0; j < 2; j++) {
      gl.Begin(GL_QUAD_STRIP);
      for (int i = 0; i <= 4; i++) gl.EvalPoint2(i, j), gl.EvalPoint2(i, j + 1);
      gl.End();
    }
  };
  const GLfloat colors[16] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1};
  gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, colors);
  gl.Enable(GL_MAP2_COLOR_4);
  const auto picture = [&](const std::function<void()>& draw) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    draw();
    std::vector<GLubyte> pixels(64 * 64 * 4);
    gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  };
  for (const GLenum shade_model : {GL_FLAT, GL_SMOOTH})
    for (const GLenum mode : {GL_FILL, GL_LINE, GL_POINT}) {
      gl.ShadeModel(shade_model);
      gl.PolygonMode(GL_FRONT_AND_BACK, mode);
      INFO(shade_model << " " << mode);
      if (shade_model == GL_SMOOTH && mode == GL_FILL) continue; // the diagonals are not told
      CHECK((picture(mesh) == picture(strips)));
    }
}

// OSMesa adds the steps up (reference/DEVIATIONS.md).
TEST_CASE("a grid begins and ends exactly where it was told to", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  // The points of the map are 0 outside of the first 2^-24 of its domain or so: a value next to the end
  // shows.
  for (int n = 1; n < 60; n++) {
    const float first = 0.1f * float(n), last = first + 0.7f + 0.01f * float(n);
    const GLfloat at_end[6] = {0.5f, 0, 0, -3e7f, 0, 0};
    gl.MapGrid1f(n, first, last);
    gl.Map1f(GL_MAP1_VERTEX_3, last, first, 3, 2, at_end);
    gl.Enable(GL_MAP1_VERTEX_3);
    INFO(n);
    for (const auto& draw : std::initializer_list<std::function<void()>>{
             [&] { gl.EvalMesh1(GL_POINT, n > 3 ? n - 3 : 0, n); },
             [&] { gl.Begin(GL_POINTS), gl.EvalPoint1(n), gl.End(); }}) {
      const std::vector<GLfloat> p = feedback(gl, draw, GL_2D);
      REQUIRE(p.size() >= 3);
      CHECK(p[p.size() - 2] == 48);
    }
    gl.Map1f(GL_MAP1_VERTEX_3, first, last, 3, 2, at_end);
    for (const auto& draw : std::initializer_list<std::function<void()>>{
             [&] { gl.EvalMesh1(GL_POINT, -3, 0); },
             [&] { gl.Begin(GL_POINTS), gl.EvalPoint1(0), gl.End(); }}) {
      const std::vector<GLfloat> p = feedback(gl, draw, GL_2D);
      REQUIRE(p.size() >= 3);
      CHECK(p[p.size() - 2] == 48);
    }
  }
}

// OSMesa takes the derivatives for those of the unit square (reference/DEVIATIONS.md).
TEST_CASE("an automatic normal turns round with the domain", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Enable(GL_AUTO_NORMAL);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
  for (const bool u_back : {false, true})
    for (const bool v_back : {false, true}) {
      define_sheet(gl); // u is x, v is y: the normal is +z
      gl.Map2f(GL_MAP2_VERTEX_3, GLfloat(u_back), GLfloat(!u_back), 6, 2, GLfloat(v_back), GLfloat(!v_back),
               3, 2, kSheet);
      const std::vector<GLfloat> p =
          feedback(gl, [&] { gl.Begin(GL_POINTS), gl.EvalCoord2f(0.25f, 0.5f), gl.End(); });
      REQUIRE(p.size() == 12);
      CHECK((p[4] > 0.5f) == (u_back == v_back)); // lit from +z
    }
}

// OSMesa reads behind the control points (reference/DEVIATIONS.md).
TEST_CASE("a surface of order 1 has no automatic normal", "[spec][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Enable(GL_AUTO_NORMAL);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_MAP2_VERTEX_3);
  for (const auto& [u_order, v_order] : {std::pair{1, 1}, {1, 2}, {4, 1}}) {
    gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, u_order, 0, 1, 3, v_order, kSheet);
    const std::vector<GLfloat> p = feedback(gl, [&] { gl.Begin(GL_POINTS), gl.EvalCoord2f(0, 0), gl.End(); });
    REQUIRE(p.size() == 12);
    CHECK(p[1] == 16);
    CHECK(p[4] < 0.1f); // ambient light only
  }
}

TEST_CASE("a list keeps the control points of its time, and evaluates when it is played",
          "[spec][lists][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLdouble points[20];
  for (int i = 0; i < 20; i++) points[i] = i % 5 == 0 ? 0.1 * i : 0.01 * i;
  gl.NewList(1, GL_COMPILE);
  gl.Map1d(GL_MAP1_VERTEX_3, 0, 1, 5, 4, points);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.MapGrid1f(5, 0, 1);
  gl.EndList();
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK_FALSE(gl.IsEnabled(GL_MAP1_VERTEX_3));
  for (GLdouble& p : points) p = 77;
  gl.CallList(1);
  GLfloat kept[12];
  gl.GetMapfv(GL_MAP1_VERTEX_3, GL_COEFF, kept);
  CHECK(kept[0] == 0);
  CHECK(kept[3] == 0.5f);
  CHECK(kept[9] == 1.5f);

  gl.NewList(2, GL_COMPILE);
  gl.Color4f(0, 1, 0, 1);
  gl.Begin(GL_LINE_STRIP);
  gl.Vertex2f(0.5f, 0.5f);
  gl.EvalCoord1f(0);
  gl.EvalPoint1(5);
  gl.Vertex2f(0.5f, -0.5f);
  gl.End();
  gl.EvalMesh1(GL_POINT, 0, 5);
  gl.EndList();
  const auto directly = [&] {
    gl.Color4f(0, 1, 0, 1);
    gl.Begin(GL_LINE_STRIP);
    gl.Vertex2f(0.5f, 0.5f);
    gl.EvalCoord1f(0);
    gl.EvalPoint1(5);
    gl.Vertex2f(0.5f, -0.5f);
    gl.End();
    gl.EvalMesh1(GL_POINT, 0, 5);
  };
  for (int i = 0; i < 2; i++) {
    const std::vector<GLfloat> drawn = feedback(gl, directly);
    CHECK(drawn.size() >= 3 * 23);
    CHECK(feedback(gl, [&] { gl.CallList(2); }) == drawn);
    define_line(gl); // the list asks this map then
  }
  CHECK(gl.GetError() == GL_NO_ERROR);

  // A list that is executed at the same time: once, and the list holds it once.
  const std::vector<GLfloat> drawn = feedback(gl, directly);
  CHECK(feedback(gl, [&] {
          gl.NewList(3, GL_COMPILE_AND_EXECUTE);
          directly();
          gl.EndList();
        }) == drawn);
  CHECK(feedback(gl, [&] { gl.CallList(3); }) == drawn);
}

TEST_CASE("a list raises the errors of evaluators when it is played", "[spec][lists][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 2, 2, kLine);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  gl.Begin(GL_POINTS);
  gl.EvalMesh1(GL_POINT, 0, 1);
  gl.End();
  gl.EndList();
  gl.NewList(3, GL_COMPILE);
  gl.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, 2, kLine);
  gl.EndList();
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.CallList(1);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  gl.CallList(2);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.CallList(3);
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.CallList(3);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("selection sees evaluated primitives", "[spec][selection][evaluators]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  define_sheet(gl);
  GLuint names[32] = {};
  gl.SelectBuffer(32, names);
  gl.RenderMode(GL_SELECT);
  gl.InitNames();
  gl.PushName(1);
  gl.EvalMesh2(GL_FILL, 0, 1, 0, 1);
  gl.LoadName(2);
  gl.EvalMesh2(GL_POINT, 9, 9, 0, 0); // out of view
  gl.LoadName(3);
  gl.EvalMesh2(GL_LINE, 0, 1, 0, 1);
  CHECK(gl.RenderMode(GL_RENDER) == 2);
  CHECK(names[3] == 1);
  CHECK(names[7] == 3);
}

} // namespace softgl::test
