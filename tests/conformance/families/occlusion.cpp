// Occlusion queries: how many fragments pass. Counts become pixels, so that they are compared as all others.
#include <vector>

#include "conformance/families/common.h"

namespace softgl::test {
namespace {

/// A scene's queries, one of which may be counting.
class Queries {
public:
  explicit Queries(Stage& s) : s_(s), names_(size_t(s.random.integer(2, 6))) {
    s.gl.GenQueries(GLsizei(names_.size()), names_.data());
  }
  /// Begins a query, or ends the one that counts.
  void step() {
    if (active_) return end();
    active_ = names_[size_t(s_.random.integer(0, int(names_.size()) - 1))];
    s_.gl.BeginQuery(GL_SAMPLES_PASSED, active_);
  }
  void end() {
    if (!active_) return;
    s_.gl.EndQuery(GL_SAMPLES_PASSED);
    // Sometimes at once, sometimes behind further draws, sometimes only in the end.
    if (s_.random.chance(30)) ask(active_);
    active_ = 0;
  }
  /// Any one that does not count; one that was never begun has no result.
  void ask_any() {
    const GLuint name = names_[size_t(s_.random.integer(0, int(names_.size()) - 1))];
    if (name != active_ && s_.gl.IsQuery(name)) ask(name);
  }
  /// Makes all that was asked for visible, and forgets the queries.
  void show() {
    const Gl& gl = s_.gl;
    end();
    for (GLuint name : names_)
      if (gl.IsQuery(name)) ask(name);
    gl.DeleteQueries(GLsizei(names_.size()), names_.data());
    reset_state(s_);
    gl.Enable(GL_SCISSOR_TEST);
    int x = 0;
    for (GLuint count : counts_) {
      gl.Scissor(x, 0, 2, 2);
      x += 2;
      gl.ClearColor(float(count & 255) / 255, float(count >> 8 & 255) / 255, float(count >> 16 & 255) / 255,
                    float(count >> 24) / 255);
      gl.Clear(GL_COLOR_BUFFER_BIT);
    }
  }

private:
  void ask(GLuint name) {
    const Gl& gl = s_.gl;
    if (s_.random.chance(30)) {
      GLint available = 0; // stays so where the query found no memory
      while (!available && gl.IsQuery(name)) gl.GetQueryObjectiv(name, GL_QUERY_RESULT_AVAILABLE, &available);
    }
    GLuint count = 0;
    gl.GetQueryObjectuiv(name, GL_QUERY_RESULT, &count);
    counts_.push_back(count);
  }
  Stage& s_;
  std::vector<GLuint> names_, counts_;
  GLuint active_ = 0;
};

void random_stencil(Stage& s) {
  const Gl& gl = s.gl;
  if (!s.random.chance(25)) return gl.Disable(GL_STENCIL_TEST);
  gl.Enable(GL_STENCIL_TEST);
  const GLint reference = s.random.integer(0, 3);
  const GLuint mask = s.random.pick({0xffu, 3u});
  gl.StencilFunc(random_compare(s), reference, mask);
  const GLenum fail = s.random.pick({GL_KEEP, GL_INCR, GL_REPLACE}),
               depth_fail = s.random.pick({GL_KEEP, GL_DECR_WRAP}),
               pass = s.random.pick({GL_KEEP, GL_INCR, GL_INVERT, GL_ZERO});
  gl.StencilOp(fail, depth_fail, pass);
}

void draw_rectangle_of_pixels(Stage& s) {
  const Gl& gl = s.gl;
  std::vector<GLubyte> pixels(40 * 40 * 4);
  for (GLubyte& b : pixels) b = GLubyte(s.random.bits());
  const int x = s.random.integer(0, s.width - 1), y = s.random.integer(0, s.height - 1);
  gl.WindowPos3f(float(x), float(y), s.random.real(0, 1));
  const int width = s.random.integer(1, 40), height = s.random.integer(1, 40);
  if (s.random.chance(50)) return gl.DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl.Flush(); // OSMesa draws waiting bitmaps with later state (DEVIATIONS.md)
  gl.Bitmap(width, height, 0, 0, 0, 0, pixels.data());
  gl.Flush();
}

void random_draw(Stage& s) {
  const Gl& gl = s.gl;
  PrimitiveOptions options;
  options.mode = s.random.chance(25)
                     ? GLenum(s.random.pick({GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_POINTS}))
                     : random_filled_mode(s);
  gl.PointSize(s.random.chance(50) ? 1.0f : s.random.real(1, 9));
  gl.LineWidth(s.random.chance(50) ? 1.0f : s.random.real(1, 5));
  gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
  random_primitive(s, options);
}

void draw_occlusion(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  Queries queries(s);
  for (int batch = s.random.integer(2, 9); batch > 0; batch--) {
    if (s.random.chance(60)) queries.step();
    random_projection(s);
    random_modelview(s);
    random_depth(s, 70);
    random_culling(s);
    random_scissor(s, 25);
    random_stencil(s);
    if (s.random.chance(25))
      random_alpha_test(s);
    else
      gl.Disable(GL_ALPHA_TEST);
    gl.ColorMask(1, 1, 1, 1);
    gl.Disable(GL_BLEND), gl.Disable(GL_COLOR_LOGIC_OP);
    if (s.random.chance(25)) random_blending(s);
    if (s.random.chance(20)) gl.ColorMask(0, 0, 0, 0); // as programs do that only want to count
    if (s.random.chance(20))
      random_fog(s);
    else
      gl.Disable(GL_FOG);
    for (int draws = s.random.integer(1, 3); draws > 0; draws--) {
      if (s.random.chance(12))
        draw_rectangle_of_pixels(s);
      else
        random_draw(s);
      if (s.random.chance(15)) queries.step();
    }
    // What hides draws does not hide them from queries.
    if (s.random.chance(15)) {
      gl.ColorMask(1, 1, 1, 1);
      gl.DepthMask(1);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    if (s.random.chance(10)) gl.Flush();
    if (s.random.chance(20)) queries.ask_any();
  }
  queries.show();
}

SceneRegistration occlusion{{"occlusion", draw_occlusion, true}};

} // namespace
} // namespace softgl::test
