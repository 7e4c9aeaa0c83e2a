// Evaluators of two dimensions, and their normals (5.1).
#include "special/chapter.h"
#include "special/evaluated.h"

namespace softgl::suite {
namespace {

Test surface_row(const std::string& name, const char* sentence, std::function<void(Script&)> body,
                 const char* section = "5.1") {
  return special_test("surface." + name, section, sentence, std::move(body));
}

// Points of the surface.
void places(Script& s, double u1 = 0, double u2 = 1, double v1 = 0, double v2 = 1) {
  const double at[6][2] = {{0, 0}, {1, 0}, {0.3, 0.8}, {0.6, 0.45}, {0, 1}, {1, 1}};
  s.Begin(GL_POINTS);
  for (const auto& p : at) s.EvalCoord2f(u1 + (u2 - u1) * p[0], v1 + (v2 - v1) * p[1]);
  s.End();
}

// A map of so many values and orders, enabled.
void map_of(Script& s, GLenum target, int values, int u_order, int v_order) {
  V points;
  for (int i = 0; i < u_order * v_order * values; i++)
    points.push_back(0.1 + 0.17 * (i % 5) - 0.06 * (i % 7) + 0.01 * i);
  s.Map2f(target, 0, 1, values * v_order, u_order, 0, 1, values, v_order, points), s.Enable(target);
}

void lights(Script& s) {
  s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0), s.Lightfv(GL_LIGHT0, GL_POSITION, V{0.4, 0.5, 1, 0});
  s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0);
}

Test surface_texture_row(int coordinates, const char* sentence) {
  return surface_row("texture_" + std::to_string(coordinates), sentence, [=](Script& s) {
    hill(s), map_of(s, GL_MAP2_TEXTURE_COORD_1 + GLenum(coordinates) - 1, coordinates, 3, 2),
        s.TexCoord4f(5, 6, 7, 8);
    fed_back(
        s, GL_3D_COLOR_TEXTURE, [&] { places(s); }, FedOrder::InOrder, 6);
  });
}

Test orders_row(const char* name, int u_order, int v_order, const char* sentence) {
  return surface_row(name, sentence, [=](Script& s) {
    V points;
    for (int i = 0; i < u_order; i++)
      for (int j = 0; j < v_order; j++)
        points.insert(points.end(), {-0.8 + 1.5 * i / std::max(u_order - 1, 1) + 0.04 * j * i,
                                     -0.8 + 1.4 * j / std::max(v_order - 1, 1), 0.3 * ((i + 2 * j) % 4)});
    s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3 * v_order, u_order, 0, 1, 3, v_order, points),
        s.Enable(GL_MAP2_VERTEX_3);
    fed_back(s, GL_3D, [&] { places(s); });
  });
}

} // namespace

std::vector<Test> special_surface_tests() {
  return {
      orders_row("orders", 3, 2, "A surface has an order in u and one in v."),
      orders_row("orders_turned", 2, 4, "The order in v may be the greater one."),
      orders_row("orders_8", 8, 8, "Orders of 8 are possible in both directions."),
      orders_row("order_1", 1, 1, "A surface of order 1 is one point."),
      surface_row(
          "strides", "The control point R_ij stands ustride i + vstride j numbers behind the first.",
          [](Script& s) {
            V points; // v runs slower than u, and there is a number between the points
            for (int j = 0; j < 2; j++)
              for (int i = 0; i < 3; i++)
                points.insert(points.end(), {-0.8 + 0.7 * i, -0.7 + 1.3 * j + 0.2 * i, 0.4 * (i - j), 9});
            s.Map2f(GL_MAP2_VERTEX_3, 0, 1, 4, 3, 0, 1, 12, 2, points), s.Enable(GL_MAP2_VERTEX_3),
                fed_back(s, GL_3D, [&] { places(s); });
          }),
      surface_row(
          "domain", "The domain goes from (u1, v1) to (u2, v2).",
          [](Script& s) { hill(s, -2, 3, 10, 14), fed_back(s, GL_3D, [&] { places(s, -2, 3, 10, 14); }); }),
      surface_row("domain_backwards", "u1 may be greater than u2, v1 than v2.",
                  [](Script& s) {
                    hill(s, 3, -2, 14, 10),
                        fed_back(s, GL_3D, [&] { places(s, 3, -2, 14, 10), places(s, 1, 2, 11, 12); });
                  }),
      surface_row("vertex_4", "GL_MAP2_VERTEX_4 gives x, y, z and w, and is preferred to GL_MAP2_VERTEX_3.",
                  [](Script& s) {
                    hill(s), s.Map2f(GL_MAP2_VERTEX_4, 0, 1, 8, 2, 0, 1, 4, 2,
                                     V{-0.9, -0.7, 0, 1, -0.5, 0.8, 0.2, 0.9, 0.9, -0.6, 0.3, 1.2, 1.5, 1.3,
                                       -0.4, 2});
                    s.Enable(GL_MAP2_VERTEX_4), fed_back(s, GL_4D_COLOR_TEXTURE, [&] { places(s); });
                  }),
      surface_row("color", "GL_MAP2_COLOR_4 gives colors.",
                  [](Script& s) { hill(s), hill_colors(s), fed_back(s, GL_3D_COLOR, [&] { places(s); }); }),
      surface_texture_row(1, "GL_MAP2_TEXTURE_COORD_1 gives s; t and r are 0, q is 1."),
      surface_texture_row(2, "GL_MAP2_TEXTURE_COORD_2 gives s and t; r is 0, q is 1."),
      surface_texture_row(3, "GL_MAP2_TEXTURE_COORD_3 gives s, t and r; q is 1."),
      surface_texture_row(4, "GL_MAP2_TEXTURE_COORD_4 gives s, t, r and q."),
      surface_row("normal", "GL_MAP2_NORMAL gives normals.",
                  [](Script& s) {
                    lights(s), hill(s),
                        s.Map2f(GL_MAP2_NORMAL, 0, 1, 6, 2, 0, 1, 3, 2,
                                V{-0.8, 0, 0.6, 0, 0, 1, 0.6, 0, 0.8, 0, 0.6, 0.8});
                    s.Enable(GL_NORMALIZE), s.Enable(GL_MAP2_NORMAL),
                        fed_back(s, GL_3D_COLOR, [&] { places(s); });
                  }),
      surface_row("auto_normal", "GL_AUTO_NORMAL gives the normals of the surface.",
                  [](Script& s) {
                    lights(s), hill(s), s.Enable(GL_AUTO_NORMAL),
                        fed_back(s, GL_3D_COLOR, [&] { places(s); });
                  }),
      surface_row("auto_normal_4",
                  "GL_AUTO_NORMAL gives the normals of the surface that has been divided by w.",
                  [](Script& s) {
                    lights(s), s.Enable(GL_AUTO_NORMAL);
                    s.Map2f(GL_MAP2_VERTEX_4, 0, 1, 8, 2, 0, 1, 4, 2,
                            V{-0.9, -0.7, 0, 1, -0.5, 0.8, 0.2, 0.9, 0.9, -0.6, 0.3, 1.2, 1.5, 1.3, -0.4, 2});
                    s.Enable(GL_MAP2_VERTEX_4), fed_back(s, GL_3D_COLOR, [&] { places(s); });
                  }),
      surface_row("auto_normal_wins", "GL_AUTO_NORMAL is preferred to a map of normals.",
                  [](Script& s) {
                    lights(s), hill(s), s.Map2f(GL_MAP2_NORMAL, 0, 1, 3, 1, 0, 1, 3, 1, V{0.8, 0, 0.6}),
                        s.Enable(GL_MAP2_NORMAL), s.Enable(GL_AUTO_NORMAL),
                        fed_back(s, GL_3D_COLOR, [&] { places(s); });
                  }),
      surface_row("current_normal",
                  "Without GL_AUTO_NORMAL and a map of normals the current normal is taken, and stays.",
                  [](Script& s) {
                    lights(s), hill(s), s.Normal3f(0.6, 0, 0.8), fed_back(s, GL_3D_COLOR, [&] { places(s); });
                    s.GetFloatv(GL_CURRENT_NORMAL, V{0.6, 0, 0.8});
                  }),
      surface_row("auto_normal_stays", "The normals of GL_AUTO_NORMAL do not become current.",
                  [](Script& s) {
                    lights(s), hill(s), s.Enable(GL_AUTO_NORMAL), s.Normal3f(0.6, 0, 0.8);
                    fed_back(s, GL_3D_COLOR, [&] { places(s), dot(s, 30, 40); });
                  }),
      surface_row("color_stays", "Evaluation does not change the current color.",
                  [](Script& s) {
                    hill(s), hill_colors(s), s.Color4f(0.1, 0.8, 0.4, 0.6);
                    fed_back(s, GL_3D_COLOR, [&] { places(s), dot(s, 30, 40); });
                  }),
      surface_row("lit_hill", "A surface with automatic normals is lit as its normals ask for.",
                  [](Script& s) {
                    lights(s), hill(s), s.Enable(GL_AUTO_NORMAL), s.Begin(GL_TRIANGLES);
                    const double cell[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
                    for (int i = 0; i < 36; i++)
                      for (const auto& c : cell) s.EvalCoord2f((i % 6 + c[0]) / 6, (i / 6 + c[1]) / 6);
                    s.End();
                  }),
      surface_row("without_vertices", "Without a map of vertices nothing happens.",
                  [](Script& s) {
                    hill(s), hill_colors(s), s.Disable(GL_MAP2_VERTEX_3), arch(s);
                    fed_back(s, GL_3D_COLOR, [&] {
                      s.Begin(GL_POINTS), s.EvalCoord2f(0.3, 0.5), tint(s, 3), pixel_vertex(s, 30, 40),
                          s.EvalCoord2f(0.6, 0.1), s.End();
                      s.EvalMesh2(GL_FILL, 0, 1, 0, 1), s.PassThrough(3);
                    });
                  }),
      surface_row("doubles", "Maps and places may be given as doubles and behind pointers.",
                  [](Script& s) {
                    s.Map2d(GL_MAP2_VERTEX_3, 0.5, 2.5, 6, 2, -1, 1, 3, 2,
                            V{-0.9, -0.7, 0.2, -0.5, 0.8, -0.4, 0.8, -0.5, 0.3, 0.7, 0.6, 0.5});
                    s.Enable(GL_MAP2_VERTEX_3);
                    fed_back(s, GL_3D, [&] {
                      s.Begin(GL_POINTS), s.EvalCoord2d(0.7, 0.1), s.EvalCoord2fv(V{1.1, -0.4}),
                          s.EvalCoord2dv(V{2.2, 0.9}), s.End();
                    });
                  }),
      surface_row(
          "initial", "At first maps are of order 1 and cover [0, 1] x [0, 1], and none is enabled.",
          [](Script& s) {
            s.GetMapfv(GL_MAP2_VERTEX_4, GL_COEFF, V{0, 0, 0, 1}),
                s.GetMapfv(GL_MAP2_NORMAL, GL_COEFF, V{0, 0, 1}),
                s.GetMapfv(GL_MAP2_COLOR_4, GL_COEFF, V{1, 1, 1, 1}),
                s.GetMapfv(GL_MAP2_TEXTURE_COORD_3, GL_COEFF, V{0, 0, 0});
            s.GetMapfv(GL_MAP2_VERTEX_3, GL_ORDER, V{1, 1}),
                s.GetMapfv(GL_MAP2_VERTEX_3, GL_DOMAIN, V{0, 1, 0, 1}), s.IsEnabled(GL_MAP2_VERTEX_3, 0),
                s.IsEnabled(GL_AUTO_NORMAL, 0);
            s.Enable(GL_MAP2_VERTEX_4), fed_back(s, GL_3D, [&] { places(s); });
          },
          "5.1, table 6.26"),
      surface_row(
          "asked_for", "glGetMap gives R_ij as control point (uorder i + j), whatever the strides are.",
          [](Script& s) {
            s.Map2f(GL_MAP2_TEXTURE_COORD_1, 2, 5, 1, 2, -3, 4, 2, 2, V{1, 2, 3, 4});
            s.GetMapfv(GL_MAP2_TEXTURE_COORD_1, GL_COEFF, V{1, 3, 2, 4}),
                s.GetMapfv(GL_MAP2_TEXTURE_COORD_1, GL_ORDER, V{2, 2}),
                s.GetMapfv(GL_MAP2_TEXTURE_COORD_1, GL_DOMAIN, V{2, 5, -3, 4});
            s.Map2f(GL_MAP2_TEXTURE_COORD_1, 0, 1, 3, 2, 0, 1, 1, 3, V{1, 2, 3, 4, 5, 6}),
                s.GetMapfv(GL_MAP2_TEXTURE_COORD_1, GL_ORDER, V{2, 3});
            hill(s), fed_back(s, GL_3D, [&] { places(s); });
          },
          "5.1, 6.1.2, 6.1.3"),
  };
}

} // namespace softgl::suite
