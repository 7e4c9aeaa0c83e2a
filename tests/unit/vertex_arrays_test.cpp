// Vertex arrays and buffer objects (GL 1.5, 2.8 and 2.9): that they give the vertices of immediate mode,
// whatever the layout, and their errors.
#include <catch2/catch.hpp>

#include <cstring>

#include "commands/generated/commands.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/index_range.h"
#include "context/buffer_objects.h"
#include "support/random.h"
#include "unit/recorded_draws.h"

using namespace softgl;
using namespace softgl::test;

namespace {

struct Error {
  Context& c;
  GLenum operator()() const { return std::exchange(c.error, GLenum(GL_NO_ERROR)); }
};
void close(Context& c) {
  if (c.guard & kRunPending) close_run(c);
}

/// Position xyz, normal, color as 4 bytes, texture coordinates: 36 bytes.
struct Vertex {
  float position[3], normal[3];
  unsigned char color[4];
  float texcoord[2];
};
std::vector<Vertex> some_vertices(int count) {
  std::vector<Vertex> v;
  for (int i = 0; i < count; ++i) {
    const auto f = float(i);
    v.push_back({{f, f + 0.5f, -f}, {0, f, 1}, {255, 0, (unsigned char)(i % 2 * 255), 255}, {f / 8, 1 - f}});
  }
  return v;
}
void set_pointers(Context& c, const Vertex* v) {
  const auto at = [&](size_t offset) {
    return reinterpret_cast<const void*>(reinterpret_cast<uintptr_t>(v) + offset);
  };
  gl::VertexPointer(c, 3, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, position)));
  gl::NormalPointer(c, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, normal)));
  gl::ColorPointer(c, 4, GL_UNSIGNED_BYTE, sizeof(Vertex), at(offsetof(Vertex, color)));
  gl::TexCoordPointer(c, 2, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, texcoord)));
  for (GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY})
    gl::EnableClientState(c, array);
}
std::vector<ExpandedPrimitive> immediate(GLenum mode, const std::vector<Vertex>& v,
                                         const std::vector<GLuint>& indices) {
  auto c = make_recording_context();
  gl::Begin(*c, mode);
  for (GLuint i : indices) {
    set_attribute3(*c, kNormal, v[i].normal[0], v[i].normal[1], v[i].normal[2]);
    set_attribute4(*c, kColor, v[i].color[0] / 255.f, v[i].color[1] / 255.f, v[i].color[2] / 255.f,
                   v[i].color[3] / 255.f);
    set_attribute2(*c, kTexCoord0, v[i].texcoord[0], v[i].texcoord[1]);
    emit_vertex3(*c, v[i].position[0], v[i].position[1], v[i].position[2]);
  }
  gl::End(*c);
  close(*c);
  return recorded_primitives(*c);
}
template <class T> std::vector<T> narrowed(const std::vector<GLuint>& indices) {
  return {indices.begin(), indices.end()};
}

void buffer(Context& c, GLenum target, GLuint name, const void* data, size_t bytes) {
  gl::BindBuffer(c, target, name);
  gl::BufferData(c, target, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
}

} // namespace

TEST_CASE("arrays give the vertices of immediate mode", "[vertex][arrays]") {
  const std::vector<Vertex> vertices = some_vertices(200);
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const GLenum mode = GLenum(random.integer(0, 9));
    const bool in_buffer = random.integer(0, 1), indices_in_buffer = random.integer(0, 1),
               in_list = random.integer(0, 3) == 0;
    const int size = random.integer(0, 2), low = random.integer(0, 150), high = low + random.integer(1, 40);
    std::vector<GLuint> indices;
    const int count = random.integer(0, 60);
    for (int i = 0; i < count; ++i) indices.push_back(GLuint(random.integer(low, high)));
    INFO("seed " << seed << ", mode " << mode);
    const auto expected = immediate(mode, vertices, indices);

    auto c = make_recording_context();
    if (in_buffer) buffer(*c, GL_ARRAY_BUFFER, 7, vertices.data(), vertices.size() * sizeof(Vertex));
    set_pointers(*c, in_buffer ? nullptr : vertices.data());
    auto bytes = narrowed<GLubyte>(indices);
    auto shorts = narrowed<GLushort>(indices);
    const void* data = size == 0   ? static_cast<const void*>(bytes.data())
                       : size == 1 ? static_cast<const void*>(shorts.data())
                                   : indices.data();
    const GLenum type = size == 0 ? GL_UNSIGNED_BYTE : size == 1 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    if (indices_in_buffer) {
      buffer(*c, GL_ELEMENT_ARRAY_BUFFER, 8, data, size_t(count) << size);
      data = nullptr;
    }
    if (in_list) gl::NewList(*c, 1, GL_COMPILE);
    gl::DrawElements(*c, mode, count, type, data);
    if (in_list) {
      gl::EndList(*c);
      gl::CallList(*c, 1);
    }
    CHECK(c->error == GL_NO_ERROR);
    // The copies are the frame's own.
    std::fill(bytes.begin(), bytes.end(), 0);
    std::fill(shorts.begin(), shorts.end(), 0);
    std::fill(indices.begin(), indices.end(), 0);
    CHECK(recorded_primitives(*c) == expected);
  }
}

TEST_CASE("DrawArrays, MultiDraw and ArrayElement give the same vertices", "[vertex][arrays]") {
  const std::vector<Vertex> vertices = some_vertices(50);
  const auto expected = immediate(GL_TRIANGLES, vertices, {10, 11, 12, 13, 14, 15});
  auto c = make_recording_context();
  set_pointers(*c, vertices.data());
  gl::DrawArrays(*c, GL_TRIANGLES, 10, 7);
  const GLint first[3] = {10, 3, 13};
  const GLsizei count[3] = {3, 0, 3};
  gl::MultiDrawArrays(*c, GL_TRIANGLES, first, count, 3);
  const GLubyte six[6] = {10, 11, 12, 13, 14, 15};
  const void* lists[2] = {six, six + 3};
  const GLsizei three[2] = {3, 3};
  gl::MultiDrawElements(*c, GL_TRIANGLES, three, GL_UNSIGNED_BYTE, lists, 2);
  gl::DrawRangeElements(*c, GL_TRIANGLES, 10, 15, 6, GL_UNSIGNED_BYTE, six);
  gl::Begin(*c, GL_TRIANGLES);
  for (GLint i : six) gl::ArrayElement(*c, i);
  gl::End(*c);
  close(*c);
  const auto all = recorded_primitives(*c);
  REQUIRE(all.size() == 10);
  for (size_t i = 0; i < 10; ++i) CHECK(all[i] == expected[i % 2]);
  CHECK(c->error == GL_NO_ERROR);
}

TEST_CASE("indices far apart use only the vertices they name", "[vertex][arrays]") {
  std::vector<Vertex> vertices = some_vertices(100001);
  auto c = make_recording_context();
  set_pointers(*c, vertices.data());
  const GLuint indices[6] = {3, 100000, 50000, 3, 50000, 7};
  gl::DrawElements(*c, GL_TRIANGLES, 6, GL_UNSIGNED_INT, indices);
  REQUIRE(recorded_draws(*c) == 1);
  CHECK(c->frame.items()[0].draw->call.vertex_count == 4);
  CHECK(recorded_primitives(*c) == immediate(GL_TRIANGLES, vertices, {3, 100000, 50000, 3, 50000, 7}));
}

TEST_CASE("arrays with a large stride are read element by element", "[vertex][arrays]") {
  std::vector<float> memory(100 * 5000);
  for (int i = 0; i < 100; ++i) memory[size_t(i) * 5000] = float(i);
  auto c = make_recording_context();
  gl::VertexPointer(*c, 2, GL_FLOAT, 20000, memory.data());
  gl::EnableClientState(*c, GL_VERTEX_ARRAY);
  gl::DrawArrays(*c, GL_POINTS, 5, 90);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 90);
  CHECK(p[0].vertex[0].value[kPosition] == AttributeValue{5, 0, 0, 1});
  CHECK(p[89].vertex[0].value[kPosition] == AttributeValue{94, 0, 0, 1});
  CHECK(c->frame.arena().used() < 100000);
}

TEST_CASE("a buffer that changes does not change the draws before", "[vertex][arrays]") {
  std::vector<Vertex> vertices = some_vertices(3);
  const auto before = immediate(GL_TRIANGLES, vertices, {0, 1, 2});
  auto c = make_recording_context();
  buffer(*c, GL_ARRAY_BUFFER, 1, vertices.data(), 3 * sizeof(Vertex));
  set_pointers(*c, nullptr);
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3);
  const float moved[3] = {9, 9, 9};
  gl::BufferSubData(*c, GL_ARRAY_BUFFER, 0, 12, moved);
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3);
  auto* mapped = static_cast<float*>(gl::MapBuffer(*c, GL_ARRAY_BUFFER, GL_READ_WRITE));
  REQUIRE(mapped);
  CHECK(mapped[0] == 9);
  mapped[0] = 5;
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3);
  CHECK(Error{*c}() == GL_INVALID_OPERATION); // mapped
  CHECK(gl::UnmapBuffer(*c, GL_ARRAY_BUFFER));
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3);
  gl::BufferData(*c, GL_ARRAY_BUFFER, 3 * sizeof(Vertex), vertices.data(), GL_STREAM_DRAW);
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3);
  const GLuint name = 1;
  gl::DeleteBuffers(*c, 1, &name);
  gl::DrawArrays(*c, GL_TRIANGLES, 0, 3); // the arrays are gone
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 4);
  CHECK(p[0] == before[0]);
  CHECK(p[1].vertex[0].value[kPosition] == AttributeValue{9, 9, 9, 1});
  CHECK(p[2].vertex[0].value[kPosition] == AttributeValue{5, 9, 9, 1});
  CHECK(p[3] == before[0]);
}

TEST_CASE("indices and vertices behind the end of a buffer do no harm", "[vertex][arrays]") {
  std::vector<Vertex> vertices = some_vertices(4);
  auto c = make_recording_context();
  buffer(*c, GL_ARRAY_BUFFER, 1, vertices.data(), 4 * sizeof(Vertex));
  set_pointers(*c, nullptr);
  gl::DrawArrays(*c, GL_POINTS, 2, 1000000);
  CHECK(recorded_primitives(*c).size() == 2);
  gl::DrawArrays(*c, GL_POINTS, 1 << 30, 1 << 30);
  const GLuint indices[4] = {0, 1, 0xffffffffu, 2};
  gl::DrawElements(*c, GL_POINTS, 4, GL_UNSIGNED_INT, indices);
  auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 6);
  CHECK(p[4].vertex[0].value[kPosition] == AttributeValue{0, 0, 0, 1});
  buffer(*c, GL_ELEMENT_ARRAY_BUFFER, 2, indices, 8);
  gl::DrawElements(*c, GL_POINTS, 100, GL_UNSIGNED_INT, nullptr);
  CHECK(recorded_primitives(*c).size() == 8);
  gl::DrawElements(*c, GL_POINTS, 1, GL_UNSIGNED_INT, reinterpret_cast<void*>(8));
  gl::DrawElements(*c, GL_POINTS, 1, GL_UNSIGNED_INT, reinterpret_cast<void*>(~uintptr_t(0)));
  gl::VertexPointer(*c, 3, GL_FLOAT, 0, reinterpret_cast<void*>(~uintptr_t(0)));
  gl::DrawArrays(*c, GL_POINTS, 0, 5);
  CHECK(recorded_primitives(*c).size() == 8);
  CHECK(c->error == GL_NO_ERROR);
}

TEST_CASE("the fourteen interleaved formats", "[vertex][arrays]") {
  // Offsets in floats of texture coordinates, color, normal, position (-1: none) and the size, of table 2.5.
  static constexpr int formats[14][5] = {
      {-1, -1, -1, 0, 2}, {-1, -1, -1, 0, 3}, {-1, 0, -1, 1, 3}, {-1, 0, -1, 1, 4}, {-1, 0, -1, 3, 6},
      {-1, -1, 0, 3, 6},  {-1, 0, 4, 7, 10},  {0, -1, -1, 2, 5}, {0, -1, -1, 4, 8}, {0, 2, -1, 3, 6},
      {0, 2, -1, 5, 8},   {0, -1, 2, 5, 8},   {0, 2, 6, 9, 12},  {0, 4, 8, 11, 15}};
  float memory[64] = {};
  auto c = make_recording_context();
  for (GLenum i = 0; i < 14; ++i) {
    gl::InterleavedArrays(*c, GL_V2F + i, 0, memory);
    const int slots[4] = {kTexCoord0, kColor, kNormal, kPosition};
    INFO("format " << i);
    for (int k = 0; k < 4; ++k) {
      const VertexArray& a = c->client.vertex_array.array[slots[k]];
      CHECK(a.enabled == (formats[i][k] >= 0));
      if (!a.enabled) continue;
      CHECK(static_cast<const float*>(a.pointer) - memory == formats[i][k]);
      CHECK(a.stride == 4 * formats[i][4]);
    }
  }
  gl::InterleavedArrays(*c, GL_V3F, 100, memory);
  CHECK(c->client.vertex_array.array[kPosition].stride == 100);
  gl::InterleavedArrays(*c, GL_V2F - 1, 0, memory);
  CHECK(Error{*c}() == GL_INVALID_ENUM);
  gl::InterleavedArrays(*c, GL_V2F, -1, memory);
  CHECK(Error{*c}() == GL_INVALID_VALUE);
}

TEST_CASE("errors of vertex arrays", "[vertex][arrays]") {
  auto c = make_recording_context();
  const Error error{*c};
  float memory[16] = {};
  gl::VertexPointer(*c, 1, GL_FLOAT, 0, memory);
  CHECK(error() == GL_INVALID_VALUE);
  gl::VertexPointer(*c, 3, GL_BYTE, 0, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::VertexPointer(*c, 3, GL_FLOAT, -4, memory);
  CHECK(error() == GL_INVALID_VALUE);
  CHECK(c->client.vertex_array.array[kPosition].pointer == nullptr);
  gl::NormalPointer(*c, GL_UNSIGNED_BYTE, 0, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::ColorPointer(*c, 2, GL_FLOAT, 0, memory);
  CHECK(error() == GL_INVALID_VALUE);
  gl::ColorPointer(*c, 3, GL_2_BYTES, 0, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::SecondaryColorPointer(*c, 4, GL_FLOAT, 0, memory);
  CHECK(error() == GL_INVALID_VALUE);
  gl::FogCoordPointer(*c, GL_INT, 0, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::IndexPointer(*c, GL_BYTE, 0, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::EdgeFlagPointer(*c, -1, memory);
  CHECK(error() == GL_INVALID_VALUE);
  gl::TexCoordPointer(*c, 5, GL_FLOAT, 0, memory);
  CHECK(error() == GL_INVALID_VALUE);
  gl::ClientActiveTexture(*c, GL_TEXTURE0 + kMaxTextureUnits);
  CHECK(error() == GL_INVALID_ENUM);
  gl::DrawArrays(*c, GL_POLYGON + 1, 0, 3);
  CHECK(error() == GL_INVALID_ENUM);
  gl::DrawArrays(*c, GL_POINTS, 0, -1);
  CHECK(error() == GL_INVALID_VALUE);
  gl::DrawArrays(*c, GL_POINTS, -1, 1);
  CHECK(error() == GL_INVALID_VALUE);
  gl::DrawElements(*c, GL_POINTS, 1, GL_INT, memory);
  CHECK(error() == GL_INVALID_ENUM);
  gl::DrawRangeElements(*c, GL_POINTS, 2, 1, 1, GL_UNSIGNED_INT, memory);
  CHECK(error() == GL_INVALID_VALUE);
  const GLsizei bad[2] = {1, -1};
  const GLint zero[2] = {0, 0};
  gl::MultiDrawArrays(*c, GL_POINTS, zero, bad, 2);
  CHECK(error() == GL_INVALID_VALUE);
  gl::MultiDrawArrays(*c, GL_POINTS, zero, bad, -2);
  CHECK(error() == GL_INVALID_VALUE);
  void* pointer = nullptr;
  gl::GetPointerv(*c, GL_VERTEX_ARRAY, &pointer);
  CHECK(error() == GL_INVALID_ENUM);
  gl::ClientActiveTexture(*c, GL_TEXTURE3);
  gl::TexCoordPointer(*c, 2, GL_SHORT, 8, memory);
  gl::GetPointerv(*c, GL_TEXTURE_COORD_ARRAY_POINTER, &pointer);
  CHECK(pointer == memory);
  // Arrays that are enabled without a pointer, and positions that are not enabled, draw nothing.
  gl::EnableClientState(*c, GL_TEXTURE_COORD_ARRAY);
  gl::EnableClientState(*c, GL_COLOR_ARRAY);
  gl::DrawArrays(*c, GL_POINTS, 0, 1);
  CHECK(error() == GL_NO_ERROR);
  CHECK(recorded_draws(*c) == 0);
}

TEST_CASE("errors and queries of buffer objects", "[vertex][buffers]") {
  auto c = make_recording_context();
  const Error error{*c};
  GLint value = 0;
  gl::BindBuffer(*c, GL_TEXTURE_2D, 1);
  CHECK(error() == GL_INVALID_ENUM);
  gl::BufferData(*c, GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
  CHECK(error() == GL_INVALID_OPERATION);
  gl::GetBufferParameteriv(*c, GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &value);
  CHECK(error() == GL_INVALID_OPERATION);
  GLuint names[2];
  gl::GenBuffers(*c, -1, names);
  CHECK(error() == GL_INVALID_VALUE);
  gl::GenBuffers(*c, 2, names);
  CHECK_FALSE(gl::IsBuffer(*c, names[0])); // only reserved
  gl::BindBuffer(*c, GL_ARRAY_BUFFER, names[0]);
  CHECK(gl::IsBuffer(*c, names[0]));
  gl::BufferData(*c, GL_ARRAY_BUFFER, -4, nullptr, GL_STATIC_DRAW);
  CHECK(error() == GL_INVALID_VALUE);
  gl::BufferData(*c, GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW - 1);
  CHECK(error() == GL_INVALID_ENUM);
  gl::BufferData(*c, GL_ARRAY_BUFFER, GLsizeiptr(1) << 61, nullptr, GL_STATIC_DRAW);
  CHECK(error() == GL_OUT_OF_MEMORY);
  gl::BufferData(*c, GL_ARRAY_BUFFER, 8, "abcdefg", GL_DYNAMIC_READ);
  gl::BufferSubData(*c, GL_ARRAY_BUFFER, 6, 3, "xyz");
  CHECK(error() == GL_INVALID_VALUE);
  gl::BufferSubData(*c, GL_ARRAY_BUFFER, 1, 2, "XY");
  char back[8] = {};
  gl::GetBufferSubData(*c, GL_ARRAY_BUFFER, 0, 8, back);
  CHECK(std::strcmp(back, "aXYdefg") == 0);
  gl::GetBufferSubData(*c, GL_ARRAY_BUFFER, -1, 8, back);
  CHECK(error() == GL_INVALID_VALUE);
  CHECK(gl::MapBuffer(*c, GL_ARRAY_BUFFER, GL_STATIC_DRAW) == nullptr);
  CHECK(error() == GL_INVALID_ENUM);
  CHECK_FALSE(gl::UnmapBuffer(*c, GL_ARRAY_BUFFER));
  CHECK(error() == GL_INVALID_OPERATION);
  void* p = gl::MapBuffer(*c, GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  void* again = nullptr;
  gl::GetBufferPointerv(*c, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &again);
  CHECK((p && p == again));
  CHECK(gl::MapBuffer(*c, GL_ARRAY_BUFFER, GL_WRITE_ONLY) == nullptr);
  CHECK(error() == GL_INVALID_OPERATION);
  gl::BufferSubData(*c, GL_ARRAY_BUFFER, 0, 1, "x");
  CHECK(error() == GL_INVALID_OPERATION);
  const auto parameter = [&](GLenum name) {
    gl::GetBufferParameteriv(*c, GL_ARRAY_BUFFER, name, &value);
    return GLenum(value);
  };
  CHECK(parameter(GL_BUFFER_SIZE) == 8);
  CHECK(parameter(GL_BUFFER_USAGE) == GL_DYNAMIC_READ);
  CHECK(parameter(GL_BUFFER_ACCESS) == GL_WRITE_ONLY);
  CHECK(parameter(GL_BUFFER_MAPPED) == GL_TRUE);
  CHECK(gl::UnmapBuffer(*c, GL_ARRAY_BUFFER));
  CHECK(parameter(GL_BUFFER_MAPPED) == GL_FALSE);
  CHECK(error() == GL_NO_ERROR);
  gl::GetBufferParameteriv(*c, GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &value);
  CHECK(error() == GL_INVALID_ENUM);
  gl::DeleteBuffers(*c, -1, names);
  CHECK(error() == GL_INVALID_VALUE);
  gl::DeleteBuffers(*c, 2, names);
  CHECK(c->client.vertex_array.array_buffer == 0);
  CHECK_FALSE(gl::IsBuffer(*c, names[0]));
  gl::BindBuffer(*c, GL_ARRAY_BUFFER, 0);
  CHECK(error() == GL_NO_ERROR);
}

TEST_CASE("the range of indices of any type and alignment", "[vertex][arrays]") {
  Random random(3);
  std::vector<unsigned char> memory(4 * 10000 + 8);
  for (auto& byte : memory) byte = (unsigned char)(random.bits());
  for (GLenum type : {GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_UNSIGNED_INT})
    for (int round = 0; round < 100; ++round) {
      const uint32_t count = uint32_t(random.integer(1, 9000));
      const unsigned char* data = memory.data() + random.integer(0, 7);
      IndexRange expected{~0u, 0};
      for (uint32_t i = 0; i < count; ++i) {
        const uint32_t v = load_index(data, type, i);
        expected = {std::min(expected.low, v), std::max(expected.high, v)};
      }
      std::vector<unsigned char> copy(count * index_bytes(type));
      for (const IndexRange r :
           {index_range(data, type, count), copy_indices(data, type, count, copy.data())}) {
        CHECK(r.low == expected.low);
        CHECK(r.high == expected.high);
      }
      CHECK(std::memcmp(copy.data(), data, copy.size()) == 0);
    }
}
