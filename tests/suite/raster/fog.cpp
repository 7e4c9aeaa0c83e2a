// Fog (3.10).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kCoordinates{14};

Test fogged(const char* name, const char* section, const char* sentence, std::function<void(Script&)> body,
            Need need = {}) {
  return raster_test(std::string("fog.") + name, section, sentence, std::move(body), need);
}

void fog(Script& s, GLenum mode, double density = 0.12, double start = 3, double end = 14) {
  s.Fogi(GL_FOG_MODE, mode), s.Fogf(GL_FOG_DENSITY, density), s.Fogf(GL_FOG_START, start),
      s.Fogf(GL_FOG_END, end);
  s.Fogfv(GL_FOG_COLOR, V{0.1, 0.9, 0.6, 1}), s.Enable(GL_FOG);
}
void landscape(Script& s) { mesh(s, -1, -1, 1, 1, 7, 3, -10); }

// Boxes with coordinates of fog from `first` on, at different depths.
void coordinates(Script& s, double first = 0) {
  for (int i = 0; i < 16; i++)
    s.FogCoordf(first + i / 15.0), tint(s, i),
        box(s, 8 + 20 * (i % 4), 8 + 20 * (i / 4), 26 + 20 * (i % 4), 26 + 20 * (i / 4), -0.9 * i);
}

} // namespace

std::vector<Test> raster_fog_tests() {
  return {
      fogged("linear", "3.10, equation 3.28", "f falls from 1 at the start to 0 at the end.",
             [](Script& s) { fog(s, GL_LINEAR), landscape(s); }),
      fogged("linear_turned", "3.10, equation 3.28", "The end may be before the start.",
             [](Script& s) { fog(s, GL_LINEAR, 0, 12, 4), landscape(s); }),
      fogged("exponential", "3.10, equation 3.26",
             "f is e to the power of the density times the distance, less than 0.",
             [](Script& s) { fog(s, GL_EXP), landscape(s); }),
      fogged("exponential_squared", "3.10, equation 3.27", "f is e to the power of the square, less than 0.",
             [](Script& s) { fog(s, GL_EXP2), landscape(s); }),
      fogged("density_of_0", "3.10", "With a density of 0 there is no fog.",
             [](Script& s) { fog(s, GL_EXP, 0), landscape(s); }),
      fogged("clamped", "3.10", "f is clamped to [0, 1].",
             [](Script& s) { fog(s, GL_LINEAR, 0, 6, 8), landscape(s); }),
      fogged("color_clamped", "3.10", "The color of fog is clamped to [0, 1].",
             [](Script& s) {
               fog(s, GL_LINEAR), s.Fogfv(GL_FOG_COLOR, V{3, -1, 0.5, 1}), landscape(s);
             }),
      fogged("color_of_integers", "3.10, table 2.9", "Integers are the color of fog as those of colors are.",
             [](Script& s) {
               fog(s, GL_LINEAR), s.Fogiv(GL_FOG_COLOR, V{2147483647, 1073741824, -5, 0}), landscape(s);
             }),
      fogged("not_alpha", "3.10", "Fog does not change alpha.",
             [](Script& s) {
               fog(s, GL_EXP), s.Fogfv(GL_FOG_COLOR, V{0.1, 0.9, 0.6, 0}),
                   s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND);
               for (int i = 0; i < 4; i++)
                 s.Color4f(1, 0.3, 0.2, 0.25 * (i + 1)), box(s, 8 + 20 * i, 8, 26 + 20 * i, 88, -2 * i);
             }),
      fogged("lines_and_points", "3.10", "Lines and points are fogged.",
             [](Script& s) {
               fog(s, GL_LINEAR), s.LineWidth(4), s.PointSize(11);
               for (int i = 0; i < 5; i++) {
                 tint(s, i), s.Begin(GL_LINES), pixel_vertex(s, 6.2, 8.3 + 17 * i, 2 - 2 * i), tint(s, i),
                     pixel_vertex(s, 90.2, 12.3 + 17 * i, -1 - 2 * i), s.End();
                 s.Begin(GL_POINTS), pixel_vertex(s, 30.3 + 8 * i, 20.2 + 17 * i, -3 * i), s.End();
               }
             }),
      fogged("off", "3.10", "Without GL_FOG there is no fog.",
             [](Script& s) { fog(s, GL_EXP, 1), s.Disable(GL_FOG), landscape(s); }),
      fogged(
          "coordinate_linear", "3.10", "With GL_FOG_COORD the distance is the coordinate that is current.",
          [](Script& s) {
            fog(s, GL_LINEAR, 0, 0.1, 0.9), s.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD), coordinates(s);
          },
          kCoordinates),
      fogged(
          "coordinate_exponential", "3.10",
          "With GL_FOG_COORD the distance is the coordinate that is current.",
          [](Script& s) { fog(s, GL_EXP, 1.5), s.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD), coordinates(s); },
          kCoordinates),
      fogged(
          "coordinate_of_vertices", "3.10", "The coordinate is interpolated.",
          [](Script& s) {
            fog(s, GL_LINEAR, 0, 0, 1), s.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD), tint(s, 0),
                s.Begin(GL_TRIANGLES);
            s.FogCoordf(0), pixel_vertex(s, 8.2, 10.3), s.FogCoordfv(V{0.5}), pixel_vertex(s, 88.3, 12.4),
                s.FogCoordd(1.1), pixel_vertex(s, 12.3, 50.2);
            s.FogCoorddv(V{0.9}), pixel_vertex(s, 88.2, 22.3), s.FogCoordf(0.3), pixel_vertex(s, 84.3, 88.2),
                s.FogCoordf(0.1), pixel_vertex(s, 16.3, 84.2), s.End();
          },
          kCoordinates),
      fogged(
          "coordinate_negative", "3.10", "A coordinate may be less than 0: its sign matters.",
          [](Script& s) {
            fog(s, GL_LINEAR, 0, -0.8, 0.1), s.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD), coordinates(s, -1);
          },
          kCoordinates),
      fogged(
          "coordinate_unused", "3.10", "With GL_FRAGMENT_DEPTH the coordinate does not matter.",
          [](Script& s) {
            fog(s, GL_LINEAR), s.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD),
                s.Fogi(GL_FOG_COORD_SRC, GL_FRAGMENT_DEPTH), coordinates(s);
          },
          kCoordinates),
      fogged("hint", "5.6", "A hint may change how well fog is computed, but not what it is.",
             [](Script& s) { s.Hint(GL_FOG_HINT, GL_FASTEST), fog(s, GL_EXP2), landscape(s); }),
      fogged("before_blending", "3.10, 4.1.8", "What is blended has fog.",
             [](Script& s) {
               stripes(s), fog(s, GL_LINEAR), s.BlendFunc(GL_ONE, GL_DST_COLOR), s.Enable(GL_BLEND),
                   crossing_stripes(s);
             }),
      fogged("saved", "6.1.14, table 6.8", "GL_FOG_BIT brings back the parameters of fog.",
             [](Script& s) {
               fog(s, GL_LINEAR), s.PushAttrib(GL_FOG_BIT), fog(s, GL_EXP, 3, 0, 1), s.Disable(GL_FOG),
                   s.PopAttrib(), landscape(s);
             }),
  };
}

} // namespace softgl::suite
