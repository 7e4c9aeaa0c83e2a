// Half a sphere seen from both sides: two-sided lighting with separate specular color.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_two_sided_bowl(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat front[4] = {0.2f, 0.5f, 0.8f, 1};
  two_sided_bowl(s);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, front);
  gl.Rotatef(70, 1, 0.2f, 0);
  torus(s, 0.8f, 0.5f, 36, 18);
}

static SceneRegistration registration{{"two_sided_bowl", draw_two_sided_bowl, false, 224, 168}};

} // namespace softgl::test
