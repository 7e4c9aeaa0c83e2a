// A spinning textured cube with mipmaps, modulated by one light.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_textured_cube(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0.1f, 0.1f, 0.1f, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3.2f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  checker_texture(s, 64, true);
  gl.Rotatef(30, 1, 0, 0);
  gl.Rotatef(40, 0, 1, 0);
  cube(s, 0.8f);
}

static SceneRegistration registration{{"textured_cube", draw_textured_cube, false, 192, 192}};

} // namespace softgl::test
