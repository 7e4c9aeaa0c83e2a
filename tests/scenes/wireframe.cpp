// A lit teapot with its mesh drawn over it, as modellers do: lines that polygon offset keeps in front of the
// surface. Beside it polygons whose back faces are points.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_wireframe(Stage& s) {
  const Gl& gl = s.gl;
  const GLfloat position[4] = {1, 2, 3, 0};
  gl.ClearColor(0.9f, 0.9f, 0.88f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 4);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHT0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1, 2);
  teapot(s, 14);
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Color3f(0.1f, 0.15f, 0.4f);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  teapot(s, 14);
  gl.PolygonMode(GL_FRONT, GL_LINE);
  gl.PolygonMode(GL_BACK, GL_POINT);
  gl.PointSize(3);
  gl.Color3f(0.7f, 0.2f, 0.1f);
  gl.Translatef(-0.4f, 0.1f, 0);
  for (GLenum mode : {GL_QUADS, GL_POLYGON}) {
    gl.Translatef(0.3f, 0.3f, -0.2f);
    gl.Begin(mode);
    gl.Vertex3f(0, 0, 0.8f), gl.Vertex3f(0.8f, 0, 0.8f), gl.Vertex3f(0.9f, 0.6f, 0.8f),
        gl.Vertex3f(0, 0.5f, 0.8f);
    gl.Vertex3f(-0.2f, 0.2f, 0.9f), gl.Vertex3f(-0.6f, 0.6f, 0.9f), gl.Vertex3f(-0.2f, 0.9f, 0.9f),
        gl.Vertex3f(0.1f, 0.6f, 0.9f);
    gl.End();
  }
}

static SceneRegistration registration{
    {.name = "wireframe", .draw = draw_wireframe, .width = 220, .height = 180}};

} // namespace softgl::test
