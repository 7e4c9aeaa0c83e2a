// SOFTGL_ANSWERS=specification: polygons are cut as a whole (GL 1.5, 2.12), and fed back so (5.3).
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "spec/specification_context.h"

namespace softgl::test {
namespace {

constexpr int kSize = SpecificationContext::kSize;

/// What the buffer holds of points and lines: how many there are, and whether a line lies along x = 0.
struct Fed {
  int points = 0, lines = 0, resets = 0;
  bool left_edge = false;
  bool operator==(const Fed&) const = default;
};

Fed feed_back(const Gl& gl, const std::function<void()>& draw) {
  std::vector<GLfloat> values(100000);
  gl.FeedbackBuffer(GLsizei(values.size()), GL_2D, values.data());
  gl.RenderMode(GL_FEEDBACK);
  draw();
  const GLint count = gl.RenderMode(GL_RENDER);
  REQUIRE(count >= 0);
  Fed fed;
  for (GLint i = 0; i < count;) {
    const auto token = GLenum(values[size_t(i)]);
    const float* v = &values[size_t(i) + 1];
    if (token == GL_POINT_TOKEN) {
      ++fed.points;
      i += 3;
    } else {
      REQUIRE((token == GL_LINE_TOKEN || token == GL_LINE_RESET_TOKEN));
      ++fed.lines;
      fed.resets += token == GL_LINE_RESET_TOKEN;
      fed.left_edge = fed.left_edge || (std::fabs(v[0]) < 1e-3f && std::fabs(v[2]) < 1e-3f);
      i += 5;
    }
  }
  return fed;
}

using Corners = std::vector<std::array<float, 2>>;

/// The ways by which vertices come.
void draw_in_all_ways(const Gl& gl, GLenum mode, const Corners& corners,
                      const std::function<void(const char*, const std::function<void()>&)>& check) {
  const auto immediate = [&] {
    gl.Begin(mode);
    for (const auto& v : corners) gl.Vertex2fv(v.data());
    gl.End();
  };
  check("immediate", immediate);
  gl.NewList(1, GL_COMPILE);
  immediate();
  gl.EndList();
  check("list", [&] { gl.CallList(1); });
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, corners.data());
  check("array", [&] { gl.DrawArrays(mode, 0, GLsizei(corners.size())); });
  std::vector<GLushort> index(corners.size());
  for (size_t i = 0; i < index.size(); ++i) index[i] = GLushort(i);
  check("indices", [&] { gl.DrawElements(mode, GLsizei(index.size()), GL_UNSIGNED_SHORT, index.data()); });
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

} // namespace

TEST_CASE("a polygon that is cut has the corners and edges of one polygon", "[spec][answers]") {
  struct Case {
    const char* name;
    GLenum mode;
    Corners corners;
    int polygons, left; // how many edges and corners are left
  };
  const Case cases[] = {
      {"triangle", GL_TRIANGLES, {{-2, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}}, 1, 4},
      {"quadrilateral", GL_QUADS, {{-2, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-2, 0.5f}}, 1, 4},
      {"quadrilateral, other corner first",
       GL_QUADS,
       {{0.5f, -0.5f}, {0.5f, 0.5f}, {-2, 0.5f}, {-2, -0.5f}},
       1,
       4},
      {"polygon",
       GL_POLYGON,
       {{-2, -0.2f}, {-1.5f, -0.6f}, {0.4f, -0.6f}, {0.6f, 0}, {0.4f, 0.6f}, {-1.5f, 0.6f}, {-2, 0.2f}},
       1,
       5},
      {"strip of quadrilaterals",
       GL_QUAD_STRIP,
       {{-2, 0.5f}, {-2, -0.5f}, {0, 0.5f}, {0, -0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}},
       2,
       8},
      {"strip", GL_TRIANGLE_STRIP, {{-2, 0.5f}, {-2, -0.5f}, {0, 0.5f}, {0, -0.5f}}, 2, 7},
      {"fan", GL_TRIANGLE_FAN, {{0, 0}, {0.3f, 0.5f}, {-2, 0.5f}, {-2, -0.5f}}, 2, 7},
      {"corner of the window", GL_QUADS, {{-2, -2}, {0.5f, -2}, {0.5f, 0.5f}, {-2, 0.5f}}, 1, 4},
  };
  for (const Case& test : cases) {
    const SpecificationContext a;
    const Gl& gl = a.gl;
    draw_in_all_ways(gl, test.mode, test.corners, [&](const char* way, const std::function<void()>& draw) {
      INFO(test.name << ", " << way);
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
      Fed fed = feed_back(gl, draw);
      CHECK(fed.lines == test.left);
      CHECK(fed.resets == test.polygons);
      CHECK(fed.left_edge);
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
      CHECK(feed_back(gl, draw).points == test.left);
      // A plane of the user cuts as the view volume does: here x < 0.2 is left.
      const GLdouble plane[4] = {-1, 0, 0, 0.2};
      gl.ClipPlane(GL_CLIP_PLANE0, plane);
      gl.Enable(GL_CLIP_PLANE0);
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
      fed = feed_back(gl, draw);
      CHECK(fed.left_edge);
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
      CHECK(feed_back(gl, draw).points == fed.lines);
      gl.Disable(GL_CLIP_PLANE0);
      // The other side is filled, and these are the front.
      gl.PolygonMode(GL_BACK, GL_FILL);
      gl.PolygonMode(GL_FRONT, GL_LINE);
      gl.Enable(GL_CULL_FACE);
      CHECK(feed_back(gl, draw).lines == test.left);
      gl.CullFace(GL_FRONT);
      CHECK(feed_back(gl, draw) == Fed{});
      gl.CullFace(GL_BACK);
      gl.Disable(GL_CULL_FACE);
    });
  }
}

TEST_CASE("new edges are boundaries, and old ones keep their flags", "[spec][answers]") {
  const SpecificationContext a;
  const Gl& gl = a.gl;
  const Corners corners = {{-2, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-2, 0.5f}};
  for (GLenum mode : {GL_QUADS, GL_POLYGON})
    for (int flagged = -1; flagged < 4; ++flagged) {
      INFO("mode " << mode << ", edge " << flagged);
      const auto draw = [&] {
        gl.Begin(mode);
        for (int i = 0; i < 4; ++i) {
          gl.EdgeFlag(i == flagged);
          gl.Vertex2fv(corners[size_t(i)].data());
        }
        gl.End();
      };
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
      const Fed fed = feed_back(gl, draw);
      // The edge from corner 3 to corner 0 is outside.
      CHECK(fed.lines == (flagged >= 0 && flagged < 3 ? 2 : 1));
      CHECK(fed.left_edge);
      gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
      CHECK(feed_back(gl, draw).points == fed.lines);
    }
}

TEST_CASE("a polygon of many corners is cut as a whole", "[spec][answers]") {
  for (GLenum mode : {GL_POINT, GL_LINE}) {
    const SpecificationContext a;
    const Gl& gl = a.gl;
    const auto draw = [&] {
      gl.Begin(GL_POLYGON);
      for (int i = 0; i < 6000; ++i) {
        const float angle = float(i) * 6.2831853f / 6000;
        gl.Vertex2f(0.9f * std::cos(angle) - 0.7f, 0.9f * std::sin(angle));
      }
      gl.End();
    };
    gl.PolygonMode(GL_FRONT_AND_BACK, mode);
    draw();
    // The circle's right end, in column 38. It is drawn in several pieces, cut in one.
    const auto red = a.red();
    const auto lit = [&](int x) { return red[size_t(32 * kSize + x)] == 255; };
    CHECK((lit(37) || lit(38) || lit(39)));
    const Fed fed = feed_back(gl, draw);
    CHECK(fed.lines + fed.points > 3000);
    CHECK(fed.lines + fed.points < 6000);
    CHECK(fed.left_edge == (mode == GL_LINE));
    CHECK(fed.resets == (mode == GL_LINE));
  }
}

TEST_CASE("depths that are fed back have no offset", "[spec][answers]") {
  for (const bool specification : {false, true}) {
    const SpecificationContext a(specification);
    const Gl& gl = a.gl;
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(0, 1000000);
    GLfloat values[16] = {};
    gl.FeedbackBuffer(16, GL_3D, values);
    gl.RenderMode(GL_FEEDBACK);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(-0.5f, -0.5f);
    gl.Vertex2f(0.5f, -0.5f);
    gl.Vertex2f(0, 0.5f);
    gl.End();
    CHECK(gl.RenderMode(GL_RENDER) == 11);
    CHECK((values[4] == 0.5f) == specification);
  }
}

TEST_CASE("a polygon is selected whatever its mode is", "[spec][answers]") {
  for (const bool specification : {false, true}) {
    const SpecificationContext a(specification);
    const Gl& gl = a.gl;
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    GLuint names[8] = {};
    gl.SelectBuffer(8, names);
    gl.RenderMode(GL_SELECT);
    gl.Begin(GL_TRIANGLES); // around the view volume: no corner is inside
    gl.Vertex2f(-9, -8);
    gl.Vertex2f(9, -7);
    gl.Vertex2f(0, 9);
    gl.End();
    CHECK(gl.RenderMode(GL_RENDER) == int(specification));
  }
}

} // namespace softgl::test
