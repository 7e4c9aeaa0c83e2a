// Stippled polygons: patterns as the pixel storage modes read them, with all that fragments go through, among
// lines and points that are not stippled.
#include "conformance/families/common.h"

namespace softgl::test {

static void random_pattern(Stage& s) {
  const Gl& gl = s.gl;
  std::vector<GLubyte> pattern(4096);
  const int period = s.random.pick({1, 4, 16, 4096}); // short ones show rows and columns
  for (size_t i = 0; i < pattern.size(); i++)
    pattern[i] = i < size_t(period) ? GLubyte(s.random.bits()) : pattern[i - size_t(period)];
  random_unpacking(s);
  // OSMesa 22.3.6 writes a byte behind its stipple where this is no multiple of 8
  // (tests/spec/polygon_stipple_test.cpp).
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, s.random.pick({0, 0, 8, 16}));
  gl.PolygonStipple(pattern.data());
}

static void draw_polygon_stipples(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_depth(s, 60);
    random_scissor(s, 20);
    const bool stippled = s.random.chance(85);
    stippled ? gl.Enable(GL_POLYGON_STIPPLE) : gl.Disable(GL_POLYGON_STIPPLE);
    if (s.random.chance(80)) random_pattern(s);
    if (s.random.chance(25)) random_blending(s);
    if (s.random.chance(15)) random_alpha_test(s);
    if (s.random.chance(15)) random_fog(s);
    gl.ShadeModel(s.random.chance(60) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.mode = s.random.chance(85) ? random_filled_mode(s)
                                       : GLenum(s.random.pick({GL_LINES, GL_LINE_LOOP, GL_POINTS}));
    if (s.random.chance(15) && stippled) { // edges and corners are not stippled
      gl.PolygonMode(GL_FRONT_AND_BACK, s.random.pick({GL_LINE, GL_POINT}));
      options.mode = GL_TRIANGLES;
    }
    gl.LineWidth(s.random.pick({1.0f, 5.0f}));
    gl.PointSize(s.random.pick({1.0f, 9.0f}));
    random_primitive(s, options);
    for (GLenum what : {GL_FOG, GL_ALPHA_TEST, GL_BLEND, GL_COLOR_LOGIC_OP}) gl.Disable(what);
    gl.ColorMask(1, 1, 1, 1);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
}

static SceneRegistration stipples{{"polygon_stipples", draw_polygon_stipples, true}};

} // namespace softgl::test
