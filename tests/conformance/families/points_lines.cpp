// Points of any size; lines, strips and loops of any width.
#include "conformance/families/common.h"

namespace softgl::test {

static void draw_points(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    random_scissor(s, 10);
    s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
    s.gl.PointSize(s.random.chance(20) ? 1.0f : s.random.chance(20) ? float(s.random.integer(1, 20)) * 0.5f : s.random.real(0.1f, s.random.chance(10) ? 80.0f : 12.0f));
    PrimitiveOptions options;
    options.mode = GL_POINTS;
    random_primitive(s, options);
  }
}

static void draw_lines(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    random_scissor(s, 10);
    s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
    s.gl.LineWidth(s.random.chance(50) ? 1.0f : s.random.chance(20) ? float(s.random.integer(1, 20)) * 0.5f : s.random.real(0.1f, s.random.chance(10) ? 60.0f : 10.0f));
    PrimitiveOptions options;
    options.mode = GLenum(s.random.pick({GL_LINES, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}));
    random_primitive(s, options);
  }
}

static SceneRegistration points{{"points", draw_points, true}}, lines{{"lines", draw_lines, true}};

} // namespace softgl::test
