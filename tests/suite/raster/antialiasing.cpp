// Antialiasing of points, lines and polygons (3.2 to 3.5, 3.11).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

const char* const kOpen = "What part of a pixel's square is covered may be approximated (3.2).";

Test smooth(const char* name, const char* section, const char* sentence, std::function<void(Script&)> body) {
  return raster_test(std::string("antialiasing.") + name, section, sentence, std::move(body), {}, kOpen);
}

void blend(Script& s) { s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND); }

void points(Script& s, double alpha = 1) {
  s.Begin(GL_POINTS);
  for (int i = 0; i < 9; i++)
    s.Color4f(1, 0.1 + 0.1 * i, 0.3, alpha), pixel_vertex(s, 17.2 + 30.3 * (i % 3), 16.3 + 31.2 * (i / 3));
  s.End();
}
void lines(Script& s, double alpha = 1) {
  s.Begin(GL_LINES);
  for (int i = 0; i < 4; i++)
    s.Color4f(1, 0.2 * i, 0.4, alpha), pixel_vertex(s, 8.3, 14.2 + 19 * i),
        pixel_vertex(s, 86.4, 10.3 + 25 * i);
  s.End();
}
void triangles(Script& s, double alpha = 1) {
  s.Color4f(1, 0.8, 0.2, alpha), triangle(s, {{8.3, 10.2}, {86.4, 16.3}, {20.3, 50.4}});
  s.Color4f(0.3, 1, 0.7, alpha), triangle(s, {{88.2, 28.3}, {80.3, 88.2}, {14.2, 84.4}});
}

// Draws the same at two places, a whole number of pixels from each other. All coordinates are exact in
// floats.
Test moved(const char* name, std::function<void(Script&)> shape) {
  return smooth(name, "3.2", "What is covered does not depend on where in the window it is.", [=](Script& s) {
    blend(s), s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Ortho(0, 64, 0, 64, 1, 20),
        s.MatrixMode(GL_MODELVIEW);
    s.Color4f(1, 0.9, 0.7, 1), s.Viewport(0, 0, 64, 64), shape(s), s.Viewport(32, 40, 64, 64), shape(s);
    s.PaintSame(0, 0, 32, 40, 32, 40, 88, 0);
  });
}
const char* const kRising =
    "Of two pixels of which one is covered where the other is, it has no greater coverage.";

} // namespace

std::vector<Test> raster_antialiasing_tests() {
  return {
      smooth("points", "3.3.1", "A point is a circle: pixels inside are covered, those outside not drawn.",
             [](Script& s) { blend(s), s.Enable(GL_POINT_SMOOTH), s.PointSize(14), points(s); }),
      smooth("points_small", "3.3.1", "A point of size 1 touches no more pixels than its circle does.",
             [](Script& s) {
               blend(s), s.Enable(GL_POINT_SMOOTH), points(s), tint(s, 1), box(s, 40, 54, 56, 70);
             }),
      smooth("points_alpha", "3.11", "The alpha of a point is multiplied by the part that is covered.",
             [](Script& s) { blend(s), s.Enable(GL_POINT_SMOOTH), s.PointSize(18), points(s, 0.5); }),
      smooth("points_colors", "3.2", "Red, green and blue are not changed where a pixel is covered in part.",
             [](Script& s) { s.Enable(GL_POINT_SMOOTH), s.PointSize(15), points(s); }),
      smooth("points_rising", "3.2", kRising,
             [](Script& s) {
               blend(s), s.Enable(GL_POINT_SMOOTH), s.PointSize(24), tint(s, 0), s.Begin(GL_POINTS),
                   pixel_vertex(s, 48.3, 48.4), s.End(), s.PaintRising(30, 48, 1, 0, 17, 0, 0);
               s.PaintRising(48, 66, 0, -1, 17, 8, 0);
             }),
      moved("points_moved",
            [](Script& s) {
              s.Enable(GL_POINT_SMOOTH), s.PointSize(12), s.Begin(GL_POINTS), s.Vertex3f(14.25, 15.375, 0),
                  s.End();
            }),
      smooth("lines", "3.4.2", "A line is a rectangle: pixels inside are covered, those outside not drawn.",
             [](Script& s) { blend(s), s.Enable(GL_LINE_SMOOTH), s.LineWidth(7), lines(s); }),
      smooth("lines_thin", "3.4.2", "A line of width 1 touches no more pixels than its rectangle does.",
             [](Script& s) {
               blend(s), s.Enable(GL_LINE_SMOOTH), lines(s), tint(s, 1), box(s, 40, 54, 56, 60);
             }),
      smooth("lines_alpha", "3.11", "The alpha of a line is multiplied by the part that is covered.",
             [](Script& s) { blend(s), s.Enable(GL_LINE_SMOOTH), s.LineWidth(8), lines(s, 0.5); }),
      smooth("lines_colors", "3.2", "Red, green and blue are not changed where a pixel is covered in part.",
             [](Script& s) { s.Enable(GL_LINE_SMOOTH), s.LineWidth(6), lines(s); }),
      smooth("lines_rising", "3.2", kRising,
             [](Script& s) {
               blend(s), s.Enable(GL_LINE_SMOOTH), s.LineWidth(10), tint(s, 0), s.Begin(GL_LINES),
                   pixel_vertex(s, 10.3, 20.2), pixel_vertex(s, 85.2, 50.4), s.End();
               s.PaintRising(48, 26, 0, 1, 9, 0, 0), s.PaintRising(60, 52, 0, -1, 11, 8, 0);
             }),
      moved("lines_moved",
            [](Script& s) {
              s.Enable(GL_LINE_SMOOTH), s.LineWidth(5), s.Begin(GL_LINES), s.Vertex3f(6.25, 8.5, 0),
                  s.Vertex3f(24.75, 30.125, 0), s.End();
            }),
      smooth("lines_stippled", "3.4.2", "Of a stippled line rectangles of one pixel's length are drawn.",
             [](Script& s) {
               blend(s), s.Enable(GL_LINE_SMOOTH), s.LineWidth(7), s.LineStipple(6, 0x3333),
                   s.Enable(GL_LINE_STIPPLE), lines(s);
             }),
      smooth("polygons", "3.5.3", "Pixels inside of a polygon are covered, those outside not drawn.",
             [](Script& s) { blend(s), s.Enable(GL_POLYGON_SMOOTH), triangles(s); }),
      smooth("polygons_alpha", "3.11", "The alpha of a polygon is multiplied by the part that is covered.",
             [](Script& s) { blend(s), s.Enable(GL_POLYGON_SMOOTH), triangles(s, 0.5); }),
      smooth("polygons_colors", "3.5.3",
             "Pixels inside of a polygon have the colors of their centers or squares.",
             [](Script& s) { blend(s), s.Enable(GL_POLYGON_SMOOTH), s.Scalef(2, 2, 1), arrow(s); }),
      smooth("polygons_rising", "3.2", kRising,
             [](Script& s) {
               blend(s), s.Enable(GL_POLYGON_SMOOTH), tint(s, 0),
                   triangle(s, {{20.2, 8.3}, {80.4, 30.2}, {24.7, 90.3}});
               for (int i = 0; i < 4; i++) s.PaintRising(20 + i, 86, 0, -1, 70, 8 * i, 0);
             }),
      moved("polygons_moved",
            [](Script& s) {
              s.Enable(GL_POLYGON_SMOOTH), s.Begin(GL_TRIANGLES), s.Vertex3f(4.25, 6.5, 0),
                  s.Vertex3f(28.75, 12.125, 0), s.Vertex3f(14.375, 36.25, 0), s.End();
            }),
      smooth("polygons_stippled", "3.5.2", "The pattern of polygons is the same with antialiasing.",
             [](Script& s) {
               Memory rows{GL_UNSIGNED_BYTE, {}};
               for (int i = 0; i < 128; i++) rows.elements.push_back(i / 16 % 2 ? 0xff : 0x0f);
               s.PolygonStipple(rows), s.Enable(GL_POLYGON_STIPPLE), blend(s), s.Enable(GL_POLYGON_SMOOTH),
                   triangles(s);
             }),
      raster_test("antialiasing.polygons_as_lines", "3.5.4",
                  "Polygons that are drawn as lines are antialiased as lines.",
                  [](Script& s) {
                    s.Enable(GL_POLYGON_SMOOTH), s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.LineWidth(3),
                        triangles(s);
                  }),
      raster_test("antialiasing.off", "3.11", "Without antialiasing alpha is not changed.",
                  [](Script& s) {
                    blend(s), s.PointSize(9), s.LineWidth(4);
                    for (GLenum name : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH})
                      s.Enable(name), s.Disable(name);
                    triangles(s, 0.5), points(s, 0.5);
                  }),
      smooth("hints", "5.6", "Hints may change how well, but not what is drawn.",
             [](Script& s) {
               for (GLenum name : {GL_POINT_SMOOTH_HINT, GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT})
                 s.Hint(name, GL_FASTEST);
               blend(s), s.Enable(GL_POINT_SMOOTH), s.Enable(GL_LINE_SMOOTH), s.Enable(GL_POLYGON_SMOOTH);
               s.PointSize(12), s.LineWidth(6), triangles(s), lines(s), points(s);
             }),
      smooth("saved", "6.1.14, tables 6.10 to 6.12",
             "The bits of points, lines and polygons bring antialiasing back.",
             [](Script& s) {
               blend(s), s.PointSize(14), s.LineWidth(7);
               for (GLenum name : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH}) s.Enable(name);
               s.PushAttrib(GL_POINT_BIT | GL_LINE_BIT | GL_POLYGON_BIT);
               for (GLenum name : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH}) s.Disable(name);
               s.PopAttrib(), triangles(s), points(s);
             }),
  };
}

} // namespace softgl::suite
