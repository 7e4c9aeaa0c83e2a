// Parts of images, copies from the window (3.8.2), and what a GL says of its images (3.8.11, 6.1.3, 6.1.4).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

// What was copied is drawn on an empty window.
void draw_copy(Script& s, GLenum target) {
  filters(s, target, GL_NEAREST, GL_NEAREST), environment(s, GL_REPLACE), s.Enable(target);
  s.Clear(GL_COLOR_BUFFER_BIT), textured_sheet(s);
}

// The n-th answer about a level, a square each.
void level(Script& s, GLenum target, int n, GLenum name, double low, double high, int at) {
  s.PaintTexLevel(target, n, name, low, high, 2 + at % 10 * 9, 2 + at / 10 * 9);
}

void read(Script& s, int level, GLenum format, GLenum type, int elements, int columns) {
  s.PixelStorei(GL_PACK_ALIGNMENT, 1),
      s.PaintTexImage(GL_TEXTURE_2D, level, format, type, elements, 2, 2, columns, 8);
}

const Memory kNothing{GL_NONE, {}};

} // namespace

std::vector<Test> texture_part_tests() {
  const auto test = [](const char* name, const char* section, const char* sentence,
                       std::function<void(Script&)> body, Need need = {}) {
    return texture_test(name, section, sentence, std::move(body), need);
  };
  return {
      test("part.of_2d", "3.8.2", "glTexSubImage2D changes a rectangle of texels and no others.",
           [](Script& s) {
             replace_scene(s), image_2d(s, GL_RGBA, GL_RGBA, 8, 8);
             s.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 1, 3, 5, GL_RGBA, GL_UNSIGNED_BYTE, texel_bytes(15, 4, 5));
             textured_sheet(s);
           }),
      test("part.of_1d", "3.8.2", "glTexSubImage1D changes a row of texels and no others.",
           [](Script& s) {
             replace_scene(s, GL_TEXTURE_1D), image_1d(s, 16);
             s.TexSubImage1D(GL_TEXTURE_1D, 0, 5, 4, GL_RGBA, GL_UNSIGNED_BYTE, texel_bytes(4, 4, 5)),
                 textured_sheet(s);
           }),
      test(
          "part.of_3d", "3.8.2", "glTexSubImage3D changes a box of texels and no others.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_3D), generate_r(s, 0, 0.9);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(64, 4));
            s.TexSubImage3D(GL_TEXTURE_3D, 0, 1, 0, 1, 2, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE,
                            texel_bytes(12, 4, 5));
            textured_sheet(s);
          },
          kVersion12),
      test("part.other_format", "3.8.2", "A part may come in another format than the image.",
           [](Script& s) {
             replace_scene(s), see_alpha(s), image_2d(s, GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA);
             s.TexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 2, 2, GL_RGBA, GL_FLOAT,
                             Memory{GL_FLOAT, {1, 0, 0, 1, 0.5, 1, 1, 1, 0, 1, 0, 0.5, 0.25, 0, 0, 0.75}});
             textured_sheet(s);
           }),
      test("part.of_level", "3.8.2", "A part of a level changes this level.",
           [](Script& s) {
             replace_scene(s, GL_TEXTURE_1D),
                 filters(s, GL_TEXTURE_1D, GL_NEAREST_MIPMAP_NEAREST, GL_NEAREST);
             colored_levels(s, 64);
             s.TexSubImage1D(GL_TEXTURE_1D, 2, 0, 16, GL_RGBA, GL_UNSIGNED_BYTE,
                             plain_bytes(16, {90, 160, 30, 255}));
             stripes(s, 64, {-1, 1, 2, 3});
           }),
      test("copy.image_2d", "3.8.2", "glCopyTexImage2D takes the texels from the window.",
           [](Script& s) {
             colored_window(s), s.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 30, 20, 16, 8, 0),
                 draw_copy(s, GL_TEXTURE_2D);
           }),
      test("copy.image_1d", "3.8.2", "glCopyTexImage1D takes a row of the window.",
           [](Script& s) {
             colored_window(s), s.CopyTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 12, 50, 64, 0),
                 draw_copy(s, GL_TEXTURE_1D);
           }),
      test("copy.luminance", "3.8.2", "A copy to a luminance takes red.",
           [](Script& s) {
             colored_window(s), s.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 50, 30, 16, 16, 0);
             draw_copy(s, GL_TEXTURE_2D);
           }),
      test("copy.part_2d", "3.8.2", "glCopyTexSubImage2D changes a rectangle of texels and no others.",
           [](Script& s) {
             colored_window(s), image_2d(s, GL_RGB, GL_RGB, 16, 16);
             s.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 20, 60, 9, 8), draw_copy(s, GL_TEXTURE_2D);
           }),
      test("copy.part_1d", "3.8.2", "glCopyTexSubImage1D changes a row of texels and no others.",
           [](Script& s) {
             colored_window(s), image_1d(s, 8), s.CopyTexSubImage1D(GL_TEXTURE_1D, 0, 2, 20, 70, 4);
             draw_copy(s, GL_TEXTURE_1D);
           }),
      test(
          "copy.part_3d", "3.8.2", "glCopyTexSubImage3D changes a rectangle in one layer.",
          [](Script& s) {
            colored_window(s), generate_r(s, 0.9, 0);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 8, 8, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, texel_bytes(128, 3));
            s.CopyTexSubImage3D(GL_TEXTURE_3D, 0, 1, 2, 1, 20, 60, 6, 5), draw_copy(s, GL_TEXTURE_3D);
          },
          kVersion12),
      test("copy.transfer", "3.8.2, 3.6.5",
           "What is copied goes through the scales and biases of pixel transfer.",
           [](Script& s) {
             colored_window(s), s.PixelTransferf(GL_RED_SCALE, 0.5), s.PixelTransferf(GL_BLUE_BIAS, 0.3);
             s.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 20, 60, 8, 8, 0);
             s.PixelTransferf(GL_RED_SCALE, 1.0), s.PixelTransferf(GL_BLUE_BIAS, 0.0),
                 draw_copy(s, GL_TEXTURE_2D);
           }),
  };
}

std::vector<Test> texture_query_tests() {
  const auto test = [](const char* name, const char* section, const char* sentence,
                       std::function<void(Script&)> body, Need need = {}) {
    return texture_test(name, section, sentence, std::move(body), need);
  };
  return {
      test("query.level_sizes", "6.1.3",
           "Each level tells its own width, height, border and internal format.",
           [](Script& s) {
             image_2d(s, GL_RGB8, GL_RGB, 16, 8), image_2d(s, GL_LUMINANCE8, GL_LUMINANCE, 4, 2, 2);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, 16, 16, 0),
                 level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, 8, 8, 1);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER, 0, 0, 2);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, GL_RGB8, GL_RGB8, 3);
             level(s, GL_TEXTURE_2D, 2, GL_TEXTURE_WIDTH, 4, 4, 4),
                 level(s, GL_TEXTURE_2D, 2, GL_TEXTURE_HEIGHT, 2, 2, 5);
             level(s, GL_TEXTURE_2D, 2, GL_TEXTURE_INTERNAL_FORMAT, GL_LUMINANCE8, GL_LUMINANCE8, 6);
             level(s, GL_TEXTURE_2D, 1, GL_TEXTURE_WIDTH, 0, 0, 7);
           }),
      test("query.component_sizes", "6.1.3", "A component that the base format does not have has no bits.",
           [](Script& s) {
             image_2d(s, GL_RGB8, GL_RGB), image_2d(s, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, 2, 2, 1);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE, 1, 64, 0);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_GREEN_SIZE, 1, 64, 1);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_BLUE_SIZE, 1, 64, 2);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_ALPHA_SIZE, 0, 0, 3);
             level(s, GL_TEXTURE_2D, 0, GL_TEXTURE_LUMINANCE_SIZE, 0, 0, 4);
             level(s, GL_TEXTURE_2D, 1, GL_TEXTURE_RED_SIZE, 0, 0, 5);
             level(s, GL_TEXTURE_2D, 1, GL_TEXTURE_LUMINANCE_SIZE, 1, 64, 6);
             level(s, GL_TEXTURE_2D, 1, GL_TEXTURE_ALPHA_SIZE, 1, 64, 7);
             level(s, GL_TEXTURE_2D, 1, GL_TEXTURE_INTENSITY_SIZE, 0, 0, 8);
           }),
      test("query.initial_parameters", "6.1.3, table 6.15",
           "A texture has the initial parameters of the table.",
           [](Script& s) {
             const auto is = [&](GLenum name, double value, int at) {
               s.PaintTexParameter(GL_TEXTURE_2D, name, value, value, 2 + at * 9, 2);
             };
             is(GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR, 0), is(GL_TEXTURE_MAG_FILTER, GL_LINEAR, 1);
             is(GL_TEXTURE_WRAP_S, GL_REPEAT, 2), is(GL_TEXTURE_WRAP_T, GL_REPEAT, 3),
                 is(GL_TEXTURE_PRIORITY, 1, 4);
             is(GL_TEXTURE_BORDER_COLOR, 0, 5), is(GL_TEXTURE_RESIDENT, 1, 6);
           }),
      test(
          "query.initial_levels", "6.1.3, table 6.15",
          "Levels and levels of detail are not limited at first.",
          [](Script& s) {
            const auto is = [&](GLenum name, double value, int at) {
              s.PaintTexParameter(GL_TEXTURE_2D, name, value, value, 2 + at * 9, 2);
            };
            is(GL_TEXTURE_MIN_LOD, -1000, 0), is(GL_TEXTURE_MAX_LOD, 1000, 1),
                is(GL_TEXTURE_BASE_LEVEL, 0, 2);
            is(GL_TEXTURE_MAX_LEVEL, 1000, 3), is(GL_TEXTURE_WRAP_R, GL_REPEAT, 4);
          },
          kVersion12),
      test("query.environment", "6.1.3, table 6.17", "The environment tells its mode.",
           [](Script& s) {
             s.PaintTexEnv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE, GL_MODULATE, 2, 2);
             environment(s, GL_BLEND),
                 s.PaintTexEnv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND, GL_BLEND, 11, 2);
           }),
      test(
          "query.initial_combiner", "6.1.3, table 6.17", "The combiners have the initial state of the table.",
          [](Script& s) {
            const auto is = [&](GLenum name, double value, int at) {
              s.PaintTexEnv(GL_TEXTURE_ENV, name, value, value, 2 + at % 9 * 9, 2 + at / 9 * 9);
            };
            is(GL_COMBINE_RGB, GL_MODULATE, 0), is(GL_COMBINE_ALPHA, GL_MODULATE, 1),
                is(GL_SOURCE0_RGB, GL_TEXTURE, 2);
            is(GL_SOURCE1_RGB, GL_PREVIOUS, 3), is(GL_SOURCE2_RGB, GL_CONSTANT, 4),
                is(GL_SOURCE0_ALPHA, GL_TEXTURE, 5);
            is(GL_SOURCE1_ALPHA, GL_PREVIOUS, 6), is(GL_SOURCE2_ALPHA, GL_CONSTANT, 7),
                is(GL_OPERAND0_RGB, GL_SRC_COLOR, 8);
            is(GL_OPERAND1_RGB, GL_SRC_COLOR, 9), is(GL_OPERAND2_RGB, GL_SRC_ALPHA, 10),
                is(GL_RGB_SCALE, 1, 11);
            is(GL_OPERAND2_ALPHA, GL_SRC_ALPHA, 12), is(GL_ALPHA_SCALE, 1, 13);
          },
          kVersion13),
      test("proxy.fits", "3.8.11", "A proxy says of an image that fits what an image would.",
           [](Script& s) {
             s.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, kNothing);
             level(s, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, 64, 64, 0);
             level(s, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, 32, 32, 1);
             level(s, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, GL_RGBA8, GL_RGBA8, 2);
             s.TexImage1D(GL_PROXY_TEXTURE_1D, 0, GL_RGBA8, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, kNothing);
             level(s, GL_PROXY_TEXTURE_1D, 0, GL_TEXTURE_WIDTH, 64, 64, 3), s.PaintError(47, 2);
           }),
      test("proxy.too_large", "3.8.11",
           "A proxy of an image that is too large is 0 wide, and there is no error.",
           [](Script& s) {
             s.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 1 << 20, 1 << 20, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          kNothing);
             level(s, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, 0, 0, 0);
             level(s, GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, 0, 0, 1), s.PaintError(47, 2);
           }),
      test("proxy.changes_nothing", "3.8.11", "A proxy does not change the texture.",
           [](Script& s) {
             replace_scene(s);
             s.TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, kNothing),
                 textured_sheet(s);
           }),
      test("read.rgba", "6.1.4", "glGetTexImage gives the texels, rows from below.",
           [](Script& s) { image_2d(s), read(s, 0, GL_RGBA, GL_UNSIGNED_BYTE, 64, 8); }),
      test("read.luminance", "6.1.4, table 6.1",
           "A luminance is read as red; green and blue are 0, alpha is 1.",
           [](Script& s) {
             image_2d(s, GL_LUMINANCE8, GL_LUMINANCE), read(s, 0, GL_RGBA, GL_UNSIGNED_BYTE, 64, 8);
           }),
      test("read.luminance_alpha", "6.1.4, table 6.1", "A luminance with alpha is read as red and alpha.",
           [](Script& s) {
             image_2d(s, GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA),
                 read(s, 0, GL_RGBA, GL_UNSIGNED_BYTE, 64, 8);
           }),
      test("read.intensity", "6.1.4, table 6.1",
           "An intensity is read as red; green and blue are 0, alpha is 1.",
           [](Script& s) { image_2d(s, GL_INTENSITY8, GL_LUMINANCE), read(s, 0, GL_RGBA, GL_FLOAT, 64, 8); }),
      test("read.alpha", "6.1.4, table 6.1", "Of a texture of alpha only alpha is read; the color is black.",
           [](Script& s) { image_2d(s, GL_ALPHA8, GL_ALPHA), read(s, 0, GL_RGBA, GL_UNSIGNED_BYTE, 64, 8); }),
      test(
          "read.rgb_as_bgra", "6.1.4", "Texels are read in another order of components.",
          [](Script& s) { image_2d(s, GL_RGB8, GL_RGB), read(s, 0, GL_BGRA, GL_UNSIGNED_BYTE, 64, 8); },
          kVersion12),
      test("read.level", "6.1.4", "Each level is read by its number.",
           [](Script& s) {
             image_2d(s, GL_RGB8, GL_RGB), image_2d(s, GL_RGB8, GL_RGB, 2, 2, 1, 9),
                 read(s, 1, GL_RGB, GL_UNSIGNED_BYTE, 12, 6);
           }),
  };
}

} // namespace softgl::suite
