// All primitives that are filled, without lighting: smooth and flat, one to many primitives, clipped and not.
#include <vector>

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
    options.mode = s.random.pick({GL_TRIANGLES, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                  GL_QUAD_STRIP, GL_POLYGON});
    random_primitive(s, options);
  }
}

// Smooth quads that nothing clips, drawn at once: there OSMesa cuts them from vertex 0 to vertex 2.
static void draw_quads(Stage& s) {
  const Gl& gl = s.gl;
  random_canvas(s);
  for (int batch = s.random.integer(1, 3); batch > 0; batch--) {
    random_depth(s, 40);
    random_culling(s);
    if (s.random.chance(30)) random_fog(s);
    const int count = 4 * s.random.integer(1, 12);
    std::vector<float> positions, colors;
    const bool twisted = s.random.chance(30);
    for (int i = 0; i < count; i += 4) {
      const float x = s.random.real(-0.5f, 0.5f), y = s.random.real(-0.5f, 0.5f),
                  size = s.random.pick({0.45f, 0.45f, 0.2f, 0.01f});
      for (int k = 0; k < 4; k++) {
        const float dx = k == 1 || k == 2 ? size : -size, dy = k >= 2 ? size : -size,
                    bend = size * (twisted ? 0.9f : 0.3f);
        // 0.7 keeps the farthest corner (1.36) inside the view volume.
        const Float3 p{0.7f * (x + dx + s.random.real(-bend, bend)),
                       0.7f * (y + dy + s.random.real(-bend, bend)), s.random.real(-0.9f, 0.9f)};
        positions.insert(positions.end(), p.begin(), p.end());
        const Float4 c = s.random.color();
        colors.insert(colors.end(), c.begin(), c.end());
      }
    }
    if (s.random.chance(50)) {
      gl.Begin(GL_QUADS);
      for (int i = 0; i < count; i++) {
        gl.Color4fv(&colors[size_t(4 * i)]);
        gl.Vertex3fv(&positions[size_t(3 * i)]);
      }
      gl.End();
    } else {
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.EnableClientState(GL_COLOR_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
      gl.ColorPointer(4, GL_FLOAT, 0, colors.data());
      gl.DrawArrays(GL_QUADS, 0, count);
    }
  }
  gl.Finish();
}

static SceneRegistration quads{{"quads", draw_quads, true}};
static SceneRegistration registration{{"triangles", draw_triangles, true}};

} // namespace softgl::test
