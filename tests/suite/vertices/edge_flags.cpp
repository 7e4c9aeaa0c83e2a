// Edge flags (2.6.2), which polygons that are drawn as lines and points show (3.5.4).
#include <cmath>

#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// A polygon on a circle; the bits of `flags` are its edge flags.
void flagged_ring(Script& s, GLenum mode, int count, unsigned flags) {
  s.Begin(mode);
  for (int i = 0; i < count; i++) {
    const double turn = 6.2831853 * i / count + 0.3;
    s.EdgeFlag(int(flags >> i & 1));
    s.Vertex3f(0.93 * std::cos(turn), 0.91 * std::sin(turn), 0);
  }
  s.End();
}
void outlined(Script& s, GLenum mode = GL_LINE) {
  s.PolygonMode(GL_FRONT_AND_BACK, mode), s.Color3f(1, 0.9, 0.2);
  if (mode == GL_POINT) s.PointSize(9);
}

} // namespace

std::vector<Test> vertices_edge_flag_tests() {
  return {
      row("edge_flags.polygon", "2.6.2",
          "An edge of GL_POLYGON whose first vertex has the flag GL_FALSE is not drawn.",
          [](Script& s) { outlined(s), flagged_ring(s, GL_POLYGON, 6, 0b110101); }),
      row("edge_flags.triangles", "2.6.2", "Each vertex of GL_TRIANGLES begins an edge.",
          [](Script& s) {
            outlined(s), s.Begin(GL_TRIANGLES);
            for (int i = 0; i < 6; i++)
              s.EdgeFlag(int(i != 1 && i != 5)),
                  s.Vertex3f(-0.9 + 0.33 * i, i % 3 == 1 ? 0.85 : -0.8 + 0.1 * i, 0);
            s.End();
          }),
      row("edge_flags.quads", "2.6.2", "Each vertex of GL_QUADS begins an edge.",
          [](Script& s) { outlined(s), flagged_ring(s, GL_QUADS, 4, 0b1011); }),
      row("edge_flags.strip_has_none", "2.6.2", "Edge flags do not matter to strips and fans.",
          [](Script& s) {
            outlined(s), s.EdgeFlag(0);
            s.Begin(GL_TRIANGLE_STRIP);
            for (int i = 0; i < 4; i++) s.Vertex3f(-0.9 + 0.6 * i, i % 2 ? 0.9 : 0.2, 0);
            s.End();
            s.Begin(GL_QUAD_STRIP);
            for (int i = 0; i < 4; i++) s.Vertex3f(-0.9 + 1.6 * (i / 2), i % 2 ? -0.1 : -0.9, 0);
            s.End();
          }),
      row("edge_flags.initial", "2.6.2", "At first all edges are boundaries.",
          [](Script& s) {
            outlined(s), s.Begin(GL_POLYGON);
            for (int i = 0; i < 5; i++) s.Vertex3f(0.9 * std::cos(1.2566 * i), 0.9 * std::sin(1.2566 * i), 0);
            s.End();
          }),
      row("edge_flags.vector", "2.6.2", "glEdgeFlagv sets the flag, which stays until it is set again.",
          [](Script& s) {
            outlined(s), s.EdgeFlagv(V{0}), s.Begin(GL_POLYGON);
            for (int i = 0; i < 6; i++) {
              if (i == 2) s.EdgeFlagv(V{1});
              if (i == 4) s.EdgeFlagv(V{0});
              s.Vertex3f(0.9 * std::cos(1.0472 * i), 0.9 * std::sin(1.0472 * i), 0);
            }
            s.End();
          }),
      row("edge_flags.points", "2.6.2, 3.5.4",
          "As points, a polygon shows the vertices whose flag is GL_TRUE.",
          [](Script& s) { outlined(s, GL_POINT), flagged_ring(s, GL_POLYGON, 6, 0b101101); }),
      row("edge_flags.filled", "2.6.2", "A filled polygon has no edge flags.",
          [](Script& s) { s.Color3f(0.3, 1, 0.5), flagged_ring(s, GL_POLYGON, 6, 0b010010); }),
      row("edge_flags.saved", "2.6.2, table 6.5", "GL_CURRENT_BIT saves the edge flag.",
          [](Script& s) {
            outlined(s), s.EdgeFlag(0), s.PushAttrib(GL_CURRENT_BIT), s.EdgeFlag(1), s.PopAttrib();
            s.Begin(GL_QUADS);
            s.Vertex3f(-0.9, -0.8, 0), s.Vertex3f(0.9, -0.85, 0), s.EdgeFlag(1), s.Vertex3f(0.85, 0.9, 0),
                s.Vertex3f(-0.8, 0.8, 0);
            s.End();
          }),
      row("edge_flags.list", "2.6.2, 5.4", "A list holds edge flags.",
          [](Script& s) {
            outlined(s), s.NewList(3, GL_COMPILE), flagged_ring(s, GL_QUADS, 4, 0b0101), s.EndList();
            s.CallList(3);
          }),
  };
}

} // namespace softgl::suite
