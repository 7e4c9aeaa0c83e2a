// Flat primitives that have the color of their first vertex (GL_EXT_provoking_vertex). Depths are not tested:
// where corners come in another order, last bits of planes differ. A fan of three vertices is left out
// (reference/DEVIATIONS.md).
#include "conformance/families/common.h"

namespace softgl::test {
namespace {

void draw_first_vertices(Stage& s) {
  const Gl& gl = s.gl;
  Random& r = s.random;
  random_canvas(s);
  for (int batch = r.integer(1, 4); batch > 0; --batch) {
    random_projection(s);
    random_modelview(s);
    random_culling(s);
    random_scissor(s, 20);
    gl.ShadeModel(GL_FLAT);
    gl.ProvokingVertex(r.chance(80) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
    gl.Disable(GL_LIGHTING);
    if (r.chance(25)) {
      gl.Enable(GL_LIGHTING);
      gl.Enable(GL_LIGHT0);
      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, r.chance(70));
    }
    PrimitiveOptions options;
    options.mode = r.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON,
                           GL_TRIANGLE_FAN, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_POINTS});
    if (options.mode == GL_TRIANGLE_FAN) options.primitives = r.integer(2, 20);
    options.normals = true;
    options.secondary_colors = r.chance(30);
    if (options.secondary_colors) gl.Enable(GL_COLOR_SUM);
    const bool in_list = r.chance(30);
    if (in_list) gl.NewList(1, r.pick({GL_COMPILE, GL_COMPILE_AND_EXECUTE}));
    random_primitive(s, options);
    if (in_list) gl.EndList();
    if (in_list) gl.CallList(1);
    gl.Disable(GL_COLOR_SUM);
  }
}

SceneRegistration first_vertices{{"provoking_vertex", draw_first_vertices, true}};

} // namespace
} // namespace softgl::test
