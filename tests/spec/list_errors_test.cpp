// GL 1.5, 5.4 and 2.6.3: commands that a list has recorded raise their errors when it is played.
#include <catch2/catch.hpp>

#include <functional>
#include <vector>

#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

struct Played {
  GLenum compiled, outside,
      inside; // errors: of compiling, of playing the list, and of playing it between Begin and End
};

Played play(const Gl& gl, const std::function<void(const Gl&)>& command) {
  CurrentContext context(gl);
  Played p;
  gl.NewList(1, GL_COMPILE);
  command(gl);
  gl.EndList();
  p.compiled = gl.GetError();
  gl.CallList(1);
  p.outside = gl.GetError();
  gl.Begin(GL_TRIANGLES);
  gl.CallList(1);
  gl.End();
  p.inside = gl.GetError();
  return p;
}

TEST_CASE("A list whose Begin is refused is not between Begin and End", "[spec][lists][framebuffers]") {
  // GL_ARB_framebuffer_object, 4.4.4.2: Begin is ignored while the framebuffer is not complete.
  const Gl& gl = softgl_library();
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    CurrentContext context(gl);
    GLuint incomplete = 0;
    gl.GenFramebuffers(1, &incomplete);
    const auto bind = [&](GLuint name) { gl.BindFramebuffer(GL_FRAMEBUFFER, name); };
    bind(incomplete);
    const auto commands = [&] {
      gl.Begin(GL_TRIANGLES);
      gl.Color3f(0, 1, 0);
      gl.Vertex2f(-1, -1);
      gl.Vertex2f(3, -1);
      gl.Enable(GL_FOG);
      gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 1); // an argument that is wrong everywhere
      gl.Vertex2f(-1, 3);
      gl.End();
      gl.Enable(GL_BLEND);
    };
    gl.NewList(1, mode);
    commands();
    gl.EndList();
    if (mode == GL_COMPILE) {
      CHECK(gl.GetError() == GL_NO_ERROR);
      CHECK(!gl.IsEnabled(GL_FOG));
      gl.CallList(1);
    }
    CHECK(gl.GetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
    CHECK(gl.IsEnabled(GL_FOG)); // as without a list
    CHECK(gl.IsEnabled(GL_BLEND));
    GLfloat color[4];
    gl.GetFloatv(GL_CURRENT_COLOR, color);
    CHECK(color[0] == 0);
    gl.Disable(GL_FOG);
    gl.Disable(GL_BLEND);
    bind(0);
    gl.CallList(1);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    CHECK(!gl.IsEnabled(GL_FOG));
    CHECK(gl.IsEnabled(GL_BLEND));
    GLubyte pixel[4] = {};
    gl.ReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[1] == 255); // and the triangle is drawn
    gl.Disable(GL_BLEND);
  }
}

TEST_CASE("Errors of a list come when it is played", "[spec][lists]") {
  const GLuint index = 0;
  struct Case {
    const char* name;
    std::function<void(const Gl&)> command;
    GLenum outside, inside;
  };
  const std::vector<Case> cases = {
      {"nothing between Begin and End", [](const Gl& gl) { gl.Begin(GL_LINES), gl.End(); }, GL_NO_ERROR,
       GL_INVALID_OPERATION},
      {"half a triangle", [](const Gl& gl) { gl.Begin(GL_TRIANGLES), gl.Vertex2f(0, 0), gl.End(); },
       GL_NO_ERROR, GL_INVALID_OPERATION},
      {"no vertices of arrays", [](const Gl& gl) { gl.DrawArrays(GL_LINES, 0, 0); }, GL_NO_ERROR,
       GL_INVALID_OPERATION},
      {"arrays that are not enabled", [](const Gl& gl) { gl.DrawArrays(GL_LINES, 0, 4); }, GL_NO_ERROR,
       GL_INVALID_OPERATION},
      {"elements", [&](const Gl& gl) { gl.DrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, &index); }, GL_NO_ERROR,
       GL_INVALID_OPERATION},
      {"arrays of no mode", [](const Gl& gl) { gl.DrawArrays(99, 0, 4); }, GL_INVALID_ENUM,
       GL_INVALID_OPERATION},
      {"one number for four", [](const Gl& gl) { gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 1); },
       GL_INVALID_ENUM, GL_INVALID_OPERATION},
      {"the same between Begin and End",
       [](const Gl& gl) { gl.Begin(GL_LINES), gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 1), gl.End(); },
       GL_INVALID_OPERATION, GL_INVALID_OPERATION},
      {"a command with a bad name", [](const Gl& gl) { gl.Enable(1); }, GL_INVALID_ENUM,
       GL_INVALID_OPERATION},
      {"fewer lists than none", [&](const Gl& gl) { gl.CallLists(-1, GL_UNSIGNED_INT, &index); },
       GL_INVALID_VALUE, GL_INVALID_VALUE},
      {"the same without a list", [](const Gl& gl) { gl.CallLists(-1, GL_INT, nullptr); }, GL_INVALID_VALUE,
       GL_INVALID_VALUE},
      {"a vertex", [](const Gl& gl) { gl.Vertex2f(0, 0); }, GL_NO_ERROR, GL_NO_ERROR},
  };
  for (const Case& c : cases) {
    INFO(c.name);
    const Played p = play(softgl_library(), c.command);
    CHECK(p.compiled == GL_NO_ERROR);
    CHECK(p.outside == c.outside);
    CHECK(p.inside == c.inside);
  }
}

TEST_CASE("Of a list between Begin and End the Begin is ignored, and no other command",
          "[spec][lists][deviation]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.NewList(1, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(0, 1, 0);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(3, -1);
  gl.Vertex2f(-1, 3);
  gl.End();
  gl.EndList();
  gl.Begin(GL_TRIANGLES);
  gl.CallList(1); // its End is that of the Begin before it
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  GLubyte pixel[4] = {};
  gl.ReadPixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK(pixel[1] == 255);
  CHECK(gl.GetError() == GL_NO_ERROR);
}

} // namespace
} // namespace softgl::test
