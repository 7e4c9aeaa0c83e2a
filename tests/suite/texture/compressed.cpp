// Compressed images (3.8.3) of the blocks of GL_EXT_texture_compression_s3tc.
#include "texture/chapter.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kS3tc{kNoVersion, "GL_EXT_texture_compression_s3tc"};
const char* const kRounding = "how the components of a block are rounded";

// Blocks of colors; in the first one color 0 is the greater, in the second color 1.
const V kFour = {0x08, 0xfc, 0x1f, 0x04, 0xe4, 0x1b, 0xb1, 0x4e},
        kThree = {0x1f, 0x04, 0x08, 0xfc, 0xe4, 0x1b, 0xb1, 0x4e};
// Blocks of alphas: 4 bits each; 3 bits each between two alphas, the first of which is the greater or not.
const V kAlphas4 = {0x10, 0x32, 0x54, 0x76, 0x98, 0xba, 0xdc, 0xfe},
        kAlphas8 = {240, 40, 0x88, 0xc6, 0xfa, 0x77, 0x39, 0x05},
        kAlphas6 = {40, 240, 0x88, 0xc6, 0xfa, 0x77, 0x39, 0x05};

Memory blocks(std::initializer_list<V> parts) {
  Memory m{GL_UNSIGNED_BYTE, {}};
  for (const V& part : parts) m.elements.insert(m.elements.end(), part.begin(), part.end());
  return m;
}

// An image of two blocks beside each other.
Test two_blocks(const char* name, GLenum format, const char* sentence, const Memory& memory) {
  return texture_test(
      name, "3.8.3, GL_EXT_texture_compression_s3tc", sentence,
      [=](Script& s) {
        replace_scene(s), see_alpha(s);
        s.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, 8, 4, 0, int(memory.elements.size()), memory);
        textured_sheet(s);
      },
      kS3tc, kRounding);
}

} // namespace

std::vector<Test> texture_compressed_tests() {
  return {
      two_blocks("compressed.rgb_dxt1", GL_COMPRESSED_RGB_S3TC_DXT1_EXT,
                 "A block of DXT1 has four colors if color 0 is greater than color 1, else three and black.",
                 blocks({kFour, kThree})),
      two_blocks("compressed.rgba_dxt1", GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                 "The black of a block of three colors is transparent if the format has alpha.",
                 blocks({kThree, kFour})),
      two_blocks("compressed.rgba_dxt3", GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                 "A block of DXT3 has alphas of four bits, and always four colors.",
                 blocks({kAlphas4, kFour, kAlphas4, kThree})),
      two_blocks(
          "compressed.rgba_dxt5", GL_COMPRESSED_RGBA_S3TC_DXT5_EXT,
          "A block of DXT5 has six alphas between two if alpha 0 is the greater one, else four, 0 and 1.",
          blocks({kAlphas8, kFour, kAlphas6, kThree})),
      texture_test(
          "compressed.part", "3.8.3, GL_EXT_texture_compression_s3tc",
          "A part of whole blocks replaces those blocks.",
          [](Script& s) {
            replace_scene(s), see_alpha(s);
            s.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8, 8, 0, 32,
                                   blocks({kFour, kFour, kFour, kFour}));
            s.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8,
                                      blocks({kThree}));
            textured_sheet(s);
          },
          kS3tc, kRounding),
      texture_test(
          "compressed.small", "3.8.3, GL_EXT_texture_compression_s3tc",
          "An image of less than four texels takes the first ones of its block.",
          [](Script& s) {
            replace_scene(s), s.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 2, 1,
                                                     0, 8, blocks({kFour}));
            textured_sheet(s);
          },
          kS3tc, kRounding),
      texture_test(
          "compressed.errors", "3.8.3, GL_EXT_texture_compression_s3tc",
          "Sizes of memory that are not those of the blocks, and parts that are no blocks, are errors.",
          [](Script& s) {
            const GLenum dxt1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT;
            replace_scene(s),
                s.CompressedTexImage2D(GL_TEXTURE_2D, 0, dxt1, 8, 4, 0, 16, blocks({kFour, kThree}));
            s.CompressedTexImage2D(GL_TEXTURE_2D, 0, dxt1, 4, 4, 0, 16, blocks({kFour, kThree})),
                s.raises(GL_INVALID_VALUE);
            s.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 2, 0, 4, 4, dxt1, 8, blocks({kThree})),
                s.raises(GL_INVALID_OPERATION);
            s.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, dxt1, 16, blocks({kThree, kFour})),
                s.raises(GL_INVALID_VALUE);
            textured_sheet(s);
          },
          kS3tc, kRounding),
  };
}

} // namespace softgl::suite
