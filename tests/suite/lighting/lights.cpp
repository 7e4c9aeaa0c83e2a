// Attenuation, spotlights, positions and the number of lights (2.14.1, 2.14.2).
#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {
namespace {

// A white light at a point near the dome, with attenuation.
void attenuated(Script& s, double constant, double linear, double quadratic) {
  diffuse_scene(s, {0.3, 0.3, 1.2, 1}, {1, 0.9, 0.8, 1});
  s.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant);
  s.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear);
  s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, quadratic);
}

// A spotlight above the dome that shines down.
void spot(Script& s, double cutoff, double exponent, V direction = {0, 0, -1},
          V position = {0.2, 0.1, 1, 1}) {
  diffuse_scene(s, position, {1, 0.8, 0.6, 1});
  s.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
  s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff), s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent);
}

const char* const kAttenuation = "2.14.1, equation 2.4";
const char* const kSpot = "2.14.1, equation 2.5";
const Dome kFine{.cells = 16, .tilt = 0.2};

} // namespace

std::vector<Test> lighting_attenuation_tests() {
  return {
      {"lighting.attenuation.none", kAttenuation, "At first a light does not get weaker with distance.", "",
       [](Script& s) {
         diffuse_scene(s, {0.3, 0.3, 1.2, 1}), dome(s);
       }},
      {"lighting.attenuation.constant", kAttenuation, "The constant factor divides.", "",
       [](Script& s) { attenuated(s, 2, 0, 0), dome(s); }},
      {"lighting.attenuation.constant_below_1", kAttenuation,
       "A constant factor below 1 makes the light stronger.", "",
       [](Script& s) {
         attenuated(s, 0.5, 0, 0), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.4, 0.4, 0.4, 1});
         dome(s);
       }},
      {"lighting.attenuation.linear", kAttenuation, "The linear factor is multiplied by the distance.", "",
       [](Script& s) { attenuated(s, 0, 0.8, 0), dome(s); }},
      {"lighting.attenuation.quadratic", kAttenuation,
       "The quadratic factor is multiplied by the distance squared.", "",
       [](Script& s) { attenuated(s, 0, 0, 0.7), dome(s); }},
      {"lighting.attenuation.sum", kAttenuation, "The three terms are added.", "",
       [](Script& s) { attenuated(s, 0.5, 0.25, 0.5), dome(s); }},
      {"lighting.attenuation.w", kAttenuation, "The distance is that to the position divided by w.", "",
       [](Script& s) {
         attenuated(s, 0.2, 0.4, 0.2), s.Lightfv(GL_LIGHT0, GL_POSITION, V{0.6, -0.6, 2.4, 2});
         dome(s);
       }},
      {"lighting.attenuation.directional", kAttenuation, "A light at infinity is not attenuated.", "",
       [](Script& s) {
         attenuated(s, 3, 2, 1), s.Lightfv(GL_LIGHT0, GL_POSITION, V{1, 1, 2, 0});
         dome(s);
       }},
      {"lighting.attenuation.ambient", kAttenuation, "The ambient term of the light is attenuated.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{0.5, 0.5, 0.5, 1});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{1, 0.7, 0.4, 1}),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 1, 1, 1});
         s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 1.0);
         dome(s);
       }},
      {"lighting.attenuation.specular", kAttenuation, "The specular term of the light is attenuated.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 1, 1}, 4), s.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1.0);
         dome(s, {.tilt = 0.5});
       }},
      {"lighting.attenuation.not_the_scene", "2.14.1",
       "Emission and the scene's ambient color are not attenuated.", "",
       [](Script& s) {
         attenuated(s, 4, 0, 0), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.3, 0.1, 0, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.3, 0.6, 0.9, 1});
         s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.5, 0.5, 0.5, 1});
         dome(s);
       }},
      {"lighting.attenuation.eye_distance", "2.14.1",
       "Distances are those in eye coordinates: the modelview's scale changes them.", "",
       [](Script& s) {
         attenuated(s, 0.2, 0, 0.5), s.Scalef(0.5, 0.5, 0.5), s.Enable(GL_NORMALIZE);
         dome(s);
       }},
      {"lighting.attenuation.by_vertex", kAttenuation, "The distance is that of each vertex.", "",
       [](Script& s) {
         attenuated(s, 0, 0, 1), s.Normal3f(0, 0, 1);
         sheet(s, -1, -1, 0, 1), sheet(s, 0, -1, 1, 1, 0.6);
       }},
  };
}

std::vector<Test> lighting_spot_tests() {
  return {
      {"lighting.spot.cutoff_180", kSpot,
       "A cutoff of 180 is no spotlight, whatever direction and exponent are.", "",
       [](Script& s) {
         spot(s, 180, 20, {1, 0, 0}), dome(s, kFine);
       }},
      {"lighting.spot.cutoff_90", kSpot, "A cutoff of 90 lights the half space that the spot points to.", "",
       [](Script& s) {
         spot(s, 90, 0, {1, 0.3, 0}, {-0.1, 0.05, 1, 1}), dome(s, kFine);
       }},
      {"lighting.spot.cutoff_90_exponent", kSpot, "With a cutoff of 90 the exponent still counts.", "",
       [](Script& s) { spot(s, 90, 2), dome(s, kFine); }},
      {"lighting.spot.cutoff_30", kSpot, "Outside of the cutoff the light is not there.", "",
       [](Script& s) { spot(s, 30, 0), dome(s, kFine); }},
      {"lighting.spot.cutoff_60", kSpot, "The cutoff is the angle between the axis and the rim.", "",
       [](Script& s) {
         spot(s, 50, 0, {0, 0, -1}, {0, 0, 0.7, 1}), dome(s, kFine);
       }},
      {"lighting.spot.cutoff_0", kSpot, "With a cutoff of 0 only the axis is lit.", "",
       [](Script& s) {
         spot(s, 0, 0, {0, 0, -1}, {0, 0, 1, 1}), s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.5, 0.5, 0.5, 1});
         s.Materialfv(GL_FRONT, GL_EMISSION, V{0.2, 0.3, 0.1, 1}),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 1, 1, 1});
         dome(s, {.cells = 7, .tilt = 0.2}); // no vertex on the axis
       }},
      {"lighting.spot.exponent_1", kSpot, "An exponent of 1 is the cosine of the angle to the axis.", "",
       [](Script& s) { spot(s, 80, 1), dome(s, kFine); }},
      {"lighting.spot.exponent_10", kSpot, "The cosine is raised to the exponent.", "",
       [](Script& s) { spot(s, 80, 10), dome(s, kFine); }},
      {"lighting.spot.exponent_128", kSpot, "An exponent of 128 gives the narrowest beam.", "",
       [](Script& s) {
         spot(s, 80, 128, {0, 0, -1}, {0.125, 0.125, 1.5, 1}), dome(s, kFine);
       }},
      {"lighting.spot.exponent_fraction", kSpot, "The exponent may be a fraction.", "",
       [](Script& s) { spot(s, 80, 0.5), dome(s, kFine); }},
      {"lighting.spot.direction_length", kSpot, "The length of the direction does not matter.", "",
       [](Script& s) {
         spot(s, 60, 8, {1, 0, -5}), dome(s, kFine);
       }},
      {"lighting.spot.direction_short", kSpot, "A short direction is normalized, too.", "",
       [](Script& s) {
         spot(s, 60, 8, {1e-3, 0, -4e-3}), dome(s, kFine);
       }},
      {"lighting.spot.tilted", kSpot, "The axis may point anywhere.", "",
       [](Script& s) {
         spot(s, 40, 3, {-0.6, -0.4, -1}, {0.6, 0.4, 1, 1}), dome(s, kFine);
       }},
      {"lighting.spot.away", kSpot, "A spot that points away lights nothing.", "",
       [](Script& s) {
         spot(s, 60, 0, {0, 0, 1}), s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{1, 1, 1, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, V{1, 1, 1, 1}),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{0, 0.2, 0.4, 1});
         dome(s, kFine);
       }},
      {"lighting.spot.ambient", kSpot, "The ambient term of the light is cut by the spot.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{0, 0, 1, 1}), s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.9, 0.8, 0.2, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 1, 1, 1}), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 35.0);
         s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 5.0);
         dome(s, kFine);
       }},
      {"lighting.spot.specular", kSpot, "The specular term of the light is cut by the spot.", "",
       [](Script& s) {
         specular_scene(s, {0.3, 0.2, 1, 1}, 3), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 35.0);
         s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 5.0);
         dome(s, kFine);
       }},
      {"lighting.spot.attenuated", "2.14.1", "Spot and attenuation are multiplied.", "",
       [](Script& s) {
         spot(s, 60, 4), s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.5),
             s.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.3);
         dome(s, kFine);
       }},
      {"lighting.spot.directional", kSpot,
       "A light at infinity may be a spot: all vertices see it at one angle.", "",
       [](Script& s) {
         spot(s, 60, 2, {0.2, 0, -1}, {0, 0, 1, 0}), dome(s);
       }},
      {"lighting.spot.directional_outside", kSpot,
       "A light at infinity outside of its own cutoff lights nothing.", "",
       [](Script& s) {
         spot(s, 20, 0, {1, 0, -1}, {0, 0, 1, 0}), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.5, 0.2, 0, 1});
         dome(s);
       }},
      {"lighting.spot.default_direction", "table 2.10", "At first a spot points along -z.", "",
       [](Script& s) {
         diffuse_scene(s, {0.2, 0.1, 1, 1}), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45.0);
         s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 6.0);
         dome(s, kFine);
       }},
      {"lighting.spot.integers", "2.14.2", "glLighti sets exponent and cutoff.", "",
       [](Script& s) {
         diffuse_scene(s, {0.2, 0.1, 1, 1}), s.Lighti(GL_LIGHT0, GL_SPOT_CUTOFF, 40),
             s.Lighti(GL_LIGHT0, GL_SPOT_EXPONENT, 3);
         s.Lightiv(GL_LIGHT0, GL_SPOT_DIRECTION, V{0, 0, -3});
         dome(s, kFine);
       }},
  };
}

std::vector<Test> lighting_position_tests() {
  const char* const section = "2.14.2";
  return {
      {"lighting.position.transformed", section,
       "The position of a light is transformed by the modelview when it is set.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 1});
         s.PushMatrix(), s.Translatef(0.5, 0.5, 0), s.Rotatef(30, 0, 1, 0), lamp(s, GL_LIGHT0, V{0, 0, 1, 1}),
             s.PopMatrix();
         s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.9, 0.8, 0.7, 1});
         dome(s, {.tilt = 0.3});
       }},
      {"lighting.position.direction_transformed", section,
       "A direction to a light is rotated when it is set.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 1});
         s.PushMatrix(), s.Rotatef(50, 0, 1, 0), lamp(s, GL_LIGHT0, V{0, 0, 1, 0}), s.PopMatrix();
         s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.9, 0.8, 0.7, 1});
         dome(s);
       }},
      {"lighting.position.not_again", section, "A modelview that changes later does not move the light.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}), s.Rotatef(40, 0, 0, 1), s.Scalef(0.7, 0.7, 1);
         dome(s, {.tilt = 0.5});
       }},
      {"lighting.position.stays_with_eye", section,
       "A light that is set under the identity stays with the eye.", "",
       [](Script& s) {
         s.LoadIdentity(), diffuse_scene(s, {0, 0, -3.5, 1});
         s.Translatef(0.2, 0.1, -5), dome(s, {.tilt = 0.2});
       }},
      {"lighting.position.scaled", section, "A scale of the modelview moves a light at a point.", "",
       [](Script& s) {
         s.PushMatrix(), s.Scalef(2, 2, 2), diffuse_scene(s, {0.25, 0.25, 0.5, 1}), s.PopMatrix();
         dome(s, {.tilt = 0});
       }},
      {"lighting.position.directional_not_translated", section,
       "A translation does not change a direction to a light.", "",
       [](Script& s) {
         s.PushMatrix(), s.Translatef(7, 8, 9), diffuse_scene(s, {1, 0.5, 2, 0}), s.PopMatrix();
         dome(s);
       }},
      {"lighting.position.spot_direction_transformed", section,
       "A spot direction is transformed by the upper left 3x3 of the modelview when it is set.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 1}), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 35.0);
         s.PushMatrix(), s.Rotatef(25, 0, 1, 0), s.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, V{0, 0, -1}),
             s.PopMatrix();
         dome(s, kFine);
       }},
      {"lighting.position.spot_direction_not_translated", section,
       "A translation does not change a spot direction.", "",
       [](Script& s) {
         diffuse_scene(s, {0.2, 0, 1, 1}), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45.0),
             s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 9.0);
         s.PushMatrix(), s.Translatef(3, 2, 1), s.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, V{0.3, 0, -1}),
             s.PopMatrix();
         dome(s, kFine);
       }},
      {"lighting.position.spot_direction_not_again", section,
       "A modelview that changes later does not turn the spot.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 1}), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 35.0);
         s.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, V{0.4, 0, -1});
         s.Rotatef(90, 0, 0, 1), dome(s, kFine);
       }},
      {"lighting.position.integers", section,
       "Positions that are given as integers are not mapped to [-1, 1].", "",
       [](Script& s) {
         diffuse_scene(s), s.Lightiv(GL_LIGHT0, GL_POSITION, V{1, 0, 2, 1});
         dome(s, {.tilt = 0.3});
       }},
      {"lighting.position.below_surface", "2.14.1",
       "A light at a point behind the surface lights what turns to it.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, -0.5, 1}), dome(s, {.tilt = -3});
       }},
      {"lighting.position.w_negative", "2.14.1", "A negative w divides like any other.", "",
       [](Script& s) {
         diffuse_scene(s, {-0.5, -0.3, -1, -1}), dome(s, {.tilt = 0.2});
       }},
      {"lighting.position.after_diffuse_object_space", "2.14.1",
       "A rotated model and a rotated light give the light's direction in eye coordinates.", "",
       [](Script& s) {
         s.Rotatef(35, 1, 1, 0), diffuse_scene(s, {1, 2, 3, 0}), dome(s, {.size = 0.7});
       }},
  };
}

std::vector<Test> lighting_count_tests() {
  return {
      {"lighting.lights.two", "2.14.1", "The terms of the lights are added.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}, {0.8, 0, 0.1, 1}), lamp(s, GL_LIGHT1, V{-1, 0, 1, 0});
         s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{0, 0.7, 0.1, 1}), dome(s);
       }},
      {"lighting.lights.eight", "2.14.1", "There are at least eight lights.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 1});
         const double colors[8][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},   {1, 1, 0},
                                      {0, 1, 1}, {1, 0, 1}, {1, 0.5, 0}, {0.5, 0.5, 0.5}};
         for (unsigned i = 0; i < 8; i++) {
           const double x = (i % 3) - 1.0, y = (i / 3) - 1.0;
           lamp(s, GL_LIGHT0 + i, V{0.8 * x, 0.8 * y, 0.5, 1});
           s.Lightf(GL_LIGHT0 + i, GL_QUADRATIC_ATTENUATION, 3.0);
           s.Lightfv(GL_LIGHT0 + i, GL_DIFFUSE, V{colors[i][0], colors[i][1], colors[i][2], 1});
         }
         dome(s, {.tilt = 0.2});
       }},
      {"lighting.lights.seventh_alone", "2.14.1", "Light 7 works without the others.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT7, V{1, 1, 1, 0}), s.Lightfv(GL_LIGHT7, GL_DIFFUSE, V{0.5, 1, 0.5, 1});
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 1}), dome(s);
       }},
      {"lighting.lights.defaults_differ", "table 2.10", "Lights other than light 0 are black at first.", "",
       [](Script& s) {
         s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT1), s.Materialfv(GL_FRONT, GL_SPECULAR, V{1, 1, 1, 1});
         s.Materialfv(GL_FRONT, GL_EMISSION, V{0.3, 0, 0, 1}), dome(s);
       }},
      {"lighting.lights.default_specular", "table 2.10", "Light 0 has a white highlight at first.", "",
       [](Script& s) {
         dark(s), s.Enable(GL_LIGHT0), s.Materialfv(GL_FRONT, GL_SPECULAR, V{1, 0.8, 0.6, 1});
         s.Materialf(GL_FRONT, GL_SHININESS, 8.0), dome(s);
       }},
      {"lighting.lights.disabled", "2.14.2", "A light that is off gives nothing.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}), lamp(s, GL_LIGHT1, V{-1, 0, 1, 0}),
             s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{0, 1, 1, 1});
         s.Disable(GL_LIGHT0), dome(s);
       }},
      {"lighting.lights.mixed_kinds", "2.14.1", "Lights at infinity, at points and spots may be mixed.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 1, 1, 0}, {0.4, 0, 0, 1}), lamp(s, GL_LIGHT3, V{-0.5, 0, 1, 1}),
             lamp(s, GL_LIGHT5, V{0.5, 0, 1, 1});
         s.Lightfv(GL_LIGHT3, GL_DIFFUSE, V{0, 0.6, 0, 1}), s.Lightf(GL_LIGHT3, GL_LINEAR_ATTENUATION, 0.4);
         s.Lightfv(GL_LIGHT5, GL_DIFFUSE, V{0, 0, 1, 1}), s.Lightf(GL_LIGHT5, GL_SPOT_CUTOFF, 30.0);
         dome(s, kFine);
       }},
      {"lighting.lights.highlights_added", "2.14.1", "The highlights of several lights are added.", "",
       [](Script& s) {
         specular_scene(s, {1, 0, 2, 0}, 10), lamp(s, GL_LIGHT1, V{-1, 0, 2, 0}),
             lamp(s, GL_LIGHT2, V{0, 1, 1, 1});
         s.Lightfv(GL_LIGHT1, GL_SPECULAR, V{1, 0, 0, 1}), s.Lightfv(GL_LIGHT2, GL_SPECULAR, V{0, 1, 0, 1}),
             dome(s);
       }},
      {"lighting.lights.integers", "2.14.2, table 2.9",
       "Colors that are given as integers are mapped to [-1, 1].", "",
       [](Script& s) {
         diffuse_scene(s), s.Lightiv(GL_LIGHT0, GL_DIFFUSE, V{2147483647, 1073741824, 0, 0});
         s.LightModeliv(GL_LIGHT_MODEL_AMBIENT, V{0, 536870912, 1073741824, 0});
         s.Materialiv(GL_FRONT, GL_AMBIENT, V{2147483647, 2147483647, 1073741824, 0}), dome(s);
       }},
      {"lighting.lights.negative", "table 2.10", "A negative color of a light takes light away.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {0.9, 0.9, 0.9, 1}), lamp(s, GL_LIGHT1, V{1, 0, 1, 0});
         s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{-0.5, -0.9, 0, 1}), dome(s);
       }},
  };
}

} // namespace softgl::suite
