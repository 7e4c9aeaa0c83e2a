// SOFTGL_QUADS=osmesa: quadrilaterals are cut where OSMesa 22.3.6 cuts them, whatever it depends on.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <vector>

#include "support/random.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

struct Vertex {
  GLfloat color[4], position[3];
};

/// Bent quadrilaterals of four colors, side by side or on top of each other; one in three scenes reaches
/// beyond the window.
std::vector<Vertex> random_quads(Random& r) {
  std::vector<Vertex> vertices;
  const bool beyond = r.chance(33);
  const int quads = r.integer(1, 12);
  for (int i = 0; i < quads; ++i) {
    const float x = r.real(-0.7f, 0.7f), y = r.real(-0.7f, 0.7f), size = r.real(0.1f, beyond ? 0.6f : 0.29f);
    for (int corner = 0; corner < 4; ++corner) {
      Vertex v;
      for (GLfloat& c : v.color) c = r.real(0, 1);
      v.position[0] = x + (corner == 1 || corner == 2 ? size : -size);
      v.position[1] = y + (corner >= 2 ? size : -size);
      v.position[2] = r.real(-0.9f, 0.9f);
      vertices.push_back(v);
    }
  }
  return vertices;
}

/// One draw, or several Begin/End pairs in a row, of the vertices' colors or of the first one.
void draw_vertices(const Gl& gl, Random& r, const std::vector<Vertex>& vertices, bool colored) {
  const int cut = r.chance(40) ? 4 : 1000;
  const bool rebound = r.chance(50); // a command that changes nothing parts no draws
  if (!colored) gl.Color4fv(vertices[0].color);
  gl.Begin(GL_QUADS);
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (i && i % size_t(cut) == 0) {
      gl.End();
      if (rebound) gl.BindTexture(GL_TEXTURE_2D, 0);
      gl.Begin(GL_QUADS);
    }
    if (colored) gl.Color4fv(vertices[i].color);
    gl.Vertex3fv(vertices[i].position);
  }
  gl.End();
}

void draw_random_quads(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  for (int draw = 0; draw < 3; ++draw) {
    const std::vector<Vertex> vertices = random_quads(r);
    gl.ShadeModel(r.chance(50) ? GL_SMOOTH : GL_FLAT);
    gl.PolygonMode(GL_FRONT_AND_BACK, r.chance(15) ? GL_LINE : GL_FILL);
    const bool colored = r.chance(70), lit = r.chance(15);
    (lit ? gl.Enable : gl.Disable)(GL_LIGHTING);
    const int path = r.integer(0, 3);
    if (path == 0) {
      // Where OSMesa merges draws and one of them has colors, the other one has, too.
      if (!colored) gl.Finish();
      draw_vertices(gl, r, vertices, colored);
      if (!colored) gl.Finish();
    } else if (path == 1) {
      gl.NewList(1, GL_COMPILE);
      draw_vertices(gl, r, vertices, colored);
      gl.EndList();
      gl.CallList(1);
    } else {
      gl.EnableClientState(GL_VERTEX_ARRAY);
      if (colored) gl.EnableClientState(GL_COLOR_ARRAY);
      gl.ColorPointer(4, GL_FLOAT, sizeof(Vertex), vertices[0].color);
      gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices[0].position);
      std::vector<GLushort> index(vertices.size());
      for (size_t i = 0; i < index.size(); ++i) index[i] = GLushort(i);
      if (path == 2)
        gl.DrawArrays(GL_QUADS, 0, GLsizei(vertices.size()));
      else
        gl.DrawElements(GL_QUADS, GLsizei(vertices.size()), GL_UNSIGNED_SHORT, index.data());
      gl.DisableClientState(GL_VERTEX_ARRAY);
      gl.DisableClientState(GL_COLOR_ARRAY);
      gl.Finish();
    }
  }
}

} // namespace

TEST_CASE("SOFTGL_QUADS=osmesa cuts quadrilaterals where OSMesa does", "[conformance][quads]") {
  const Scene scene{"random_quads", draw_random_quads};
  int others = 0;
  for (uint64_t seed = 0; seed < 150; ++seed) {
    INFO("seed " << seed);
    const Picture expected = draw(osmesa_library(), scene, seed);
    others += compare(draw(softgl_library(), scene, seed), expected).any();
    setenv("SOFTGL_QUADS", "osmesa", 1);
    const Difference difference = compare(draw(softgl_library(), scene, seed), expected);
    unsetenv("SOFTGL_QUADS");
    INFO(difference.text);
    CHECK_FALSE(difference.any());
  }
  CHECK(others > 20); // the shade model alone gives other pictures
}

TEST_CASE("an attribute of the context says where quadrilaterals are cut", "[conformance][quads]") {
  const Gl& gl = softgl_library();
  const auto middle_is_near = [&](int value) {
    const int attributes[] = {0x30 /* OSMESA_DEPTH_BITS */, 24, SOFTGL_OSMESA_QUADS, value, 0};
    void* context = gl.OSMesaCreateContextAttribs(attributes, nullptr);
    REQUIRE(context);
    unsigned char buffer[16 * 16 * 4];
    REQUIRE(gl.OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 16, 16));
    const GLfloat v[4][3] = {{-1, -1, -0.5f}, {1, -1, 0.5f}, {1, 1, -0.5f}, {-1, 1, 0.5f}};
    const GLubyte index[4] = {0, 1, 2, 3};
    gl.Enable(GL_DEPTH_TEST);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.VertexPointer(3, GL_FLOAT, 0, v);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, index);
    GLfloat depth = 0;
    gl.ReadPixels(8, 8, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
    return depth < 0.5f;
  };
  CHECK(middle_is_near(0));
  CHECK_FALSE(middle_is_near(1));
  const int wrong[] = {SOFTGL_OSMESA_QUADS, 2, 0};
  CHECK(gl.OSMesaCreateContextAttribs(wrong, nullptr) == nullptr);
}

} // namespace softgl::test
