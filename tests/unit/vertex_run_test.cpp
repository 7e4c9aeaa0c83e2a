// Runs of vertices: layout, values, pieces; and that lists replay what immediate mode draws.
#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>

#include "commands/generated/commands.h"
#include "commands/vertices/attribute_doors.h"
#include "support/random.h"
#include "unit/recorded_draws.h"

using namespace softgl;
using namespace softgl::test;

namespace {

using Stream = std::function<void(Context&)>;

/// As the generated doors do for a command that changes state.
void state_change(Context& c) {
  if (c.guard & kRunPending) close_run(c);
}
std::vector<ExpandedPrimitive> immediate(const Stream& stream) {
  auto c = make_recording_context();
  stream(*c);
  state_change(*c);
  CHECK(c->error == GL_NO_ERROR);
  return recorded_primitives(*c);
}
std::vector<ExpandedPrimitive> played(const Stream& stream, GLenum mode, AttributeValue color, int times) {
  auto c = make_recording_context();
  set_attribute4(*c, kColor, color[0], color[1], color[2], color[3]);
  gl::NewList(*c, 1, mode);
  stream(*c);
  gl::EndList(*c);
  for (int i = 0; i < times; ++i) gl::CallList(*c, 1);
  state_change(*c);
  CHECK(c->error == GL_NO_ERROR);
  return recorded_primitives(*c);
}
/// `times` times in immediate mode, with this color before the first.
std::vector<ExpandedPrimitive> repeated(const Stream& stream, AttributeValue color, int times) {
  return immediate([&](Context& c) {
    set_attribute4(c, kColor, color[0], color[1], color[2], color[3]);
    for (int i = 0; i < times; ++i) stream(c);
  });
}
void check_lists(const Stream& stream) {
  const AttributeValue color{0.25f, 0.5f, 0.75f, 1};
  CHECK(played(stream, GL_COMPILE, color, 1) == repeated(stream, color, 1));
  CHECK(played(stream, GL_COMPILE, color, 3) == repeated(stream, color, 3));
  CHECK(played(stream, GL_COMPILE_AND_EXECUTE, color, 2) == repeated(stream, color, 3));
}

AttributeValue value_of(const ExpandedPrimitive& p, int corner, int slot) {
  return p.vertex[size_t(corner)].value[size_t(slot)];
}

void random_stream(Context& c, uint64_t seed) {
  Random random(seed);
  const int primitives = random.integer(1, 12);
  const auto attribute = [&] {
    static constexpr int slots[] = {kNormal,        kColor,          kTexCoord0, kTexCoord0 + 3,
                                    kFogCoordinate, kSecondaryColor, kEdgeFlag};
    set_attribute4(c, slots[random.integer(0, 6)], random.real(-1, 1), random.real(0, 1),
                   float(random.integer(0, 1)), 1);
  };
  for (int i = 0; i < primitives; ++i) {
    while (random.integer(0, 2) == 0) attribute();
    gl::Begin(c, GLenum(random.integer(0, 9)));
    const int vertices = random.integer(0, random.integer(0, 9) ? 9 : 90);
    for (int v = 0; v < vertices; ++v) {
      while (random.integer(0, 3) == 0) attribute();
      emit_vertex3(c, random.real(-1, 1), random.real(-1, 1), float(v));
    }
    if (random.integer(0, 3) == 0) attribute();
    gl::End(c);
  }
}

} // namespace

TEST_CASE("a run stores the attributes that were set and no others", "[vertex]") {
  auto c = make_recording_context();
  gl::Begin(*c, GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    set_attribute3(*c, kNormal, 0, float(i), 1);
    emit_vertex3(*c, float(i), 2, 3);
  }
  gl::End(*c);
  state_change(*c);
  REQUIRE(recorded_draws(*c) == 1);
  const DrawCall& call = c->frame.items()[0].draw->call;
  CHECK(call.source->present == (1u << kPosition | 1u << kNormal));
  CHECK(call.source->stream[kPosition].stride == 32);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 1);
  CHECK(value_of(p[0], 1, kNormal) == AttributeValue{0, 1, 1, 1});
  CHECK(value_of(p[0], 2, kPosition) == AttributeValue{2, 2, 3, 1});
  CHECK(value_of(p[0], 2, kColor) == AttributeValue{1, 1, 1, 1});
  CHECK(c->state.current.slot[kNormal] == Vec4(0, 2, 1, 1));
}

TEST_CASE("an attribute that comes late leaves the earlier vertices their value", "[vertex]") {
  auto c = make_recording_context();
  set_attribute4(*c, kColor, 0.5f, 0, 0, 1);
  gl::Begin(*c, GL_LINES);
  emit_vertex2(*c, 1, 0);
  set_attribute4(*c, kColor, 0, 0.5f, 0, 1);
  emit_vertex2(*c, 2, 0);
  gl::End(*c);
  state_change(*c);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 1);
  CHECK(value_of(p[0], 0, kColor) == AttributeValue{0.5f, 0, 0, 1});
  CHECK(value_of(p[0], 1, kColor) == AttributeValue{0, 0.5f, 0, 1});
}

TEST_CASE("pairs of Begin and End without a state change share a run", "[vertex]") {
  auto c = make_recording_context();
  for (int i = 0; i < 20; ++i) {
    set_attribute3(*c, kColor, float(i), 0, 0);
    gl::Begin(*c, i % 2 ? GL_TRIANGLES : GL_QUADS);
    for (int v = 0; v < 5; ++v) emit_vertex2(*c, float(i), float(v)); // one or two too many
    gl::End(*c);
  }
  state_change(*c);
  // The color of the first one is constant. Behind it the vertices have a color, and all others share a run.
  CHECK(recorded_draws(*c) == 2);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 20);
  for (int i = 0; i < 20; ++i) CHECK(value_of(p[size_t(i)], 0, kColor)[0] == float(i));
}

TEST_CASE("incomplete primitives are dropped", "[vertex]") {
  const int least[10] = {1, 2, 2, 2, 3, 3, 3, 4, 4, 3};
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode)
    for (int count = 0; count < 4; ++count) {
      const auto p = immediate([&](Context& c) {
        gl::Begin(c, mode);
        for (int i = 0; i < count; ++i) emit_vertex2(c, float(i), 0);
        gl::End(c);
      });
      INFO("mode " << mode << ", " << count << " vertices");
      CHECK(p.empty() == (count < least[mode]));
    }
}

TEST_CASE("a primitive larger than a chunk is continued with the right vertices", "[vertex]") {
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode)
    for (int count : {70001, 70002, 70003, 140000}) {
      const Stream stream = [&](Context& c) {
        set_attribute3(c, kColor, 0.1f, 0.2f, 0.3f);
        gl::Begin(c, GL_LINE_STRIP);
        for (int i = 0; i < 3; ++i) emit_vertex2(c, float(i), 7);
        gl::End(c);
        gl::Begin(c, mode);
        for (int i = 0; i < count; ++i) {
          if (i % 3) set_attribute1(c, kFogCoordinate, float(i));
          emit_vertex2(c, float(i), 0);
        }
        gl::End(c);
      };
      auto c = make_recording_context();
      stream(*c);
      state_change(*c);
      INFO("mode " << mode << ", " << count << " vertices");
      CHECK(recorded_draws(*c) > 1);
      const bool same =
          recorded_primitives(*c) == played(stream, GL_COMPILE, {0, 0, 0, 1}, 1); // a list is not cut
      CHECK(same);
    }
}

TEST_CASE("errors of Begin and End", "[vertex]") {
  auto c = make_recording_context();
  gl::End(*c);
  CHECK(std::exchange(c->error, GL_NO_ERROR) == GL_INVALID_OPERATION);
  gl::Begin(*c, GL_POLYGON + 1);
  CHECK(std::exchange(c->error, GL_NO_ERROR) == GL_INVALID_ENUM);
  CHECK_FALSE(c->guard & kInsideBeginEnd);
  gl::Begin(*c, GL_TRIANGLES);
  gl::Begin(*c, GL_TRIANGLES);
  CHECK(std::exchange(c->error, GL_NO_ERROR) == GL_INVALID_OPERATION);
  CHECK(c->guard & kInsideBeginEnd);
  gl::End(*c);
  CHECK(c->error == GL_NO_ERROR);
  emit_vertex2(*c, 1, 1); // undefined, but harmless
  state_change(*c);
  CHECK(recorded_draws(*c) == 0);
}

TEST_CASE("a list replays what immediate mode draws", "[vertex][lists]") {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    INFO("seed " << seed);
    check_lists([&](Context& c) { random_stream(c, seed); });
  }
}

TEST_CASE("equal vertices of a list are joined at its second playing", "[lists]") {
  const Stream stream = [](Context& c) {
    for (GLenum mode : {GL_TRIANGLES, GL_QUAD_STRIP, GL_TRIANGLES}) {
      gl::Begin(c, mode);
      for (int i = 0; i < 600; ++i) {
        set_attribute3(c, kNormal, 0, float(i % 7), 1);
        if (i % 5 == 0) set_attribute2(c, kTexCoord0, float(i % 10), 1);
        emit_vertex3(c, float(i % 20), i % 40 < 20 ? 0.0f : -0.0f, 1); // 0 and -0 are two vertices
      }
      gl::End(c);
    }
  };
  check_lists(stream);
  auto c = make_recording_context();
  gl::NewList(*c, 1, GL_COMPILE);
  stream(*c);
  gl::EndList(*c);
  for (int i = 0; i < 3; ++i) gl::CallList(*c, 1);
  REQUIRE(recorded_draws(*c) == 3);
  CHECK(c->frame.items()[0].draw->call.vertex_count == 1800);
  CHECK(c->frame.items()[2].draw->call.vertex_count < 600);
  // Between Begin and End the list is replayed call by call; its own Begins are errors.
  gl::NewList(*c, 2, GL_COMPILE);
  gl::Begin(*c, GL_POINTS);
  gl::CallList(*c, 1);
  gl::End(*c);
  gl::EndList(*c);
  gl::CallList(*c, 2);
  state_change(*c);
  CHECK(c->error == GL_INVALID_OPERATION);
  const auto p = recorded_primitives(*c);
  CHECK(std::count_if(p.begin(), p.end(), [](const auto& one) { return one.mode == GL_POINTS; }) == 600);
}

TEST_CASE("vertices of a list take the color that is current when it is played", "[lists]") {
  auto c = make_recording_context();
  gl::NewList(*c, 1, GL_COMPILE);
  gl::Begin(*c, GL_LINES);
  emit_vertex2(*c, 1, 0);
  set_attribute4(*c, kColor, 0, 1, 0, 1);
  emit_vertex2(*c, 2, 0);
  gl::End(*c);
  gl::EndList(*c);
  for (float red : {0.25f, 0.5f, 0.5f}) {
    set_attribute4(*c, kColor, red, 0, 0, 1);
    gl::CallList(*c, 1);
    CHECK(c->state.current.slot[kColor] == Vec4(0, 1, 0, 1));
  }
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 3);
  CHECK(value_of(p[0], 0, kColor)[0] == 0.25f);
  CHECK(value_of(p[2], 0, kColor)[0] == 0.5f);
  CHECK(value_of(p[2], 1, kColor)[1] == 1);
}

TEST_CASE("a list that is compiled and executed calls another", "[lists]") {
  auto c = make_recording_context();
  gl::NewList(*c, 1, GL_COMPILE);
  gl::Begin(*c, GL_LINES);
  emit_vertex2(*c, 1, 0);
  set_attribute4(*c, kColor, 0, 1, 0, 1);
  emit_vertex2(*c, 2, 0);
  gl::End(*c);
  gl::EndList(*c);
  gl::NewList(*c, 2, GL_COMPILE_AND_EXECUTE);
  set_attribute4(*c, kColor, 0.25f, 0, 0, 1);
  gl::CallList(*c, 1);
  CHECK(c->state.current.slot[kColor] == Vec4(0, 1, 0, 1));
  gl::EndList(*c);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 1);
  CHECK(value_of(p[0], 0, kColor) == AttributeValue{0.25f, 0, 0, 1});
}

TEST_CASE("a primitive may begin and end in different lists", "[lists]") {
  auto c = make_recording_context();
  gl::NewList(*c, 1, GL_COMPILE);
  gl::Begin(*c, GL_TRIANGLES);
  emit_vertex2(*c, 1, 0);
  gl::EndList(*c);
  gl::NewList(*c, 2, GL_COMPILE);
  set_attribute3(*c, kColor, 0, 1, 0);
  emit_vertex2(*c, 2, 0);
  gl::EndList(*c);
  gl::NewList(*c, 3, GL_COMPILE);
  emit_vertex2(*c, 3, 0);
  gl::End(*c);
  gl::EndList(*c);
  CHECK(c->guard == 0);
  for (GLuint list : {1u, 2u, 3u}) gl::CallList(*c, list);
  gl::NewList(*c, 4, GL_COMPILE);
  gl::Begin(*c, GL_LINES);
  gl::CallList(*c, 2);
  emit_vertex2(*c, 4, 0);
  gl::End(*c);
  gl::EndList(*c);
  gl::CallList(*c, 4);
  state_change(*c);
  CHECK(c->error == GL_NO_ERROR);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == 2);
  CHECK(p[0].mode == GL_TRIANGLES);
  CHECK(value_of(p[0], 0, kColor) == AttributeValue{1, 1, 1, 1});
  CHECK(value_of(p[0], 2, kColor) == AttributeValue{0, 1, 0, 1});
  CHECK(p[1].mode == GL_LINES);
  CHECK(value_of(p[1], 1, kPosition)[0] == 4);
  gl::CallList(*c, 3); // an End without a Begin
  CHECK(c->error == GL_INVALID_OPERATION);
}

TEST_CASE("errors of display lists", "[lists]") {
  auto c = make_recording_context();
  const auto error = [&] { return std::exchange(c->error, GLenum(GL_NO_ERROR)); };
  gl::NewList(*c, 0, GL_COMPILE);
  CHECK(error() == GL_INVALID_VALUE);
  gl::NewList(*c, 1, GL_RENDER);
  CHECK(error() == GL_INVALID_ENUM);
  gl::EndList(*c);
  CHECK(error() == GL_INVALID_OPERATION);
  CHECK(gl::GenLists(*c, -1) == 0);
  CHECK(error() == GL_INVALID_VALUE);
  gl::DeleteLists(*c, 1, -1);
  CHECK(error() == GL_INVALID_VALUE);
  gl::CallLists(*c, -1, GL_UNSIGNED_BYTE, "");
  CHECK(error() == GL_INVALID_VALUE);
  gl::CallLists(*c, 1, GL_DOUBLE, "");
  CHECK(error() == GL_INVALID_ENUM);
  gl::NewList(*c, 5, GL_COMPILE);
  gl::NewList(*c, 6, GL_COMPILE);
  CHECK(error() == GL_INVALID_OPERATION);
  gl::Begin(*c, 77);   // raised when played
  gl::CallList(*c, 5); // itself: ends at the nesting limit
  CHECK(error() == GL_NO_ERROR);
  CHECK_FALSE(gl::IsList(*c, 5));
  gl::EndList(*c);
  CHECK(gl::IsList(*c, 5));
  gl::CallList(*c, 5);
  CHECK(error() == GL_INVALID_ENUM);
  gl::CallList(*c, 1234);
  CHECK(error() == GL_NO_ERROR);
  const GLuint first = gl::GenLists(*c, 3);
  CHECK(first != 0);
  CHECK(gl::IsList(*c, first + 2));
  gl::DeleteLists(*c, first, 0x7fffffff);
  CHECK_FALSE(gl::IsList(*c, first));
  CHECK(error() == GL_NO_ERROR);
}

TEST_CASE("CallLists knows ten types of offsets", "[lists]") {
  auto c = make_recording_context();
  for (GLuint i : {1u, 2u, 300u, 70000u}) {
    gl::NewList(*c, i, GL_COMPILE);
    gl::Begin(*c, GL_POINTS);
    emit_vertex2(*c, float(i), 0);
    gl::End(*c);
    gl::EndList(*c);
  }
  const auto called = [&](GLenum type, const void* lists, GLsizei n = 1) {
    const size_t before = recorded_primitives(*c).size();
    gl::CallLists(*c, n, type, lists);
    const auto p = recorded_primitives(*c);
    return p.size() == before ? 0 : int(value_of(p.back(), 0, kPosition)[0]);
  };
  const GLbyte b = 2;
  const GLubyte ub = 2, two[] = {300 >> 8, 300 & 255}, three[] = {1, 70000 >> 8 & 255, 70000 & 255},
                four[] = {0, 1, 70000 >> 8 & 255, 70000 & 255};
  const GLshort s = 300;
  const GLushort us = 300;
  const GLint i = 70000;
  const GLfloat f = 300.9f;
  CHECK(called(GL_BYTE, &b) == 2);
  CHECK(called(GL_UNSIGNED_BYTE, &ub) == 2);
  CHECK(called(GL_SHORT, &s) == 300);
  CHECK(called(GL_UNSIGNED_SHORT, &us) == 300);
  CHECK(called(GL_INT, &i) == 70000);
  CHECK(called(GL_UNSIGNED_INT, &i) == 70000);
  CHECK(called(GL_FLOAT, &f) == 300);
  CHECK(called(GL_2_BYTES, two) == 300);
  CHECK(called(GL_3_BYTES, three) == 70000);
  CHECK(called(GL_4_BYTES, four) == 70000);
  gl::ListBase(*c, 303);
  const GLshort minus = -3;
  CHECK(called(GL_SHORT, &minus) == 300);
  gl::NewList(*c, 9, GL_COMPILE);
  gl::CallLists(*c, 1, GL_SHORT, &minus);
  gl::EndList(*c);
  gl::ListBase(*c, 4); // the base counts when the list is played
  const size_t before = recorded_primitives(*c).size();
  gl::CallList(*c, 9);
  const auto p = recorded_primitives(*c);
  REQUIRE(p.size() == before + 1);
  CHECK(value_of(p.back(), 0, kPosition)[0] == 1);
}

TEST_CASE("lists may be called 64 deep", "[lists]") {
  auto c = make_recording_context();
  for (GLuint i = 1; i <= 80; ++i) {
    gl::NewList(*c, i, GL_COMPILE);
    gl::Begin(*c, GL_POINTS);
    emit_vertex2(*c, float(i), 0);
    gl::End(*c);
    gl::CallList(*c, i + 1);
    gl::EndList(*c);
  }
  gl::CallList(*c, 1);
  CHECK(recorded_primitives(*c).size() == 64);
}
