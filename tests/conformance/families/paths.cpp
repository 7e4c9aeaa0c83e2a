// Phong-lit primitives from immediate mode, from a display list and from arrays: three families with one
// picture a seed (for tests/identity, and not for the GLSL twins: OSMesa cuts smooth quads in its own way,
// reference/DEVIATIONS.md).
#include "conformance/families/paths.h"
#include "conformance/families/common.h"

#include <cstddef>

namespace softgl::test {
namespace {

struct Vertex {
  Float4 color, position;
  Float3 normal;
  Float2 texcoord;
};

void hand_over(Stage& s, Path path, GLenum mode, const std::vector<Vertex>& v) {
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
  case Path::Arrays:
    arrays(client);
    gl.DrawArrays(mode, 0, count);
    break;
  case Path::Elements:
    arrays(client);
    gl.DrawElements(mode, count, GL_UNSIGNED_INT, indices.data());
    break;
  case Path::ArrayElement:
    arrays(client);
    gl.Begin(mode);
    for (GLsizei i = 0; i < count; i++) gl.ArrayElement(i);
    gl.End();
    break;
  case Path::Buffers: {
    GLuint buffers[2] = {};
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

void light_somehow(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ShadeModel(GLenum(r.pick({GL_SMOOTH, GL_SMOOTH, GL_FLAT, GL_PHONG_WIN})));
  if (!r.chance(50)) return;
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_NORMALIZE);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(50));
  if (r.chance(50)) gl.Enable(GL_COLOR_MATERIAL);
}

void light_by_phong(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Enable(GL_LIGHTING);
  const GLenum end = GL_LIGHT0 + GLenum(r.integer(1, 3));
  for (GLenum light = GL_LIGHT0; light < end; light++) {
    const Float3 d = r.direction();
    const Float4 position{3 * d[0], 3 * d[1], 3 * d[2], r.chance(50) ? 1.0f : 0.0f}, color = r.color();
    gl.Enable(light);
    gl.Lightfv(light, GL_POSITION, position.data());
    gl.Lightfv(light, GL_DIFFUSE, color.data());
    gl.Lightfv(light, GL_SPECULAR, color.data());
    if (r.chance(40)) gl.Lightf(light, GL_QUADRATIC_ATTENUATION, r.real(0, 0.3f));
    if (!r.chance(40)) continue;
    const Float3 inwards{-d[0], -d[1], -d[2]};
    gl.Lightfv(light, GL_SPOT_DIRECTION, inwards.data());
    gl.Lightf(light, GL_SPOT_CUTOFF, r.real(10, 90));
    gl.Lightf(light, GL_SPOT_EXPONENT, r.real(0, 20));
  }
  const Float4 specular = r.color();
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, r.chance(10) ? 0.0f : r.real(0, 128));
  if (r.chance(60)) gl.Enable(GL_NORMALIZE);
  if (r.chance(50)) gl.Enable(GL_COLOR_MATERIAL);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(50));
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, r.chance(50));
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, r.chance(30) ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  gl.LightModeli(GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL,
                 r.chance(30) ? GL_REFLECTION_VECTOR_SOFTGL : GL_HALF_VECTOR_SOFTGL);
}

} // namespace

void draw_by_path(Stage& s, Path path, bool phong) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  random_projection(s);
  random_modelview(s);
  random_depth(s, 50);
  random_culling(s);
  if (phong)
    light_by_phong(s);
  else
    light_somehow(s);
  gl.LineWidth(r.real(1, 4));
  gl.PointSize(r.real(1, 8));
  if (r.chance(30)) random_fog(s);
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
    const std::vector<Float4> positions =
        random_positions(s, mode, count, count > 400 ? Spread::Tiny : Spread::Any, false);
    std::vector<Vertex> v(positions.size());
    for (size_t k = 0; k < v.size(); k++) {
      v[k].color = r.color();
      v[k].position = positions[k];
      v[k].normal = r.direction();
      v[k].texcoord = {r.real(-2, 2), r.real(-2, 2)};
    }
    keep.push_back(v);
    hand_over(s, path, mode, keep.back());
  }
}

static SceneRegistration immediate{{.name = "phong_immediate",
                                    .draw = [](Stage& s) { draw_by_path(s, Path::Immediate, true); },
                                    .random = true,
                                    .extension = true,
                                    .numbers = "phong_paths"}};
static SceneRegistration list{{.name = "phong_list",
                               .draw = [](Stage& s) { draw_by_path(s, Path::List, true); },
                               .random = true,
                               .extension = true,
                               .numbers = "phong_paths"}};
static SceneRegistration arrays{{.name = "phong_arrays",
                                 .draw = [](Stage& s) { draw_by_path(s, Path::Elements, true); },
                                 .random = true,
                                 .extension = true,
                                 .numbers = "phong_paths"}};

} // namespace softgl::test
