// A grid of points of growing size, on and off pixel centres.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_point_sizes(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0, 0, 0.2f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(0, 200, 0, 200, -1, 1);
  for (int y = 0; y < 12; y++)
    for (int x = 0; x < 12; x++) {
      gl.PointSize(0.5f + 0.1f * float(y * 12 + x));
      gl.Begin(GL_POINTS);
      gl.Color3f(float(x) / 12, float(y) / 12, 1);
      gl.Vertex2f(10 + 16 * float(x) + 0.25f * float(x % 4), 10 + 16 * float(y) + 0.125f * float(y));
      gl.End();
    }
}

static SceneRegistration registration{{"point_sizes", draw_point_sizes, false, 200, 200}};

} // namespace softgl::test
