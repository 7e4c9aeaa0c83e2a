// Vertex arrays (2.8).
#include <cstring>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

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

// As the commands with the type's letter take it (table 2.9).
double unit(double x, GLenum type) {
  switch (type) {
  case GL_BYTE: return signed_unit(x, 8);
  case GL_SHORT: return signed_unit(x, 16);
  case GL_INT: return signed_unit(x, 32);
  case GL_UNSIGNED_BYTE: return x / 255;
  case GL_UNSIGNED_SHORT: return x / 65535;
  case GL_UNSIGNED_INT: return x / 4294967295.0;
  default: return x;
  }
}

V element(const ArrayState& array, int index, bool units) {
  V v;
  for (int i = 0; i < array.size; i++) {
    const double x = array.elements.at(size_t(index * array.stride + i));
    v.push_back(units ? unit(x, array.type) : x);
  }
  return v;
}

// A row of table 2.5.
struct Format {
  GLenum name;
  int texture, color; // components, 0: none
  GLenum color_type;
  bool normal;
  int vertex, color_at, normal_at, vertex_at, stride; // offsets in bytes
};
constexpr Format kFormats[] = {
    {GL_V2F, 0, 0, 0, false, 2, 0, 0, 0, 8},
    {GL_V3F, 0, 0, 0, false, 3, 0, 0, 0, 12},
    {GL_C4UB_V2F, 0, 4, GL_UNSIGNED_BYTE, false, 2, 0, 0, 4, 12},
    {GL_C4UB_V3F, 0, 4, GL_UNSIGNED_BYTE, false, 3, 0, 0, 4, 16},
    {GL_C3F_V3F, 0, 3, GL_FLOAT, false, 3, 0, 0, 12, 24},
    {GL_N3F_V3F, 0, 0, 0, true, 3, 0, 0, 12, 24},
    {GL_C4F_N3F_V3F, 0, 4, GL_FLOAT, true, 3, 0, 16, 28, 40},
    {GL_T2F_V3F, 2, 0, 0, false, 3, 0, 0, 8, 20},
    {GL_T4F_V4F, 4, 0, 0, false, 4, 0, 0, 16, 32},
    {GL_T2F_C4UB_V3F, 2, 4, GL_UNSIGNED_BYTE, false, 3, 8, 0, 12, 24},
    {GL_T2F_C3F_V3F, 2, 3, GL_FLOAT, false, 3, 8, 0, 20, 32},
    {GL_T2F_N3F_V3F, 2, 0, 0, true, 3, 0, 8, 20, 32},
    {GL_T2F_C4F_N3F_V3F, 2, 4, GL_FLOAT, true, 3, 8, 24, 36, 48},
    {GL_T4F_C4F_N3F_V4F, 4, 4, GL_FLOAT, true, 4, 16, 32, 44, 60},
};

} // namespace

void Machine::set_array(ArrayState& array, int size, GLenum type, int stride, const Argument& memory) {
  const int bytes = int(size_of(type));
  if (stride % bytes || memory.memory_type != type)
    throw std::logic_error("an array that does not lie on its elements");
  array.size = size, array.type = type, array.stride = stride ? stride / bytes : size;
  array.given_stride = stride;
  array.elements = memory.numbers;
}

void Machine::interleaved_arrays(const Call& call) {
  for (const Format& f : kFormats) {
    if (f.name != call.e(0)) continue;
    const size_t stride = call.n(1) != 0 ? size_t(call.n(1)) : size_t(f.stride);
    const std::vector<double>& bytes = call.v(2); // of any type, as bytes
    const auto set = [&](ArrayState& array, int size, GLenum type, int offset) {
      array.on = size > 0;
      if (!size) return;
      array.size = array.stride = size, array.type = type, array.elements.clear();
      array.given_stride = int(stride);
      for (size_t first = size_t(offset); first + size_of(type) * size_t(size) <= bytes.size();
           first += stride)
        for (size_t i = 0; i < size_t(size); i++) {
          uint8_t raw[4];
          for (size_t b = 0; b < size_of(type); b++) raw[b] = uint8_t(bytes[first + size_of(type) * i + b]);
          float real;
          std::memcpy(&real, raw, sizeof real);
          array.elements.push_back(type == GL_FLOAT ? double(real) : raw[0]);
        }
    };
    set(state_.color_array, f.color, f.color_type, f.color_at);
    set(state_.normal_array, f.normal ? 3 : 0, GL_FLOAT, f.normal_at);
    set(state_.vertex_array, f.vertex, GL_FLOAT, f.vertex_at);
    set(state_.texture_array, f.texture, GL_FLOAT, 0);
    state_.edge_flag_array.on = false;
    return;
  }
  throw std::logic_error("glInterleavedArrays of what the machine does not know");
}

// The calls that the element stands for: a list that is compiled holds them (5.4).
void Machine::array_element(int index) {
  const State& s = state_;
  Script script;
  if (s.edge_flag_array.on) script.EdgeFlag(element(s.edge_flag_array, index, false)[0]);
  if (s.normal_array.on) {
    const V n = element(s.normal_array, index, true);
    script.Normal3d(n[0], n[1], n[2]);
  }
  if (s.color_array.on) {
    V c = element(s.color_array, index, true);
    if (c.size() < 4) c.push_back(1);
    script.Color4dv(c);
  }
  if (s.texture_array.on) {
    V t = element(s.texture_array, index, false);
    while (t.size() < 4) t.push_back(t.size() == 3);
    script.TexCoord4dv(t);
  }
  if (s.vertex_array.on) {
    V v = element(s.vertex_array, index, false);
    while (v.size() < 4) v.push_back(v.size() == 3);
    script.Vertex4dv(v);
  }
  for (const Call& call : script.calls) play(call);
}

void Machine::draw_elements(GLenum mode, const std::vector<int>& indices) {
  const State& s = state_;
  Script begin, end;
  begin.Begin(mode), end.End();
  play(begin.calls[0]);
  for (int i : indices)
    if (s.vertex_array.on) array_element(i);
  play(end.calls[0]);
  if (s.color_array.on) state_.current.color_known = false;
  if (s.normal_array.on) state_.current.normal_known = false;
  if (s.edge_flag_array.on) state_.current.edge_known = false;
}

bool Machine::play_arrays(const Call& call) {
  State& s = state_;
  const auto n = [&](size_t i) { return int(call.n(i)); };
  const auto enable = [&](bool on) {
    switch (call.e(0)) {
    case GL_VERTEX_ARRAY: s.vertex_array.on = on; break;
    case GL_NORMAL_ARRAY: s.normal_array.on = on; break;
    case GL_COLOR_ARRAY: s.color_array.on = on; break;
    case GL_EDGE_FLAG_ARRAY: s.edge_flag_array.on = on; break;
    case GL_TEXTURE_COORD_ARRAY: s.texture_array.on = on; break;
    default: throw std::logic_error("an array that the machine does not know");
    }
  };
  const auto indices = [&](size_t count_at, size_t memory_at) {
    return std::vector<int>(call.v(memory_at).begin(), call.v(memory_at).begin() + n(count_at));
  };
  switch (call.command) {
  case Command::EnableClientState: enable(true); return true;
  case Command::DisableClientState: enable(false); return true;
  case Command::VertexPointer:
    set_array(s.vertex_array, n(0), call.e(1), n(2), call.arguments[3]);
    return true;
  case Command::ColorPointer: set_array(s.color_array, n(0), call.e(1), n(2), call.arguments[3]); return true;
  case Command::TexCoordPointer:
    set_array(s.texture_array, n(0), call.e(1), n(2), call.arguments[3]);
    return true;
  case Command::NormalPointer: set_array(s.normal_array, 3, call.e(0), n(1), call.arguments[2]); return true;
  case Command::EdgeFlagPointer:
    set_array(s.edge_flag_array, 1, GL_UNSIGNED_BYTE, n(0), call.arguments[1]);
    return true;
  case Command::InterleavedArrays: interleaved_arrays(call); return true;
  case Command::ArrayElement: array_element(n(0)); return true;
  case Command::DrawArrays: {
    std::vector<int> all;
    for (int i = 0; i < n(2); i++) all.push_back(n(1) + i);
    draw_elements(call.e(0), all);
    return true;
  }
  case Command::DrawElements: draw_elements(call.e(0), indices(1, 3)); return true;
  case Command::DrawRangeElements: draw_elements(call.e(0), indices(3, 5)); return true;
  default: return false;
  }
}

} // namespace softgl::suite
