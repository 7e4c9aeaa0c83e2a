// Errors of texture commands: each is raised, and the state stays (2.5, 3.8).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

// The call raises the error, and the texture of before is drawn.
Test error(const char* name, const char* section, const char* sentence, GLenum raised,
           std::function<void(Script&)> call, Need need = {}) {
  return texture_test(
      name, section, sentence,
      [=](Script& s) {
        replace_scene(s), s.Raises(raised), call(s), s.PaintError(0, 0), s.PaintError(0, 10);
        textured_sheet(s, {-0.1, -0.1, 1.1, 1.1});
      },
      need);
}

const GLenum kEnum = GL_INVALID_ENUM, kValue = GL_INVALID_VALUE, kOperation = GL_INVALID_OPERATION;
const Memory kTexels = texel_bytes(64, 4, 3);

} // namespace

std::vector<Test> texture_error_tests() {
  return {
      error("error.level", "3.8.1", "A negative level is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.TexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.level_too_large", "3.8.1", "A level beyond the largest image is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.TexImage2D(GL_TEXTURE_2D, 60, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.width", "3.8.1", "A negative width is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, -4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.border", "3.8.1", "A border other than 0 or 1 is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 2, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error(
          "error.internal_format", "3.8.1", "An unknown internal format is GL_INVALID_VALUE.", kValue,
          [](Script& s) { s.TexImage2D(GL_TEXTURE_2D, 0, 5, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels); }),
      error("error.format", "3.6.4", "An unknown format is GL_INVALID_ENUM.", kEnum,
            [](Script& s) {
              s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_LINEAR, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.type", "3.6.4", "An unknown type is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_LINEAR, kTexels); }),
      error(
          "error.packed_type", "3.6.4",
          "A packed type of another number of components is GL_INVALID_OPERATION.", kOperation,
          [](Script& s) {
            s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, kTexels);
          },
          kVersion12),
      error("error.target", "3.8.1", "The target of another dimension is GL_INVALID_ENUM.", kEnum,
            [](Script& s) {
              s.TexImage1D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.part_outside", "3.8.2", "A part that reaches out of the image is GL_INVALID_VALUE.",
            kValue,
            [](Script& s) {
              s.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 2, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.part_before", "3.8.2", "A part that begins before the image is GL_INVALID_VALUE.", kValue,
            [](Script& s) {
              s.TexSubImage2D(GL_TEXTURE_2D, 0, -1, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.part_without_image", "3.8.2",
            "A part of a level without an image is GL_INVALID_OPERATION.", kOperation,
            [](Script& s) {
              s.TexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
            }),
      error("error.copy_level", "3.8.2", "A negative level of a copy is GL_INVALID_VALUE.", kValue,
            [](Script& s) { s.CopyTexImage2D(GL_TEXTURE_2D, -1, GL_RGBA, 0, 0, 4, 4, 0); }),
      error("error.copy_format", "3.8.2", "1, 2, 3 and 4 are no internal formats of a copy.", kEnum,
            [](Script& s) { s.CopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 4, 4, 0); }),
      error("error.copy_outside", "3.8.2", "A copy to texels outside of the image is GL_INVALID_VALUE.",
            kValue, [](Script& s) { s.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 0, 2, 2); }),
      error("error.parameter", "3.8.4", "An unknown parameter is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_LINEAR); }),
      error(
          "error.filter", "3.8.4", "A magnification filter with mipmaps is GL_INVALID_ENUM.", kEnum,
          [](Script& s) { s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR); }),
      error("error.wrap", "3.8.4", "An unknown wrap mode is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR); }),
      error(
          "error.base_level", "3.8.4", "A negative base level is GL_INVALID_VALUE.", kValue,
          [](Script& s) { s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1); }, kVersion12),
      error("error.environment", "3.8.13", "An unknown environment is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LINEAR); }),
      error(
          "error.scale", "3.8.13", "A scale other than 1, 2 and 4 is GL_INVALID_VALUE.", kValue,
          [](Script& s) { s.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3.0); }, kVersion13),
      error("error.generation", "2.11.4", "GL_SPHERE_MAP for r is GL_INVALID_ENUM.", kEnum,
            [](Script& s) { s.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP); }),
      error(
          "error.reflection_of_q", "2.11.4", "GL_REFLECTION_MAP for q is GL_INVALID_ENUM.", kEnum,
          [](Script& s) { s.TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP); }, kVersion13),
      error("error.bound_to_other_target", "3.8.12",
            "An object of another target cannot be bound: GL_INVALID_OPERATION.", kOperation,
            [](Script& s) {
              s.calls.pop_back(); // what raises comes last
              s.BindTexture(GL_TEXTURE_1D, 6), s.Raises(kOperation), s.BindTexture(GL_TEXTURE_2D, 6);
            }),
      error(
          "error.unit", "2.7", "A unit that is not there is GL_INVALID_ENUM.", kEnum,
          [](Script& s) { s.ActiveTexture(GL_TEXTURE0 + 1000); }, kMultitexture),
      texture_test("error.inside_begin", "2.6.3",
                   "Texture commands between glBegin and glEnd are GL_INVALID_OPERATION.",
                   [](Script& s) {
                     replace_scene(s), s.Begin(GL_TRIANGLES), s.Raises(kOperation);
                     s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                  texel_bytes(4, 4, 6));
                     s.Raises(kOperation), s.BindTexture(GL_TEXTURE_2D, 4), s.Raises(kOperation),
                         s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
                     s.End(), s.PaintError(0, 0), textured_sheet(s);
                   }),
      texture_test(
          "error.image_in_wrong_level_of_cube", "3.8.1",
          "A face of a cube map that is not square is GL_INVALID_VALUE.",
          [](Script& s) {
            replace_scene(s), s.Raises(kValue);
            s.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         kTexels);
            s.PaintError(0, 0), textured_sheet(s);
          },
          kVersion13),
  };
}

} // namespace softgl::suite
