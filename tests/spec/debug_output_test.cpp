// GL_KHR_debug: messages of errors and of the program, filters, groups and labels.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

struct Message {
  GLenum source, type, severity;
  GLuint id;
  std::string text;
};

void APIENTRY keep(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* text,
                   const void* user) {
  auto* kept = static_cast<std::vector<Message>*>(const_cast<void*>(user));
  kept->push_back({source, type, severity, id, std::string(text, size_t(length))});
}

GLint get(const Gl& gl, GLenum pname) {
  GLint value = -1;
  gl.GetIntegerv(pname, &value);
  return value;
}

void insert(const Gl& gl, GLuint id, GLenum severity, const char* text = "text") {
  gl.DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, id, severity, -1, text);
}

} // namespace

TEST_CASE("an error makes a message that spells the call out", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  std::vector<Message> kept;
  gl.DebugMessageCallback(keep, &kept);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK(kept.empty()); // debug output is off
  gl.Enable(GL_DEBUG_OUTPUT);
  CHECK(gl.IsEnabled(GL_DEBUG_OUTPUT));
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR);
  gl.Viewport(0, 0, -1, 5); // the first error waits; the second one has a message all the same
  gl.MultiTexCoord1f(GL_TEXTURE0 + 99, 0);
  CHECK(gl.GetError() == GL_INVALID_ENUM);
  CHECK(gl.GetError() == GL_NO_ERROR);
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].source == GL_DEBUG_SOURCE_API);
  CHECK(kept[0].type == GL_DEBUG_TYPE_ERROR);
  CHECK(kept[0].severity == GL_DEBUG_SEVERITY_HIGH);
  CHECK(kept[0].text ==
        "GL_INVALID_ENUM: glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR): param = GL_LINEAR");
  CHECK(kept[1].text == "GL_INVALID_VALUE: glViewport(0, 0, -1, 5): width = -1");
  CHECK(kept[2].text.find("GL_INVALID_ENUM: glMultiTexCoord1f(") == 0);
  gl.Disable(GL_DEBUG_OUTPUT);
  gl.Viewport(0, 0, -1, 5);
  CHECK(gl.GetError() == GL_INVALID_VALUE);
  CHECK(kept.size() == 3);
  void* pointer = nullptr;
  gl.GetPointerv(GL_DEBUG_CALLBACK_FUNCTION, &pointer);
  CHECK(pointer == reinterpret_cast<void*>(keep));
  gl.GetPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &pointer);
  CHECK(pointer == &kept);
}

TEST_CASE("without a callback the log keeps the oldest messages", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  insert(gl, 1, GL_DEBUG_SEVERITY_HIGH);
  CHECK(get(gl, GL_DEBUG_LOGGED_MESSAGES) == 0);
  gl.Enable(GL_DEBUG_OUTPUT);
  for (GLuint i = 0; i < 12; ++i) insert(gl, i, GL_DEBUG_SEVERITY_HIGH, i ? "more" : "first");
  CHECK(get(gl, GL_DEBUG_LOGGED_MESSAGES) == get(gl, GL_MAX_DEBUG_LOGGED_MESSAGES));
  CHECK(get(gl, GL_DEBUG_NEXT_LOGGED_MESSAGE_LENGTH) == 6);
  GLchar text[12] = {};
  GLuint ids[3] = {};
  GLsizei lengths[3] = {};
  // Room for the first two messages.
  CHECK(gl.GetDebugMessageLog(3, 12, nullptr, nullptr, ids, nullptr, lengths, text) == 2);
  CHECK(std::string(text, 11) == std::string("first\0more\0", 11));
  CHECK(ids[1] == 1);
  CHECK(lengths[0] == 6);
  CHECK(gl.GetDebugMessageLog(100, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == 8);
  CHECK(get(gl, GL_DEBUG_LOGGED_MESSAGES) == 0);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("messages are filtered by source, type, severity and number", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.Enable(GL_DEBUG_OUTPUT);
  const auto passes = [&](GLuint id, GLenum severity) {
    insert(gl, id, severity);
    return gl.GetDebugMessageLog(10, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr) == 1;
  };
  CHECK(passes(1, GL_DEBUG_SEVERITY_HIGH));
  CHECK(passes(1, GL_DEBUG_SEVERITY_NOTIFICATION));
  CHECK(!passes(1, GL_DEBUG_SEVERITY_LOW));
  gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_LOW, 0, nullptr, GL_TRUE);
  CHECK(passes(1, GL_DEBUG_SEVERITY_LOW));
  const GLuint two = 2;
  gl.DebugMessageControl(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, GL_DONT_CARE, 1, &two, GL_FALSE);
  CHECK(!passes(2, GL_DEBUG_SEVERITY_HIGH));
  CHECK(passes(3, GL_DEBUG_SEVERITY_HIGH));
  gl.DebugMessageControl(GL_DEBUG_SOURCE_APPLICATION, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  CHECK(passes(2, GL_DEBUG_SEVERITY_HIGH));
  gl.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_OTHER, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  CHECK(!passes(3, GL_DEBUG_SEVERITY_HIGH));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("a group has its own filter, and says when it begins and ends", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  std::vector<Message> kept;
  gl.DebugMessageCallback(keep, &kept);
  gl.Enable(GL_DEBUG_OUTPUT);
  CHECK(get(gl, GL_DEBUG_GROUP_STACK_DEPTH) == 1);
  gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 7, 4, "shadow");
  CHECK(get(gl, GL_DEBUG_GROUP_STACK_DEPTH) == 2);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_OTHER, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  insert(gl, 1, GL_DEBUG_SEVERITY_HIGH);
  gl.PopDebugGroup();
  insert(gl, 1, GL_DEBUG_SEVERITY_HIGH);
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].type == GL_DEBUG_TYPE_PUSH_GROUP);
  CHECK(kept[0].text == "shad");
  CHECK(kept[1].type == GL_DEBUG_TYPE_POP_GROUP);
  CHECK(kept[1].id == 7);
  CHECK(kept[1].severity == GL_DEBUG_SEVERITY_NOTIFICATION);
  gl.Disable(GL_DEBUG_OUTPUT);
  for (int i = 1; i < get(gl, GL_MAX_DEBUG_GROUP_STACK_DEPTH); ++i)
    gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "");
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "");
  CHECK(gl.GetError() == GL_STACK_OVERFLOW);
}

TEST_CASE("objects have labels as long as they live", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint texture = 0, buffer = 0, query = 0, array = 0, frame = 0, render = 0;
  gl.GenTextures(1, &texture), gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.GenQueries(1, &query), gl.BeginQuery(GL_SAMPLES_PASSED, query), gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
  gl.GenFramebuffers(1, &frame), gl.BindFramebuffer(GL_FRAMEBUFFER, frame);
  gl.GenRenderbuffers(1, &render), gl.BindRenderbuffer(GL_RENDERBUFFER, render);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0), gl.BindVertexArray(0);
  gl.NewList(5, GL_COMPILE), gl.EndList();
  const std::pair<GLenum, GLuint> objects[] = {
      {GL_TEXTURE, texture},   {GL_BUFFER, buffer},       {GL_QUERY, query},   {GL_VERTEX_ARRAY, array},
      {GL_FRAMEBUFFER, frame}, {GL_RENDERBUFFER, render}, {GL_DISPLAY_LIST, 5}};
  for (const auto& [kind, name] : objects) {
    INFO("kind " << kind);
    GLchar text[8] = "xxxxxxx";
    GLsizei length = -1;
    gl.GetObjectLabel(kind, name, 8, &length, text);
    CHECK(std::string(text) == "");
    CHECK(length == 0);
    gl.ObjectLabel(kind, name, -1, "a label");
    gl.GetObjectLabel(kind, name, 4, &length, text);
    CHECK(std::string(text) == "a l");
    CHECK(length == 3);
    gl.GetObjectLabel(kind, name, 0, &length, nullptr);
    CHECK(length == 7);
    gl.ObjectLabel(kind, name, 1, nullptr);
    gl.GetObjectLabel(kind, name, 8, &length, text);
    CHECK(length == 0);
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

REFUSAL_TEST_CASE("debug output refuses what its text refuses", "[spec][debug]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const std::string long_text(5000, 'x');
  static const GLuint id = 1;
  static GLchar text[4];
  // clang-format off
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, DebugMessageControl(GL_FRONT, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE)),
      BAD(INVALID_ENUM, DebugMessageControl(GL_DONT_CARE, GL_FRONT, GL_DONT_CARE, 0, nullptr, GL_TRUE)),
      BAD(INVALID_ENUM, DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_FRONT, 0, nullptr, GL_TRUE)),
      BAD(INVALID_VALUE, DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, -1, &id, GL_TRUE)),
      BAD(INVALID_OPERATION, DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_OTHER, GL_DONT_CARE, 1, &id, GL_TRUE)),
      BAD(INVALID_OPERATION, DebugMessageControl(GL_DEBUG_SOURCE_API, GL_DONT_CARE, GL_DONT_CARE, 1, &id, GL_TRUE)),
      BAD(INVALID_OPERATION, DebugMessageControl(GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_OTHER, GL_DEBUG_SEVERITY_LOW, 1, &id, GL_TRUE)),
      BAD(INVALID_ENUM, DebugMessageInsert(GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_OTHER, 0, GL_DEBUG_SEVERITY_LOW, -1, "")),
      BAD(INVALID_ENUM, DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DONT_CARE, 0, GL_DEBUG_SEVERITY_LOW, -1, "")),
      BAD(INVALID_ENUM, DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 0, GL_DONT_CARE, -1, "")),
      BAD(INVALID_VALUE, DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 0, GL_DEBUG_SEVERITY_LOW, -1, long_text.c_str())),
      BAD(INVALID_ENUM, PushDebugGroup(GL_DEBUG_SOURCE_API, 0, -1, "")),
      BAD(INVALID_VALUE, PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, long_text.c_str())),
      BAD(STACK_UNDERFLOW, PopDebugGroup()),
      BAD(INVALID_VALUE, GetDebugMessageLog(1, -1, nullptr, nullptr, nullptr, nullptr, nullptr, text)),
      BAD(INVALID_ENUM, ObjectLabel(GL_TEXTURE_2D, 1, -1, "")),
      BAD(INVALID_VALUE, ObjectLabel(GL_TEXTURE, 1, -1, "")),
      BAD(INVALID_VALUE, ObjectLabel(GL_PROGRAM, 1, -1, "")),
      BAD(INVALID_VALUE, ObjectLabel(GL_TEXTURE, 77, -1, long_text.c_str())),
      BAD(INVALID_ENUM, GetObjectLabel(GL_TEXTURE_2D, 1, 4, nullptr, text)),
      BAD(INVALID_VALUE, GetObjectLabel(GL_TEXTURE, 1, 4, nullptr, text)),
      BAD(INVALID_VALUE, GetObjectLabel(GL_TEXTURE, 77, -1, nullptr, text)),
      BAD(INVALID_VALUE, ObjectPtrLabel(text, -1, "")),
      BAD(INVALID_VALUE, GetObjectPtrLabel(text, 4, nullptr, text)),
      BAD(INVALID_ENUM, EnableClientState(GL_DEBUG_OUTPUT)),
  };
  // clang-format on
  gl.BindTexture(GL_TEXTURE_2D, 77);
  const StateSnapshot before = take_snapshot(gl, true);
  expect_refused(gl, calls, [] {});
  CHECK(compare_snapshots(before, take_snapshot(gl, true)) == "");
}
