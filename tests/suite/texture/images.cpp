// Texture images: internal formats, the client's formats, dimensions, borders (3.8.1).
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

// An internal format is seen in color and alpha.
Test internal(const char* name, GLenum format, const char* sentence, const char* open = "") {
  return {std::string("texture.format.") + name, "3.8.1, tables 3.15 and 3.16", sentence, open,
          [format](Script& s) {
            replace_scene(s), see_alpha(s), environment(s, GL_MODULATE), s.Color4f(1, 0.9, 0.8, 0.9);
            image_2d(s, format), textured_sheet(s);
          }};
}

// What the client's memory holds, in a texture of RGBA.
Test source(const char* name, GLenum format, const char* sentence, Need need = {}) {
  return {std::string("texture.source.") + name,
          "3.6.4, 3.8.1",
          sentence,
          "",
          [format](Script& s) {
            replace_scene(s), see_alpha(s), image_2d(s, GL_RGBA, format), textured_sheet(s);
          },
          need};
}

const char* const kBits = "how many bits a component has: as close as possible to what is asked for";

// A sheet for each face of a cube map.
void faces(Script& s, float extent) {
  for (int i = 0; i < 6; i++) {
    const double left = -1 + 0.7 * (i % 3), bottom = i < 3 ? -1 : 0.05;
    s.Begin(GL_TRIANGLES);
    for (int corner : {0, 1, 3, 0, 3, 2}) {
      const float a = corner & 1 ? extent : -extent, b = corner & 2 ? extent : -extent,
                  major = i % 2 ? -1 : 1;
      if (i / 2 == 0) s.TexCoord3f(major, b, a);
      if (i / 2 == 1) s.TexCoord3f(a, major, b);
      if (i / 2 == 2) s.TexCoord3f(a, b, major);
      s.Vertex3f(float(left + (corner & 1 ? 0.6 : 0)), float(bottom + (corner & 2 ? 0.9 : 0)), 0);
    }
    s.End();
  }
}

} // namespace

std::vector<Test> texture_image_tests() {
  return {
      internal("alpha", GL_ALPHA, "GL_ALPHA keeps the alpha component, and the color of the fragment."),
      internal("luminance", GL_LUMINANCE, "GL_LUMINANCE is the red component, as red, green and blue."),
      internal("luminance_alpha", GL_LUMINANCE_ALPHA,
               "GL_LUMINANCE_ALPHA is the red component and the alpha."),
      internal("intensity", GL_INTENSITY, "GL_INTENSITY is the red component, as color and as alpha."),
      internal("rgb", GL_RGB, "GL_RGB has no alpha: that of the fragment stays."),
      internal("rgba", GL_RGBA, "GL_RGBA keeps all components."),
      internal("1", 1, "The internal format 1 is GL_LUMINANCE."),
      internal("2", 2, "The internal format 2 is GL_LUMINANCE_ALPHA."),
      internal("3", 3, "The internal format 3 is GL_RGB."),
      internal("4", 4, "The internal format 4 is GL_RGBA."),
      internal("alpha8", GL_ALPHA8, "GL_ALPHA8 is GL_ALPHA of 8 bits."),
      internal("alpha4", GL_ALPHA4, "GL_ALPHA4 is GL_ALPHA of 4 bits.", kBits),
      internal("luminance8", GL_LUMINANCE8, "GL_LUMINANCE8 is GL_LUMINANCE of 8 bits."),
      internal("luminance8_alpha8", GL_LUMINANCE8_ALPHA8,
               "GL_LUMINANCE8_ALPHA8 is GL_LUMINANCE_ALPHA of 8 bits each."),
      internal("luminance6_alpha2", GL_LUMINANCE6_ALPHA2, "GL_LUMINANCE6_ALPHA2 is GL_LUMINANCE_ALPHA.",
               kBits),
      internal("intensity8", GL_INTENSITY8, "GL_INTENSITY8 is GL_INTENSITY of 8 bits."),
      internal("r3_g3_b2", GL_R3_G3_B2, "GL_R3_G3_B2 is GL_RGB.", kBits),
      internal("rgb5", GL_RGB5, "GL_RGB5 is GL_RGB of 5 bits each.", kBits),
      internal("rgb8", GL_RGB8, "GL_RGB8 is GL_RGB of 8 bits each."),
      internal("rgba4", GL_RGBA4, "GL_RGBA4 is GL_RGBA of 4 bits each.", kBits),
      internal("rgb5_a1", GL_RGB5_A1, "GL_RGB5_A1 is GL_RGBA.", kBits),
      internal("rgba8", GL_RGBA8, "GL_RGBA8 is GL_RGBA of 8 bits each."),
      internal("rgb10_a2", GL_RGB10_A2, "GL_RGB10_A2 is GL_RGBA.", kBits),
      internal("rgba16", GL_RGBA16, "GL_RGBA16 is GL_RGBA of 16 bits each."),

      source("red", GL_RED, "GL_RED gives red; green and blue are 0, alpha is 1."),
      source("green", GL_GREEN, "GL_GREEN gives green; red and blue are 0, alpha is 1."),
      source("blue", GL_BLUE, "GL_BLUE gives blue; red and green are 0, alpha is 1."),
      source("alpha", GL_ALPHA, "GL_ALPHA gives alpha; the color is black."),
      source("luminance", GL_LUMINANCE, "A luminance is red, green and blue; alpha is 1."),
      source("luminance_alpha", GL_LUMINANCE_ALPHA,
             "A luminance is red, green and blue, and alpha comes behind it."),
      source("rgb", GL_RGB, "GL_RGB gives red, green and blue; alpha is 1."),
      source("bgr", GL_BGR, "GL_BGR gives blue, green and red.", kVersion12),
      source("bgra", GL_BGRA, "GL_BGRA gives blue, green, red and alpha.", kVersion12),
      texture_test("source.color_index", "3.6.5, 3.8.1",
                   "Color indexes become texels through the maps from I to R, G, B and A.",
                   [](Script& s) {
                     replace_scene(s), see_alpha(s);
                     s.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 4, V{0, 0.4, 0.8, 1});
                     s.PixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, V{1, 0.2});
                     s.PixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, V{0.6, 0, 1, 0.2});
                     s.PixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, V{1, 0.6});
                     image_2d(s, GL_RGBA, GL_COLOR_INDEX), textured_sheet(s);
                   }),
      texture_test(
          "source.bitmap", "3.6.4, 3.8.1", "The color indexes of a texture may be the bits of a bitmap.",
          [](Script& s) {
            replace_scene(s), s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
            s.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, V{0.2, 1}),
                s.PixelMapfv(GL_PIXEL_MAP_I_TO_G, 2, V{0.9, 0.4});
            s.PixelMapfv(GL_PIXEL_MAP_I_TO_B, 2, V{0.3, 0}), s.PixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, V{1, 1});
            s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 4, 0, GL_COLOR_INDEX, GL_BITMAP,
                         Memory{GL_UNSIGNED_BYTE, {0xd1, 0x3a, 0x07, 0xc4}});
            textured_sheet(s);
          }),
      texture_test("source.transfer", "3.6.5, 3.8.1",
                   "Texels go through the scales and biases of pixel transfer.",
                   [](Script& s) {
                     replace_scene(s), see_alpha(s);
                     s.PixelTransferf(GL_RED_SCALE, 0.5), s.PixelTransferf(GL_GREEN_BIAS, 0.25);
                     s.PixelTransferf(GL_BLUE_SCALE, -1.0), s.PixelTransferf(GL_BLUE_BIAS, 1.0);
                     s.PixelTransferf(GL_ALPHA_SCALE, 2.0), image_2d(s);
                     s.PixelTransferf(GL_RED_SCALE, 1.0), s.PixelTransferf(GL_GREEN_BIAS, 0.0);
                     s.PixelTransferf(GL_BLUE_SCALE, 1.0), s.PixelTransferf(GL_BLUE_BIAS, 0.0);
                     s.PixelTransferf(GL_ALPHA_SCALE, 1.0), textured_sheet(s);
                   }),
      texture_test("source.row_length", "3.6.4",
                   "Rows and pixels are skipped, and rows have GL_UNPACK_ROW_LENGTH pixels.",
                   [](Script& s) {
                     replace_scene(s), s.PixelStorei(GL_UNPACK_ROW_LENGTH, 7),
                         s.PixelStorei(GL_UNPACK_SKIP_ROWS, 2), s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
                     s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_UNSIGNED_BYTE,
                                  texel_bytes(42, 3));
                     textured_sheet(s);
                   }),
      texture_test(
          "source.skip_images", "3.6.4, 3.8.1",
          "Images of three dimensions are skipped, and are so many rows high.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_3D);
            s.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5), s.PixelStorei(GL_UNPACK_SKIP_IMAGES, 1);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(60, 4));
            generate_r(s, 0.9, 0), textured_sheet(s);
          },
          kVersion12),
      texture_test("image.clamped", "3.8.1", "Components are clamped to [0, 1].",
                   [](Script& s) {
                     replace_scene(s);
                     s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_FLOAT,
                                  Memory{GL_FLOAT, {-1, 0.5, 2, 1.5, -0.25, 0.75, 0.25, 3, -9, 1, 0, 0.5}});
                     textured_sheet(s);
                   }),
      texture_test(
          "image.rows_from_below", "3.8.1", "The first texel is at the coordinates (0, 0): rows go up.",
          [](Script& s) { replace_scene(s), image_2d(s, GL_RGBA, GL_RGBA, 8, 2), textured_sheet(s); }),
      texture_test(
          "image.narrow", "3.8.1", "Width and height may differ.",
          [](Script& s) { replace_scene(s), image_2d(s, GL_RGBA, GL_RGBA, 1, 8), textured_sheet(s); }),
      texture_test("image.replaced", "3.8.1", "A new image takes the place of the one before.",
                   [](Script& s) {
                     replace_scene(s), textured_sheet(s, {}, -1, -1, 0);
                     image_2d(s, GL_RGB, GL_RGB, 2, 8, 0, 3), textured_sheet(s, {}, 0.02, -1, 1);
                   }),
      texture_test("image.one_dimension", "3.8.1", "A 1D image varies along s.",
                   [](Script& s) { replace_scene(s, GL_TEXTURE_1D), image_1d(s, 16), textured_sheet(s); }),
      texture_test(
          "image.three_dimensions", "3.8.1", "A 3D image varies along s, t and r.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_3D), generate_r(s, 0, 0.9);
            s.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                         texel_bytes(128, 4));
            textured_sheet(s);
          },
          kVersion12),
      texture_test(
          "image.cube", "3.8.6, table 3.19", "The largest of s, t and r chooses the face of a cube map.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_CUBE_MAP), wrap(s, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
            for (int face = 0; face < 6; face++)
              s.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 2, 2, 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, texel_bytes(4, 4, face));
            faces(s, 0.8f);
          },
          kVersion13),
      texture_test(
          "image.cube_edges", "3.8.6, table 3.19", "Beyond the edge of a face the next face begins.",
          [](Script& s) {
            replace_scene(s, GL_TEXTURE_CUBE_MAP), wrap(s, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
            for (int face = 0; face < 6; face++)
              s.TexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 1, 1, 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, texel_bytes(1, 4, face));
            faces(s, 1.7f);
          },
          kVersion13),
      texture_test(
          "image.border_texels", "3.8.1, 3.8.8", "The texels of an image's border are filtered at its edges.",
          [](Script& s) {
            replace_scene(s), filters(s, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR),
                wrap(s, GL_TEXTURE_2D, GL_CLAMP);
            s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel_bytes(36, 4));
            textured_sheet(s, {-0.2, -0.2, 1.2, 1.2});
          }),
      texture_test("image.border_inside", "3.8.1",
                   "An image with a border has its first texel inside at the coordinate 0.",
                   [](Script& s) {
                     replace_scene(s), wrap(s, GL_TEXTURE_2D, GL_CLAMP);
                     s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                  texel_bytes(36, 4));
                     textured_sheet(s);
                   }),
  };
}

} // namespace softgl::suite
