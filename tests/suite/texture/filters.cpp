// Wrap modes, filters, levels of detail, completeness (3.8.7 to 3.8.10).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

Test wrapped(const char* name, GLenum mode, GLenum filter, const char* sentence, Need need = {}) {
  return texture_test(
      name, "3.8.7, 3.8.8", sentence,
      [=](Script& s) {
        replace_scene(s), filters(s, GL_TEXTURE_2D, filter, filter), wrap(s, GL_TEXTURE_2D, mode);
        s.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, V{1, 0.5, 0, 1});
        textured_sheet(s, {-0.77, -0.62, 1.71, 1.43});
      },
      need);
}

// A 1D texture of 64 texels with a color a level, with stripes of several levels of detail.
Test leveled(const char* name, GLenum min_filter, GLenum mag_filter, const char* sentence,
             std::vector<double> lods, std::function<void(Script&)> before = {}, Need need = {}) {
  return texture_test(
      name, "3.8.8, 3.8.9", sentence,
      [=](Script& s) {
        replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, min_filter, mag_filter),
            colored_levels(s, 64);
        if (before) before(s);
        stripes(s, 64, lods);
      },
      need);
}

// Magnified and minified texels differ in how they are filtered: levels of detail around where the two meet.
Test switched(const char* name, GLenum min_filter, GLenum mag_filter, const char* sentence,
              std::vector<double> lods) {
  return texture_test(
      name, "3.8.9", sentence,
      [=](Script& s) {
        replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, min_filter, mag_filter);
        for (int level = 0, width = 64; width > 0; level++, width /= 2) image_1d(s, width, level, level);
        stripes(s, 64, lods);
      },
      {}, "which of two texels a pixel takes that lies between them");
}

void limit(Script& s, GLenum name, double value) { s.TexParameterf(GL_TEXTURE_1D, name, value); }

// Draws what an incomplete texture leaves as it is: the color of the fragment.
Test incomplete(const char* name, const char* sentence, std::function<void(Script&)> images, Need need = {},
                GLenum target = GL_TEXTURE_2D) {
  return texture_test(
      name, "3.8.10", sentence,
      [=](Script& s) {
        filters(s, target, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST), environment(s, GL_REPLACE),
            s.Enable(target);
        s.Color4f(0.9, 0.6, 0.3, 0.8), images(s), textured_sheet(s);
      },
      need);
}

} // namespace

std::vector<Test> texture_filter_tests() {
  const auto nearest = GL_NEAREST, linear = GL_LINEAR;
  return {
      wrapped("wrap.repeat", GL_REPEAT, nearest, "GL_REPEAT takes the fraction of the coordinate."),
      wrapped("wrap.repeat_linear", GL_REPEAT, linear, "GL_REPEAT: beside the last texel stands the first."),
      wrapped("wrap.clamp", GL_CLAMP, nearest, "GL_CLAMP clamps the coordinate to [0, 1]."),
      wrapped("wrap.clamp_linear", GL_CLAMP, linear,
              "GL_CLAMP: at the edges half of the border color is seen."),
      wrapped("wrap.edge", GL_CLAMP_TO_EDGE, nearest, "GL_CLAMP_TO_EDGE continues the texels at the edges.",
              kVersion12),
      wrapped("wrap.edge_linear", GL_CLAMP_TO_EDGE, linear, "GL_CLAMP_TO_EDGE never filters the border.",
              kVersion12),
      wrapped("wrap.border", GL_CLAMP_TO_BORDER, nearest,
              "GL_CLAMP_TO_BORDER gives the border color outside.", kVersion13),
      wrapped("wrap.border_linear", GL_CLAMP_TO_BORDER, linear,
              "GL_CLAMP_TO_BORDER filters to the border color.", kVersion13),
      wrapped("wrap.mirrored", GL_MIRRORED_REPEAT, nearest,
              "GL_MIRRORED_REPEAT turns every other repetition.", kVersion14),
      wrapped("wrap.mirrored_linear", GL_MIRRORED_REPEAT, linear,
              "GL_MIRRORED_REPEAT clamps to the edge where it turns.", kVersion14),
      texture_test("wrap.each_axis", "3.8.7", "s and t have wrap modes of their own.",
                   [](Script& s) {
                     replace_scene(s);
                     s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
                     s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
                     textured_sheet(s, {-0.6, -0.6, 1.6, 1.6});
                   }),
      texture_test(
          "wrap.r", "3.8.7", "r has a wrap mode of its own.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_3D), wrap(s, GL_TEXTURE_3D, GL_REPEAT);
            s.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(16, 4));
            generate_r(s, 0, 2.3), textured_sheet(s);
          },
          kVersion12),
      texture_test("wrap.border_color_of_luminance", "3.8.8, table 3.15",
                   "The border color is taken as a color of the image's format: luminance is its red.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR),
                         wrap(s, GL_TEXTURE_2D, GL_CLAMP);
                     image_2d(s, GL_LUMINANCE, GL_LUMINANCE);
                     s.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, V{0.9, 0.1, 0.4, 1});
                     textured_sheet(s, {-0.5, -0.5, 1.5, 1.5});
                   }),
      texture_test("wrap.border_color_clamped", "3.8.4", "The border color is clamped to [0, 1].",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR),
                         wrap(s, GL_TEXTURE_2D, GL_CLAMP);
                     s.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, V{3, -1, 0.5, 1});
                     textured_sheet(s, {-0.5, -0.5, 1.5, 1.5});
                   }),

      texture_test("filter.magnified_nearest", "3.8.9",
                   "GL_NEAREST takes the texel that the coordinate lies in.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_NEAREST),
                         textured_sheet(s, {0.1, 0.1, 0.8, 0.9});
                   }),
      texture_test("filter.magnified_linear", "3.8.9",
                   "GL_LINEAR weighs the four texels round the coordinate.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_NEAREST, GL_LINEAR),
                         textured_sheet(s, {0.1, 0.1, 0.8, 0.9});
                   }),
      texture_test("filter.linear_1d", "3.8.8", "GL_LINEAR weighs two texels of a 1D image.",
                   [](Script& s) {
                     replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, GL_LINEAR, GL_LINEAR),
                         image_1d(s, 8), textured_sheet(s);
                   }),
      texture_test(
          "filter.linear_3d", "3.8.8", "GL_LINEAR weighs eight texels of a 3D image.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_3D), filters(s, GL_TEXTURE_3D, GL_LINEAR, GL_LINEAR),
                generate_r(s, 0.5, 0.4);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(16, 4));
            textured_sheet(s);
          },
          kVersion12),
      texture_test("filter.linear_alpha", "3.8.8", "Alpha is filtered as the other components are.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR), see_alpha(s);
                     image_2d(s, GL_ALPHA, GL_ALPHA), textured_sheet(s);
                   }),

      leveled("level.nearest_mipmap_nearest", GL_NEAREST_MIPMAP_NEAREST, nearest,
              "GL_NEAREST_MIPMAP_NEAREST takes the nearest level.", {-1, 0.3, 0.7, 1.3, 1.7, 2.3, 3.7, 9}),
      leveled("level.linear_mipmap_nearest", GL_LINEAR_MIPMAP_NEAREST, nearest,
              "GL_LINEAR_MIPMAP_NEAREST takes the nearest level.", {-1, 0.3, 0.7, 1.3, 1.7, 2.3, 3.7, 9}),
      leveled("level.nearest_mipmap_linear", GL_NEAREST_MIPMAP_LINEAR, nearest,
              "GL_NEAREST_MIPMAP_LINEAR weighs two levels by the fraction of the level of detail.",
              {-1, 0.25, 0.5, 1.4, 2, 2.75, 4.5, 9}),
      leveled("level.linear_mipmap_linear", GL_LINEAR_MIPMAP_LINEAR, linear,
              "GL_LINEAR_MIPMAP_LINEAR weighs two levels by the fraction of the level of detail.",
              {-1, 0.25, 0.5, 1.4, 2, 2.75, 4.5, 9}),
      leveled("level.nearest_ignores_levels", nearest, nearest,
              "GL_NEAREST takes the base level at every size.", {-1, 0.5, 1.5, 3, 5}),
      leveled("level.linear_ignores_levels", linear, linear, "GL_LINEAR takes the base level at every size.",
              {-1, 0.5, 1.5, 3, 4}),
      leveled(
          "level.base", GL_NEAREST_MIPMAP_NEAREST, nearest, "The base level is the largest that is taken.",
          {-1, 1.3, 2.3, 2.7, 4.3}, [](Script& s) { limit(s, GL_TEXTURE_BASE_LEVEL, 2); }, kVersion12),
      leveled(
          "level.max", GL_NEAREST_MIPMAP_NEAREST, nearest, "The maximum level is the smallest that is taken.",
          {-1, 1.3, 2.3, 3.3, 6}, [](Script& s) { limit(s, GL_TEXTURE_MAX_LEVEL, 2); }, kVersion12),
      leveled(
          "level.max_weighed", GL_NEAREST_MIPMAP_LINEAR, nearest,
          "Beyond the maximum level nothing is weighed.", {-1, 0.75, 1.5, 2.5, 4.5},
          [](Script& s) { limit(s, GL_TEXTURE_MAX_LEVEL, 2); }, kVersion12),
      leveled(
          "level.min_lod", GL_NEAREST_MIPMAP_NEAREST, nearest,
          "The level of detail is at least GL_TEXTURE_MIN_LOD.", {-3, 0.7, 1.7, 3.3},
          [](Script& s) { limit(s, GL_TEXTURE_MIN_LOD, 2.2); }, kVersion12),
      leveled(
          "level.max_lod", GL_NEAREST_MIPMAP_NEAREST, nearest,
          "The level of detail is at most GL_TEXTURE_MAX_LOD.", {-3, 0.7, 1.7, 3.3, 6},
          [](Script& s) { limit(s, GL_TEXTURE_MAX_LOD, 1.8); }, kVersion12),
      leveled(
          "level.bias", GL_NEAREST_MIPMAP_NEAREST, nearest,
          "The bias of the unit is added to the level of detail.", {-3, -1, 0.1, 1, 2},
          [](Script& s) { s.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1.25); }, kVersion14),
      leveled(
          "level.bias_before_limits", GL_NEAREST_MIPMAP_NEAREST, nearest,
          "The level of detail is limited after the bias.", {-3, -1, 0.1, 1, 4},
          [](Script& s) {
            s.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 1.25);
            limit(s, GL_TEXTURE_MIN_LOD, 0.75), limit(s, GL_TEXTURE_MAX_LOD, 1.75);
          },
          kVersion14),
      switched(
          "level.switch_at_half", GL_NEAREST_MIPMAP_NEAREST, linear,
          "Between GL_LINEAR and GL_NEAREST_MIPMAP_NEAREST magnification ends at a level of detail of 0.5.",
          {-2, -0.3, 0.2, 0.4}),
      switched(
          "level.switch_at_half_linear", GL_NEAREST_MIPMAP_LINEAR, linear,
          "Between GL_LINEAR and GL_NEAREST_MIPMAP_LINEAR magnification ends at a level of detail of 0.5.",
          {-2, -0.3, 0.2, 0.4}),
      switched("level.switch_at_zero", nearest, linear, "Between GL_LINEAR and GL_NEAREST it ends at 0.",
               {-2, -0.5, -0.12, 0.15}),
      switched("level.switch_to_linear", linear, nearest, "Between GL_NEAREST and GL_LINEAR it ends at 0.",
               {-2, -0.5, -0.12, 0.3}),
      texture_test(
          "level.largest_change", "3.8.8", "The axis with the larger change decides about the level.",
          [](Script& s) { // the coordinate changes along y, which the texels of s are seen by
            replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
            colored_levels(s, 64);
            s.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
            for (int i = 0; i < 4; i++) {
              const double plane[4] = {0.3, 1.5, 4.4, 11};
              s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0.1, plane[i], 0, 0}), s.Enable(GL_TEXTURE_GEN_S);
              textured_sheet(s, {}, -1 + 0.5 * i, -1, -0.6 + 0.5 * i, 1);
            }
          }),

      incomplete("complete.no_image", "Without an image texturing is as if it were off.", [](Script&) {}),
      incomplete("complete.missing_level", "If a level is missing, texturing is as if it were off.",
                 [](Script& s) { image_2d(s), image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 2); }),
      incomplete("complete.wrong_size", "If a level is not half as large, texturing is as if it were off.",
                 [](Script& s) {
                   image_2d(s, GL_RGBA, GL_RGBA, 8, 8), image_2d(s, GL_RGBA, GL_RGBA, 4, 2, 1);
                   image_2d(s, GL_RGBA, GL_RGBA, 2, 2, 2), image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 3);
                 }),
      incomplete("complete.wrong_format",
                 "If a level has another internal format, texturing is as if it were off.",
                 [](Script& s) {
                   image_2d(s), image_2d(s, GL_RGB, GL_RGB, 2, 2, 1), image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 2);
                 }),
      incomplete(
          "complete.first_filter", "The initial filter needs levels.",
          [](Script& s) { filters(s, GL_TEXTURE_2D, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR), image_2d(s); }),
      incomplete("complete.all_levels", "With all levels down to 1x1 the texture is complete.",
                 [](Script& s) {
                   image_2d(s, GL_RGBA, GL_RGBA, 4, 2), image_2d(s, GL_RGBA, GL_RGBA, 2, 1, 1, 3),
                       image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 2, 4);
                 }),
      incomplete(
          "complete.up_to_max_level", "Levels beyond the maximum level may be missing.",
          [](Script& s) {
            image_2d(s), image_2d(s, GL_RGBA, GL_RGBA, 2, 2, 1, 3);
            s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
          },
          kVersion12),
      incomplete(
          "complete.from_base_level", "Levels before the base level may be missing.",
          [](Script& s) {
            image_2d(s, GL_RGBA, GL_RGBA, 2, 2, 1, 3), image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 2, 4);
            s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
          },
          kVersion12),
      incomplete(
          "complete.base_above_max",
          "With the base level above the maximum level texturing is as if it were off.",
          [](Script& s) {
            image_2d(s), image_2d(s, GL_RGBA, GL_RGBA, 2, 2, 1), image_2d(s, GL_RGBA, GL_RGBA, 1, 1, 2);
            s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
            s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
          },
          kVersion12),
      incomplete(
          "complete.cube_face", "A cube map without one of its faces is as if it were off.",
          [](Script& s) {
            filters(s, GL_TEXTURE_CUBE_MAP, GL_NEAREST, GL_NEAREST);
            for (int face = 0; face < 5; face++)
              s.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 2, 2, 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, texel_bytes(4, 4, face));
          },
          kVersion13, GL_TEXTURE_CUBE_MAP),
      texture_test(
          "mipmap.generated", "3.8.8", "GL_GENERATE_MIPMAP makes all levels when the base level is given.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
            s.TexParameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, GL_TRUE);
            s.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         plain_bytes(64, {40, 200, 120, 255}));
            stripes(s, 64, {-1, 1.3, 3.3, 6});
          },
          kVersion14),
      texture_test(
          "mipmap.of_part", "3.8.8",
          "GL_GENERATE_MIPMAP makes all levels anew when a part of the base level changes.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
            colored_levels(s, 64), s.TexParameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, GL_TRUE);
            s.TexSubImage1D(GL_TEXTURE_1D, 0, 0, 64, GL_RGBA, GL_UNSIGNED_BYTE,
                            plain_bytes(64, {40, 200, 120, 255}));
            stripes(s, 64, {-1, 1.3, 3.3, 6});
          },
          kVersion14),
      texture_test(
          "mipmap.not_of_other_levels", "3.8.8", "Another level than the base level generates nothing.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_1D), filters(s, GL_TEXTURE_1D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
            colored_levels(s, 64), s.TexParameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, GL_TRUE);
            s.TexSubImage1D(GL_TEXTURE_1D, 2, 0, 16, GL_RGBA, GL_UNSIGNED_BYTE,
                            plain_bytes(16, {40, 200, 120, 255}));
            stripes(s, 64, {-1, 1.3, 2.3, 3.3});
          },
          kVersion14),
  };
}

} // namespace softgl::suite
