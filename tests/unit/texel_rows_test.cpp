// TexelRows: where it looks texels up or takes bytes, they are what each pixel gives by itself.
#include <catch2/catch.hpp>

#include <vector>

#include "support/random.h"
#include "texture/pixel_formats.h"
#include "texture/pixel_transfer.h"
#include "texture/texel_format.h"

using namespace softgl;

namespace {

constexpr int kPixels = 5000; // worth a table

void check(const PixelTransfer& transfer) {
  softgl::test::Random random(7);
  std::vector<unsigned char> pixels(kPixels * 4);
  for (unsigned char& b : pixels) b = static_cast<unsigned char>(random.bits());
  std::vector<uint64_t> rows(kPixels), single(kPixels); // a texel has 4 or 8 bytes
  for (GLint internal : {GL_ALPHA8,
                         GL_ALPHA4,
                         GL_LUMINANCE8,
                         GL_LUMINANCE4,
                         GL_LUMINANCE16,
                         GL_LUMINANCE,
                         GL_LUMINANCE8_ALPHA8,
                         GL_LUMINANCE6_ALPHA2,
                         GL_INTENSITY8,
                         GL_INTENSITY4,
                         GL_RGB8,
                         GL_R3_G3_B2,
                         GL_RGB5,
                         GL_RGBA8,
                         GL_RGBA4,
                         GL_RGB5_A1,
                         GL_RGB10_A2,
                         GL_RGBA,
                         GL_R8,
                         GL_RG8,
                         GL_SRGB8_ALPHA8,
                         GL_SLUMINANCE8,
                         GL_RGBA8_SNORM})
    for (GLenum format : {GL_LUMINANCE, GL_ALPHA, GL_RED, GL_GREEN, GL_BLUE, GL_LUMINANCE_ALPHA, GL_RG,
                          GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_ABGR_EXT}) {
      INFO("internal format " << std::hex << internal << ", format " << format);
      const PixelFormat from = describe_pixel_format(format, GL_UNSIGNED_BYTE);
      const TexelFormat& to = *choose_texel_format(internal, format, GL_UNSIGNED_BYTE, false);
      TexelRows(to, from, false, transfer, kPixels).store(rows.data(), pixels.data(), kPixels);
      store_texels(to, single.data(), from, pixels.data(), kPixels, false, transfer);
      CHECK(rows == single);
    }
}

} // namespace

TEST_CASE("looked up texels are those that are computed", "[texture]") {
  PixelModeState mode;
  PixelMaps maps;
  SECTION("as they are") { check({mode, maps}); }
  SECTION("scaled and moved") {
    mode.scale = {0.5f, -1.5f, 2, 0.7f};
    mode.bias = {0.2f, 0.9f, -0.3f, 0.1f};
    check({mode, maps});
  }
  SECTION("mapped") {
    mode.map_color = true;
    for (int map = 0; map < 10; ++map) {
      maps.size[map] = 16;
      for (int i = 0; i < 16; ++i) maps.value[map][i] = float((i * 7 + map) % 16) / 15;
    }
    check({mode, maps});
  }
}
