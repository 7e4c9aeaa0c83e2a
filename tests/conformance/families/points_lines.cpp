// Points of any size; lines, strips and loops of any width, whole and stippled.
#include "conformance/families/common.h"

namespace softgl::test {

using SetSize = void (*Gl::*)(GLfloat);

// Vertices that are in view: where the first line of a strip is not, OSMesa goes on with an earlier pattern.
static void strip_in_view(Stage& s, GLenum mode) {
  for (GLenum matrix : {GL_PROJECTION, GL_MODELVIEW}) s.gl.MatrixMode(matrix), s.gl.LoadIdentity();
  s.gl.Begin(mode);
  for (int i = s.random.integer(2, 12); i > 0; i--) {
    const Float4 color = s.random.color();
    const Float3 v{s.random.real(-0.99f, 0.99f), s.random.real(-0.99f, 0.99f), s.random.real(-0.99f, 0.99f)};
    s.gl.Color4fv(color.data());
    s.gl.Vertex3fv(v.data());
  }
  s.gl.End();
}

// A few primitives, each with a size that is often 1, often a multiple of a half, rarely as large as `most`.
static void draw_batches(Stage& s, std::initializer_list<int> modes, SetSize set_size, int often, float usual,
                         float most, bool stippled) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 30);
    random_scissor(s, 10);
    s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
    (s.gl.*set_size)(s.random.chance(often) ? 1.0f
                     : s.random.chance(20)  ? float(s.random.integer(1, 20)) * 0.5f
                                            : s.random.real(0.1f, s.random.chance(10) ? most : usual));
    if (stippled) {
      s.gl.Enable(GL_LINE_STIPPLE);
      const GLint factor = s.random.chance(50) ? 1 : s.random.integer(0, 9);
      s.gl.LineStipple(factor, GLushort(s.random.bits()));
    }
    PrimitiveOptions options;
    options.mode = GLenum(s.random.pick(modes));
    if (stippled && options.mode != GL_LINES)
      strip_in_view(s, options.mode);
    else
      random_primitive(s, options);
  }
}

static void draw_points(Stage& s) { draw_batches(s, {GL_POINTS}, &Gl::PointSize, 20, 12, 80, false); }
static void draw_lines(Stage& s) {
  draw_batches(s, {GL_LINES, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}, &Gl::LineWidth, 50, 10, 60, false);
}
static void draw_stippled(Stage& s) {
  draw_batches(s, {GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP}, &Gl::LineWidth, 50, 10, 60, true);
}

static SceneRegistration points{{"points", draw_points, true}}, lines{{"lines", draw_lines, true}},
    stippled{{"stippled", draw_stippled, true}};

} // namespace softgl::test
