// Vertex arrays in client memory and buffer objects: ranges, indices, compaction, buffers that change while a
// frame waits for them.
#include "faults/streams.h"

#include <cstring>

namespace softgl::test {
namespace {

struct Vertex {
  float x, y, z;
  unsigned char color[4];
};
constexpr int kVertices = 3000;

std::vector<Vertex> vertices(Player& p) {
  std::vector<Vertex> all(kVertices);
  for (Vertex& v : all) {
    v.x = p.random.real(-1, 1);
    v.y = p.random.real(-1, 1);
    v.z = p.random.real(-1, 1);
    for (auto& c : v.color) c = static_cast<unsigned char>(p.random.integer(0, 255));
  }
  return all;
}
template <class Index> std::vector<Index> indices(Player& p, int count, int most) {
  std::vector<Index> all(static_cast<size_t>(count));
  for (Index& i : all) i = static_cast<Index>(p.random.integer(0, most));
  return all;
}

void point_at(const Gl& gl, const unsigned char* base) {
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), base);
  const uintptr_t color = reinterpret_cast<uintptr_t>(base) + offsetof(Vertex, color); // base may be null
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), reinterpret_cast<const void*>(color));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
}

void draw_all(Player& p, const std::vector<GLushort>& shorts, const std::vector<GLuint>& few) {
  const Gl& gl = p.gl;
  gl.DrawArrays(GL_TRIANGLES, 3, kVertices - 3);
  p.check();
  gl.DrawElements(GL_TRIANGLE_STRIP, 2000, GL_UNSIGNED_SHORT, shorts.data());
  gl.DrawRangeElements(GL_LINES, 0, kVertices, 100, GL_UNSIGNED_SHORT, shorts.data());
  p.check();
  gl.DrawElements(GL_TRIANGLES, 30, GL_UNSIGNED_INT, few.data()); // far apart: compacted
  const GLint first[3] = {0, 30, 900};
  const GLsizei counts[3] = {9, 30, 300};
  gl.MultiDrawArrays(GL_TRIANGLES, first, counts, 3);
  p.check();
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 300; ++i) gl.ArrayElement(i);
  gl.End();
  p.check();
}

void client_memory(Player& p) {
  const auto data = vertices(p);
  const auto shorts = indices<GLushort>(p, 2000, kVertices - 1);
  const auto few = indices<GLuint>(p, 30, kVertices - 1);
  point_at(p.gl, reinterpret_cast<const unsigned char*>(data.data()));
  draw_all(p, shorts, few);
  p.picture();
}

void buffer_objects(Player& p) {
  const Gl& gl = p.gl;
  const auto data = vertices(p);
  const auto shorts = indices<GLushort>(p, 2000, kVertices - 1);
  const auto few = indices<GLuint>(p, 30, kVertices - 1);
  GLuint names[3] = {};
  gl.GenBuffers(3, names);
  if (!names[0]) return p.check(); // offsets must not become addresses
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(data.size() * sizeof(Vertex)), data.data(), GL_DYNAMIC_DRAW);
  p.check();
  if (p.out_of_memory()) return; // without a buffer its offsets would be addresses
  point_at(gl, nullptr);
  draw_all(p, shorts, few);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 4000, shorts.data(), GL_STATIC_DRAW);
  p.check();
  if (p.out_of_memory()) return;
  for (int i = 0; i < 4; ++i) {
    gl.DrawElements(GL_TRIANGLES, 300 + 30 * i, GL_UNSIGNED_SHORT,
                    nullptr); // ranges of indices are remembered
    gl.DrawElements(GL_QUADS, 200, GL_UNSIGNED_SHORT, reinterpret_cast<void*>(7)); // not aligned
    gl.BufferSubData(GL_ARRAY_BUFFER, 48 * i, 4800, data.data() + 100); // a frame waits: a copy is made
    p.check();
  }
  if (void* map = gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY)) {
    std::memcpy(map, data.data() + 500, 500 * sizeof(Vertex));
    gl.UnmapBuffer(GL_ARRAY_BUFFER);
  } else {
    p.refuse();
  }
  gl.DrawArrays(GL_TRIANGLES, 0, 900);
  gl.BufferData(GL_ARRAY_BUFFER, 2 << 20, nullptr, GL_STREAM_DRAW);
  gl.DrawArrays(GL_TRIANGLES, 0, 900);
  gl.DeleteBuffers(3, names); // while the frame waits
  p.check();
  p.picture();
}

} // namespace

const std::vector<Stream>& array_streams() {
  static const std::vector<Stream> streams = {{"arrays.client", client_memory},
                                              {"arrays.buffers", buffer_objects}};
  return streams;
}

} // namespace softgl::test
