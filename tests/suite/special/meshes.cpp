// Grids, and the points and meshes that are evaluated on them (5.1).
#include "special/chapter.h"
#include "special/evaluated.h"

namespace softgl::suite {
namespace {

Test mesh_row(const std::string& name, const char* sentence, std::function<void(Script&)> body,
              const char* section = "5.1") {
  return special_test("mesh." + name, section, sentence, std::move(body));
}

// The grid of the hill: 4 partitions in u, 3 in v.
void grid(Script& s) { hill(s), s.MapGrid2f(4, 0, 1, 3, 0, 1); }

} // namespace

std::vector<Test> special_mesh_tests() {
  return {
      mesh_row("grid_1", "glEvalPoint1 evaluates a point of the grid between u1 and u2.",
               [](Script& s) {
                 arch(s), s.MapGrid1f(5, 0.1, 0.9);
                 fed_back(s, GL_3D, [&] {
                   s.Begin(GL_POINTS);
                   for (int i = 0; i <= 5; i++) s.EvalPoint1(i);
                   s.End();
                 });
               }),
      mesh_row("grid_1_backwards", "A grid may run backwards.",
               [](Script& s) {
                 arch(s), s.MapGrid1d(4, 0.9, 0.2);
                 fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 4); });
               }),
      mesh_row("grid_1_domain", "A grid lies in the domain of the map.",
               [](Script& s) {
                 arch(s, -3, 5), s.MapGrid1f(4, -2, 4),
                     fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 4); });
               }),
      mesh_row("mesh_1_points", "glEvalMesh1 with GL_POINT gives points.",
               [](Script& s) {
                 arch(s), s.MapGrid1f(6, 0, 1), fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 6); });
               }),
      mesh_row("mesh_1_line", "glEvalMesh1 with GL_LINE gives a strip of lines.",
               [](Script& s) {
                 arch(s), arch_colors(s), s.MapGrid1f(5, 0, 1),
                     fed_back(
                         s, GL_3D_COLOR, [&] { s.EvalMesh1(GL_LINE, 0, 5); }, FedOrder::InOrder, 6);
               }),
      mesh_row("mesh_1_part", "A mesh may be a part of its grid.",
               [](Script& s) {
                 arch(s), s.MapGrid1f(8, 0, 1),
                     fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_LINE, 2, 5), s.EvalMesh1(GL_POINT, 7, 8); });
               }),
      mesh_row("mesh_1_ends", "The ends of a grid are exactly u1 and u2.",
               [](Script& s) {
                 arch(s), s.MapGrid1f(7, 0, 1), fed_back(s, GL_3D, [&] {
                   s.EvalMesh1(GL_POINT, 0, 0), s.EvalMesh1(GL_POINT, 7, 7), s.Begin(GL_POINTS),
                       s.EvalCoord1f(0), s.EvalCoord1f(1), s.End();
                 });
               }),
      mesh_row("mesh_1_empty", "A mesh from a greater to a smaller number is empty.",
               [](Script& s) {
                 arch(s), s.MapGrid1f(6, 0, 1),
                     fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 4, 3), s.PassThrough(2); });
               }),
      mesh_row("drawn_line", "A curve is drawn as lines.",
               [](Script& s) {
                 arch(s), s.LineWidth(3), tint(s, 3), s.MapGrid1f(9, 0, 1), s.EvalMesh1(GL_LINE, 0, 9);
               }),
      mesh_row("drawn_points", "A curve is drawn as points.",
               [](Script& s) {
                 arch(s), tint(s, 1), s.PointSize(5), s.MapGrid1f(9, 0, 1), s.EvalMesh1(GL_POINT, 0, 9);
               }),
      mesh_row("grid_2", "glEvalPoint2 evaluates a point of the grid.",
               [](Script& s) {
                 hill(s), s.MapGrid2f(3, 0.1, 0.7, 2, 0.9, 0.2);
                 fed_back(s, GL_3D, [&] {
                   s.Begin(GL_POINTS);
                   for (int i = 0; i <= 3; i++)
                     for (int j = 0; j <= 2; j++) s.EvalPoint2(i, j);
                   s.End();
                 });
               }),
      mesh_row("grid_2_double", "glMapGrid2d sets the same grid.",
               [](Script& s) {
                 hill(s, -1, 2, 5, 9), s.MapGrid2d(3, 1.5, -0.5, 2, 6, 8);
                 fed_back(s, GL_3D, [&] { s.EvalMesh2(GL_POINT, 0, 3, 0, 2); });
               }),
      mesh_row("mesh_2_points", "glEvalMesh2 with GL_POINT gives points.",
               [](Script& s) { grid(s), fed_back(s, GL_3D, [&] { s.EvalMesh2(GL_POINT, 0, 4, 0, 3); }); }),
      mesh_row("mesh_2_lines", "glEvalMesh2 with GL_LINE gives strips of lines in u, then in v.",
               [](Script& s) {
                 grid(s), fed_back(
                              s, GL_2D, [&] { s.EvalMesh2(GL_LINE, 0, 4, 0, 3); }, FedOrder::InOrder, 4);
               }),
      mesh_row("mesh_2_fill", "glEvalMesh2 with GL_FILL gives strips of quadrilaterals.",
               [](Script& s) {
                 grid(s), hill_colors(s);
                 fed_back(
                     s, GL_3D_COLOR, [&] { s.EvalMesh2(GL_FILL, 0, 4, 0, 3); }, FedOrder::AnyOrder, 6);
               }),
      mesh_row("mesh_2_part", "A mesh may be a part of its grid.",
               [](Script& s) {
                 grid(s), fed_back(
                              s, GL_3D,
                              [&] {
                                s.EvalMesh2(GL_POINT, 1, 3, 1, 2), s.PassThrough(8),
                                    s.EvalMesh2(GL_LINE, 2, 3, 0, 1);
                              },
                              FedOrder::InOrder, 6);
               }),
      mesh_row("mesh_2_fill_part", "A part of a grid may be filled.",
               [](Script& s) {
                 grid(s), fed_back(
                              s, GL_3D, [&] { s.EvalMesh2(GL_FILL, 1, 3, 1, 3); }, FedOrder::AnyOrder);
               }),
      mesh_row("mesh_2_ends", "The ends of a grid are exactly u1, u2, v1 and v2.",
               [](Script& s) {
                 hill(s), s.MapGrid2f(7, 0, 1, 11, 0, 1), fed_back(s, GL_3D, [&] {
                   s.EvalMesh2(GL_POINT, 0, 0, 0, 0), s.EvalMesh2(GL_POINT, 7, 7, 0, 0),
                       s.EvalMesh2(GL_POINT, 7, 7, 11, 11), s.EvalMesh2(GL_POINT, 0, 0, 11, 11);
                 });
               }),
      mesh_row("drawn_hill", "A surface is filled.",
               [](Script& s) {
                 grid(s), hill_colors(s), s.Disable(GL_MAP2_COLOR_4), tint(s, 5),
                     s.EvalMesh2(GL_FILL, 0, 4, 0, 3);
               }),
      mesh_row("drawn_net", "A surface is drawn as lines.",
               [](Script& s) { grid(s), tint(s, 1), s.EvalMesh2(GL_LINE, 0, 4, 0, 3); }),
      mesh_row(
          "edges", "The edges of a filled mesh that is drawn as lines are those of its quadrilaterals.",
          [](Script& s) {
            hill(s), s.MapGrid2f(2, 0, 1, 1, 0, 1), s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), tint(s, 3),
                s.EvalMesh2(GL_FILL, 0, 2, 0, 1);
          },
          "5.1, 3.5.4"),
      mesh_row(
          "faces",
          "The quadrilaterals of a mesh whose u goes right and whose v goes up face away from the viewer.",
          [](Script& s) {
            grid(s), tint(s, 4), s.Enable(GL_CULL_FACE), s.CullFace(GL_FRONT),
                s.EvalMesh2(GL_FILL, 0, 2, 0, 3), s.CullFace(GL_BACK), s.EvalMesh2(GL_FILL, 2, 4, 0, 3);
          },
          "5.1, 3.5.1"),
      mesh_row(
          "grid_asked_for", "The grids can be asked for; at first they have one partition of [0, 1].",
          [](Script& s) {
            s.GetFloatv(GL_MAP1_GRID_DOMAIN, V{0, 1}), s.GetFloatv(GL_MAP1_GRID_SEGMENTS, V{1}),
                s.GetFloatv(GL_MAP2_GRID_DOMAIN, V{0, 1, 0, 1}), s.GetFloatv(GL_MAP2_GRID_SEGMENTS, V{1, 1});
            s.MapGrid1f(5, -1, 3), s.MapGrid2f(2, 3, 4, 7, -5, 6), s.GetFloatv(GL_MAP1_GRID_DOMAIN, V{-1, 3}),
                s.GetFloatv(GL_MAP1_GRID_SEGMENTS, V{5});
            s.GetFloatv(GL_MAP2_GRID_DOMAIN, V{3, 4, -5, 6}), s.GetFloatv(GL_MAP2_GRID_SEGMENTS, V{2, 7}),
                arrow(s);
          },
          "5.1, table 6.26"),
      mesh_row(
          "grid_initial", "At first a grid has two points.",
          [](Script& s) {
            hill(s), arch(s),
                fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 1), s.EvalMesh2(GL_POINT, 0, 1, 0, 1); });
          },
          "5.1, table 6.26"),
  };
}

} // namespace softgl::suite
