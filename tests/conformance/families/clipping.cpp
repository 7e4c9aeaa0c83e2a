// User clip planes, the view volume, vertices behind the eye.
#include "conformance/families/common.h"

namespace softgl::test {

static void draw_clip(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 40);
    for (int i = 0; i < 6; i++) {
      if (!s.random.chance(35)) {
        gl.Disable(GL_CLIP_PLANE0 + GLenum(i));
        continue;
      }
      const Float3 d = s.random.direction();
      const GLdouble plane[4] = {d[0], d[1], d[2], s.random.real(-0.1f, 0.8f)};
      gl.ClipPlane(GL_CLIP_PLANE0 + GLenum(i), plane);
      gl.Enable(GL_CLIP_PLANE0 + GLenum(i));
    }
    gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.mode = s.random.chance(25)
                       ? GLenum(s.random.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}))
                       : random_filled_mode(s);
    options.spread = s.random.pick({Spread::View, Spread::Beyond, Spread::Beyond, Spread::Any});
    options.secondary_colors = s.random.chance(20);
    if (options.secondary_colors) gl.Enable(GL_COLOR_SUM);
    gl.PointSize(4);
    gl.LineWidth(s.random.chance(50) ? 1.0f : 3.0f);
    random_primitive(s, options);
    gl.Disable(GL_COLOR_SUM);
  }
}

// Everything crosses the near plane, the eye or all planes at once.
static void draw_near(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    const float n = s.random.real(0.05f, 1);
    gl.Frustum(-n, n, -n * 0.8f, n * 0.8f, n, s.random.real(2, 30));
    gl.MatrixMode(GL_MODELVIEW);
    rigid_modelview(s);
    random_depth(s, 50);
    random_culling(s);
    gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.mode = s.random.chance(25)
                       ? GLenum(s.random.pick({GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}))
                       : random_filled_mode(s);
    options.spread = s.random.pick({Spread::Beyond, Spread::Beyond, Spread::Huge});
    gl.PointSize(9);
    gl.LineWidth(s.random.chance(50) ? 1.0f : 5.0f);
    random_primitive(s, options);
  }
}

static SceneRegistration clip{{"clip", draw_clip, true}}, nearby{{"near", draw_near, true}};

} // namespace softgl::test
