// Polygons (3.5.1 to 3.5.4).
#include <cmath>

#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test culled(const char* name, GLenum face, GLenum front, const char* sentence) {
  return raster_test(std::string("polygons.cull_") + name, "3.5.1", sentence, [=](Script& s) {
    s.Enable(GL_CULL_FACE), s.CullFace(face), s.FrontFace(front), two_faces(s);
    s.Disable(GL_CULL_FACE), tint(s, 6), box(s, 10, 84, 86, 92);
  });
}
Test drawn_as(const char* name, GLenum face, GLenum mode) {
  return raster_test(std::string("polygons.mode_") + name, "3.5.4",
                     "Polygons of the face are filled, or drawn as lines or points.",
                     [=](Script& s) { s.PointSize(7), s.PolygonMode(face, mode), two_faces(s); });
}

Memory pattern(int kind) {
  Memory m{GL_UNSIGNED_BYTE, {}};
  for (int y = 0; y < 32; y++)
    for (int b = 0; b < 4; b++)
      m.elements.push_back(kind == 0   ? (y % 2 ? 0x55 : 0xaa)
                           : kind == 1 ? (b * 37 + y * 11) % 256
                           : y < 16    ? 0xf0
                           : b < 2     ? 0xff
                                       : 1);
  return m;
}
Test patterned(const char* name, int kind, const char* sentence) {
  return raster_test(std::string("polygons.stipple_") + name, "3.5.2", sentence, [=](Script& s) {
    s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.PolygonStipple(pattern(kind)), s.Enable(GL_POLYGON_STIPPLE);
    mesh(s, -0.95, -0.95, 0.95, 0.95, 4);
  });
}
const char* const kPattern = "A fragment of a polygon is drawn if its bit of the 32 x 32 pattern is 1.";

// All pixels of the rectangle have the same color: a rectangle that is a pixel to the right is the same.
void paint_even(Script& s, int x, int y, int width, int height) {
  s.PaintSame(x, y, x + 1, y, width - 1, height, 0, 0), s.PaintSame(x, y, x, y + 1, width, height - 1, 0, 8);
}

// A sheet of triangles whose corners are `from` and whole pixels behind it.
void sheet(Script& s, double from, int cells, double size) {
  s.Begin(GL_TRIANGLES);
  for (int j = 0; j < cells; j++)
    for (int i = 0; i < cells; i++) {
      const double x = from + size * i, y = from + size * j;
      const bool other = (i * 7 + j * 3) % 2 != 0; // diagonal
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {other ? 1 : 0, 1}})
        pixel_vertex(s, x + dx * size, y + dy * size);
      for (const auto& [dx, dy] : {std::pair{other ? 0 : 1, 0}, {1, 1}, {0, 1}})
        pixel_vertex(s, x + dx * size, y + dy * size);
    }
  s.End();
}
void add_up(Script& s) { s.Enable(GL_BLEND), s.BlendFunc(GL_ONE, GL_ONE), s.Color3f(0.3, 0.25, 0.2); }

} // namespace

std::vector<Test> raster_polygon_tests() {
  return {
      raster_test(
          "polygons.centers", "3.5.1",
          "A fragment is drawn if its center lies inside: small triangles with no center are not seen.",
          [](Script& s) {
            tint(s, 3), s.Begin(GL_TRIANGLES);
            for (int j = 0; j < 12; j++)
              for (int i = 0; i < 12; i++) {
                const double x = 5.3 + 7.3 * i, y = 5.2 + 7.2 * j, size = 0.5 + 0.4 * ((i * 5 + j * 3) % 9);
                pixel_vertex(s, x, y), pixel_vertex(s, x + size, y + 0.1),
                    pixel_vertex(s, x + 0.3 * size, y + size);
              }
            s.End();
          }),
      raster_test("polygons.common_edges", "3.5.1",
                  "Of two polygons with a common edge exactly one draws a fragment of the edge.",
                  [](Script& s) {
                    add_up(s), s.Begin(GL_TRIANGLE_FAN), pixel_vertex(s, 48.5, 48.5);
                    for (int i = 0; i <= 7; i++)
                      pixel_vertex(s, 48.5 + 41 * std::cos(0.8976 * i), 48.5 + 41 * std::sin(0.8976 * i));
                    s.End(), paint_even(s, 24, 24, 49, 49);
                  }),
      raster_test(
          "polygons.edges_through_centers", "3.5.1",
          "Of two polygons with a common edge exactly one draws a fragment whose center lies on the edge.",
          [](Script& s) { add_up(s), sheet(s, 16.5, 4, 16), paint_even(s, 20, 20, 56, 56); }),
      raster_test("polygons.colors", "3.5.1, equation 3.6", "Colors are interpolated over a triangle.",
                  [](Script& s) { s.Scalef(2, 2, 1), arrow(s); }),
      raster_test("polygons.depths", "3.5.1",
                  "Depths are interpolated evenly in the window: two triangles meet in a line.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), tint(s, 2), s.Begin(GL_TRIANGLES);
                    pixel_vertex(s, 10.3, 82.2, 2), pixel_vertex(s, 86.2, 84.3, -11),
                        pixel_vertex(s, 48.4, 8.2, -2), s.End();
                  }),
      raster_test("polygons.depths_in_perspective", "3.5.1",
                  "Depths are interpolated evenly in the window: two triangles meet in a line.",
                  [](Script& s) {
                    s.MatrixMode(GL_PROJECTION), s.LoadIdentity(),
                        s.Frustum(-0.27, 0.27, -0.273, 0.267, 1, 20), s.MatrixMode(GL_MODELVIEW);
                    s.Enable(GL_DEPTH_TEST), tint(s, 0), s.Begin(GL_TRIANGLES), s.Vertex3f(-1, -0.9, -3),
                        s.Vertex3f(0.8, -0.7, 1.5), s.Vertex3f(-0.7, 1.1, -1), s.End();
                    tint(s, 2), s.Begin(GL_TRIANGLES), s.Vertex3f(-0.9, 0.8, 1.2), s.Vertex3f(1.2, 0.9, -4),
                        s.Vertex3f(0.1, -1, -0.5), s.End();
                  }),
      culled("back", GL_BACK, GL_CCW, "With GL_BACK front faces are drawn."),
      culled("front", GL_FRONT, GL_CCW, "With GL_FRONT back faces are drawn."),
      culled("back_clockwise", GL_BACK, GL_CW, "glFrontFace turns the faces around."),
      culled("front_clockwise", GL_FRONT, GL_CW, "glFrontFace turns the faces around."),
      culled("both", GL_FRONT_AND_BACK, GL_CCW, "With GL_FRONT_AND_BACK no polygon is drawn."),
      raster_test("polygons.cull_not_lines", "3.5.1", "Lines and points have no faces.",
                  [](Script& s) {
                    s.Enable(GL_CULL_FACE), s.CullFace(GL_FRONT_AND_BACK), star(s), s.PointSize(9),
                        s.Begin(GL_POINTS), pixel_vertex(s, 48.3, 48.2), s.End();
                  }),
      raster_test("polygons.cull_before_mode", "3.5.1, 3.5.4",
                  "A polygon that is drawn as lines is culled before.",
                  [](Script& s) {
                    s.Enable(GL_CULL_FACE), s.CullFace(GL_FRONT), s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE),
                        two_faces(s);
                  }),
      drawn_as("front_line", GL_FRONT, GL_LINE),
      drawn_as("back_line", GL_BACK, GL_LINE),
      drawn_as("front_point", GL_FRONT, GL_POINT),
      drawn_as("back_point", GL_BACK, GL_POINT),
      drawn_as("both_line", GL_FRONT_AND_BACK, GL_LINE),
      raster_test("polygons.mode_line_width", "3.5.4", "Edges are lines of the width that is set.",
                  [](Script& s) { s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.LineWidth(3), two_faces(s); }),
      raster_test("polygons.degenerate", "3.5.1", "A polygon of no area has no fragments.",
                  [](Script& s) {
                    tint(s, 0), triangle(s, {{10, 20}, {50, 20}, {86, 20}}),
                        triangle(s, {{20, 10}, {20, 80}, {20, 80}});
                    tint(s, 1), triangle(s, {{30.2, 30.1}, {80.3, 32.2}, {50.1, 85.3}});
                  }),
      raster_test("polygons.degenerate_edges", "3.5.4",
                  "The edges of a polygon of no area are drawn as lines.",
                  [](Script& s) {
                    s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.LineWidth(3), tint(s, 0);
                    triangle(s, {{10, 20}, {50, 20}, {86, 20}}), tint(s, 3),
                        triangle(s, {{20, 30}, {20, 80}, {20, 54}});
                    tint(s, 1), triangle(s, {{30.2, 30.1}, {80.3, 32.2}, {50.1, 85.3}});
                  }),
      patterned("checkers", 0, kPattern),
      patterned("irregular", 1, kPattern),
      patterned("blocks", 2, kPattern),
      raster_test(
          "polygons.stipple_unpacked", "3.5.2, 3.6.4", "The pattern is unpacked as a bitmap of 32 x 32.",
          [](Script& s) {
            Memory bytes = pattern(1);
            for (int i = 0; i < 80; i++) bytes.elements.push_back(i * 29 % 256);
            s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
            s.PixelStorei(GL_UNPACK_ROW_LENGTH, 40), s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
            s.PixelStorei(GL_UNPACK_SKIP_ROWS, 3), s.PolygonStipple(bytes), s.Enable(GL_POLYGON_STIPPLE);
            tint(s, 5), box(s, 6, 7, 90, 91);
          }),
      raster_test("polygons.stipple_not_lines", "3.5.2", "The pattern of polygons does not matter to lines.",
                  [](Script& s) {
                    s.PolygonStipple(Memory{GL_UNSIGNED_BYTE, std::vector<double>(128, 0)}),
                        s.Enable(GL_POLYGON_STIPPLE), star(s), box(s, 40, 40, 56, 56);
                  }),
      raster_test("polygons.stipple_saved", "6.1.14, table 6.12",
                  "GL_POLYGON_STIPPLE_BIT brings back the pattern, GL_POLYGON_BIT the switch.",
                  [](Script& s) {
                    s.PolygonStipple(pattern(2)), s.Enable(GL_POLYGON_STIPPLE),
                        s.PushAttrib(GL_POLYGON_STIPPLE_BIT | GL_POLYGON_BIT);
                    s.PolygonStipple(pattern(0)), s.Disable(GL_POLYGON_STIPPLE), s.PopAttrib(), tint(s, 1),
                        box(s, 8, 8, 88, 88);
                  }),
      raster_test("polygons.saved", "6.1.14, table 6.12", "GL_POLYGON_BIT brings back culling and modes.",
                  [](Script& s) {
                    s.CullFace(GL_FRONT), s.Enable(GL_CULL_FACE), s.PolygonMode(GL_BACK, GL_LINE),
                        s.PushAttrib(GL_POLYGON_BIT);
                    s.CullFace(GL_BACK), s.Disable(GL_CULL_FACE), s.PolygonMode(GL_BACK, GL_FILL),
                        s.FrontFace(GL_CW), s.PopAttrib(), two_faces(s);
                  }),
  };
}

} // namespace softgl::suite
