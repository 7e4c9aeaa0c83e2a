// Points (3.3).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

// Points all over the window, whose corners are not near the centers of pixels.
void point_grid(Script& s, double near_z = 0, double step_z = 0) {
  s.Begin(GL_POINTS);
  for (int i = 0; i < 20; i++)
    tint(s, i), pixel_vertex(s, 10.2 + 18 * (i % 5) + 0.1 * (i % 2), 12.3 + 23 * (i / 5) + 0.4 * (i % 2),
                             near_z - step_z * (i % 5));
  s.End();
}

// More points of few pixels.
void dots(Script& s) {
  s.Begin(GL_POINTS);
  for (int i = 0; i < 49; i++) tint(s, i), pixel_vertex(s, 8.2 + 13 * (i % 7), 9.3 + 13.1 * (i / 7));
  s.End();
}

Test sized(const char* name, double size, const char* sentence) {
  return raster_test(std::string("points.size_") + name, "3.3.1", sentence,
                     [=](Script& s) { s.PointSize(size), size > 1 ? point_grid(s) : dots(s); });
}

// Points near the axis of view: their distances are those of their planes, nearly.
void receding(Script& s) {
  static const double at[6][3] = {{48.2, 48.3, 2.5}, {66.2, 48.3, 0.5}, {48.2, 68.3, -2},
                                  {28.2, 48.3, -5},  {48.2, 26.3, -9},  {70.2, 72.3, -13}};
  s.Begin(GL_POINTS);
  for (int i = 0; i < 6; i++) tint(s, i), pixel_vertex(s, at[i][0], at[i][1], at[i][2]);
  s.End();
}

constexpr Need kParameters{14};
const char* const kSquare =
    "A point is a square of as many fragments as its size, rounded, around its position.";

} // namespace

std::vector<Test> raster_point_tests() {
  return {
      sized("1", 1, "A point of size 1 is the fragment that its position lies in."),
      sized("2", 2, kSquare),
      sized("3", 3, kSquare),
      sized("8", 8, kSquare),
      sized("13", 13, kSquare),
      sized("rounded_down", 5.4, "The size is rounded to the nearest whole number."),
      sized("rounded_up", 5.6, "The size is rounded to the nearest whole number."),
      sized("rounded_to_0", 0.3, "A size that is rounded to 0 is 1."),
      raster_test("points.one_color", "3.3.1", "All fragments of a point have the color of its vertex.",
                  [](Script& s) { s.PointSize(16), s.ShadeModel(GL_SMOOTH), ring(s, GL_POINTS, 6); }),
      raster_test("points.one_depth", "3.3.1", "All fragments of a point have the depth of its vertex.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), tint(s, 2), slope(s), s.PointSize(14), point_grid(s, 1, 3);
                  }),
      raster_test(
          "points.at_the_border", "2.12, 3.3.1",
          "A point is drawn as far as the window reaches if its position is inside, and not at all if not.",
          [](Script& s) {
            s.PointSize(18), s.Begin(GL_POINTS), tint(s, 1), pixel_vertex(s, 2.3, 30.2), tint(s, 3),
                pixel_vertex(s, 93.3, 60.2), tint(s, 4), pixel_vertex(s, 50.3, 94.2), tint(s, 0),
                pixel_vertex(s, -3.3, 70.2), tint(s, 5), pixel_vertex(s, 30.3, -4.2), s.End();
          }),
      raster_test(
          "points.attenuation", "3.3", "The size gets less with the distance from the eye.",
          [](Script& s) {
            s.PointSize(40), s.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, V{0.3, 0.4, 0.09}),
                receding(s);
          },
          kParameters),
      raster_test(
          "points.attenuation_beside", "3.3", "The distance is that from the eye itself, not from its plane.",
          [](Script& s) {
            s.PointSize(40), s.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, V{0, 0, 1}),
                s.Begin(GL_POINTS);
            for (int i = 0; i < 4; i++)
              tint(s, i), pixel_vertex(s, i % 2 ? 80.2 : 16.3, i / 2 ? 80.3 : 16.2, 3 - 0.2 * i);
            s.End();
          },
          kParameters),
      raster_test(
          "points.attenuation_least", "3.3", "A size is not less than GL_POINT_SIZE_MIN.",
          [](Script& s) {
            s.PointParameterf(GL_POINT_SIZE_MIN, 6), s.PointSize(20),
                s.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, V{0, 0, 1}), receding(s);
          },
          kParameters),
      raster_test(
          "points.attenuation_greatest", "3.3", "A size is not greater than GL_POINT_SIZE_MAX.",
          [](Script& s) {
            s.PointParameterf(GL_POINT_SIZE_MAX, 7), s.PointSize(30),
                s.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, V{0.1, 0, 0.2}), receding(s);
          },
          kParameters),
      raster_test("points.saved", "6.1.14, table 6.10", "GL_POINT_BIT brings back the size.",
                  [](Script& s) {
                    s.PointSize(9), s.PushAttrib(GL_POINT_BIT), s.PointSize(3), s.PopAttrib(), point_grid(s);
                  }),
  };
}

} // namespace softgl::suite
