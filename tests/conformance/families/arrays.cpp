// Vertex arrays of every type, interleaved, in buffer objects, drawn by every array command.
#include <algorithm>
#include <cstring>
#include <memory>

#include "conformance/families/common.h"

namespace softgl::test {

namespace {

// Client memory of a scene: it must outlive the last draw from it.
struct Memory {
  std::vector<std::unique_ptr<unsigned char[]>> blocks;
  unsigned char* take(size_t bytes) {
    blocks.push_back(std::make_unique<unsigned char[]>(bytes + 64));
    return blocks.back().get();
  }
};

size_t size_of(GLenum type) {
  switch (type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE: return 1;
  case GL_SHORT:
  case GL_UNSIGNED_SHORT: return 2;
  case GL_DOUBLE: return 8;
  default: return 4;
  }
}

// Stores `value` as `type`: colors and normals use the type's range, coordinates its integers.
void store(unsigned char* p, GLenum type, float value, bool normalized) {
  auto put = [&](auto x) { std::memcpy(p, &x, sizeof x); };
  switch (type) {
  case GL_FLOAT: put(value); break;
  case GL_DOUBLE: put(double(value)); break;
  case GL_BYTE: put(GLbyte(normalized ? value * 127 : value)); break;
  case GL_UNSIGNED_BYTE: put(GLubyte(normalized ? value * 255 : value)); break;
  case GL_SHORT: put(GLshort(normalized ? value * 32767 : value)); break;
  case GL_UNSIGNED_SHORT: put(GLushort(normalized ? value * 65535 : value)); break;
  case GL_INT: put(GLint(normalized ? double(value) * 2147483647.0 : double(value))); break;
  default: put(GLuint(normalized ? double(value) * 4294967295.0 : double(value))); break;
  }
}

struct Array {
  int size;
  GLenum type;
  GLsizei stride; // as given to GL
  unsigned char* data;
  const void* pointer; // data, or an offset into the buffer bound
};

// Binds a new buffer. False where it found no memory: an offset would be an address then.
bool bind_new_buffer(const Gl& gl, GLenum target, GLenum binding) {
  GLuint buffer = 0;
  GLint bound = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.GetIntegerv(binding, &bound);
  return bound != 0 && GLuint(bound) == buffer;
}

// An array of `count` vertices; `value(i, component)` makes the numbers.
template <class F> Array make_array(Stage& s, Memory& memory, int count, int size, GLenum type,
                                    bool normalized, bool vbo, F value) {
  const size_t element = size_of(type) * size_t(size);
  const GLsizei stride =
      s.random.chance(50) ? 0
                          : GLsizei((element + size_of(type) * size_t(s.random.integer(0, 3)) + 3) / 4 * 4);
  const size_t step = stride ? size_t(stride) : element;
  Array a{size, type, stride, memory.take(step * size_t(count)), nullptr};
  for (int i = 0; i < count; i++)
    for (int c = 0; c < size; c++)
      store(a.data + step * size_t(i) + size_of(type) * size_t(c), type, value(i, c), normalized);
  a.pointer = a.data;
  if (vbo) {
    const size_t offset = size_of(type) * size_t(s.random.integer(0, 3)), bytes = step * size_t(count);
    const bool bound = bind_new_buffer(s.gl, GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING);
    if (s.random.chance(50)) {
      s.gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes + offset), nullptr, GL_STATIC_DRAW);
      s.gl.BufferSubData(GL_ARRAY_BUFFER, GLintptr(offset), GLsizeiptr(bytes), a.data);
    } else {
      s.gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes + offset), nullptr, GL_DYNAMIC_DRAW);
      void* map = s.gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
      if (map) std::memcpy(static_cast<char*>(map) + offset, a.data, bytes);
      s.gl.UnmapBuffer(GL_ARRAY_BUFFER);
    }
    if (bound)
      a.pointer = reinterpret_cast<const void*>(offset);
    else
      s.gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  } else {
    s.gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  }
  return a;
}

void draw_batch(Stage& s, Memory& memory) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_projection(s);
  random_modelview(s);
  random_depth(s, 30);
  for (GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_SECONDARY_COLOR_ARRAY,
                       GL_FOG_COORDINATE_ARRAY, GL_TEXTURE_COORD_ARRAY})
    gl.DisableClientState(array);
  const GLenum mode = r.chance(20) ? GLenum(r.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}))
                                   : random_filled_mode(s);
  const bool smooth =
      mode == GL_QUADS ? false : r.chance(70); // smooth quads from arrays: reference/DEVIATIONS.md
  gl.ShadeModel(smooth ? GL_SMOOTH : GL_FLAT);
  gl.PointSize(5);
  gl.LineWidth(2);
  const int primitives = r.chance(80) ? r.integer(1, 20) : r.integer(20, 300);
  const int count = vertices_of(mode, primitives);
  const std::vector<Float4> p =
      random_positions(s, mode, count, r.chance(70) ? Spread::View : Spread::Any, false);
  const bool vbo = r.chance(40);
  const Float4 current = r.color(); // arrays leave an undefined current color behind them (2.8)
  gl.Color4fv(current.data());
  for (GLenum capability : {GL_LIGHTING, GL_COLOR_SUM, GL_FOG}) gl.Disable(capability);
  if (r.chance(15)) {
    // Interleaved: position and color in one of glInterleavedArrays' formats
    const GLenum format =
        GLenum(r.pick({mode == GL_QUADS ? GL_C3F_V3F : GL_V2F, mode == GL_QUADS ? GL_C3F_V3F : GL_V3F,
                       GL_C4UB_V2F, GL_C4UB_V3F, GL_C3F_V3F, GL_C4F_N3F_V3F,
                       mode == GL_QUADS ? GL_C3F_V3F : GL_T2F_V3F, GL_T2F_C4UB_V3F}));
    std::vector<float> values;
    auto ubyte_color = [&] {
      const uint32_t bits = uint32_t(r.bits());
      float f;
      std::memcpy(&f, &bits, 4);
      values.push_back(f);
    };
    for (int i = 0; i < count; i++) {
      const Float4 c = r.color();
      const Float4& v = p[size_t(i)];
      if (format == GL_T2F_V3F || format == GL_T2F_C4UB_V3F) values.insert(values.end(), {c[0], c[1]});
      if (format == GL_C4UB_V2F || format == GL_C4UB_V3F || format == GL_T2F_C4UB_V3F) ubyte_color();
      if (format == GL_C3F_V3F) values.insert(values.end(), {c[0], c[1], c[2]});
      if (format == GL_C4F_N3F_V3F) values.insert(values.end(), {c[0], c[1], c[2], c[3], 0, 0, 1});
      values.insert(values.end(), {v[0], v[1]});
      if (format != GL_V2F && format != GL_C4UB_V2F) values.push_back(v[2]);
    }
    unsigned char* data = memory.take(values.size() * 4);
    std::memcpy(data, values.data(), values.size() * 4);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.InterleavedArrays(format, 0, data);
  } else {
    const int size = r.integer(2, 4);
    const GLenum type = GLenum(r.pick({GL_FLOAT, GL_FLOAT, GL_FLOAT, GL_DOUBLE, GL_SHORT, GL_INT}));
    const bool integers = type == GL_SHORT || type == GL_INT;
    if (integers) gl.Scalef(0.01f, 0.01f, 0.01f);
    const Array position = make_array(s, memory, count, size, type, false, vbo, [&](int i, int c) {
      const float v = p[size_t(i)][size_t(c)] * (integers && c < 3 ? 100.0f : 1.0f);
      return integers ? std::min(30000.0f, std::max(-30000.0f, v)) : v;
    });
    gl.VertexPointer(position.size, position.type, position.stride, position.pointer);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    // Normalized arrays of signed integers and of unsigned int: reference/DEVIATIONS.md. Quads of one color
    // are smooth to OSMesa.
    if (mode == GL_QUADS || r.chance(85)) {
      const GLenum color_type =
          GLenum(r.pick({GL_FLOAT, GL_UNSIGNED_BYTE, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_DOUBLE}));
      const Array color = make_array(s, memory, count, r.integer(3, 4), color_type, true, vbo,
                                     [&](int, int) { return r.real(0, 1); });
      gl.ColorPointer(color.size, color.type, color.stride, color.pointer);
      gl.EnableClientState(GL_COLOR_ARRAY);
    }
    if (r.chance(30)) {
      const GLenum normal_type = GLenum(r.pick({GL_FLOAT, GL_DOUBLE}));
      const Array normal =
          make_array(s, memory, count, 3, normal_type, true, vbo, [&](int, int) { return r.real(-1, 1); });
      gl.NormalPointer(normal.type, normal.stride, normal.pointer);
      gl.EnableClientState(GL_NORMAL_ARRAY);
      gl.Enable(GL_LIGHTING);
      gl.Enable(GL_LIGHT0);
      gl.Enable(GL_NORMALIZE);
      gl.Enable(GL_COLOR_MATERIAL);
    }
    if (r.chance(20)) {
      const GLenum secondary_type =
          GLenum(r.pick({GL_FLOAT, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_DOUBLE}));
      const Array secondary =
          make_array(s, memory, count, 3, secondary_type, true, vbo, [&](int, int) { return r.real(0, 1); });
      gl.SecondaryColorPointer(secondary.size, secondary.type, secondary.stride, secondary.pointer);
      gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
      gl.Enable(GL_COLOR_SUM);
    }
    if (r.chance(20)) {
      const Array fog = make_array(s, memory, count, 1, GLenum(r.pick({GL_FLOAT, GL_DOUBLE})), false, vbo,
                                   [&](int, int) { return r.real(0, 3); });
      gl.FogCoordPointer(fog.type, fog.stride, fog.pointer);
      gl.EnableClientState(GL_FOG_COORDINATE_ARRAY);
      gl.Fogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
      gl.Enable(GL_FOG);
    }
  }

  // The draw: indices of any type over the vertices, or in order.
  const GLenum index_type =
      GLenum(count <= 256 ? r.pick({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT})
                          : r.pick({GL_UNSIGNED_SHORT, GL_UNSIGNED_INT}));
  unsigned char* indices = memory.take(size_t(count) * 4);
  // Strips of quadrilaterals in another order may be folded, and leave out vertices: reference/DEVIATIONS.md.
  const bool shuffled = r.chance(40) && mode != GL_POLYGON && mode != GL_QUAD_STRIP;
  for (int i = 0; i < count; i++)
    store(indices + size_of(index_type) * size_t(i), index_type,
          float(shuffled ? r.integer(0, count - 1) : i), false);
  const void* index_pointer = indices;
  int command = r.integer(0, 6);
  if (command == 5 && primitives < 4)
    command = 3; // OSMesa draws nothing at all when the first count is 0: reference/DEVIATIONS.md
  const bool index_buffer = vbo && r.chance(50);
  if (index_buffer) {
    const bool bound = bind_new_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER_BINDING);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(size_t(count) * size_of(index_type)), indices,
                  GL_STATIC_DRAW);
    if (bound)
      index_pointer = nullptr;
    else
      gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  }
  const bool in_list = r.chance(12) && command != 6;
  if (in_list) gl.NewList(5, GL_COMPILE);
  switch (command) {
  case 0:
  case 1: {
    const int group =
        vertices_of(mode, 1) > 0 && (mode == GL_TRIANGLES || mode == GL_QUADS || mode == GL_LINES)
            ? vertices_of(mode, 1)
            : 1;
    const int first = mode == GL_POLYGON ? 0 : std::min(count - 1, group * r.integer(0, 2));
    gl.DrawArrays(mode, first, count - first);
    break;
  }
  case 2:
  case 3: gl.DrawElements(mode, count, index_type, index_pointer); break;
  case 4: gl.DrawRangeElements(mode, 0, GLuint(count - 1), count, index_type, index_pointer); break;
  case 5: {
    const int half = (mode == GL_TRIANGLES ? primitives / 2 * 3
                      : mode == GL_QUADS   ? primitives / 2 * 4
                      : mode == GL_LINES   ? primitives / 2 * 2
                                           : count / 2 / 2 * 2);
    const GLint first[2] = {0, half};
    const GLsizei counts[2] = {half, count - half};
    const auto address = reinterpret_cast<uintptr_t>(index_pointer); // or the offset in a buffer
    const void* offsets[2] = {index_pointer,
                              reinterpret_cast<const void*>(address + size_t(half) * size_of(index_type))};
    if (r.chance(50))
      gl.MultiDrawArrays(mode, first, counts, 2);
    else
      gl.MultiDrawElements(mode, counts, index_type, offsets, 2);
    break;
  }
  default:
    gl.Begin(mode);
    for (int i = 0; i < count; i++) gl.ArrayElement(shuffled ? r.integer(0, count - 1) : i);
    gl.End();
  }
  if (in_list) {
    gl.EndList();
    gl.CallList(5);
  }
  if (index_buffer) gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

void draw_arrays(Stage& s) {
  Memory memory;
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) draw_batch(s, memory);
  s.gl.Finish();
}

SceneRegistration arrays{{"arrays", draw_arrays, true}};

} // namespace
} // namespace softgl::test
