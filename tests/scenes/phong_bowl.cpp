// Per-pixel lighting of half a torus seen from both sides: two-sided, separate specular, clipped, color
// material.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_phong_bowl(Stage& s) {
  const Gl& gl = s.gl;
  two_sided_bowl(s);
  gl.ColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.Rotatef(70, 1, 0.2f, 0);
  torus(s, 0.8f, 0.5f, 14, 8);
  gl.Begin(GL_TRIANGLES); // a material that varies within one large triangle
  gl.Normal3f(0, 0, 1);
  gl.Color3f(1, 0, 0);
  gl.Vertex3f(-1.5f, -1, -0.6f);
  gl.Color3f(0, 1, 0);
  gl.Vertex3f(1.5f, -1, -0.6f);
  gl.Color3f(0, 0, 1);
  gl.Vertex3f(0, 2, -0.6f);
  gl.End();
}

static SceneRegistration registration{{.name = "phong_bowl",
                                       .draw = draw_phong_bowl,
                                       .width = 224,
                                       .height = 168,
                                       .extension = true,
                                       .clipped = true}};

} // namespace softgl::test
