// Depth offset (3.5.5).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

// A slope, and one that lies behind or before it by less than the offset.
Test offset(const char* name, double factor, double units, double behind, const char* sentence) {
  return raster_test(std::string("offset.") + name, "3.5.5", sentence, [=](Script& s) {
    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), s.PolygonOffset(factor, units),
        s.Enable(GL_POLYGON_OFFSET_FILL), tint(s, 1), slope(s, -behind);
  });
}
// The same polygon again with an offset.
Test again(const char* name, double units, GLenum function, const char* sentence) {
  return raster_test(std::string("offset.") + name, "3.5.5", sentence, [=](Script& s) {
    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), s.DepthFunc(function), s.PolygonOffset(0, units),
        s.Enable(GL_POLYGON_OFFSET_FILL), tint(s, 1), slope(s);
  });
}
// Edges or corners of a polygon that was filled at the same place.
Test outlined(const char* name, GLenum mode, GLenum on, double factor, const char* sentence) {
  return raster_test(std::string("offset.") + name, "3.5.5", sentence, [=](Script& s) {
    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), s.PolygonMode(GL_FRONT_AND_BACK, mode), s.LineWidth(5),
        s.PointSize(11), s.PolygonOffset(factor, 0), s.Enable(on), tint(s, 1), slope(s);
  });
}
const char* const kSum =
    "The offset is the slope times the factor, and the least difference times the units.";
const char* const kDistinct = "An offset of one unit makes a depth that the buffer tells from the first.";
const char* const kModes = "Each polygon mode has a switch of its own.";

} // namespace

std::vector<Test> raster_offset_tests() {
  return {
      offset("factor", -8, 0, 0.6, kSum),
      offset("factor_behind", 8, 0, -0.6, kSum),
      offset("units", 0, -1e9, 0.3, kSum),
      offset("units_behind", 0, 1e9, -0.3, kSum),
      offset("none", 0, 0, 0.4, "Without factor and units nothing is moved."),
      again("one_unit", -1, GL_LESS, kDistinct),
      again("one_unit_behind", 1, GL_LEQUAL, kDistinct),
      again("one_unit_distinct", 1, GL_NOTEQUAL, kDistinct),
      outlined("line", GL_LINE, GL_POLYGON_OFFSET_LINE, -12, kModes),
      outlined("point", GL_POINT, GL_POLYGON_OFFSET_POINT, -40, kModes),
      raster_test("offset.fill_only", "3.5.5", kModes,
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), s.PolygonOffset(0, -1e9), s.Enable(GL_POLYGON_OFFSET_LINE),
                        s.Enable(GL_POLYGON_OFFSET_POINT), tint(s, 0), slope(s), tint(s, 1), slope(s, -1);
                    s.Disable(GL_POLYGON_OFFSET_LINE), s.Disable(GL_POLYGON_OFFSET_POINT),
                        s.Enable(GL_POLYGON_OFFSET_FILL), tint(s, 2), box(s, 40, 8, 60, 50, -13);
                  }),
      raster_test("offset.not_lines", "3.5.5", "The offset is of polygons: lines and points are not moved.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), s.PolygonOffset(0, -1e9),
                        s.Enable(GL_POLYGON_OFFSET_FILL), s.Enable(GL_POLYGON_OFFSET_LINE),
                        s.Enable(GL_POLYGON_OFFSET_POINT);
                    s.LineWidth(5), tint(s, 3), s.Begin(GL_LINES), pixel_vertex(s, 10.3, 20.2, -13),
                        pixel_vertex(s, 90.2, 60.3, -13), s.End();
                    s.PointSize(9), tint(s, 5), s.Begin(GL_POINTS), pixel_vertex(s, 30.3, 40.2, -13),
                        pixel_vertex(s, 80.3, 80.2, -13), s.End();
                  }),
      raster_test("offset.saved", "6.1.14, table 6.12",
                  "GL_POLYGON_BIT brings back factor, units and switches.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), tint(s, 0), slope(s), s.PolygonOffset(-8, 0),
                        s.Enable(GL_POLYGON_OFFSET_FILL), s.PushAttrib(GL_POLYGON_BIT);
                    s.PolygonOffset(3, 7), s.Disable(GL_POLYGON_OFFSET_FILL), s.PopAttrib(), tint(s, 1),
                        slope(s, -0.6);
                  }),
  };
}

} // namespace softgl::suite
