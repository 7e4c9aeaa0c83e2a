// Texture environments, combiners, several units (3.8.13, 3.8.15).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kAdd{13, "GL_ARB_texture_env_add"}, kCombine{13, "GL_ARB_texture_env_combine"},
    kCrossbar{14, "GL_ARB_texture_env_crossbar"}, kDot{13, "GL_ARB_texture_env_dot3"};

const char* mode_name(GLenum mode) {
  switch (mode) {
  case GL_REPLACE: return "replace";
  case GL_MODULATE: return "modulate";
  case GL_DECAL: return "decal";
  case GL_BLEND: return "blend";
  }
  return "add";
}
const char* base_name(GLenum base) {
  switch (base) {
  case GL_ALPHA: return "alpha";
  case GL_LUMINANCE: return "luminance";
  case GL_LUMINANCE_ALPHA: return "luminance_alpha";
  case GL_INTENSITY: return "intensity";
  case GL_RGB: return "rgb";
  }
  return "rgba";
}

// A fragment's color that varies meets a texture, and an environment's color.
void colored_scene(Script& s, GLenum base) {
  replace_scene(s), see_alpha(s), image_2d(s, base, GL_RGBA, 4, 4, 0, 2);
  s.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, V{0.2, 0.9, 0.5, 0.7});
}
void colored_sheet(Script& s, bool second_unit = false) {
  s.Begin(GL_TRIANGLES);
  for (int corner : {0, 1, 3, 0, 3, 2}) {
    const float x = corner & 1 ? 1 : 0, y = corner & 2 ? 1 : 0;
    s.Color4f(0.3f + 0.7f * x, 0.9f - 0.6f * y, 0.4f + 0.3f * x, 0.5f + 0.4f * y), s.TexCoord2f(x, y);
    if (second_unit) s.MultiTexCoord2f(GL_TEXTURE1, y, x * 2);
    s.Vertex3f(2 * x - 1, 2 * y - 1, 0);
  }
  s.End();
}

Test simple(GLenum mode, GLenum base) {
  const std::string name = std::string("texture.environment.") + mode_name(mode) + "_" + base_name(base),
                    sentence = std::string("The environment ") + mode_name(mode) + " of a texture of " +
                               base_name(base) + " follows its row of the table.";
  return {name,
          "3.8.13, tables 3.22 and 3.23",
          sentence,
          "",
          [=](Script& s) { colored_scene(s, base), environment(s, mode), colored_sheet(s); },
          mode == GL_ADD ? kAdd : Need{}};
}

void combine(Script& s, GLenum name, GLenum value) { s.TexEnvi(GL_TEXTURE_ENV, name, value); }

// GL_COMBINE with the state that the test sets.
Test combined(const char* name, const char* sentence, std::function<void(Script&)> state,
              Need need = kCombine, GLenum base = GL_RGBA) {
  return texture_test(
      name, "3.8.13, tables 3.24 and 3.25", sentence,
      [=](Script& s) { colored_scene(s, base), environment(s, GL_COMBINE), state(s), colored_sheet(s); },
      need);
}

// A second texture on unit 1.
void second_texture(Script& s, GLenum mode, GLenum base = GL_RGB) {
  s.ActiveTexture(GL_TEXTURE1), s.BindTexture(GL_TEXTURE_2D, 5), s.Enable(GL_TEXTURE_2D);
  filters(s, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST), image_2d(s, base, GL_RGBA, 2, 2, 0, 7),
      environment(s, mode);
  s.ActiveTexture(GL_TEXTURE0);
}
Test units(const char* name, const char* section, const char* sentence, std::function<void(Script&)> state,
           Need need = kMultitexture) {
  return texture_test(
      name, section, sentence,
      [=](Script& s) {
        colored_scene(s, GL_RGBA), environment(s, GL_MODULATE), state(s), colored_sheet(s, true);
      },
      need);
}

} // namespace

std::vector<Test> texture_environment_tests() {
  std::vector<Test> tests;
  for (GLenum mode : {GL_REPLACE, GL_MODULATE, GL_BLEND, GL_ADD})
    for (GLenum base : {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA})
      tests.push_back(simple(mode, base));
  for (GLenum base : {GL_RGB, GL_RGBA}) tests.push_back(simple(GL_DECAL, base));
  const std::vector<Test> more = {
      texture_test("environment.first", "3.8.13", "The first environment is GL_MODULATE.",
                   [](Script& s) {
                     filters(s, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST), s.Enable(GL_TEXTURE_2D), image_2d(s);
                     colored_sheet(s);
                   }),
      texture_test("environment.color_clamped", "3.8.13", "The environment's color is clamped to [0, 1].",
                   [](Script& s) {
                     colored_scene(s, GL_RGB), environment(s, GL_BLEND);
                     s.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, V{2, -1, 0.5, 1}), colored_sheet(s);
                   }),
      combined("combine.replace", "GL_REPLACE gives the first argument.",
               [](Script& s) { combine(s, GL_COMBINE_RGB, GL_REPLACE); }),
      combined("combine.modulate", "GL_MODULATE gives the product of two arguments.",
               [](Script& s) { combine(s, GL_COMBINE_RGB, GL_MODULATE); }),
      combined("combine.add", "GL_ADD gives the sum of two arguments.",
               [](Script& s) { combine(s, GL_COMBINE_RGB, GL_ADD); }),
      combined("combine.add_signed", "GL_ADD_SIGNED gives the sum less 0.5.",
               [](Script& s) { combine(s, GL_COMBINE_RGB, GL_ADD_SIGNED); }),
      combined("combine.subtract", "GL_SUBTRACT gives the first argument less the second.",
               [](Script& s) { combine(s, GL_COMBINE_RGB, GL_SUBTRACT); }),
      combined("combine.interpolate", "GL_INTERPOLATE weighs two arguments by the third.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_INTERPOLATE), combine(s, GL_SOURCE2_RGB, GL_TEXTURE),
                     combine(s, GL_OPERAND2_RGB, GL_SRC_ALPHA), combine(s, GL_SOURCE1_RGB, GL_CONSTANT);
               }),
      combined(
          "combine.dot3_rgb", "GL_DOT3_RGB gives four times the product of vectors that are 0 at 0.5.",
          [](Script& s) { combine(s, GL_COMBINE_RGB, GL_DOT3_RGB); }, kDot),
      combined(
          "combine.dot3_rgba", "GL_DOT3_RGBA gives the product to alpha, too.",
          [](Script& s) { combine(s, GL_COMBINE_RGB, GL_DOT3_RGBA); }, kDot),
      combined("combine.alpha_add", "Alpha has a function of its own.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_COMBINE_ALPHA, GL_ADD_SIGNED);
               }),
      combined("combine.alpha_subtract", "GL_SUBTRACT of alphas.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_COMBINE_ALPHA, GL_SUBTRACT),
                     combine(s, GL_SOURCE1_ALPHA, GL_CONSTANT),
                     combine(s, GL_SOURCE0_ALPHA, GL_PRIMARY_COLOR),
                     combine(s, GL_OPERAND1_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
               }),
      combined("combine.alpha_interpolate", "GL_INTERPOLATE of alphas.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_COMBINE_ALPHA, GL_INTERPOLATE);
               }),
      combined("combine.source_constant", "GL_CONSTANT is the environment's color.",
               [](Script& s) {
                 combine(s, GL_SOURCE1_RGB, GL_CONSTANT), combine(s, GL_SOURCE1_ALPHA, GL_CONSTANT);
               }),
      combined("combine.source_primary", "GL_PRIMARY_COLOR is the fragment's color.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_SOURCE0_RGB, GL_PRIMARY_COLOR);
               }),
      combined("combine.operand_one_minus_color", "GL_ONE_MINUS_SRC_COLOR takes one less the color.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_OPERAND0_RGB, GL_ONE_MINUS_SRC_COLOR);
               }),
      combined("combine.operand_alpha", "GL_SRC_ALPHA takes alpha for each component.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_REPLACE), combine(s, GL_OPERAND0_RGB, GL_SRC_ALPHA);
               }),
      combined("combine.operand_one_minus_alpha", "GL_ONE_MINUS_SRC_ALPHA takes one less alpha.",
               [](Script& s) {
                 combine(s, GL_OPERAND0_RGB, GL_ONE_MINUS_SRC_ALPHA),
                     combine(s, GL_OPERAND0_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
               }),
      combined("combine.scale_2", "GL_RGB_SCALE of 2 doubles the color and clamps it.",
               [](Script& s) { s.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2.0); }),
      combined("combine.scale_4", "GL_RGB_SCALE of 4 scales the color and clamps it.",
               [](Script& s) { s.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 4.0); }),
      combined("combine.scale_after_subtract", "The scale comes before the clamp.",
               [](Script& s) {
                 combine(s, GL_COMBINE_RGB, GL_ADD_SIGNED), s.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 2.0);
               }),
      combined("combine.alpha_scale", "GL_ALPHA_SCALE scales alpha alone.",
               [](Script& s) { s.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 2.0); }),
      combined(
          "combine.luminance", "The alpha of a luminance is 1.",
          [](Script& s) { combine(s, GL_COMBINE_ALPHA, GL_REPLACE); }, kCombine, GL_LUMINANCE),
      combined(
          "combine.alpha_texture", "The color of a texture of alpha is black.",
          [](Script& s) { combine(s, GL_COMBINE_RGB, GL_ADD); }, kCombine, GL_ALPHA),
      combined(
          "combine.intensity", "The alpha of an intensity is the intensity.",
          [](Script& s) { combine(s, GL_COMBINE_ALPHA, GL_REPLACE); }, kCombine, GL_INTENSITY),

      units("units.two", "3.8.15", "The second unit takes what the first gives.",
            [](Script& s) { second_texture(s, GL_MODULATE); }),
      units(
          "units.add_after_modulate", "3.8.15", "Each unit has an environment of its own.",
          [](Script& s) { second_texture(s, GL_ADD); }, kVersion13),
      units("units.decal", "3.8.15", "GL_DECAL on the second unit lies over what the first gives.",
            [](Script& s) { second_texture(s, GL_DECAL, GL_RGBA); }),
      units("units.second_alone", "3.8.15", "The second unit works without the first.",
            [](Script& s) { second_texture(s, GL_MODULATE), s.Disable(GL_TEXTURE_2D); }),
      units("units.first_incomplete", "3.8.10, 3.8.15",
            "A unit whose texture is not complete passes colors on.",
            [](Script& s) {
              second_texture(s, GL_MODULATE);
              s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
            }),
      units(
          "units.previous", "3.8.13", "GL_PREVIOUS is what the unit before gives.",
          [](Script& s) {
            second_texture(s, GL_COMBINE), s.ActiveTexture(GL_TEXTURE1),
                combine(s, GL_COMBINE_RGB, GL_SUBTRACT);
            combine(s, GL_SOURCE0_RGB, GL_PREVIOUS), combine(s, GL_SOURCE1_RGB, GL_TEXTURE),
                s.ActiveTexture(GL_TEXTURE0);
          },
          kVersion13),
      units(
          "units.primary", "3.8.13", "GL_PRIMARY_COLOR on the second unit is the fragment's color.",
          [](Script& s) {
            second_texture(s, GL_COMBINE), s.ActiveTexture(GL_TEXTURE1),
                combine(s, GL_COMBINE_RGB, GL_ADD_SIGNED);
            combine(s, GL_SOURCE1_RGB, GL_PRIMARY_COLOR), s.ActiveTexture(GL_TEXTURE0);
          },
          kVersion13),
      units(
          "units.crossbar", "3.8.13", "A unit takes the texture of another.",
          [](Script& s) {
            second_texture(s, GL_COMBINE), s.ActiveTexture(GL_TEXTURE1),
                combine(s, GL_COMBINE_RGB, GL_MODULATE);
            combine(s, GL_SOURCE0_RGB, GL_TEXTURE0), combine(s, GL_SOURCE1_RGB, GL_TEXTURE1),
                s.ActiveTexture(GL_TEXTURE0);
          },
          kCrossbar),
      units(
          "units.crossbar_forward", "3.8.13", "The first unit takes the texture of the second.",
          [](Script& s) {
            second_texture(s, GL_MODULATE), environment(s, GL_COMBINE), combine(s, GL_COMBINE_RGB, GL_ADD);
            combine(s, GL_SOURCE1_RGB, GL_TEXTURE1);
          },
          kCrossbar),
      units("units.matrix", "2.11.2", "Each unit has a texture matrix of its own.",
            [](Script& s) {
              second_texture(s, GL_MODULATE), s.ActiveTexture(GL_TEXTURE1), s.MatrixMode(GL_TEXTURE);
              s.Scalef(0.5, 1.5, 1.0), s.Translatef(0.3, 0.0, 0.0), s.MatrixMode(GL_MODELVIEW),
                  s.ActiveTexture(GL_TEXTURE0);
            }),
      units("units.generation", "2.11.4", "Each unit generates coordinates of its own.",
            [](Script& s) {
              second_texture(s, GL_MODULATE), s.ActiveTexture(GL_TEXTURE1);
              s.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR),
                  s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{1, 1, 0, 0.2});
              s.Enable(GL_TEXTURE_GEN_S), s.ActiveTexture(GL_TEXTURE0);
            }),
      units("units.separate_filters", "3.8.12", "Each unit samples the texture that is bound to it.",
            [](Script& s) {
              second_texture(s, GL_MODULATE), s.ActiveTexture(GL_TEXTURE1);
              filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR), s.ActiveTexture(GL_TEXTURE0);
            }),
      units("units.same_texture", "3.8.12", "Two units may sample one texture.",
            [](Script& s) {
              s.ActiveTexture(GL_TEXTURE1), s.Enable(GL_TEXTURE_2D), environment(s, GL_MODULATE),
                  s.ActiveTexture(GL_TEXTURE0);
            }),
      units("units.client_attribute", "2.7",
            "glTexCoord sets the coordinates of unit 0, whatever unit is active.",
            [](Script& s) { second_texture(s, GL_MODULATE), s.ActiveTexture(GL_TEXTURE1); }),
  };
  tests.insert(tests.end(), more.begin(), more.end());
  return tests;
}

} // namespace softgl::suite
