#include "unit/recorded_draws.h"

#include <cstring>

#include "commands/vertices/index_range.h"

namespace softgl::test {
namespace {

template <class T> float component(const unsigned char* p, bool normalized) {
  T v;
  std::memcpy(&v, p, sizeof v);
  if (!normalized || std::is_floating_point_v<T>) return float(v);
  return float(v) / float(std::numeric_limits<T>::max()); // exact enough for the unsigned bytes of the tests
}

float load(const AttributeStream& s, const unsigned char* p, int i) {
  switch (s.type) {
  case ComponentType::Float: return component<GLfloat>(p + 4 * i, false);
  case ComponentType::Double: return component<GLdouble>(p + 8 * i, false);
  case ComponentType::Byte: return component<GLbyte>(p + i, s.normalized);
  case ComponentType::UnsignedByte: return component<GLubyte>(p + i, s.normalized);
  case ComponentType::Short: return component<GLshort>(p + 2 * i, s.normalized);
  case ComponentType::UnsignedShort: return component<GLushort>(p + 2 * i, s.normalized);
  case ComponentType::Int: return component<GLint>(p + 4 * i, s.normalized);
  default: return component<GLuint>(p + 4 * i, s.normalized);
  }
}

ExpandedVertex expand(const DrawCall& call, uint32_t element) {
  const uint32_t index = call.indices ? load_index(call.indices, call.index_type, element) : element;
  if (index - call.first_vertex >= call.vertex_count)
    throw std::out_of_range("a vertex outside of the draw's range");
  ExpandedVertex v;
  for (int slot = 0; slot < kAttributeSlots; ++slot) {
    if (call.source->present >> slot & 1) {
      const AttributeStream& s = call.source->stream[slot];
      v.value[slot] = {0, 0, 0, 1};
      const auto* p = reinterpret_cast<const unsigned char*>(reinterpret_cast<uintptr_t>(s.data) +
                                                             uintptr_t(index) * s.stride);
      for (int i = 0; i < s.components; ++i) v.value[slot][i] = load(s, p, i);
    } else if (slot < kMaterial0) {
      std::memcpy(&v.value[slot], &call.constant[slot], 16);
    }
  }
  return v;
}

void assemble(const DrawCall& call, const PrimitiveRange& r, std::vector<ExpandedPrimitive>& out) {
  std::vector<ExpandedVertex> v;
  for (uint32_t i = 0; i < r.count; ++i) v.push_back(expand(call, r.first + i));
  const size_t n = v.size();
  const auto add = [&](GLenum mode, std::initializer_list<size_t> corners) {
    ExpandedPrimitive p{mode, {}};
    for (size_t i : corners) p.vertex.push_back(v[i]);
    out.push_back(std::move(p));
  };
  switch (r.mode) {
  case GL_POINTS:
    for (size_t i = 0; i < n; ++i) add(GL_POINTS, {i});
    break;
  case GL_LINES:
    for (size_t i = 0; i + 1 < n; i += 2) add(GL_LINES, {i, i + 1});
    break;
  case GL_LINE_STRIP:
    for (size_t i = 0; i + 1 < n; ++i) add(GL_LINES, {i, i + 1});
    break;
  case GL_LINE_LOOP:
    for (size_t i = r.begins ? 0 : 1; i + 1 < n; ++i) add(GL_LINES, {i, i + 1});
    if (r.ends) add(GL_LINES, {n - 1, 0});
    break;
  case GL_TRIANGLES:
    for (size_t i = 0; i + 2 < n; i += 3) add(GL_TRIANGLES, {i, i + 1, i + 2});
    break;
  case GL_TRIANGLE_STRIP:
    for (size_t i = 0; i + 2 < n; ++i)
      i % 2 ? add(GL_TRIANGLES, {i + 1, i, i + 2}) : add(GL_TRIANGLES, {i, i + 1, i + 2});
    break;
  case GL_QUADS:
    for (size_t i = 0; i + 3 < n; i += 4) add(GL_QUADS, {i, i + 1, i + 2, i + 3});
    break;
  case GL_QUAD_STRIP:
    for (size_t i = 0; i + 3 < n; i += 2) add(GL_QUADS, {i, i + 1, i + 3, i + 2});
    break;
  default:
    for (size_t i = 2; i < n; ++i) add(GL_TRIANGLES, {0, i - 1, i}); // fan, polygon
  }
}

} // namespace

std::unique_ptr<Context> make_recording_context() {
  auto c = std::make_unique<Context>();
  c->framebuffer.surface.width = c->framebuffer.surface.height = 64;
  return c;
}

std::vector<ExpandedPrimitive> recorded_primitives(const Context& c) {
  std::vector<ExpandedPrimitive> out;
  for (const auto& item : c.frame.items())
    if (item.draw)
      for (uint32_t i = 0; i < item.draw->call.primitive_count; ++i)
        assemble(item.draw->call, item.draw->call.primitives[i], out);
  return out;
}

size_t recorded_draws(const Context& c) {
  size_t n = 0;
  for (const auto& item : c.frame.items()) n += item.draw != nullptr;
  return n;
}

} // namespace softgl::test
