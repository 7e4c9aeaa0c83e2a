// Antialiased lines: of any width, whole and stippled, and as the edges of polygons.
#include "conformance/families/common.h"

namespace softgl::test {

static void random_width(Stage& s) {
  const int kind = s.random.integer(0, 9);
  const float usual = s.random.real(0.1f, 8), most = s.random.real(0.1f, 60);
  s.gl.LineWidth(kind < 4 ? 1.0f : kind < 9 ? usual : most);
}

static void draw_smooth_lines(Stage& s) {
  random_canvas(s);
  s.gl.Enable(GL_LINE_SMOOTH);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    random_scissor(s, 10);
    if (s.random.chance(60)) {
      s.gl.Enable(GL_BLEND);
      s.gl.BlendFunc(GL_SRC_ALPHA, s.random.chance(70) ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
    } else {
      s.gl.Disable(GL_BLEND);
    }
    if (s.random.chance(20)) random_alpha_test(s);
    if (s.random.chance(20)) random_fog(s);
    s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
    random_width(s);
    PrimitiveOptions options;
    const bool stippled = s.random.chance(20), polygon = s.random.chance(20);
    options.mode =
        GLenum(polygon ? GL_TRIANGLES : s.random.pick({GL_LINES, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}));
    if (stippled && !polygon) {
      options.mode = GL_LINES; // of strips see the family "stippled"
      s.gl.Enable(GL_LINE_STIPPLE);
      const GLint factor = s.random.chance(50) ? 1 : s.random.integer(0, 9);
      s.gl.LineStipple(factor, GLushort(s.random.bits()));
    } else {
      s.gl.Disable(GL_LINE_STIPPLE);
    }
    s.gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    random_primitive(s, options);
  }
}

static SceneRegistration smooth_lines{{"smooth_lines", draw_smooth_lines, true}};

} // namespace softgl::test
