// Each term of the equation alone, and their sum (2.14.1).
#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {

std::vector<Test> lighting_term_tests() {
  return {
      {"lighting.emission.alone", "2.14.1", "The emission of the material is added without any light.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.8, 0.4, 0.2, 1});
         dome(s);
       }},
      {"lighting.scene_ambient.alone", "2.14.1",
       "The ambient color of the scene is multiplied by that of the material.", "",
       [](Script& s) {
         dark(s), s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.5, 0.6, 1, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 0.5, 0.25, 1});
         dome(s);
       }},
      {"lighting.scene_ambient.default", "2.14.1, table 2.10",
       "At first scene and material have the ambient color (0.2, 0.2, 0.2), the material the diffuse color "
       "(0.8, 0.8, 0.8), and "
       "light 0 is white and at infinity along +z.",
       "", [](Script& s) { s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0), dome(s); }},
      {"lighting.scene_ambient.without_lights", "2.14.1", "The ambient color of the scene needs no light.",
       "",
       [](Script& s) {
         s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{1, 0.5, 0, 1}), s.Enable(GL_LIGHTING);
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.7, 0.7, 0.7, 1});
         dome(s);
       }},
      {"lighting.ambient.alone", "2.14.1", "The ambient color of a light does not depend on the normal.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{0, 0, 1, 0});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.9, 0.5, 0.3, 1}),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.8, 0.9, 1, 1});
         dome(s, {.tilt = 4});
       }},
      {"lighting.ambient.behind", "2.14.1",
       "The ambient color of a light reaches a surface that faces away from it.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{0, 0, -1, 0});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.2, 0.5, 0.9, 1}),
             s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{1, 1, 1, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, V{1, 1, 1, 1});
         dome(s);
       }},
      {"lighting.diffuse.alone", "2.14.1",
       "The diffuse term is the cosine between normal and light, times both colors.", "",
       [](Script& s) {
         diffuse_scene(s), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.8, 1, 0.6, 1});
         dome(s);
       }},
      {"lighting.diffuse.chart", "2.14.1", "The diffuse term follows the normal in all directions.", "",
       [](Script& s) {
         diffuse_scene(s, {2, 1, 2, 0}), chart(s);
       }},
      {"lighting.diffuse.behind", "2.14.1", "A surface that faces away from the light has no diffuse term.",
       "",
       [](Script& s) {
         diffuse_scene(s, {-1, 0, 0.2, 0}), dome(s, {.tilt = 4});
       }},
      {"lighting.diffuse.position_length", "2.14.1", "The length of a direction to a light does not matter.",
       "",
       [](Script& s) {
         diffuse_scene(s, {10, 20, 30, 0}), dome(s);
       }},
      {"lighting.diffuse.tiny_position", "2.14.1",
       "A short direction to a light is normalized like any other.", "",
       [](Script& s) {
         diffuse_scene(s, {1e-4, 2e-4, 3e-4, 0}), dome(s);
       }},
      {"lighting.diffuse.positional", "2.14.1", "The vector to a light at a point is taken at each vertex.",
       "",
       [](Script& s) {
         diffuse_scene(s, {0.5, 0.5, 1, 1}), dome(s, {.tilt = 0});
       }},
      {"lighting.diffuse.positional_w", "2.14.1", "The position of a light is divided by its w.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 1, 2, 2}), dome(s, {.tilt = 0});
       }},
      {"lighting.specular.alone", "2.14.1, equation 2.3",
       "The highlight is the cosine between normal and half vector to the shininess.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 10), dome(s);
       }},
      {"lighting.specular.half_vector_is_unit", "2.14.1",
       "The half vector is of unit length however wide the angle to the light is.", "",
       [](Script& s) {
         specular_scene(s, {3, 0, 0.5, 0}, 2), dome(s, {.tilt = 2});
       }},
      {"lighting.specular.shininess_1", "2.14.1", "A shininess of 1 is the cosine itself.", "",
       [](Script& s) {
         specular_scene(s, {1, -1, 2, 0}, 1), dome(s);
       }},
      {"lighting.specular.shininess_128", "2.14.1", "A shininess of 128 gives the smallest highlight.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 2, 0}, 128), dome(s, {.cells = 16, .tilt = 1});
       }},
      {"lighting.specular.shininess_fraction", "2.14.1", "The shininess may be a fraction.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 2.5), dome(s);
       }},
      {"lighting.specular.shininess_0", "2.14.1",
       "A shininess of 0 makes the highlight 1 wherever the light falls.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 1, 0}, 0), dome(s);
       }},
      {"lighting.specular.behind", "2.14.1, equation 2.2",
       "A surface that faces away from the light has no highlight.", "",
       [](Script& s) {
         specular_scene(s, {-1, 0, -0.3, 0}, 1), dome(s, {.tilt = 4});
       }},
      {"lighting.specular.positional", "2.14.1",
       "The half vector of a light at a point is taken at each vertex.", "",
       [](Script& s) {
         specular_scene(s, {-0.5, 0.5, 1.5, 1}, 6), dome(s, {.tilt = 0.3});
       }},
      {"lighting.viewer.local", "2.14.1, equation 2.3", "A local viewer stands at the eye.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 20), s.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
         s.LoadIdentity(), s.Translatef(0, 0, -2);
         dome(s, {.tilt = 0.3});
       }},
      {"lighting.viewer.local_perspective", "2.14.1", "The projection does not matter to a local viewer.", "",
       [](Script& s) {
         perspective(s), specular_scene(s, {0.5, -0.5, 1, 1}, 8),
             s.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
         dome(s, {.tilt = 0.5});
       }},
      {"lighting.viewer.infinite_perspective", "2.14.1",
       "An infinite viewer looks along -z, whatever the projection is.", "",
       [](Script& s) {
         perspective(s), specular_scene(s, {0.5, -0.5, 1, 1}, 8), dome(s, {.tilt = 0.5});
       }},
      {"lighting.sum.all_terms", "2.14.1", "Emission, ambient, diffuse and specular terms are added.", "",
       [](Script& s) {
         s.Enable(GL_LIGHTING), lamp(s, GL_LIGHT0, V{1, 1, 2, 0});
         s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.1, 0.2, 0.3, 1});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.2, 0.1, 0.1, 1}),
             s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.5, 0.6, 0.4, 1});
         s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{0.3, 0.2, 0.1, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.5, 0.6, 0.7, 1}),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.7, 0.6, 0.5, 1});
         s.Materialfv(GL_FRONT, GL_SPECULAR, V{0.9, 0.9, 0.9, 1}),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{0.05, 0, 0.1, 1});
         s.Materialf(GL_FRONT, GL_SHININESS, 12.0);
         dome(s);
       }},
  };
}

} // namespace softgl::suite
