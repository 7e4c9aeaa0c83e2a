// Texture objects, targets, state that comes back, depth textures, and what follows the texture (3.8.12
// to 3.8.15, 3.9).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

// An object with an image of its own.
void object(Script& s, unsigned name, int seed) {
  s.BindTexture(GL_TEXTURE_2D, name), filters(s, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  image_2d(s, GL_RGB, GL_RGB, 4, 4, 0, seed);
}
void left(Script& s) { textured_sheet(s, {}, -1, -1, -0.02); }
void right(Script& s) { textured_sheet(s, {}, 0.02, -1, 1); }

// All that GL_TEXTURE_BIT saves gets other values.
void spoil(Script& s) {
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR), wrap(s, GL_TEXTURE_2D, GL_CLAMP);
  s.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, V{1, 0, 0, 1}), environment(s, GL_BLEND);
  s.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, V{1, 0, 1, 1}),
      s.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{0, 2, 0, 0}), s.Enable(GL_TEXTURE_GEN_S), s.Disable(GL_TEXTURE_2D);
}

// Depths 0 to 1 in 16 texels, compared with an r that grows along x.
Test depth(const char* name, const char* sentence, GLenum mode, GLenum function, Need need = kVersion14) {
  return texture_test(
      name, "3.8.14", sentence,
      [=](Script& s) {
        replace_scene(s), see_alpha(s), environment(s, GL_MODULATE), wrap(s, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
        Memory depths{GL_FLOAT, {}};
        for (int i = 0; i < 16; i++) depths.elements.push_back((i * 7 % 16 + 0.5) / 16);
        s.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
        s.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, mode);
        if (function != GL_NONE) {
          s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
          s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, function);
        }
        generate_r(s, 0.93, 0), textured_sheet(s);
      },
      need);
}

} // namespace

std::vector<Test> texture_object_tests() {
  return {
      texture_test("object.two", "3.8.12", "Each object has an image of its own.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 1), object(s, 2, 9), s.BindTexture(GL_TEXTURE_2D, 1),
                         left(s);
                     s.BindTexture(GL_TEXTURE_2D, 2), right(s);
                   }),
      texture_test("object.parameters", "3.8.12", "Each object has parameters of its own.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 1), object(s, 2, 1),
                         filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
                     s.BindTexture(GL_TEXTURE_2D, 1), left(s), s.BindTexture(GL_TEXTURE_2D, 2), right(s);
                   }),
      texture_test("object.zero", "3.8.12", "The name 0 is the texture from the start.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 1), left(s), s.BindTexture(GL_TEXTURE_2D, 0), right(s);
                   }),
      texture_test(
          "object.deleted", "3.8.12", "When the bound object is deleted, 0 is bound.",
          [](Script& s) { replace_scene(s), object(s, 3, 5), s.DeleteTextures(1, V{3}), textured_sheet(s); }),
      texture_test("object.deleted_other", "3.8.12", "Deleting an object leaves the bound one.",
                   [](Script& s) {
                     replace_scene(s), object(s, 3, 5), object(s, 4, 6), s.DeleteTextures(2, V{3, 0}),
                         textured_sheet(s);
                   }),
      texture_test("object.new_is_initial", "3.8.12",
                   "A new object has the initial state: without an image it is as if off.",
                   [](Script& s) { replace_scene(s), left(s), s.BindTexture(GL_TEXTURE_2D, 17), right(s); }),
      texture_test("object.name_again", "3.8.12", "A name that was deleted names a new object.",
                   [](Script& s) {
                     replace_scene(s), object(s, 3, 5), s.DeleteTextures(1, V{3}), left(s),
                         s.BindTexture(GL_TEXTURE_2D, 3), right(s);
                   }),
      texture_test("object.targets", "3.8.12", "Each target has a binding of its own.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 1), s.BindTexture(GL_TEXTURE_1D, 2),
                         filters(s, GL_TEXTURE_1D, GL_NEAREST, GL_NEAREST);
                     image_1d(s, 8), left(s), s.Disable(GL_TEXTURE_2D), s.Enable(GL_TEXTURE_1D), right(s);
                   }),
      texture_test("target.two_over_one", "3.8.15", "If 1D and 2D are enabled, 2D is taken.",
                   [](Script& s) {
                     replace_scene(s), filters(s, GL_TEXTURE_1D, GL_NEAREST, GL_NEAREST), image_1d(s, 8),
                         s.Enable(GL_TEXTURE_1D);
                     textured_sheet(s);
                   }),
      texture_test(
          "target.three_over_two", "3.8.15", "If 2D and 3D are enabled, 3D is taken.",
          [](Script& s) {
            replace_scene(s), replace_scene(s, GL_TEXTURE_3D);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 2, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(8, 4, 3));
            s.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR),
                s.TexGenfv(GL_R, GL_OBJECT_PLANE, V{0, 0, 0, 0.3});
            s.Enable(GL_TEXTURE_GEN_R), textured_sheet(s);
          },
          kVersion12),
      texture_test(
          "target.cube_over_all", "3.8.15", "If a cube map is enabled, too, it is taken.",
          [](Script& s) {
            replace_scene(s), replace_scene(s, GL_TEXTURE_CUBE_MAP),
                wrap(s, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
            for (int face = 0; face < 6; face++)
              s.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 2, 2, 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, texel_bytes(4, 4, face));
            s.TexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR),
                s.TexGenfv(GL_R, GL_OBJECT_PLANE, V{0, 0, 0, 0.51});
            s.Enable(GL_TEXTURE_GEN_R), textured_sheet(s);
          },
          kVersion13),

      texture_test("stack.texture_bit", "6.1.14",
                   "GL_TEXTURE_BIT brings back parameters, environment, generation and switches.",
                   [](Script& s) {
                     replace_scene(s), s.PushAttrib(GL_TEXTURE_BIT), spoil(s), s.PopAttrib();
                     textured_sheet(s, {-0.2, -0.2, 1.2, 1.2});
                   }),
      texture_test("stack.binding", "6.1.14", "GL_TEXTURE_BIT brings back which texture is bound.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 4), s.PushAttrib(GL_TEXTURE_BIT), object(s, 2, 7),
                         s.PopAttrib(), textured_sheet(s);
                   }),
      texture_test("stack.images_stay", "6.1.14", "GL_TEXTURE_BIT does not save images.",
                   [](Script& s) {
                     replace_scene(s), s.PushAttrib(GL_TEXTURE_BIT), image_2d(s, GL_RGB, GL_RGB, 2, 2, 0, 9),
                         s.PopAttrib();
                     textured_sheet(s);
                   }),
      texture_test("stack.enable_bit", "6.1.14", "GL_ENABLE_BIT brings back which textures are on.",
                   [](Script& s) {
                     replace_scene(s), s.PushAttrib(GL_ENABLE_BIT), s.Disable(GL_TEXTURE_2D),
                         s.Enable(GL_TEXTURE_GEN_T), s.PopAttrib();
                     textured_sheet(s);
                   }),
      texture_test("stack.current_bit", "6.1.14", "GL_CURRENT_BIT brings back the current coordinates.",
                   [](Script& s) {
                     replace_scene(s), s.TexCoord2f(0.4f, 0.7f), s.PushAttrib(GL_CURRENT_BIT),
                         s.TexCoord2f(0.9f, 0.9f), s.PopAttrib();
                     s.Begin(GL_TRIANGLES), s.Vertex2f(-1, -1), s.Vertex2f(1, -1), s.Vertex2f(0, 1), s.End();
                   }),
      texture_test("list.image", "5.4", "A list holds images.",
                   [](Script& s) {
                     replace_scene(s), s.NewList(7, GL_COMPILE), image_2d(s, GL_RGB, GL_RGB, 2, 4, 0, 8),
                         s.EndList();
                     left(s), s.CallList(7), right(s);
                   }),
      texture_test("list.binding", "5.4", "A list binds textures when it is called.",
                   [](Script& s) {
                     replace_scene(s), object(s, 1, 1), object(s, 2, 9), s.NewList(7, GL_COMPILE),
                         s.BindTexture(GL_TEXTURE_2D, 1);
                     s.EndList(), left(s), s.CallList(7), right(s);
                   }),
      texture_test("list.parameters", "5.4", "A list holds parameters and environments.",
                   [](Script& s) {
                     replace_scene(s), s.NewList(7, GL_COMPILE),
                         filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
                     environment(s, GL_MODULATE), s.EndList(), left(s), s.CallList(7), right(s);
                   }),
      texture_test("list.coordinates", "5.4", "A list holds coordinates between vertices.",
                   [](Script& s) {
                     replace_scene(s), s.NewList(7, GL_COMPILE), textured_sheet(s), s.EndList(),
                         s.CallList(7);
                   }),

      depth("depth.luminance", "A depth is a luminance.", GL_LUMINANCE, GL_NONE),
      depth("depth.intensity", "GL_DEPTH_TEXTURE_MODE makes of a depth an intensity.", GL_INTENSITY, GL_NONE),
      depth("depth.alpha", "GL_DEPTH_TEXTURE_MODE makes of a depth an alpha.", GL_ALPHA, GL_NONE),
      depth("depth.lequal", "GL_LEQUAL gives 1 where r is not greater than the depth.", GL_LUMINANCE,
            GL_LEQUAL),
      depth("depth.gequal", "GL_GEQUAL gives 1 where r is not less than the depth.", GL_LUMINANCE, GL_GEQUAL),
      depth("depth.compared_alpha", "The result of a comparison follows the depth texture mode.", GL_ALPHA,
            GL_LEQUAL),
      depth("depth.compared_intensity", "The result of a comparison follows the depth texture mode.",
            GL_INTENSITY, GL_GEQUAL),
      depth("depth.less", "GL_LESS gives 1 where r is less than the depth.", GL_LUMINANCE, GL_LESS,
            kVersion15),
      depth("depth.greater", "GL_GREATER gives 1 where r is greater than the depth.", GL_LUMINANCE,
            GL_GREATER, kVersion15),

      texture_test("after.fog", "3.10", "Fog comes after the texture.",
                   [](Script& s) {
                     replace_scene(s), s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 0.0),
                         s.Fogf(GL_FOG_END, 10.0);
                     s.Fogfv(GL_FOG_COLOR, V{0.2, 0.9, 0.4, 1}), s.Enable(GL_FOG), textured_sheet(s);
                   }),
      texture_test("after.alpha_test", "4.1.4", "The alpha test looks at the alpha of the texture.",
                   [](Script& s) {
                     replace_scene(s), s.AlphaFunc(GL_GREATER, 0.5), s.Enable(GL_ALPHA_TEST),
                         textured_sheet(s);
                   }),
      texture_test(
          "after.separate_specular", "3.9", "The secondary color is added after the texture.",
          [](Script& s) {
            replace_scene(s), environment(s, GL_MODULATE),
                s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
            s.Lightfv(GL_LIGHT0, GL_POSITION, V{0, 0, 1, 0}),
                s.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, V{0.4, 0.3, 0, 1});
            s.Enable(GL_LIGHT0), s.Enable(GL_LIGHTING), s.Normal3f(0, 0, 1), textured_sheet(s);
          },
          kSeparateSpecular),
      texture_test("after.lighting", "2.14.1, 3.8.13", "GL_MODULATE multiplies the lit color.",
                   [](Script& s) {
                     replace_scene(s), environment(s, GL_MODULATE),
                         s.Lightfv(GL_LIGHT0, GL_POSITION, V{0, 0.6, 0.8, 0});
                     s.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, V{0.9, 0.7, 0.5, 1}), s.Enable(GL_LIGHT0),
                         s.Enable(GL_LIGHTING);
                     s.Normal3f(0, 0, 1), textured_sheet(s);
                   }),
      texture_test("after.replace_hides_light", "3.8.13", "GL_REPLACE leaves nothing of the lit color.",
                   [](Script& s) {
                     replace_scene(s), image_2d(s, GL_RGB, GL_RGB), s.Enable(GL_LIGHTING), textured_sheet(s);
                   }),
  };
}

} // namespace softgl::suite
