// The view volume and the planes of the user (2.12).
#include "lighting/scenes.h"
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

// The view volume is the middle of the window.
void small_viewport(Script& s) { s.Viewport(22, 22, 52, 52); }

Test plane_row(const char* name, GLenum plane, V equation) {
  return row(name, "2.12", "A clip plane keeps the half space where its equation is not less than 0.",
             [=](Script& s) {
               s.ClipPlane(plane, equation), s.Enable(plane), mesh(s, -0.95, -0.95, 0.95, 0.95, 8);
             });
}

// Lines from left to right that do not cross.
void fence(Script& s, double half = 0.95) {
  s.Begin(GL_LINES);
  for (int i = 0; i < 6; i++) {
    tint(s, i), s.Vertex3f(-half, -half + 2 * half * i / 5, 0);
    tint(s, i + 2), s.Vertex3f(half, -half + 2 * half * (i + 0.3) / 5, 0);
  }
  s.End();
}

} // namespace

std::vector<Test> vertices_clipping_tests() {
  return {
      row("clipping.view_sides", "2.12", "What is beside the view volume is cut away from polygons.",
          [](Script& s) { small_viewport(s), mesh(s, -1.9, -0.8, 1.7, 0.7, 9); }),
      row("clipping.view_top", "2.12", "What is above and below the view volume is cut away from polygons.",
          [](Script& s) { small_viewport(s), mesh(s, -0.8, -1.9, 0.9, 1.8, 9); }),
      row("clipping.view_corners", "2.12",
          "A polygon that is larger than the view volume fills the viewport.",
          [](Script& s) {
            small_viewport(s), s.Color3f(0.3, 0.9, 0.5), s.Begin(GL_TRIANGLES);
            s.Vertex3f(-9, -8, 0), s.Vertex3f(9, -8, 0), s.Vertex3f(0.5, 12, 0), s.End();
          }),
      row("clipping.view_near", "2.12", "What is nearer than the near plane is cut away.",
          [](Script& s) { mesh(s, -0.95, -0.9, 0.95, 0.9, 8, -6, 9); }),
      row("clipping.view_far", "2.12", "What is farther than the far plane is cut away.",
          [](Script& s) { mesh(s, -0.95, -0.9, 0.95, 0.9, 8, -30, -2); }),
      row("clipping.behind_the_eye", "2.12",
          "A polygon that reaches behind the eye is drawn in front of it only.",
          [](Script& s) {
            perspective(s), s.LoadIdentity(), s.Begin(GL_TRIANGLES);
            tint(s, 0), s.Vertex3f(-0.9, -0.4, 4), s.Vertex3f(-0.5, -0.4, -14), s.Vertex3f(2.5, -0.4, -14);
            tint(s, 3), s.Vertex3f(1, 0.5, 6), tint(s, 3), s.Vertex3f(2, 0.5, -16),
                s.Vertex3f(-2.2, 0.5, -16);
            s.End();
          }),
      row("clipping.negative_w", "2.12", "A polygon of vertices with w < 0 is outside.",
          [](Script& s) {
            s.Begin(GL_TRIANGLES), tint(s, 0), s.Vertex4f(0.9, 0.9, 0, -1), s.Vertex4f(-0.9, 0.9, 0, -1),
                s.Vertex4f(0, -0.9, 0, -1), s.End();
            arrow(s);
          }),
      row("clipping.view_lines", "2.12",
          "The part of a line outside of the view volume is not drawn; colors are those of the whole line.",
          [](Script& s) { small_viewport(s), fence(s, 1.9); }),
      row("clipping.lines_near", "2.12",
          "Lines are cut by the near plane, and their color at the cut is interpolated.",
          [](Script& s) {
            s.Begin(GL_LINES);
            for (int i = 0; i < 5; i++) {
              tint(s, i), s.Vertex3f(-0.9, -0.8 + 0.35 * i, -3);
              tint(s, i + 3), s.Vertex3f(0.95, -0.7 + 0.35 * i, 9);
            }
            s.End();
          }),
      row("clipping.points_by_center", "2.12",
          "A point whose center is outside is not drawn; one whose center is inside is.",
          [](Script& s) {
            s.Viewport(24, 24, 48, 48), s.PointSize(7), s.Begin(GL_POINTS);
            for (int i = 0; i < 7; i++)
              for (int j = 0; j < 7; j++)
                tint(s, i + j), s.Vertex3f(-1.65 + 0.55 * i, -1.65 + 0.55 * j, i == 3 && j == 3 ? 9 : 0);
            s.End();
          }),
      row("clipping.colors", "2.12.1",
          "The color where a triangle is cut is interpolated between those of its corners.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{0, 1, 0, 0.1}), s.Enable(GL_CLIP_PLANE0), s.Begin(GL_TRIANGLES);
            tint(s, 0), s.Vertex3f(-0.95, -0.9, 0), tint(s, 1), s.Vertex3f(0.95, -0.7, 0), tint(s, 2),
                s.Vertex3f(-0.1, 0.95, 0);
            s.End();
          }),
      row("clipping.flat", "2.12.1, 2.14.7",
          "A flat triangle keeps its color although the vertex that gives it is cut off.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), s.ClipPlane(GL_CLIP_PLANE0, V{0, -1, 0, 0.2}), s.Enable(GL_CLIP_PLANE0),
                arrow(s);
            s.Translatef(-0.4, -0.6, 0), arrow(s), s.Translatef(0.9, 0.3, 0), s.Scalef(1.3, 1.3, 1), arrow(s);
          }),
      row("clipping.edges", "2.12", "The edge along a cut is a boundary.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.ClipPlane(GL_CLIP_PLANE0, V{-1, -0.3, 0, 0.2}),
                s.Enable(GL_CLIP_PLANE0);
            tint(s, 3), s.Begin(GL_POLYGON), s.Vertex3f(-0.9, -0.8, 0), s.Vertex3f(0.8, -0.9, 0),
                s.Vertex3f(0.9, 0.7, 0), s.Vertex3f(-0.7, 0.9, 0), s.End();
          }),
      row("clipping.edges_near", "2.12", "The edge along a plane of the view volume is a boundary, too.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), tint(s, 1), s.Begin(GL_POLYGON),
                s.Vertex3f(-0.9, -0.8, 0), s.Vertex3f(0.8, -0.9, 8), s.Vertex3f(0.9, 0.7, 8),
                s.Vertex3f(-0.7, 0.9, 0), s.End();
          }),
      row("clipping.edge_flags", "2.12", "What is left of an edge keeps its flag.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.ClipPlane(GL_CLIP_PLANE0, V{-1, 0, 0, 0.3}),
                s.Enable(GL_CLIP_PLANE0);
            tint(s, 3), s.Begin(GL_QUADS);
            for (int i = 0; i < 2; i++) {
              const double y = -0.9 + i;
              s.EdgeFlag(i), s.Vertex3f(-0.9, y, 0), s.EdgeFlag(1), s.Vertex3f(0.9, y, 0), s.EdgeFlag(1 - i),
                  s.Vertex3f(0.9, y + 0.8, 0);
              s.EdgeFlag(1), s.Vertex3f(-0.9, y + 0.8, 0);
            }
            s.End();
          }),
      row("clipping.corners_as_points", "2.12, 3.5.4",
          "The corners of what is left of a polygon are its points.",
          [](Script& s) {
            s.PolygonMode(GL_FRONT_AND_BACK, GL_POINT), s.PointSize(7),
                s.ClipPlane(GL_CLIP_PLANE0, V{-1, -0.3, 0, 0.2});
            s.Enable(GL_CLIP_PLANE0), tint(s, 1), s.Begin(GL_POLYGON), s.Vertex3f(-0.9, -0.8, 0),
                s.Vertex3f(0.8, -0.9, 0), s.Vertex3f(0.9, 0.7, 0), s.Vertex3f(-0.7, 0.9, 0), s.End();
          }),
      plane_row("clipping.plane_0", GL_CLIP_PLANE0, {1, 0.2, 0, 0.3}),
      plane_row("clipping.plane_1", GL_CLIP_PLANE1, {-1, 0.3, 0, 0.4}),
      plane_row("clipping.plane_2", GL_CLIP_PLANE2, {0.1, 1, 0, 0.2}),
      plane_row("clipping.plane_3", GL_CLIP_PLANE3, {0.2, -1, 0, 0.5}),
      plane_row("clipping.plane_4", GL_CLIP_PLANE4, {3, 3, 0, 1}),
      plane_row("clipping.plane_5", GL_CLIP_PLANE5, {-0.1, -0.1, 0, 0.03}),
      row("clipping.planes_together", "2.12", "The clip volume is what all planes keep.",
          [](Script& s) {
            const V planes[] = {{1, 0, 0, 0.6},  {-1, 0, 0, 0.7}, {0, 1, 0, 0.8},
                                {0, -1, 0, 0.5}, {1, 1, 0, 0.9},  {-1, -1, 0, 0.7}};
            for (unsigned i = 0; i < 6; i++)
              s.ClipPlane(GL_CLIP_PLANE0 + i, planes[i]), s.Enable(GL_CLIP_PLANE0 + i);
            mesh(s, -0.95, -0.95, 0.95, 0.95, 8);
          }),
      row("clipping.plane_transformed", "2.12",
          "A plane is transformed by the inverse of the modelview when it is set.",
          [](Script& s) {
            s.PushMatrix(), s.Translatef(0.3, 0, 0), s.Rotatef(30, 0, 0, 1), s.Scalef(2, 0.5, 1),
                s.ClipPlane(GL_CLIP_PLANE2, V{-1, 0.1, 0, 0.1}), s.PopMatrix();
            s.Enable(GL_CLIP_PLANE2), mesh(s, -0.95, -0.95, 0.95, 0.95, 8);
          }),
      row("clipping.plane_stays", "2.12", "A later change of the modelview does not move a plane.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE1, V{-1, -1, 0, 0.1}), s.Enable(GL_CLIP_PLANE1), s.Rotatef(90, 0, 0, 1),
                s.Translatef(0.1, 0, 0);
            mesh(s, -0.9, -0.9, 0.9, 0.9, 8);
          }),
      row("clipping.plane_and_projection", "2.12", "The projection does not matter to a plane.",
          [](Script& s) {
            perspective(s), s.ClipPlane(GL_CLIP_PLANE0, V{0.5, 0.2, 1, 0.3}), s.Enable(GL_CLIP_PLANE0);
            mesh(s, -0.9, -0.9, 0.9, 0.9, 8, 0.8, -0.9);
          }),
      row("clipping.plane_before_enable", "2.12", "A plane that is not enabled does nothing, and is kept.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE3, V{0, -1, 0, 0.2}), arrow(s), s.Translatef(0.2, -0.2, 0),
                s.Enable(GL_CLIP_PLANE3);
            mesh(s, -0.3, -0.4, 0.6, 0.9, 6), s.Disable(GL_CLIP_PLANE3), s.Translatef(-0.6, 0.5, 0), arrow(s);
          }),
      row("clipping.plane_initial", "2.12, table 6.7", "At first a plane is (0, 0, 0, 0), which keeps all.",
          [](Script& s) {
            s.Enable(GL_CLIP_PLANE4), arrow(s), s.IsEnabled(GL_CLIP_PLANE4, 1),
                s.IsEnabled(GL_CLIP_PLANE5, 0);
          }),
      row("clipping.plane_lines", "2.12", "Planes cut lines, and the color at the cut is interpolated.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{1, 0.4, 0, 0.3}), s.Enable(GL_CLIP_PLANE0), fence(s);
          }),
      row("clipping.plane_points", "2.12", "A point is there if its center is on the plane's side.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{1, 0.5, 0, 0.11}), s.Enable(GL_CLIP_PLANE0), s.PointSize(9),
                s.Begin(GL_POINTS);
            for (int i = 0; i < 6; i++)
              for (int j = 0; j < 6; j++) tint(s, i + j), s.Vertex3f(-0.9 + 0.36 * i, -0.9 + 0.36 * j, 0);
            s.End();
          }),
      row("clipping.plane_w", "2.12", "A plane of the user weighs the w of eye coordinates.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{1, 0, 0, 0.2}), s.Enable(GL_CLIP_PLANE0), s.Begin(GL_TRIANGLES);
            tint(s, 4), s.Vertex4f(-1.8, -1.6, 0, 2), s.Vertex4f(3.6, -3.4, 0, 4),
                s.Vertex4f(-0.05, 0.45, 0, 0.5), s.End();
          }),
      row("clipping.planes_saved", "6.1.14, table 6.7",
          "GL_TRANSFORM_BIT saves the planes, and which are enabled.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{-1, 0, 0, 0.3}), s.Enable(GL_CLIP_PLANE0),
                s.PushAttrib(GL_TRANSFORM_BIT);
            s.ClipPlane(GL_CLIP_PLANE0, V{0, 1, 0, -5}), s.Disable(GL_CLIP_PLANE0), s.Enable(GL_CLIP_PLANE1),
                s.PopAttrib();
            mesh(s, -0.95, -0.9, 0.95, 0.9, 8), s.IsEnabled(GL_CLIP_PLANE1, 0);
          }),
      row("clipping.planes_enable_bit", "6.1.14, table 6.7",
          "GL_ENABLE_BIT saves which planes are enabled, and no plane.",
          [](Script& s) {
            s.Enable(GL_CLIP_PLANE0), s.PushAttrib(GL_ENABLE_BIT),
                s.ClipPlane(GL_CLIP_PLANE0, V{-1, 0.2, 0, 0.3});
            s.Disable(GL_CLIP_PLANE0), s.PopAttrib(), mesh(s, -0.95, -0.9, 0.95, 0.9, 8);
          }),
  };
}

} // namespace softgl::suite
