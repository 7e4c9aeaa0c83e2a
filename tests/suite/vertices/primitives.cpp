// Begin and End: the ten primitives, and what is left of incomplete ones (2.6.1).
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// `few` vertices of the mode draw nothing; the same mode behind it begins anew.
Test too_few(const char* name, GLenum mode, int few, int enough, const char* sentence) {
  return row(name, "2.6.1", sentence, [=](Script& s) {
    for (int count = 1; count <= few; count++) {
      s.Begin(mode), s.Color3f(1, 1, 1);
      for (int i = 0; i < count; i++) s.Vertex3f(i % 2 ? 0.9 : -0.9, i > 1 ? 0.95 : -0.93 + 0.3 * i, 0);
      s.End();
    }
    zigzag(s, mode, enough);
  });
}

} // namespace

std::vector<Test> vertices_primitive_tests() {
  return {
      row("primitives.points", "2.6.1", "Each vertex of GL_POINTS is a point.",
          [](Script& s) { s.PointSize(9), zigzag(s, GL_POINTS, 8); }),
      row("primitives.lines", "2.6.1", "Each pair of vertices of GL_LINES is a line.",
          [](Script& s) { zigzag(s, GL_LINES, 8); }),
      row("primitives.line_strip", "2.6.1", "Each vertex of a line strip but the first ends a line.",
          [](Script& s) { zigzag(s, GL_LINE_STRIP, 6); }),
      row("primitives.line_loop", "2.6.1", "A line loop closes from its last vertex to its first.",
          [](Script& s) { ring(s, GL_LINE_LOOP, 5); }),
      row("primitives.triangles", "2.6.1", "Three vertices each are a triangle of GL_TRIANGLES.",
          [](Script& s) { zigzag(s, GL_TRIANGLES, 9); }),
      row("primitives.triangle_strip", "2.6.1",
          "Each vertex from the third on makes a triangle with the two before it.",
          [](Script& s) { zigzag(s, GL_TRIANGLE_STRIP, 8); }),
      row("primitives.triangle_fan", "2.6.1", "All triangles of a fan have its first vertex.",
          [](Script& s) { ring(s, GL_TRIANGLE_FAN, 7, true); }),
      row("primitives.quads", "2.6.1", "Four vertices each are a quadrilateral of GL_QUADS.",
          [](Script& s) { quads(s, 3); }),
      row("primitives.quad_strip", "2.6.1",
          "The third and fourth vertex of a quad strip change places in its outline.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), s.Begin(GL_QUAD_STRIP);
            for (int i = 0; i < 8; i++) {
              tint(s, i / 2);
              s.Vertex3f(-0.95 + 0.6 * (i / 2), (i % 2 ? 0.83 : -0.81) + 0.1 * (i / 2 % 2), 0);
            }
            s.End();
          }),
      row("primitives.polygon", "2.6.1", "All vertices of GL_POLYGON bound one convex polygon.",
          [](Script& s) {
            s.Color3f(0.2, 0.9, 0.6), s.Begin(GL_POLYGON);
            for (const auto& v :
                 {std::pair{-0.9, -0.2}, {-0.3, -0.95}, {0.8, -0.7}, {0.95, 0.3}, {0.1, 0.9}, {-0.7, 0.6}})
              s.Vertex3f(v.first, v.second, 0);
            s.End();
          }),
      row("primitives.strip_orientation", "2.6.1, 3.5.1", "All triangles of a strip face the same way.",
          [](Script& s) {
            s.Enable(GL_CULL_FACE), s.FrontFace(GL_CW);
            zigzag(s, GL_TRIANGLE_STRIP, 9), s.FrontFace(GL_CCW), s.Translatef(0.05, 0, 0),
                s.Scalef(0.6, 0.4, 1);
            zigzag(s, GL_TRIANGLE_STRIP, 9);
          }),
      row("primitives.quad_strip_orientation", "2.6.1, 3.5.1",
          "A quad strip faces as the order of its first, second, fourth and third vertex says.",
          [](Script& s) {
            s.Enable(GL_CULL_FACE);
            s.Begin(GL_QUAD_STRIP);
            for (int i = 0; i < 6; i++) tint(s, 1), s.Vertex3f(-0.9 + 0.4 * (i / 2), i % 2 ? 0.1 : 0.8, 0);
            s.End();
            s.Begin(GL_QUAD_STRIP);
            for (int i = 0; i < 6; i++) tint(s, 3), s.Vertex3f(-0.9 + 0.7 * (i / 2), i % 2 ? -0.1 : -0.8, 0);
            s.End();
          }),
      too_few("primitives.line_of_one", GL_LINES, 1, 4, "One vertex of GL_LINES is no line."),
      too_few("primitives.strip_of_one", GL_LINE_STRIP, 1, 4, "One vertex is no line strip."),
      too_few("primitives.loop_of_one", GL_LINE_LOOP, 1, 3, "One vertex is no line loop."),
      too_few("primitives.triangles_of_two", GL_TRIANGLES, 2, 3,
              "Fewer than three vertices of GL_TRIANGLES draw nothing."),
      too_few("primitives.triangle_strip_of_two", GL_TRIANGLE_STRIP, 2, 5,
              "Fewer than three vertices are no triangle strip."),
      too_few("primitives.triangle_fan_of_two", GL_TRIANGLE_FAN, 2, 4,
              "Fewer than three vertices are no triangle fan."),
      too_few("primitives.polygon_of_two", GL_POLYGON, 2, 3, "Fewer than three vertices are no polygon."),
      row("primitives.quads_of_three", "2.6.1", "Fewer than four vertices of GL_QUADS draw nothing.",
          [](Script& s) {
            s.Begin(GL_QUADS), s.Vertex3f(-1, -1, 0), s.Vertex3f(1, -1, 0), s.Vertex3f(1, 1, 0), s.End();
            quads(s, 2);
          }),
      row("primitives.quad_strip_of_three", "2.6.1", "Fewer than four vertices are no quad strip.",
          [](Script& s) {
            s.Begin(GL_QUAD_STRIP), s.Vertex3f(-1, -1, 0), s.Vertex3f(1, -1, 0), s.Vertex3f(1, 1, 0), s.End();
            s.Begin(GL_QUAD_STRIP), tint(s, 2);
            for (int i = 0; i < 5; i++) s.Vertex3f(-0.8 + 0.7 * (i / 2), i % 2 ? 0.7 : -0.7, 0);
            s.End();
          }),
      row("primitives.lines_left_over", "2.6.1",
          "An odd vertex of GL_LINES is ignored, also by what follows.",
          [](Script& s) {
            zigzag(s, GL_LINES, 5), s.Translatef(-0.24, 0, 0), s.Scalef(0.3, 0.3, 1), ring(s, GL_LINES, 4);
          }),
      row("primitives.triangles_left_over", "2.6.1",
          "Vertices that complete no triangle are ignored, also by what follows.",
          [](Script& s) { zigzag(s, GL_TRIANGLES, 8), s.Scalef(0.6, 0.6, 1), ring(s, GL_TRIANGLES, 4); }),
      row("primitives.quads_left_over", "2.6.1",
          "Vertices that complete no quadrilateral are ignored, also by what follows.",
          [](Script& s) {
            quads(s, 2, 3), s.Translatef(0.3, 0.2, 0), s.Scalef(0.5, 0.5, 1), quads(s, 2, 1);
          }),
      row("primitives.flat_lines", "2.14.7, 2.6.1", "A flat line has the color of its second vertex.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), s.PushMatrix(), s.Translatef(0, 0.5, 0), s.Scalef(1, 0.5, 1);
            zigzag(s, GL_LINES, 8), s.PopMatrix(), s.Translatef(0, -0.5, 0), s.Scalef(1, 0.5, 1),
                zigzag(s, GL_LINE_STRIP, 5);
          }),
      row("primitives.flat_polygon", "2.14.7, table 2.12",
          "A flat polygon has the color of its first vertex.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), ring(s, GL_POLYGON, 6), s.Begin(GL_POLYGON);
            for (int i = 0; i < 4; i++)
              tint(s, 3 + i), s.Vertex3f(i == 0 || i == 3 ? -0.5 : 0.5, i < 2 ? -0.4 : 0.4, 0);
            s.End();
          }),
      row("primitives.flat_triangles", "2.14.7, table 2.12",
          "Flat triangles, strips and fans have the color of the last vertex of each triangle.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), s.PushMatrix(), s.Translatef(0, 0.5, 0), s.Scalef(1, 0.5, 1),
                zigzag(s, GL_TRIANGLES, 9), s.Scalef(0.6, 0.6, 1);
            zigzag(s, GL_TRIANGLE_STRIP, 7), s.PopMatrix(), s.Translatef(0, -0.5, 0), s.Scalef(1, 0.5, 1),
                ring(s, GL_TRIANGLE_FAN, 7, true);
          }),
      row("primitives.none", "2.6.1", "glBegin and glEnd without vertices draw nothing.",
          [](Script& s) {
            for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; mode++) s.Begin(mode), s.End();
            arrow(s);
          }),
      row("primitives.order", "2.1", "A primitive is drawn behind all that came before it.",
          [](Script& s) {
            zigzag(s, GL_TRIANGLE_STRIP, 6), s.Translatef(0.1, 0.1, 0), tint(s, 6), patch(s, 0, 0, 0.5),
                arrow(s);
          }),
  };
}

} // namespace softgl::suite
