// One picture, whichever way the vertices come: immediate mode, display list, vertex arrays, indices, buffer objects.
#include <catch2/catch.hpp>

#include "conformance/families/common.h"
#include "support/environment.h"
#include "support/runner.h"

namespace softgl::test {
namespace {

enum class Path { Immediate, List, NestedList, Arrays, Elements, ArrayElement, Buffers, ArraysInList };
Path path = Path::Immediate; // read by the scene while it draws

struct Vertex {
  Float4 color, position;
  Float3 normal;
  Float2 texcoord;
};

void draw_by_path(Stage& s, GLenum mode, const std::vector<Vertex>& v) {
  const Gl& gl = s.gl;
  const GLsizei count = GLsizei(v.size());
  auto immediate = [&] {
    gl.Begin(mode);
    for (const Vertex& x : v) {
      gl.Color4fv(x.color.data());
      gl.Normal3fv(x.normal.data());
      gl.TexCoord2fv(x.texcoord.data());
      gl.Vertex4fv(x.position.data());
    }
    gl.End();
  };
  auto arrays = [&](const char* base) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_COLOR_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.ColorPointer(4, GL_FLOAT, sizeof(Vertex), base + offsetof(Vertex, color));
    gl.VertexPointer(4, GL_FLOAT, sizeof(Vertex), base + offsetof(Vertex, position));
    gl.NormalPointer(GL_FLOAT, sizeof(Vertex), base + offsetof(Vertex, normal));
    gl.TexCoordPointer(2, GL_FLOAT, sizeof(Vertex), base + offsetof(Vertex, texcoord));
  };
  const char* client = reinterpret_cast<const char*>(v.data());
  std::vector<GLuint> indices(v.size());
  for (size_t i = 0; i < v.size(); i++) indices[i] = GLuint(i);
  switch (path) {
  case Path::Immediate: immediate(); break;
  case Path::List:
    gl.NewList(1, GL_COMPILE);
    immediate();
    gl.EndList();
    gl.CallList(1);
    break;
  case Path::NestedList: {
    gl.NewList(1, GL_COMPILE);
    immediate();
    gl.EndList();
    gl.NewList(2, GL_COMPILE);
    gl.CallList(1);
    gl.EndList();
    const GLubyte two = 2;
    gl.CallLists(1, GL_UNSIGNED_BYTE, &two);
    break;
  }
  case Path::Arrays: arrays(client); gl.DrawArrays(mode, 0, count); break;
  case Path::Elements: arrays(client); gl.DrawElements(mode, count, GL_UNSIGNED_INT, indices.data()); break;
  case Path::ArrayElement:
    arrays(client);
    gl.Begin(mode);
    for (GLsizei i = 0; i < count; i++) gl.ArrayElement(i);
    gl.End();
    break;
  case Path::Buffers: {
    GLuint buffers[2];
    gl.GenBuffers(2, buffers);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(v.size() * sizeof(Vertex)), v.data(), GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * 4), indices.data(), GL_STATIC_DRAW);
    arrays(nullptr);
    gl.DrawRangeElements(mode, 0, GLuint(count - 1), count, GL_UNSIGNED_INT, nullptr);
    gl.DeleteBuffers(2, buffers);
    break;
  }
  case Path::ArraysInList:
    arrays(client);
    gl.NewList(1, GL_COMPILE);
    gl.DrawArrays(mode, 0, count);
    gl.EndList();
    gl.CallList(1);
    break;
  }
}

void draw_scene(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  random_projection(s);
  random_modelview(s);
  random_depth(s, 50);
  random_culling(s);
  gl.ShadeModel(GLenum(r.pick({GL_SMOOTH, GL_SMOOTH, GL_FLAT, GL_PHONG_WIN})));
  gl.LineWidth(r.real(1, 4));
  gl.PointSize(r.real(1, 8));
  if (r.chance(30)) random_fog(s);
  if (r.chance(50)) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(50));
    if (r.chance(50)) gl.Enable(GL_COLOR_MATERIAL);
  }
  if (r.chance(40)) {
    uint8_t texels[8 * 8 * 4];
    for (uint8_t& t : texels) t = uint8_t(r.bits());
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
  }
  std::vector<std::vector<Vertex>> keep; // arrays are read no later than the draw, but let them live on
  for (int i = r.integer(1, 4); i > 0; i--) {
    const GLenum mode = GLenum(r.integer(GL_POINTS, GL_POLYGON));
    const int count = vertices_of(mode, r.chance(90) ? r.integer(1, 30) : r.integer(1000, 9000));
    const std::vector<Float4> positions = random_positions(s, mode, count, count > 400 ? Spread::Tiny : Spread::Any, false);
    std::vector<Vertex> v(positions.size());
    for (size_t k = 0; k < v.size(); k++) {
      v[k].color = r.color();
      v[k].position = positions[k];
      v[k].normal = r.direction();
      v[k].texcoord = {r.real(-2, 2), r.real(-2, 2)};
    }
    keep.push_back(v);
    draw_by_path(s, mode, keep.back());
  }
}

void check_path(Path other) {
  const Scene scene{"paths", draw_scene, true};
  for (uint64_t seed = 0; seed < uint64_t(seed_count(60)); seed++) {
    path = Path::Immediate;
    const Picture expected = draw(softgl_library(), scene, seed);
    path = other;
    const Picture got = draw(softgl_library(), scene, seed);
    const Difference d = compare(got, expected);
    INFO("seed " << seed << ": " << d.text);
    CHECK_FALSE(d.any());
  }
  path = Path::Immediate;
}

} // namespace

TEST_CASE("a display list draws what immediate mode draws", "[identity][slow]") { check_path(Path::List); }
TEST_CASE("a list in a list draws what immediate mode draws", "[identity][slow]") { check_path(Path::NestedList); }
TEST_CASE("vertex arrays draw what immediate mode draws", "[identity][slow]") { check_path(Path::Arrays); }
TEST_CASE("indexed arrays draw what immediate mode draws", "[identity][slow]") { check_path(Path::Elements); }
TEST_CASE("glArrayElement draws what immediate mode draws", "[identity][slow]") { check_path(Path::ArrayElement); }
TEST_CASE("buffer objects draw what immediate mode draws", "[identity][slow]") { check_path(Path::Buffers); }
TEST_CASE("arrays compiled into a list draw what immediate mode draws", "[identity][slow]") { check_path(Path::ArraysInList); }

} // namespace softgl::test
