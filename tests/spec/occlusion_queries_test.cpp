// Occlusion queries (GL 1.5, 4.1.7 and 6.1.12): their errors, what they count, and when.
#include <catch2/catch.hpp>

#include <functional>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"
#include "support/environment.h"

using namespace softgl::test;

namespace {

GLuint names[4];
GLint numbers[4];

GLuint result_of(const Gl& gl, GLuint query) {
  GLuint count = 0xdeadbeef;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  return count;
}

GLuint count_of(const Gl& gl, GLuint query, const std::function<void()>& draw) {
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  draw();
  gl.EndQuery(GL_SAMPLES_PASSED);
  return result_of(gl, query);
}

GLint current_query(const Gl& gl) {
  GLint name = -1;
  gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &name);
  return name;
}

/// The lower left quarter of the window of 64x64 pixels.
void quarter(const Gl& gl) { gl.Rectf(-1, -1, 0, 0); }

} // namespace

REFUSAL_TEST_CASE("refused commands of queries give the specification's errors and change nothing",
                  "[spec][errors][queries]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.GenQueries(3, names);
  CHECK(count_of(gl, names[0], [&] { quarter(gl); }) == 1024);
  const auto unchanged = [&] {
    CHECK(result_of(gl, names[0]) == 1024);
    CHECK(gl.IsQuery(names[0]) == GL_TRUE);
    CHECK(gl.IsQuery(names[1]) == GL_FALSE);
    CHECK(current_query(gl) == 0);
    CHECK(numbers[0] == 0);
  };
  const BadCall idle[] = {
      BAD(INVALID_VALUE, GenQueries(-1, names)),
      BAD(INVALID_VALUE, DeleteQueries(-1, names)),
      BAD(INVALID_ENUM, BeginQuery(GL_SAMPLES, names[1])),
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, 0)),
      BAD(INVALID_ENUM, EndQuery(GL_QUERY_RESULT)),
      BAD(INVALID_OPERATION, EndQuery(GL_SAMPLES_PASSED)),
      BAD(INVALID_ENUM, GetQueryiv(GL_QUERY_RESULT, GL_CURRENT_QUERY, numbers)),
      BAD(INVALID_ENUM, GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_RESULT, numbers)),
      BAD(INVALID_ENUM, GetQueryObjectiv(names[0], GL_CURRENT_QUERY, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectiv(0, GL_QUERY_RESULT, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectiv(names[1], GL_QUERY_RESULT, numbers)), // not begun
      BAD(INVALID_OPERATION, GetQueryObjectuiv(999, GL_QUERY_RESULT_AVAILABLE, names)),
  };
  expect_refused(gl, idle, unchanged);
  gl.BeginQuery(GL_SAMPLES_PASSED, names[2]);
  quarter(gl);
  const BadCall active[] = {
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, names[0])),
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, names[2])),
      BAD(INVALID_OPERATION, GetQueryObjectiv(names[2], GL_QUERY_RESULT, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectiv(names[2], GL_QUERY_RESULT_AVAILABLE, numbers)),
  };
  expect_refused(gl, active, [&] {
    CHECK(result_of(gl, names[0]) == 1024);
    CHECK(current_query(gl) == GLint(names[2]));
    CHECK(numbers[0] == 0);
  });
  gl.EndQuery(GL_SAMPLES_PASSED);
  CHECK(result_of(gl, names[2]) == 1024);
}

TEST_CASE("names of queries are neither made nor deleted while one is active",
          "[spec][errors][queries][deviation]") {
  fix_environment();
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    gl->BeginQuery(GL_SAMPLES_PASSED, 1);
    const GLuint one = 1;
    GLuint made = 77;
    gl->GenQueries(1, &made);
    const GLenum making = gl->GetError();
    gl->DeleteQueries(1, &one);
    const GLenum deleting = gl->GetError();
    const bool ours = gl == &softgl_library();
    CHECK(making == (ours ? GL_INVALID_OPERATION : GL_NO_ERROR));
    CHECK(deleting == (ours ? GL_INVALID_OPERATION : GL_NO_ERROR));
    if (!ours) continue;
    CHECK(made == 77);
    CHECK(current_query(*gl) == 1);
    gl->EndQuery(GL_SAMPLES_PASSED);
    gl->DeleteQueries(1, &one);
    CHECK(gl->IsQuery(1) == GL_FALSE);
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("queries answer as OSMesa's do", "[spec][queries]") {
  fix_environment();
  std::vector<GLint> answers[2];
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    CurrentContext context(gl);
    std::vector<GLint>& out = answers[library == &osmesa_library()];
    const auto ask = [&] {
      for (GLuint name : {0u, 1u, 2u, 3u, 9u, 10u, 11u}) out.push_back(gl.IsQuery(name));
      GLint value = -7;
      gl.GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &value), out.push_back(value);
      out.push_back(current_query(gl));
      for (GLuint name : {1u, 9u}) {
        gl.GetQueryObjectiv(name, GL_QUERY_RESULT, &value), out.push_back(value);
        out.push_back(GLint(gl.GetError()));
      }
    };
    gl.GenQueries(2, names), out.push_back(GLint(names[0])), out.push_back(GLint(names[1]));
    ask();
    gl.BeginQuery(GL_SAMPLES_PASSED, 9); // a name that nobody generated
    ask();
    gl.EndQuery(GL_SAMPLES_PASSED);
    ask();
    gl.GenQueries(1, names), out.push_back(GLint(names[0]));
    gl.BeginQuery(GL_SAMPLES_PASSED, 1);
    quarter(gl);
    gl.EndQuery(GL_SAMPLES_PASSED);
    GLint available = 0;
    for (int i = 0; i < 1000 && !available; ++i)
      gl.GetQueryObjectiv(1, GL_QUERY_RESULT_AVAILABLE, &available);
    out.push_back(available);
    ask();
    const GLuint gone[] = {0, 1, 12345};
    gl.DeleteQueries(3, gone);
    ask();
    gl.Begin(GL_POINTS);
    gl.BeginQuery(GL_SAMPLES_PASSED, 2), out.push_back(gl.IsQuery(2));
    gl.End();
    out.push_back(GLint(gl.GetError()));
    ask();
  }
  CHECK(answers[0] == answers[1]);
}

TEST_CASE("a query counts the fragments that OSMesa counts", "[spec][queries]") {
  fix_environment();
  std::vector<GLuint> counts[2];
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    CurrentContext context(gl);
    const std::vector<GLubyte> pixels(32 * 32 * 4, 0x5f);
    const auto with = [&](GLenum capability, const auto& draw) {
      gl.Enable(capability), draw(), gl.Disable(capability);
    };
    const std::function<void()> cases[] = {
        [] {},
        [&] { quarter(gl); },
        [&] { quarter(gl), quarter(gl); },
        [&] { quarter(gl), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT); },
        [&] { gl.Scissor(3, 4, 7, 9), with(GL_SCISSOR_TEST, [&] { quarter(gl); }); },
        [&] { gl.DepthFunc(GL_NEVER), with(GL_DEPTH_TEST, [&] { quarter(gl); }); },
        [&] {
          gl.DepthFunc(GL_LESS), gl.Color3f(1, 1, 1);
          with(GL_DEPTH_TEST, [&] { quarter(gl), quarter(gl), gl.Rectf(-1, -1, 0.5f, 1); });
        },
        [&] { gl.AlphaFunc(GL_LESS, 0.5f), with(GL_ALPHA_TEST, [&] { quarter(gl); }); },
        [&] { gl.StencilFunc(GL_NOTEQUAL, 0, ~0u), with(GL_STENCIL_TEST, [&] { quarter(gl); }); },
        [&] { gl.DrawBuffer(GL_NONE), quarter(gl), gl.DrawBuffer(GL_FRONT); },
        [&] { gl.ColorMask(0, 0, 0, 0), quarter(gl), gl.ColorMask(1, 1, 1, 1); },
        [&] { gl.PointSize(7), gl.Begin(GL_POINTS), gl.Vertex2f(0, 0), gl.End(); },
        [&] { gl.Begin(GL_LINES), gl.Vertex2f(0, 0), gl.Vertex2f(0.7f, 0.3f), gl.End(); },
        [&] { gl.RasterPos2f(-1, -1), gl.DrawPixels(20, 10, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data()); },
        [&] { gl.Bitmap(32, 10, 0, 0, 0, 0, pixels.data()); },
        [&] { gl.CopyPixels(0, 0, 9, 8, GL_COLOR); },
        [&] { gl.Clear(GL_COLOR_BUFFER_BIT); },
        [&] {
          GLfloat values[64];
          gl.FeedbackBuffer(64, GL_2D, values), gl.RenderMode(GL_FEEDBACK), quarter(gl),
              gl.RenderMode(GL_RENDER);
        },
        [&] { quarter(gl), gl.Finish(), quarter(gl), gl.Flush(), quarter(gl); },
    };
    std::vector<GLuint>& out = counts[library == &osmesa_library()];
    for (const auto& draw : cases) out.push_back(count_of(gl, 1, draw));
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
  CHECK(counts[0] == counts[1]);
  CHECK(counts[0][1] == 1024);
}

TEST_CASE("stencil values that are drawn as pixels are no fragments", "[spec][queries][deviation]") {
  fix_environment();
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    const std::vector<GLubyte> values(20 * 10, 3);
    gl->RasterPos2f(-1, -1);
    const GLuint drawn = count_of(*gl, 1, [&] {
      gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
      gl->DrawPixels(20, 10, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, values.data());
    });
    const GLuint copied = count_of(*gl, 1, [&] { gl->CopyPixels(0, 0, 9, 8, GL_STENCIL); });
    const bool ours = gl == &softgl_library();
    CHECK(drawn == (ours ? 0u : 200u));
    CHECK(copied == (ours ? 0u : 72u));
  }
}

TEST_CASE("lists begin and end queries when they are played", "[spec][queries][lists]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.BeginQuery(GL_SAMPLES_PASSED, 1);
  quarter(gl);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GenQueries(1, names); // at once
  CHECK(names[0] == 1);
  CHECK(gl.IsQuery(1) == GL_FALSE);
  gl.EndList();
  CHECK(gl.IsQuery(1) == GL_FALSE);
  for (int i = 0; i < 3; ++i) {
    gl.CallList(1);
    CHECK(result_of(gl, 1) == 1024);
  }
  gl.NewList(2, GL_COMPILE_AND_EXECUTE);
  gl.BeginQuery(GL_SAMPLES_PASSED, 2);
  gl.CallList(3); // nothing yet
  quarter(gl);
  gl.EndQuery(GL_SAMPLES_PASSED);
  CHECK(result_of(gl, 2) == 1024);
  gl.EndList();
  gl.NewList(3, GL_COMPILE);
  quarter(gl);
  gl.EndList();
  gl.CallList(2);
  CHECK(result_of(gl, 2) == 2048);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("several queries count in one frame, and one query over several frames", "[spec][queries]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  constexpr GLuint kQueries = 20;
  for (GLuint q = 1; q <= kQueries; ++q) {
    quarter(gl);
    gl.BeginQuery(GL_SAMPLES_PASSED, q);
    for (GLuint i = 0; i < q; ++i) quarter(gl);
    gl.EndQuery(GL_SAMPLES_PASSED);
    quarter(gl);
  }
  for (GLuint q = 1; q <= kQueries; ++q) CHECK(result_of(gl, q) == 1024 * q);
  gl.BeginQuery(GL_SAMPLES_PASSED, 1);
  for (int i = 0; i < 5; ++i) {
    quarter(gl);
    if (i % 2) gl.Finish();
    CHECK(result_of(gl, 2) == 2048);
  }
  gl.EndQuery(GL_SAMPLES_PASSED);
  CHECK(result_of(gl, 1) == 5 * 1024);
  // The last one counts, whether or not anybody asked for the one before.
  gl.BeginQuery(GL_SAMPLES_PASSED, 1);
  quarter(gl);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.BeginQuery(GL_SAMPLES_PASSED, 1);
  gl.EndQuery(GL_SAMPLES_PASSED);
  CHECK(result_of(gl, 1) == 0);
}

TEST_CASE("contexts that share objects do not share queries", "[spec][queries]") {
  const Gl& gl = softgl_library();
  std::vector<GLubyte> buffer(64 * 64 * 4);
  void* first = gl.OSMesaCreateContext(kOSMesaRgba, nullptr);
  void* second = gl.OSMesaCreateContext(kOSMesaRgba, first);
  REQUIRE(gl.OSMesaMakeCurrent(first, buffer.data(), GL_UNSIGNED_BYTE, 64, 64));
  gl.BeginQuery(GL_SAMPLES_PASSED, 1);
  quarter(gl);
  REQUIRE(gl.OSMesaMakeCurrent(second, buffer.data(), GL_UNSIGNED_BYTE, 64, 64));
  CHECK(gl.IsQuery(1) == GL_FALSE);
  CHECK(current_query(gl) == 0);
  CHECK(count_of(gl, 1, [&] { quarter(gl), quarter(gl), quarter(gl); }) == 3 * 1024);
  REQUIRE(gl.OSMesaMakeCurrent(first, buffer.data(), GL_UNSIGNED_BYTE, 64, 64));
  CHECK(current_query(gl) == 1);
  quarter(gl);
  gl.EndQuery(GL_SAMPLES_PASSED);
  CHECK(result_of(gl, 1) == 2 * 1024);
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(second);
  gl.OSMesaDestroyContext(first);
}
