// Evaluators of one dimension (5.1).
#include "special/chapter.h"
#include "special/evaluated.h"

namespace softgl::suite {
namespace {

Test curve_row(const std::string& name, const char* sentence, std::function<void(Script&)> body,
               const char* section = "5.1") {
  return special_test("curve." + name, section, sentence, std::move(body));
}

// Points of the curve from 0 to 1.
void curve(Script& s, int count = 5, double from = 0, double to = 1) {
  s.Begin(GL_POINTS);
  for (int i = 0; i < count; i++) s.EvalCoord1f(from + (to - from) * i / (count - 1));
  s.End();
}

Test order_row(int order) {
  return curve_row("order_" + std::to_string(order), "A curve has as many control points as its order says.",
                   [=](Script& s) {
                     V points;
                     for (int i = 0; i < order; i++)
                       points.insert(points.end(), {-0.9 + 1.7 * i / std::max(order - 1, 1),
                                                    (i % 3) * 0.7 - 0.6, 0.3 * (i % 2)});
                     s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 3, order, points), s.Enable(GL_MAP1_VERTEX_3),
                         fed_back(s, GL_3D, [&] { curve(s, 6); });
                   });
}

Test curve_texture_row(int coordinates, const char* sentence) {
  return curve_row("texture_" + std::to_string(coordinates), sentence, [=](Script& s) {
    V points;
    for (int i = 0; i < 2 * coordinates; i++) points.push_back(0.3 + 0.7 * i - (i % 3));
    const GLenum target = GL_MAP1_TEXTURE_COORD_1 + GLenum(coordinates) - 1;
    arch(s), s.Map1f(target, 0, 1, coordinates, 2, points), s.Enable(target);
    s.TexCoord4f(5, 6, 7, 8), fed_back(s, GL_3D_COLOR_TEXTURE, [&] { curve(s, 3); });
  });
}

} // namespace

std::vector<Test> special_curve_tests() {
  return {
      order_row(1),
      order_row(2),
      order_row(3),
      order_row(4),
      order_row(8),
      curve_row("stride", "Between control points there may be other numbers.",
                [](Script& s) {
                  s.Map1f(GL_MAP1_VERTEX_3, 0, 1, 5, 3,
                          V{-0.9, -0.7, 0.2, 9, 9, 0.1, 1.6, -0.4, 9, 9, 0.8, -0.5, 0.3});
                  s.Enable(GL_MAP1_VERTEX_3), fed_back(s, GL_3D, [&] { curve(s); });
                }),
      curve_row("domain", "The domain goes from u1 to u2.",
                [](Script& s) { arch(s, -3, 5), fed_back(s, GL_3D, [&] { curve(s, 5, -3, 5); }); }),
      curve_row("domain_backwards", "u1 may be greater than u2.",
                [](Script& s) { arch(s, 7, 2), fed_back(s, GL_3D, [&] { curve(s, 5, 3, 7); }); }),
      curve_row("vertex_4", "GL_MAP1_VERTEX_4 gives x, y, z and w.",
                [](Script& s) {
                  s.Map1f(GL_MAP1_VERTEX_4, 0, 1, 4, 3,
                          V{-0.9, -0.7, 0, 1, 0.1, 1.2, 0.4, 2, 0.6, -0.4, -0.5, 0.8});
                  s.Enable(GL_MAP1_VERTEX_4), fed_back(s, GL_4D_COLOR_TEXTURE, [&] { curve(s); });
                }),
      curve_row("vertex_4_wins", "Of two maps of vertices the one of four coordinates is taken.",
                [](Script& s) {
                  arch(s), s.Map1f(GL_MAP1_VERTEX_4, 0, 1, 4, 2, V{-0.9, -0.7, 0, 1, 0.6, -0.4, -0.5, 0.8});
                  s.Enable(GL_MAP1_VERTEX_4),
                      fed_back(s, GL_3D, [&] { curve(s), s.Disable(GL_MAP1_VERTEX_4), curve(s); });
                }),
      curve_row("color", "GL_MAP1_COLOR_4 gives colors.",
                [](Script& s) { arch(s), arch_colors(s), fed_back(s, GL_3D_COLOR, [&] { curve(s); }); }),
      curve_texture_row(1, "GL_MAP1_TEXTURE_COORD_1 gives s; t and r are 0, q is 1."),
      curve_texture_row(2, "GL_MAP1_TEXTURE_COORD_2 gives s and t; r is 0, q is 1."),
      curve_texture_row(3, "GL_MAP1_TEXTURE_COORD_3 gives s, t and r; q is 1."),
      curve_texture_row(4, "GL_MAP1_TEXTURE_COORD_4 gives s, t, r and q."),
      curve_row("texture_most_wins", "Of several maps of texture coordinates the one of the most is taken.",
                [](Script& s) {
                  arch(s), s.Map1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, V{0.2, 0.4, 3, 4}),
                      s.Map1f(GL_MAP1_TEXTURE_COORD_1, 0, 1, 1, 2, V{7, 8}),
                      s.Map1f(GL_MAP1_TEXTURE_COORD_3, 0, 1, 3, 1, V{0.6, 2, 3.5});
                  s.Enable(GL_MAP1_TEXTURE_COORD_1), s.Enable(GL_MAP1_TEXTURE_COORD_2);
                  fed_back(
                      s, GL_3D_COLOR_TEXTURE,
                      [&] { curve(s, 3), s.Enable(GL_MAP1_TEXTURE_COORD_3), curve(s, 3); }, FedOrder::InOrder,
                      6);
                }),
      curve_row("normal", "GL_MAP1_NORMAL gives normals, which light the vertices.",
                [](Script& s) {
                  arch(s), s.Map1f(GL_MAP1_NORMAL, 0, 1, 3, 2, V{-0.8, 0, 0.6, 0.6, 0, 0.8}),
                      s.Enable(GL_MAP1_NORMAL);
                  s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0), s.Enable(GL_NORMALIZE),
                      fed_back(s, GL_3D_COLOR, [&] { curve(s); });
                }),
      curve_row("current_values", "What no map gives is current.",
                [](Script& s) {
                  arch(s), s.Color4f(0.2, 0.7, 0.9, 0.3), s.TexCoord4f(0.4, 1.3, 2.2, 3.1);
                  fed_back(
                      s, GL_3D_COLOR_TEXTURE, [&] { curve(s); }, FedOrder::InOrder, 6);
                }),
      curve_row("color_stays", "Evaluation does not change the current color.",
                [](Script& s) {
                  arch(s), arch_colors(s), s.Color4f(0.2, 0.7, 0.9, 0.3);
                  fed_back(s, GL_3D_COLOR, [&] {
                    s.Begin(GL_POINTS), s.EvalCoord1f(0.3), pixel_vertex(s, 30, 40), s.EvalCoord1f(0.6),
                        s.End();
                  });
                  s.GetFloatv(GL_CURRENT_COLOR, V{0.2, 0.7, 0.9, 0.3});
                }),
      curve_row("texture_stays", "Evaluation does not change the current texture coordinates.",
                [](Script& s) {
                  arch(s), s.Map1f(GL_MAP1_TEXTURE_COORD_2, 0, 1, 2, 2, V{0.2, 0.4, 3, 4}),
                      s.Enable(GL_MAP1_TEXTURE_COORD_2);
                  s.TexCoord4f(0.5, 0.6, 0.7, 2);
                  fed_back(s, GL_3D_COLOR_TEXTURE, [&] {
                    s.Begin(GL_POINTS), s.EvalCoord1f(0.3), pixel_vertex(s, 30, 40), s.EvalCoord1f(0.6),
                        s.End();
                  });
                  s.GetFloatv(GL_CURRENT_TEXTURE_COORDS, V{0.5, 0.6, 0.7, 2});
                }),
      curve_row("normal_stays", "Evaluation does not change the current normal.",
                [](Script& s) {
                  arch(s), s.Map1f(GL_MAP1_NORMAL, 0, 1, 3, 2, V{-0.8, 0, 0.6, 0.6, 0, 0.8}),
                      s.Enable(GL_MAP1_NORMAL);
                  s.Normal3f(0, 0.6, 0.8), s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0);
                  fed_back(s, GL_3D_COLOR, [&] {
                    s.Begin(GL_POINTS), s.EvalCoord1f(0), pixel_vertex(s, 30, 40), s.EvalCoord1f(1), s.End();
                  });
                  s.GetFloatv(GL_CURRENT_NORMAL, V{0, 0.6, 0.8});
                }),
      curve_row(
          "color_material", "An evaluated color is tracked for its vertex, and no longer.",
          [](Script& s) {
            arch(s), arch_colors(s), s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0),
                s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Enable(GL_COLOR_MATERIAL);
            s.Color4f(0.9, 0.2, 0.1, 0.5);
            fed_back(s, GL_3D_COLOR, [&] {
              s.Begin(GL_POINTS), s.EvalCoord1f(0.2), pixel_vertex(s, 30, 40), s.EvalCoord1f(0.9), s.End(),
                  dot(s, 70, 80);
            });
          },
          "5.1, 2.14.3"),
      curve_row("without_vertices", "Without a map of vertices nothing happens.",
                [](Script& s) {
                  arch(s), arch_colors(s), s.Disable(GL_MAP1_VERTEX_3), s.Color3f(1, 1, 0);
                  fed_back(s, GL_3D_COLOR, [&] {
                    s.Begin(GL_POINTS), s.EvalCoord1f(0.3), tint(s, 3), pixel_vertex(s, 30, 40),
                        s.EvalCoord1f(0.6), s.End();
                    s.EvalMesh1(GL_LINE, 0, 1), s.PassThrough(3);
                  });
                }),
      curve_row("other_dimension", "Maps of two dimensions do not matter to glEvalCoord1.",
                [](Script& s) {
                  arch(s), s.Map2f(GL_MAP2_COLOR_4, 0, 1, 4, 1, 0, 1, 4, 1, V{0.1, 0.2, 0.3, 0.4}),
                      s.Enable(GL_MAP2_COLOR_4);
                  s.Map2f(GL_MAP2_VERTEX_4, 0, 1, 4, 1, 0, 1, 4, 1, V{0.1, 0.2, 0.3, 1}),
                      s.Enable(GL_MAP2_VERTEX_4);
                  fed_back(s, GL_3D_COLOR, [&] { curve(s); });
                }),
      curve_row("doubles", "Maps and places may be given as doubles and behind pointers.",
                [](Script& s) {
                  s.Map1d(GL_MAP1_VERTEX_3, 0.5, 2.5, 4, 3,
                          V{-0.9, -0.7, 0.2, 9, 0.1, 1.6, -0.4, 9, 0.8, -0.5, 0.3});
                  s.Enable(GL_MAP1_VERTEX_3);
                  fed_back(s, GL_3D, [&] {
                    s.Begin(GL_POINTS), s.EvalCoord1d(0.7), s.EvalCoord1fv(V{1.1}), s.EvalCoord1dv(V{2.2}),
                        s.End();
                  });
                }),
      curve_row(
          "initial",
          "At first maps are of order 1: vertices (0, 0, 0, 1), normals (0, 0, 1), white, texture "
          "coordinates (0, 0, 0, 1).",
          [](Script& s) {
            s.GetMapfv(GL_MAP1_VERTEX_4, GL_COEFF, V{0, 0, 0, 1}),
                s.GetMapfv(GL_MAP1_NORMAL, GL_COEFF, V{0, 0, 1}),
                s.GetMapfv(GL_MAP1_COLOR_4, GL_COEFF, V{1, 1, 1, 1}),
                s.GetMapfv(GL_MAP1_TEXTURE_COORD_4, GL_COEFF, V{0, 0, 0, 1});
            s.GetMapfv(GL_MAP1_VERTEX_3, GL_COEFF, V{0, 0, 0}), s.GetMapfv(GL_MAP1_VERTEX_3, GL_ORDER, V{1}),
                s.GetMapfv(GL_MAP1_VERTEX_3, GL_DOMAIN, V{0, 1}), s.IsEnabled(GL_MAP1_VERTEX_3, 0),
                s.IsEnabled(GL_MAP1_COLOR_4, 0);
            s.Color3f(0.1, 0.2, 0.3), s.Enable(GL_MAP1_VERTEX_4), s.Enable(GL_MAP1_COLOR_4),
                fed_back(s, GL_3D_COLOR, [&] { curve(s, 2); });
          },
          "5.1, table 6.26"),
      curve_row(
          "asked_for", "glGetMap gives the control points, the order and the domain of a map.",
          [](Script& s) {
            s.Map1f(GL_MAP1_TEXTURE_COORD_2, -1, 4, 3, 3, V{0.2, 0.4, 9, 3, 4, 9, 5, 6});
            s.GetMapfv(GL_MAP1_TEXTURE_COORD_2, GL_COEFF, V{0.2, 0.4, 3, 4, 5, 6}),
                s.GetMapfv(GL_MAP1_TEXTURE_COORD_2, GL_ORDER, V{3}),
                s.GetMapfv(GL_MAP1_TEXTURE_COORD_2, GL_DOMAIN, V{-1, 4});
            arch(s), fed_back(s, GL_3D, [&] { curve(s); });
          },
          "5.1, 6.1.3"),
      curve_row(
          "saved", "GL_EVAL_BIT saves which maps are enabled and the grids, GL_ENABLE_BIT the first.",
          [](Script& s) {
            arch(s), s.MapGrid1f(4, 0.25, 0.75), s.PushAttrib(GL_EVAL_BIT), s.MapGrid1f(2, 0, 1),
                s.Disable(GL_MAP1_VERTEX_3), s.Enable(GL_MAP1_COLOR_4), s.Enable(GL_AUTO_NORMAL),
                s.PopAttrib();
            s.IsEnabled(GL_MAP1_COLOR_4, 0), s.IsEnabled(GL_AUTO_NORMAL, 0),
                s.GetFloatv(GL_MAP1_GRID_SEGMENTS, V{4});
            s.PushAttrib(GL_ENABLE_BIT), s.MapGrid1f(5, 0.25, 0.75), s.Disable(GL_MAP1_VERTEX_3),
                s.PopAttrib();
            fed_back(s, GL_3D, [&] { s.EvalMesh1(GL_POINT, 0, 5); });
          },
          "5.1, table 6.26, 6.1.14"),
  };
}

} // namespace softgl::suite
