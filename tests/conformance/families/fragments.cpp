// What happens to a fragment: fog, blending, logic operations, alpha test, depth test, masks, scissor,
// polygon offset.
#include "conformance/families/common.h"

namespace softgl::test {

static void draw_fog(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 50);
    random_fog(s);
    PrimitiveOptions options;
    options.mode = s.random.chance(15) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    options.fog_coordinates = s.random.chance(35);
    s.gl.Fogi(GL_FOG_COORDINATE_SOURCE, options.fog_coordinates ? GL_FOG_COORDINATE : GL_FRAGMENT_DEPTH);
    options.secondary_colors = s.random.chance(30);
    if (options.secondary_colors)
      s.gl.Enable(GL_COLOR_SUM);
    else
      s.gl.Disable(GL_COLOR_SUM);
    s.gl.ShadeModel(s.random.chance(70) ? GL_SMOOTH : GL_FLAT);
    s.gl.PointSize(5);
    s.gl.LineWidth(3);
    random_primitive(s, options);
  }
}

static void draw_blend(Stage& s) {
  random_canvas(s);
  backdrop(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 20);
    random_blending(s);
    if (s.random.chance(25))
      random_alpha_test(s);
    else
      s.gl.Disable(GL_ALPHA_TEST);
    PrimitiveOptions options;
    options.mode = s.random.chance(15) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    s.gl.PointSize(6);
    s.gl.LineWidth(2);
    random_primitive(s, options);
  }
}

static void draw_depth(Stage& s) {
  random_canvas(s);
  random_projection(s);
  for (int batch = s.random.integer(2, 5); batch > 0; batch--) {
    random_modelview(s);
    random_depth(s, 95);
    random_culling(s);
    random_scissor(s, 25);
    if (s.random.chance(10)) {
      s.gl.ClearDepth(s.random.real(-0.2f, 1.2f));
      s.gl.Clear(GL_DEPTH_BUFFER_BIT);
    }
    if (s.random.chance(10)) {
      const bool r = s.random.chance(60), g = s.random.chance(60), b = s.random.chance(60),
                 a = s.random.chance(60);
      s.gl.ColorMask(r, g, b, a);
      if (s.random.chance(50)) s.gl.Clear(GL_COLOR_BUFFER_BIT);
    }
    PrimitiveOptions options;
    options.mode = s.random.chance(15) ? GLenum(s.random.pick({GL_LINES, GL_POINTS})) : random_filled_mode(s);
    options.spread = s.random.chance(70) ? Spread::View : Spread::Any;
    s.gl.PointSize(4);
    random_primitive(s, options);
  }
}

static void draw_offset(Stage& s) {
  random_canvas(s);
  random_projection(s);
  s.gl.Enable(GL_DEPTH_TEST);
  s.gl.DepthFunc(GL_LEQUAL);
  rigid_modelview(s);
  for (int batch = s.random.integer(2, 4); batch > 0; batch--) {
    if (s.random.chance(75))
      s.gl.Enable(GL_POLYGON_OFFSET_FILL);
    else
      s.gl.Disable(GL_POLYGON_OFFSET_FILL);
    const float factor = s.random.real(-3, 3),
                units = s.random.chance(50) ? float(s.random.integer(-8, 8)) : s.random.real(-10000, 10000);
    s.gl.PolygonOffset(factor, units);
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    options.spread = s.random.chance(70) ? Spread::View : Spread::Any;
    random_primitive(s, options);
  }
}

static void draw_alpha(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_depth(s, 40);
    random_alpha_test(s);
    random_scissor(s, 15);
    PrimitiveOptions options;
    options.mode = random_filled_mode(s);
    random_primitive(s, options);
  }
}

static SceneRegistration fog{{"fog", draw_fog, true}}, blend{{"blend", draw_blend, true}},
    depth{{"depth", draw_depth, true}}, offset{{"offset", draw_offset, true}},
    alpha{{"alpha", draw_alpha, true}};

} // namespace softgl::test
