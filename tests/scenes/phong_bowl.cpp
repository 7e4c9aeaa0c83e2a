// Per-pixel lighting of half a torus seen from both sides: two-sided, separate specular, clipped, colour material.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_phong_bowl(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat back[4] = {0.8f, 0.5f, 0.1f, 1}, white[4] = {1, 1, 1, 1}, position[4] = {1, 2, 3, 1};
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3.5f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.Materialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
  gl.Materialf(GL_FRONT, GL_SHININESS, 20);
  gl.Materialf(GL_BACK, GL_SHININESS, 90);
  gl.ColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  const GLdouble plane[4] = {0.3, 1, 0.5, 0};
  gl.ClipPlane(GL_CLIP_PLANE0, plane);
  gl.Enable(GL_CLIP_PLANE0);
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

static SceneRegistration registration{{.name = "phong_bowl", .draw = draw_phong_bowl, .width = 224, .height = 168, .extension = true}};

} // namespace softgl::test
