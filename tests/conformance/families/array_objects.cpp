// Vertex array objects, bound in turn, and indices at which primitives begin anew.
#include <algorithm>
#include <cstddef>
#include <cstring>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

struct Object {
  GLuint name = 0;
  GLenum mode = GL_TRIANGLES;
  int count = 0;         // vertices
  bool elements = false; // its indices lie in a buffer
  bool converted =
      false; // of bytes b g r a or halves, which OSMesa knows in draws alone: reference/DEVIATIONS.md
};

struct Vertex {
  Float4 position;
  uint16_t half[4]; // the position again
  GLubyte color[4];
};

/// The nearest float of 16 bits towards zero.
uint16_t to_half(float v) {
  uint32_t bits;
  std::memcpy(&bits, &v, 4);
  const int exponent = int(bits >> 23 & 255) - 112;
  const auto sign = uint16_t(bits >> 16 & 0x8000);
  if (exponent <= 0) return sign;
  return uint16_t(sign | (exponent >= 31 ? 0x7bff : exponent << 10 | int(bits >> 13 & 0x3ff)));
}

/// Client memory of a scene, which outlives its draws.
struct Memory {
  std::vector<std::vector<Vertex>> vertices;
  std::vector<std::vector<GLuint>> indices;
};

constexpr int kMostIndices = 60;
constexpr GLuint kRestart[3] = {0xff, 0xffff, 0xffffffff};

GLenum index_type(int i) { return i == 0 ? GL_UNSIGNED_BYTE : i == 1 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT; }

/// Indices of 1, 2 or 4 bytes (`width` 0 to 2); some are `restart` if that begins primitives anew.
std::vector<GLuint> random_indices(Stage& s, const Object& o, int width, GLuint restart, bool restarts) {
  Random& r = s.random;
  const bool shuffled = o.mode != GL_POLYGON && o.mode != GL_QUAD_STRIP && r.chance(40);
  std::vector<GLuint> words(kMostIndices + 1);
  const int many = r.pick({0, 5, 20});
  for (int i = 0; i < kMostIndices; ++i) {
    GLuint index = GLuint(shuffled ? r.integer(0, o.count - 1) : i % o.count);
    if (r.chance(many) && restarts) index = restart;
    std::memcpy(reinterpret_cast<char*>(words.data()) + (size_t(i) << width), &index, size_t(1) << width);
  }
  return words;
}

/// Positions and colors; of a vertex array object in a buffer. False without memory for it.
bool specify_arrays(Stage& s, Memory& memory, Object& o) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  o.mode = r.chance(40) ? GLenum(r.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}))
                        : random_filled_mode(s);
  o.count = vertices_of(o.mode, r.integer(1, 12));
  const std::vector<Float4> p =
      random_positions(s, o.mode, o.count, r.pick({Spread::View, Spread::Any}), false);
  std::vector<Vertex> vertices(size_t(o.count));
  for (size_t i = 0; i < vertices.size(); ++i) {
    vertices[i].position = p[i];
    for (size_t k = 0; k < 4; ++k) vertices[i].half[k] = to_half(p[i][k]);
    for (GLubyte& c : vertices[i].color) c = GLubyte(r.bits() >> 24);
  }
  const Vertex* at = nullptr;
  GLuint buffer = 0;
  GLint bound = 0;
  if (o.name) {
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
    if (!bound) return false;
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                  GL_STATIC_DRAW);
  } else {
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    memory.vertices.push_back(std::move(vertices));
    at = memory.vertices.back().data();
  }
  const auto member = [&](size_t offset) {
    return reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(at) + offset);
  };
  const int components = r.integer(3, 4);
  const bool halves = r.chance(30), bgra = r.chance(50);
  o.converted = halves || bgra;
  if (halves)
    gl.VertexPointer(components, GL_HALF_FLOAT, sizeof(Vertex), member(offsetof(Vertex, half)));
  else
    gl.VertexPointer(components, GL_FLOAT, sizeof(Vertex), at);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.ColorPointer(bgra ? GL_BGRA : 4, GL_UNSIGNED_BYTE, sizeof(Vertex), member(offsetof(Vertex, color)));
  gl.EnableClientState(GL_COLOR_ARRAY);
  return true;
}

void draw_elements(Stage& s, Memory& memory, const Object& o, bool restarts, bool in_list) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  const int width = r.integer(0, 2);
  const GLuint restart = r.chance(70) ? kRestart[width] : GLuint(r.integer(0, o.count));
  gl.PrimitiveRestartIndex(restart);
  const std::vector<GLuint> words = random_indices(s, o, width, restart, restarts);
  const void* pointer = nullptr;
  GLint bound = 0;
  if (o.elements) gl.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
  if (bound) {
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(words.size() * 4), words.data(), GL_DYNAMIC_DRAW);
  } else {
    memory.indices.push_back(words);
    pointer = memory.indices.back().data();
  }
  const int most =
      o.mode == GL_POLYGON || o.mode == GL_QUAD_STRIP ? std::min(o.count, kMostIndices) : kMostIndices;
  const int count = r.integer(1, most);
  switch (r.integer(0, 3)) {
  case 0: gl.DrawElements(o.mode, count, index_type(width), pointer); break;
  case 1: gl.DrawRangeElements(o.mode, 0, GLuint(o.count - 1), count, index_type(width), pointer); break;
  case 2: gl.DrawElementsBaseVertex(o.mode, count, index_type(width), pointer, 0); break;
  default: {
    // In lists OSMesa goes on with vertices that are left over: reference/DEVIATIONS.md.
    const int part = !in_list                 ? 1
                     : o.mode == GL_LINES     ? 2
                     : o.mode == GL_TRIANGLES ? 3
                     : o.mode == GL_QUADS     ? 4
                                              : 1;
    const GLsizei counts[2] = {count - count % part, count / 2 - count / 2 % part};
    const void* const pointers[2] = {pointer, pointer};
    gl.MultiDrawElements(o.mode, counts, index_type(width), pointers, counts[1] ? 2 : 1);
  }
  }
}

void draw(Stage& s, Memory& memory, const Object& o) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_modelview(s);
  gl.ShadeModel(o.mode == GL_QUADS || r.chance(40) ? GL_FLAT : GL_SMOOTH); // smooth quads: DEVIATIONS.md
  const bool restarts = r.chance(70), of_client = r.chance(50);
  if (of_client)
    (restarts ? gl.EnableClientState : gl.DisableClientState)(GL_PRIMITIVE_RESTART_NV);
  else
    (restarts ? gl.Enable : gl.Disable)(GL_PRIMITIVE_RESTART);
  // Primitives that begin anew leave vertices over.
  const bool independent = o.mode == GL_LINES || o.mode == GL_TRIANGLES || o.mode == GL_QUADS;
  const bool in_list = r.chance(15) && !o.converted && !(independent && restarts);
  const int command = o.converted ? 2 * r.integer(0, 1) : r.integer(0, 3);
  if (in_list) gl.NewList(5, GL_COMPILE);
  if (command == 0) {
    gl.DrawArrays(o.mode, 0, o.count);
  } else if (command == 1) {
    // Never two restarts in a row: where a primitive is empty OSMesa loses the next one.
    const int restart = r.integer(0, o.count);
    gl.PrimitiveRestartIndex(GLuint(restart));
    gl.Begin(o.mode);
    for (int i = 0; i < o.count; ++i) {
      gl.ArrayElement(i);
      if (restarts && r.chance(10) && i != restart && i + 1 != restart) gl.PrimitiveRestartNV();
    }
    gl.End();
  } else {
    draw_elements(s, memory, o, restarts, in_list);
  }
  if (in_list) {
    gl.EndList();
    gl.CallList(5);
  }
}

void draw_array_objects(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  Memory memory;
  random_canvas(s);
  gl.PointSize(5);
  gl.LineWidth(2);
  random_projection(s);
  std::vector<Object> objects(size_t(r.integer(2, 4)));
  for (Object& o : objects) {
    if (r.chance(80)) gl.GenVertexArrays(1, &o.name);
    gl.BindVertexArray(o.name);
    GLint bound = 0;
    gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
    o.name = GLuint(bound);
    o.elements = r.chance(60);
    GLuint buffer = 0;
    if (o.elements) gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer);
    if (!specify_arrays(s, memory, o)) return;
  }
  // The arrays of name 0 are those that came last.
  for (Object& o : objects)
    if (!o.name) o = *std::find_if(objects.rbegin(), objects.rend(), [](const Object& p) { return !p.name; });
  for (int n = r.integer(2, 6); n > 0; --n) {
    const Object& o = objects[size_t(r.integer(0, int(objects.size()) - 1))];
    const bool saved = r.chance(20);
    if (saved) gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    gl.BindVertexArray(o.name);
    if (r.chance(15)) gl.DisableClientState(GL_COLOR_ARRAY); // what is changed in an object stays there
    gl.Color3ub(200, 100, 50);
    if (o.mode != GL_QUADS || gl.IsEnabled(GL_COLOR_ARRAY)) draw(s, memory, o);
    if (saved) gl.PopClientAttrib();
  }
  gl.DisableClientState(GL_PRIMITIVE_RESTART_NV);
  gl.BindVertexArray(0);
  for (const Object& o : objects)
    if (o.name && r.chance(50)) gl.DeleteVertexArrays(1, &o.name);
  gl.Finish();
}

SceneRegistration array_objects{{"array_objects", draw_array_objects, true}};

} // namespace
} // namespace softgl::test
