// Coplanar outlines over a flat-shaded floor: polygon offset decides who is in front.
#include "scenes/shapes.h"

namespace softgl::test {

static void draw_decal_offset(Stage& s) {
  const Gl& gl = s.gl;
  gl.ClearColor(0.3f, 0.3f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  camera(s, 3);
  gl.Rotatef(-55, 1, 0, 0);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  for (int pass = 0; pass < 2; pass++) {
    if (pass) {
      gl.Enable(GL_POLYGON_OFFSET_FILL);
      gl.PolygonOffset(-1, -2);
    }
    const int n = pass ? 5 : 8;
    for (int y = 0; y < n; y++) {
      gl.Begin(GL_QUAD_STRIP);
      for (int x = 0; x <= n; x++) {
        gl.Color3f(float((x + y + pass) % 2), pass ? 1.0f : 0.4f, float(x) / float(n));
        const float f = (pass ? 1.4f : 2.4f) / float(n);
        gl.Vertex2f(float(x) * f - float(n) * f / 2, float(y + 1) * f - float(n) * f / 2);
        gl.Vertex2f(float(x) * f - float(n) * f / 2, float(y) * f - float(n) * f / 2);
      }
      gl.End();
    }
  }
}

static SceneRegistration registration{{"decal_offset", draw_decal_offset, false, 192, 144}};

} // namespace softgl::test
