// Line segments (3.4).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test wide(const char* name, double width, const char* sentence) {
  return raster_test(std::string("lines.width_") + name, "3.4.2", sentence,
                     [=](Script& s) { s.LineWidth(width), star(s, 20, width < 2.5); });
}
const char* const kWideLine =
    "Each column of a line has as many fragments as it is wide; of a steep one each row.";

// Rows of lines from left to right.
void stippled_lines(Script& s, GLenum mode) {
  s.Enable(GL_LINE_STIPPLE), tint(s, 3);
  for (int i = 0; i < 5; i++) {
    s.Begin(mode), pixel_vertex(s, 4.2 + 2 * i, 12.3 + 16 * i), pixel_vertex(s, 40.4, 14.2 + 16 * i);
    pixel_vertex(s, 45.3, 14.4 + 16 * i), pixel_vertex(s, 92.2, 12.4 + 17 * i), s.End();
  }
}
Test stippled(const char* name, int factor, int pattern, GLenum mode, const char* sentence) {
  return raster_test(std::string("lines.stipple_") + name, "3.4.2", sentence,
                     [=](Script& s) { s.LineStipple(factor, pattern), stippled_lines(s, mode); });
}

} // namespace

std::vector<Test> raster_line_tests() {
  return {
      wide("1", 1, "No two fragments of a line lie in the same column; of a steep one in the same row."),
      wide("2", 2, kWideLine),
      wide("3", 3, kWideLine),
      wide("6", 6, kWideLine),
      wide("rounded_down", 3.4, "The width is rounded to the nearest whole number."),
      wide("rounded_up", 4.6, "The width is rounded to the nearest whole number."),
      wide("rounded_to_0", 0.3, "A width that is rounded to 0 is 1."),
      raster_test("lines.colors", "3.4.1, equation 3.4", "Colors run evenly along a line.",
                  [](Script& s) {
                    for (int i = 0; i < 7; i++) {
                      s.Begin(GL_LINES), s.Color3f(1, 0.1 * i, 0), pixel_vertex(s, 5.3, 8.2 + 10 * i),
                          s.Color3f(0, 1, 0.9 - 0.1 * i), pixel_vertex(s, 90.2, 8.7 + 9 * i), s.End();
                    }
                  }),
      raster_test("lines.depths", "3.4.1, equation 3.5", "Depths run evenly along a line.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), s.LineWidth(5), tint(s, 2), box(s, 8, 8, 88, 88, -4), tint(s, 3);
                    for (int i = 0; i < 6; i++)
                      s.Begin(GL_LINES), pixel_vertex(s, 5.3, 12.2 + 14 * i, 3 - i),
                          pixel_vertex(s, 90.2, 10.7 + 14 * i, -12 + i), s.End();
                  }),
      raster_test("lines.flat", "2.14.7", "A flat line has the color of its second vertex.",
                  [](Script& s) { s.ShadeModel(GL_FLAT), star(s); }),
      stippled("bits", 1, 0x0f0f, GL_LINES,
               "A fragment is drawn if its bit of the pattern is 1; the lowest bit comes first."),
      stippled("factor", 3, 0x00ff, GL_LINES, "Each bit of the pattern is used as often as the factor says."),
      stippled("each_line", 4, 0xff00, GL_LINES, "The pattern begins anew with each separate line."),
      stippled("strip", 2, 0x0fff, GL_LINE_STRIP, "The pattern goes on from line to line of a strip."),
      stippled("factor_of_0", 0, 0x00ff, GL_LINES, "A factor below 1 is 1."),
      stippled("large_factor", 300, 0x5555, GL_LINES, "A factor above 256 is 256."),
      raster_test("lines.stipple_wide", "3.4.2", "A column of a wide line is drawn as a whole, or not.",
                  [](Script& s) { s.LineWidth(5), s.LineStipple(4, 0x33cf), stippled_lines(s, GL_LINES); }),
      raster_test("lines.stipple_off", "3.4.2", "Without GL_LINE_STIPPLE the pattern does nothing.",
                  [](Script& s) { s.LineStipple(1, 0), s.Disable(GL_LINE_STIPPLE), star(s); }),
      raster_test("lines.saved", "6.1.14, table 6.11", "GL_LINE_BIT brings back width, pattern and switch.",
                  [](Script& s) {
                    s.LineWidth(4), s.LineStipple(5, 0x3333), s.Enable(GL_LINE_STIPPLE),
                        s.PushAttrib(GL_LINE_BIT);
                    s.LineWidth(1), s.LineStipple(1, 0), s.Disable(GL_LINE_STIPPLE), s.PopAttrib(),
                        tint(s, 1);
                    for (int i = 0; i < 5; i++)
                      s.Begin(GL_LINES), pixel_vertex(s, 5.2, 12.3 + 16 * i),
                          pixel_vertex(s, 90.3, 9.2 + 17 * i), s.End();
                  }),
  };
}

} // namespace softgl::suite
