// Per-pixel lighting of wide and stippled lines and of points, fogged and textured.
#include <cmath>

#include "scenes/shapes.h"

namespace softgl::test {

static void draw_phong_lines(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat white[4] = {1, 1, 1, 1}, fog[4] = {0.3f, 0.3f, 0.35f, 1}, position[4] = {0, 1, 2, 1};
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Materialfv(GL_FRONT, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 60);
  gl.Fogfv(GL_FOG_COLOR, fog);
  gl.Fogf(GL_FOG_DENSITY, 0.2f);
  gl.Enable(GL_FOG);
  checker_texture(s, 32, true);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.LineWidth(5);
  gl.PointSize(9);
  for (int i = 0; i < 12; ++i) {
    const float y = -1.1f + 0.2f * float(i), a = 0.25f * float(i);
    if (i % 3 == 1) gl.LineStipple(3, 0x3f5d), gl.Enable(GL_LINE_STIPPLE);
    gl.Begin(i % 3 == 2 ? GL_POINTS : GL_LINE_STRIP);
    for (int j = 0; j < 5; ++j) {
      gl.Normal3f(float(j) - 2, std::sin(a), 1.5f);
      gl.TexCoord2f(float(j), a);
      gl.Vertex3f(-1.4f + 0.7f * float(j), y, 0.4f * std::cos(a + float(j)));
    }
    gl.End();
    gl.Disable(GL_LINE_STIPPLE);
  }
}

static SceneRegistration registration{
    {.name = "phong_lines", .draw = draw_phong_lines, .width = 200, .height = 160, .extension = true}};

} // namespace softgl::test
