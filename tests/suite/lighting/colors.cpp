// glColorMaterial (2.14.3), and what becomes of the colors of lighting (2.14.6 to 2.14.9, 3.8 to 3.10).
#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {
namespace {

const char* const kTracking = "2.14.3";

// A light with all terms, a gray material, and the color material of the mode.
void tracking(Script& s, GLenum face, GLenum mode) {
  dark(s), lamp(s, GL_LIGHT0, V{0.5, 0.5, 1, 0});
  s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.3, 0.3, 0.3, 1}),
      s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.4, 0.4, 0.4, 1});
  s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{0.3, 0.3, 0.3, 1});
  for (GLenum term : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR})
    s.Materialfv(GL_FRONT_AND_BACK, term, V{0.4, 0.4, 0.4, 1});
  s.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 6.0);
  s.ColorMaterial(face, mode), s.Enable(GL_COLOR_MATERIAL);
}

Test tracked(const char* name, GLenum mode, const char* sentence) {
  return {std::string("lighting.color_material.") + name, kTracking, sentence, "",
          [mode](Script& s) { tracking(s, GL_FRONT, mode), s.Color3f(1, 0.4, 0.1), dome(s, {.tilt = 0.8}); }};
}

// A triangle with a color at each corner.
void colored_triangle(Script& s) {
  s.Begin(GL_TRIANGLES);
  s.Color3f(1, 0, 0), s.Vertex3f(-1, -1, 0), s.Color3f(0, 1, 0), s.Vertex3f(1, -1, 0), s.Color3f(0, 0, 1),
      s.Vertex3f(0, 1, 0);
  s.End();
}

void texture(Script& s, double r, double g, double b) {
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST),
      s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  std::vector<double> texels;
  for (int i = 0; i < 16; i++) texels.insert(texels.end(), {r, g, b, 255});
  s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               Memory{GL_UNSIGNED_BYTE, texels});
  s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE), s.Enable(GL_TEXTURE_2D);
}

void shiny(Script& s) {
  diffuse_scene(s, {0.6, 0.4, 1, 0}, {0.5, 0.6, 0.7, 1}),
      s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{0.9, 0.8, 0.7, 1});
  s.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, V{0.8, 0.8, 0.8, 1}),
      s.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 8.0);
}

} // namespace

std::vector<Test> lighting_color_material_tests() {
  return {
      tracked("ambient", GL_AMBIENT, "GL_AMBIENT: the ambient color tracks the current color."),
      tracked("diffuse", GL_DIFFUSE, "GL_DIFFUSE: the diffuse color tracks the current color."),
      tracked("specular", GL_SPECULAR, "GL_SPECULAR: the specular color tracks the current color."),
      tracked("emission", GL_EMISSION, "GL_EMISSION: the emission tracks the current color."),
      tracked("ambient_and_diffuse", GL_AMBIENT_AND_DIFFUSE,
              "GL_AMBIENT_AND_DIFFUSE: both colors track the current color."),
      {"lighting.color_material.default", kTracking,
       "At first ambient and diffuse colors of both faces would track.", "",
       [](Script& s) {
         diffuse_scene(s), s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.5, 0.5, 0.5, 1}),
             s.Enable(GL_COLOR_MATERIAL);
         s.Color3f(0.2, 0.9, 0.5), dome(s);
       }},
      {"lighting.color_material.at_enable", kTracking,
       "The color that is current when GL_COLOR_MATERIAL is enabled is tracked.", "",
       [](Script& s) {
         s.Color3f(0.9, 0.5, 0.2), diffuse_scene(s), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL), dome(s);
       }},
      {"lighting.color_material.mode_while_enabled", kTracking,
       "glColorMaterial while GL_COLOR_MATERIAL is enabled sets the material to the current color.", "",
       [](Script& s) {
         s.Color3f(0.9, 0.5, 0.2), tracking(s, GL_FRONT, GL_EMISSION), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             dome(s);
       }},
      {"lighting.color_material.stays_after_disable", kTracking, "What was tracked stays in the material.",
       "",
       [](Script& s) {
         tracking(s, GL_FRONT, GL_DIFFUSE), s.Color3f(0.1, 0.8, 0.4), s.Disable(GL_COLOR_MATERIAL),
             s.Color3f(1, 0, 0), dome(s);
       }},
      {"lighting.color_material.off", kTracking,
       "While GL_COLOR_MATERIAL is disabled the current color does not matter.", "",
       [](Script& s) {
         s.Color3f(1, 0, 0), diffuse_scene(s), s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Color3f(0, 1, 0),
             dome(s);
       }},
      {"lighting.color_material.wins_over_material", kTracking,
       "glMaterial does not change what tracks the current color.", "",
       [](Script& s) {
         tracking(s, GL_FRONT, GL_DIFFUSE), s.Color3f(0.2, 0.6, 1),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0, 0, 1}), dome(s);
       }},
      {"lighting.color_material.material_of_another_term", kTracking,
       "glMaterial changes what does not track.", "",
       [](Script& s) {
         tracking(s, GL_FRONT, GL_DIFFUSE), s.Color3f(0.2, 0.6, 1),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 0, 0, 1}), dome(s);
       }},
      {"lighting.color_material.material_after_disable", kTracking,
       "glMaterial counts again when tracking is over.", "",
       [](Script& s) {
         tracking(s, GL_FRONT, GL_DIFFUSE), s.Color3f(0.2, 0.6, 1), s.Disable(GL_COLOR_MATERIAL);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0.8, 0, 1}), dome(s);
       }},
      {"lighting.color_material.ambient_and_diffuse_half", kTracking,
       "glMaterial of both colors changes only the one that does not track.", "",
       [](Script& s) {
         tracking(s, GL_FRONT, GL_DIFFUSE), s.Color3f(0.2, 0.6, 1),
             s.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, V{1, 0.3, 0, 1}), dome(s);
       }},
      {"lighting.color_material.each_vertex", kTracking, "Each vertex has the color that is current there.",
       "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL), colored_triangle(s);
       }},
      {"lighting.color_material.each_vertex_emission", kTracking,
       "The emission may track the color of each vertex.", "",
       [](Script& s) {
         dark(s), s.ColorMaterial(GL_FRONT, GL_EMISSION), s.Enable(GL_COLOR_MATERIAL), colored_triangle(s);
       }},
      {"lighting.color_material.each_vertex_specular", kTracking,
       "The specular color may track the color of each vertex.", "",
       [](Script& s) {
         specular_scene(s, {0, 0, 1, 0}, 5), s.ColorMaterial(GL_FRONT, GL_SPECULAR),
             s.Enable(GL_COLOR_MATERIAL), colored_triangle(s);
       }},
      {"lighting.color_material.each_vertex_ambient", kTracking,
       "The ambient color may track the color of each vertex.", "",
       [](Script& s) {
         dark(s), s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.8, 0.9, 1, 1}),
             s.ColorMaterial(GL_FRONT, GL_AMBIENT);
         s.Enable(GL_COLOR_MATERIAL), colored_triangle(s);
       }},
      {"lighting.color_material.material_inside", "2.14.3, 2.6.3",
       "glMaterial between Begin and End does not change what tracks.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL);
         s.Color3f(0.3, 0.7, 0.3), s.Begin(GL_TRIANGLES), s.Vertex3f(-1, -1, 0),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0, 0, 1});
         s.Vertex3f(1, -1, 0), s.Materialfv(GL_FRONT, GL_EMISSION, V{0, 0, 0.5, 1}), s.Vertex3f(0, 1, 0),
             s.End();
       }},
      {"lighting.color_material.back", kTracking, "GL_BACK: the back material alone tracks.", "",
       [](Script& s) {
         tracking(s, GL_BACK, GL_DIFFUSE), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.Color3f(1, 0.2, 0.2);
         s.Lightfv(GL_LIGHT0, GL_POSITION, V{1, 0, 0, 0});
         dome(s, {.cells = 6, .x = -0.55, .size = 0.5}),
             dome(s, {.cells = 6, .inward = true, .x = 0.55, .size = 0.5});
       }},
      {"lighting.color_material.back_each_vertex", kTracking,
       "A back material tracks the color of each vertex, in all components.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}),
             s.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
         s.Enable(GL_COLOR_MATERIAL), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.FrontFace(GL_CW),
             s.Normal3f(0, 0, -1);
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.2, 0.2, 0.2, 1}), colored_triangle(s);
       }},
      {"lighting.color_material.alpha", kTracking,
       "The alpha of the current color becomes that of the diffuse color.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL);
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), s.Color4f(0, 0, 0, 0.4),
             sheet(s, -1, -1, 1, 1);
       }},
      {"lighting.color_material.alpha_of_ambient", kTracking,
       "The alpha of an ambient color that tracks does not matter.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 1, 1, 1}),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 0.7});
         s.ColorMaterial(GL_FRONT, GL_AMBIENT), s.Enable(GL_COLOR_MATERIAL);
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), s.Color4f(0, 0, 0, 0.1),
             sheet(s, -1, -1, 1, 1);
       }},
      {"lighting.color_material.bytes", "2.14.3, table 2.9", "Colors of bytes are tracked like others.", "",
       [](Script& s) {
         diffuse_scene(s), s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Enable(GL_COLOR_MATERIAL),
             s.Color3ub(200, 100, 50), dome(s);
       }},
      {"lighting.color_material.between_draws", kTracking, "Primitives have the color of their time.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL);
         for (int i = 0; i < 5; i++)
           s.Color3f(0.2 * i, 1 - 0.2 * i, 0.5), sheet(s, -1 + 0.4 * i, -1, -0.65 + 0.4 * i, 1);
       }},
  };
}

std::vector<Test> lighting_result_tests() {
  return {
      {"lighting.off.current_color", "2.14.1", "Without lighting a vertex has the current color.", "",
       [](Script& s) { diffuse_scene(s), s.Disable(GL_LIGHTING), colored_triangle(s); }},
      {"lighting.clamp.above", "2.14.6",
       "Colors are clamped to 1 at the vertex, before they are interpolated.", "",
       [](Script& s) {
         dark(s), s.Begin(GL_TRIANGLES), s.Materialfv(GL_FRONT, GL_EMISSION, V{4, 0, 0.5, 1}),
             s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_FRONT, GL_EMISSION, V{0, 2, 0.5, 1}), s.Vertex3f(1, -1, 0),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{0, 0, 3, 1});
         s.Vertex3f(0, 1, 0), s.End();
       }},
      {"lighting.clamp.below", "2.14.6",
       "Colors are clamped to 0 at the vertex, before they are interpolated.", "",
       [](Script& s) {
         dark(s), s.Begin(GL_TRIANGLES), s.Materialfv(GL_FRONT, GL_EMISSION, V{-3, 1, 1, 1}),
             s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_FRONT, GL_EMISSION, V{1, -2, 1, 1}), s.Vertex3f(1, -1, 0),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 1, -1, 1});
         s.Vertex3f(0, 1, 0), s.End();
       }},
      {"lighting.clamp.after_the_sum", "2.14.6", "Terms are not clamped before they are added.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {2, 2, 2, 1}), lamp(s, GL_LIGHT1, V{0, 0, 1, 0}),
             s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{-1.4, -1.2, -1.6, 1});
         dome(s, {.tilt = 0.7});
       }},
      {"lighting.clamp.alpha", "2.14.6", "Alpha is clamped, too.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 0.5, 0.2, 1}),
             s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 3}), sheet(s, -1, -1, 0, 1);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 0.5}), sheet(s, 0.1, -1, 1, 1);
       }},
      {"lighting.alpha.diffuse_only", "2.14.1",
       "Alpha is that of the diffuse color, whatever all other alphas are.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{0, 0, 1, 0}),
             s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.5, 0.5, 0.5, 0.1});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.1, 0.1, 0.1, 0.2}),
             s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.5, 0.5, 0.5, 0.3});
         s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{0.5, 0.5, 0.5, 0.4}),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 1, 1, 0.5});
         s.Materialfv(GL_FRONT, GL_SPECULAR, V{0.2, 0.2, 0.2, 0.7}),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{0.1, 0.1, 0.1, 0.8});
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.9, 0.8, 0.5, 0.6});
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), dome(s);
       }},
      {"lighting.alpha.not_attenuated", "2.14.1", "Neither distance nor angle changes alpha.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 1}), s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 2.0),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 0.5});
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), dome(s, {.tilt = 3});
       }},
      {"lighting.alpha.interpolated", "3.5.1", "Alpha is interpolated like red, green and blue.", "",
       [](Script& s) {
         dark(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 1, 1, 1}),
             s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND);
         s.Begin(GL_TRIANGLES), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 0}), s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 1}), s.Vertex3f(1, -1, 0), s.Vertex3f(0, 1, 0),
             s.End();
       }},
      {"lighting.alpha.test", "2.14.1, 4.1.3", "The alpha test sees the alpha of the diffuse color.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.AlphaFunc(GL_GREATER, 0.5), s.Enable(GL_ALPHA_TEST);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 0.3}), sheet(s, -1, -1, 0, 1);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.5, 1, 1, 0.8}), sheet(s, 0.1, -1, 1, 1);
       }},
      {"lighting.separate.untextured", "2.14.1, 3.9",
       "Without a texture the separate highlight is added to the primary color.", "",
       [](Script& s) {
         shiny(s), s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s);
       },
       kSeparateSpecular},
      {"lighting.separate.textured", "2.14.1, 3.9", "A separate highlight is added behind the texture.", "",
       [](Script& s) {
         shiny(s), texture(s, 200, 60, 20),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s);
       },
       kSeparateSpecular},
      {"lighting.separate.single_textured", "2.14.1, 3.8.13",
       "A single color has its highlight multiplied by the texture.", "",
       [](Script& s) { shiny(s), texture(s, 200, 60, 20), dome(s); }},
      {"lighting.separate.black_texture", "3.9", "Over a black texture the separate highlight alone is left.",
       "",
       [](Script& s) {
         shiny(s), texture(s, 0, 0, 0),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s);
       },
       kSeparateSpecular},
      {"lighting.separate.back", "2.14.1", "A back face has a secondary color of its own.", "",
       [](Script& s) {
         shiny(s), s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR),
             s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
         s.Materialfv(GL_BACK, GL_SPECULAR, V{1, 0, 0, 1}),
             s.Materialfv(GL_BACK, GL_DIFFUSE, V{0, 0.6, 0, 1}), texture(s, 250, 100, 50);
         s.Lightfv(GL_LIGHT0, GL_POSITION, V{-0.3, -0.2, -1, 0}), dome(s, {.tilt = 0.8, .inward = true});
       },
       kSeparateSpecular},
      {"lighting.separate.clamped_apart", "2.14.6",
       "Primary and secondary colors are clamped each by itself at the vertex.", "",
       [](Script& s) {
         shiny(s), s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{3, 3, 3, 1}),
             s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{3, 2, 1, 1}), texture(s, 80, 80, 80);
         s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s);
       },
       kSeparateSpecular},
      {"lighting.separate.sum_is_clamped", "3.9", "The sum of both colors is clamped to 1.", "",
       [](Script& s) {
         shiny(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.7, 0.6, 0.5, 1}),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
         dome(s);
       },
       kSeparateSpecular},
      {"lighting.separate.alpha", "2.14.1", "The secondary color does not change alpha.", "",
       [](Script& s) {
         shiny(s), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 0.5}),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), dome(s);
       },
       kSeparateSpecular},
      {"lighting.fog.after_lighting", "3.10", "Fog takes the lit color.", "",
       [](Script& s) {
         diffuse_scene(s), s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 2.0), s.Fogf(GL_FOG_END, 8.0);
         s.Fogfv(GL_FOG_COLOR, V{0.2, 0.6, 1, 1}), s.Enable(GL_FOG), dome(s);
       }},
      {"lighting.fog.after_separate_specular", "3.9, 3.10", "The separate highlight is added before the fog.",
       "",
       [](Script& s) {
         shiny(s), texture(s, 100, 50, 200),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
         s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 1.0), s.Fogf(GL_FOG_END, 7.0),
             s.Fogfv(GL_FOG_COLOR, V{0, 0.4, 0, 1});
         s.Enable(GL_FOG), dome(s);
       },
       kSeparateSpecular},
      {"lighting.fog.color_sum_is_clamped", "3.9", "The color sum is clamped before the fog.", "",
       [](Script& s) {
         shiny(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.9, 0.9, 0.9, 1}),
             s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
         s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 1.0), s.Fogf(GL_FOG_END, 9.0),
             s.Fogfv(GL_FOG_COLOR, V{0, 0, 0, 1});
         s.Enable(GL_FOG), dome(s);
       },
       kSeparateSpecular},
      {"lighting.interpolation.gouraud", "2.14, 3.5.1",
       "Lighting is computed at the vertices and interpolated: a highlight between them is not seen.",
       "Colors may be interpolated with or without perspective.",
       [](Script& s) {
         specular_scene(s, {0, 0, 1, 0}, 60), s.Begin(GL_TRIANGLES), s.Normal3f(-0.6, -0.6, 0.53),
             s.Vertex3f(-1, -1, 0);
         s.Normal3f(0.6, -0.6, 0.53), s.Vertex3f(1, -1, 0), s.Normal3f(0, 0.2, 0.98), s.Vertex3f(0, 1, 0),
             s.End();
       }},
      {"lighting.interpolation.perspective", "3.5.1, equation 3.6",
       "Colors are interpolated over a triangle that recedes.",
       "Equation 3.6 may be approximated: with or without perspective.",
       [](Script& s) {
         perspective(s), diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL);
         s.Begin(GL_TRIANGLES), s.Color3f(1, 0, 0), s.Vertex3f(-0.6, -0.6, 2), s.Color3f(0, 1, 0),
             s.Vertex3f(1, -1, 0);
         s.Color3f(0, 0, 1), s.Vertex3f(1, 2, -5), s.End();
       }},
      {"lighting.interpolation.quad", "3.5.1",
       "A quadrilateral has convex combinations of the colors of its corners.", "Any convex combination.",
       [](Script& s) {
         diffuse_scene(s, {0.3, 0.2, 1, 0}), s.Begin(GL_QUADS);
         dome_vertex(s, {.tilt = 0.6}, -1, -1), dome_vertex(s, {.tilt = 0.6}, 1, -1),
             dome_vertex(s, {.tilt = 0.6}, 1, 1), dome_vertex(s, {.tilt = 0.6}, -1, 1);
         s.End();
       }},
      {"lighting.interpolation.depth", "2.14, 4.1.5", "Lit surfaces hide each other by their depth.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_DEPTH_TEST), s.Normal3f(0, 0.6, 0.8), sheet(s, -1, -1, 0.3, 0.3, 0.5);
         s.Normal3f(0, 0, 1), sheet(s, -0.3, -0.3, 1, 1, 0), dome(s, {.x = 0, .size = 0.5});
       }},
  };
}

} // namespace softgl::suite
