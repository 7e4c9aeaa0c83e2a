// What GL 1.5 says of every command alike: 2.6.3 (between Begin and End), and what must do no harm: calls
// without a context, null pointers, senseless numbers. The table is all 452 commands of GL 1.0 to 1.5 and
// the 22 of framebuffer objects, the 3 of mapped ranges and copies of buffers, the 3 with a base vertex, the
// 6 of two stencil faces and of blend equations for alpha, the 32 of half floats, the 10 of debug output, and
// a few more.
#include <catch2/catch.hpp>

#include <cstring>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/traced_program.h"

using namespace softgl::test;

namespace {

alignas(16) unsigned char memory[1 << 16];

// Calls a command with `number` for every number and `pointer` for every pointer; returns what it returns, as
// bits.
template <auto Member> struct Caller;
template <class R, class... A, R (*Gl::*Member)(A...)> struct Caller<Member> {
  template <class T> static T argument(int number, void* pointer) {
    if constexpr (std::is_pointer_v<T>)
      return reinterpret_cast<T>(pointer);
    else
      return T(number);
  }
  static uint64_t call(const Gl& gl, int number, void* pointer) {
    if constexpr (std::is_void_v<R>)
      return (gl.*Member)(argument<A>(number, pointer)...), 0;
    else if constexpr (std::is_pointer_v<R>)
      return reinterpret_cast<uintptr_t>((gl.*Member)(argument<A>(number, pointer)...));
    else
      return uint64_t((gl.*Member)(argument<A>(number, pointer)...));
  }
};

struct Command {
  std::string name;
  uint64_t (*call)(const Gl& gl, int number, void* pointer);
};
const std::vector<Command> commands = {
#define GL_FUNCTION(name) {#name, Caller<&Gl::name>::call},
#include "support/gl_functions.inc"
#undef GL_FUNCTION
};

bool starts_with_one_of(const std::string& name, std::initializer_list<const char*> beginnings) {
  for (const char* beginning : beginnings)
    if (name.rfind(beginning, 0) == 0) return true;
  return false;
}
// glVertex*, glColor*, ...: commands that give a vertex or one of its attributes.
bool is_attribute(const std::string& name) {
  return starts_with_one_of(name, {"Vertex", "Normal", "Color", "SecondaryColor", "TexCoord", "MultiTexCoord",
                                   "FogCoord", "EdgeFlag", "Index"}) &&
         name.find("Pointer") == std::string::npos && name != "ColorMask" && name != "ColorMaterial" &&
         name != "IndexMask";
}
bool allowed_between_begin_and_end(const std::string& name) { // 2.6.3
  return is_attribute(name) || name == "End" || name == "ArrayElement" || name == "PrimitiveRestartNV" ||
         starts_with_one_of(name, {"Material", "EvalCoord", "EvalPoint", "CallList"});
}
bool is_built(const Gl& gl, const std::string& name) {
  return gl.OSMesaGetProcAddress(("gl" + name).c_str()) != nullptr;
}

// Those that read an array whose size they cannot know to be 0.
bool reads_blindly(const std::string& name) {
  return is_attribute(name) && (name.back() == 'v' || name.ends_with("vNV"));
}

std::string difference(const StateSnapshot& before, const Gl& gl, bool thorough = false) {
  return compare_snapshots(before, take_snapshot(gl, thorough));
}

} // namespace

TEST_CASE("between Begin and End only the commands of 2.6.3 are accepted", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot before = take_snapshot(gl, true), brief = take_snapshot(gl, false);
  REQUIRE(commands.size() == 452 + 122);
  int refused = 0;
  for (const Command& command : commands) {
    if (allowed_between_begin_and_end(command.name)) continue;
    for (void* pointer : {static_cast<void*>(memory), static_cast<void*>(nullptr)}) {
      INFO("gl" << command.name << (pointer ? "" : " with null"));
      std::memset(memory, 0, 4096);
      gl.Begin(GL_POINTS);
      CHECK(command.call(gl, 1, pointer) == 0);
      gl.End();
      CHECK(gl.GetError() == GL_INVALID_OPERATION);
      CHECK(gl.GetError() == GL_NO_ERROR);
      CHECK(std::string(memory, memory + 4096) == std::string(4096, '\0'));
    }
    INFO("gl" << command.name);
    CHECK(difference(brief, gl) == "");
    refused++;
  }
  CHECK(refused == 272 + 89);
  CHECK(difference(before, gl, true) == "");
}

TEST_CASE("between Begin and End the commands of 2.6.3 are accepted", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const Command& command : commands) {
    if (!allowed_between_begin_and_end(command.name) || !is_built(gl, command.name)) continue;
    INFO("gl" << command.name);
    std::memset(memory, 0, sizeof memory);
    gl.Begin(GL_POINTS);
    command.call(gl, 1, memory); // an argument may be wrong, the place must not be
    if (command.name != "End") gl.End();
    CHECK(gl.GetError() != GL_INVALID_OPERATION);
  }
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION); // every Begin had its End
}

TEST_CASE("in a list between Begin and End, too, only the commands of 2.6.3 are accepted",
          "[spec][errors][lists]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const StateSnapshot brief = take_snapshot(gl, false);
  const auto executed_at_once =
      [](const std::string& name) { // 5.4, and what gives an error while a list is compiled
        return name.find("Pointer") != std::string::npos || name.find("ClientState") != std::string::npos ||
               name.find("ClientAttrib") != std::string::npos ||
               starts_with_one_of(name, {"Get",
                                         "Is",
                                         "Gen",
                                         "Delete",
                                         "FeedbackBuffer",
                                         "SelectBuffer",
                                         "RenderMode",
                                         "ClientActiveTexture",
                                         "Interleaved",
                                         "ReadPixels",
                                         "PixelStore",
                                         "AreTextures",
                                         "BindBuffer",
                                         "BindFramebuffer",
                                         "BindRenderbuffer",
                                         "BindVertexArray",
                                         "PrimitiveRestartIndex",
                                         "TexStorage",
                                         "LockArrays",
                                         "UnlockArrays",
                                         "DebugMessage",
                                         "PushDebugGroup",
                                         "PopDebugGroup",
                                         "ObjectLabel",
                                         "LabelObject",
                                         "ObjectPtrLabel",
                                         "BlitFramebuffer",
                                         "CheckFramebufferStatus",
                                         "Framebuffer",
                                         "RenderbufferStorage",
                                         "BufferData",
                                         "BufferSubData",
                                         "MapBuffer",
                                         "CopyBufferSubData",
                                         "CopyImageSubData",
                                         "UnmapBuffer",
                                         "Flush",
                                         "Finish",
                                         "NewList",
                                         "EndList"});
      };
  for (const Command& command : commands) {
    const std::string& name = command.name;
    if (allowed_between_begin_and_end(name) || executed_at_once(name) || !is_built(gl, name)) continue;
    INFO("gl" << name);
    std::memset(memory, 0, sizeof memory);
    gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_POINTS);
    command.call(gl, 1, memory);
    gl.End();
    gl.EndList();
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.CallList(1);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.DeleteLists(1, 1);
    CHECK(difference(brief, gl) == "");
  }
}

TEST_CASE("every command without a context does nothing", "[spec][errors]") {
  const Gl& gl = softgl_library();
  REQUIRE(gl.OSMesaGetCurrentContext() == nullptr);
  for (int number : {-1, 0, 1, 0x7fffffff})
    for (void* pointer : {static_cast<void*>(memory), static_cast<void*>(nullptr)})
      for (const Command& command : commands) {
        if (!pointer && reads_blindly(command.name)) continue;
        INFO("gl" << command.name << " with " << number << (pointer ? "" : " and null"));
        std::memset(memory, 0, 4096);
        CHECK(command.call(gl, number, pointer) == 0);
        CHECK(std::string(memory, memory + 4096) == std::string(4096, '\0'));
      }
  CurrentContext context(gl);
  CHECK(gl.GetError() == GL_NO_ERROR);
  CHECK(compare_snapshots(take_snapshot(gl, false), take_snapshot(gl, false)) == "");
}

TEST_CASE("null pointers do no harm", "[spec][errors]") {
  const Gl& gl = softgl_library();
  for (int number : {-1, 0, 1, 5, 0x1406 /* GL_FLOAT */, 0x7fffffff}) {
    CurrentContext context(gl);
    for (const Command& command : commands) {
      if (reads_blindly(command.name)) continue;
      INFO("gl" << command.name << " with " << number);
      command.call(gl, number, nullptr);
      gl.EndList();
      gl.End();
      while (gl.GetError() != GL_NO_ERROR) {}
    }
    CHECK(gl.GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("every command is in the trace by its own name", "[spec][trace]") {
  const TracedRun run = run_traced([](const Gl& gl) {
    CurrentContext context(gl);
    for (const Command& command : commands) {
      command.call(gl, 1, memory);
      gl.EndList();
      gl.End();
    }
  });
  CHECK(run.status == 0);
  size_t at = 0;
  for (const Command& command : commands) {
    const std::string line = "\ngl" + command.name + "(";
    const size_t found = run.trace.find(line, at);
    if (found == std::string::npos) FAIL("gl" << command.name << " is not in the trace");
    at = found + 1;
  }
}
