// Fans of lines from width 1 to 12, strips and a loop.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_wide_lines(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(1, 1, 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < 36; i++) {
    const float a = float(i) * 0.17453f, c = 1 - a * a / 2 + a * a * a * a / 24;
    gl.LineWidth(1 + float(i % 12));
    gl.Begin(GL_LINES);
    gl.Color3f(float(i) / 36, 0.2f, 1 - float(i) / 36);
    gl.Vertex2f(0, 0);
    gl.Color3f(0, 0, 0);
    gl.Vertex2f(i < 18 ? -0.9f + 0.1f * float(i) : 0.9f - 0.1f * float(i - 18),
                i < 18 ? 0.9f : -0.9f + c * 1e-6f);
    gl.End();
  }
  gl.LineWidth(4.5f);
  gl.Begin(GL_LINE_LOOP);
  for (int i = 0; i < 7; i++) {
    gl.Color3f(0, float(i) / 7, 0);
    gl.Vertex2f((i & 1 ? 0.5f : 0.95f) * (i < 4 ? -1.0f : 1.0f), float(i % 4) * 0.5f - 0.75f);
  }
  gl.End();
}

static SceneRegistration registration{{"wide_lines", draw_wide_lines, false, 200, 200}};

} // namespace softgl::test
