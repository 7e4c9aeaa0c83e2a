// All primitives that are filled, without lighting: smooth and flat, one to many primitives, clipped and not.
#include "conformance/families/common.h"

namespace softgl::test {

static void draw_triangles(Stage& s) {
  random_canvas(s);
  for (int batch = s.random.integer(1, 4); batch > 0; batch--) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_depth(s, 30);
    s.gl.ShadeModel(s.random.chance(50) ? GL_SMOOTH : GL_FLAT);
    PrimitiveOptions options;
    options.mode = s.random.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
    random_primitive(s, options);
  }
}

static SceneRegistration registration{{"triangles", draw_triangles, true}};

} // namespace softgl::test
