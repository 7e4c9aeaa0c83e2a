// Compressed textures (GL 1.5, 3.8.3; GL_EXT_texture_compression_s3tc, GL_ARB_texture_compression_rgtc):
// errors as OSMesa gives them, what queries answer, and images that softgl compresses itself.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

constexpr GLenum kRgb1 = GL_COMPRESSED_RGB_S3TC_DXT1_EXT, kRgba1 = GL_COMPRESSED_RGBA_S3TC_DXT1_EXT,
                 kRgba3 = GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, kRgba5 = GL_COMPRESSED_RGBA_S3TC_DXT5_EXT;
constexpr GLenum kFormats[] = {kRgb1, kRgba1, kRgba3, kRgba5};
const GLubyte kBytes[1024] = {};

GLsizei size_in_blocks(GLenum format, int width) {
  const bool eight = format == kRgb1 || format == kRgba1 || format == GL_COMPRESSED_SRGB_S3TC_DXT1_EXT ||
                     format == GL_COMPRESSED_RED_RGTC1 || format == GL_COMPRESSED_LUMINANCE_LATC1_EXT;
  if (format == GL_COMPRESSED_RGB_FXT1_3DFX || format == GL_COMPRESSED_RGBA_FXT1_3DFX) return width / 8 * 16;
  return width / 4 * (eight ? 8 : 16);
}

std::vector<GLubyte> texels(const Gl& gl, int level, int width, int height) {
  std::vector<GLubyte> rgba(size_t(width) * size_t(height) * 4);
  gl.GetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

} // namespace

REFUSAL_TEST_CASE("Compressed images are refused as OSMesa refuses them",
                  "[spec][errors][textures][compressed]") {
  // clang-format off
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgb1, 16, 16, 0, 127, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgb1, -16, 16, 0, 128, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgb1, 0, 0, 0, -1, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, -1, kRgb1, 16, 16, 0, 128, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 20, kRgb1, 16, 16, 0, 128, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgb1, 1 << 20, 16, 0, 1 << 23, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, kRgb1, 16, 8, 0, 64, kBytes)),
      BAD(INVALID_VALUE, CompressedTexImage2D(GL_PROXY_TEXTURE_2D, 0, kRgba5, 8, 8, 0, 63, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgb1, 16, 16, 1, 128, kBytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, 128, kBytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_RECTANGLE, 0, kRgb1, 16, 16, 0, 128, kBytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_3D, 0, kRgb1, 16, 16, 0, 128, kBytes)),
      BAD(INVALID_ENUM, CompressedTexImage1D(GL_TEXTURE_1D, 0, kRgb1, 16, 0, 32, kBytes)),
      BAD(INVALID_ENUM, CompressedTexImage3D(GL_TEXTURE_3D, 0, kRgb1, 16, 16, 1, 0, 128, kBytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage1D(GL_TEXTURE_1D, 0, 0, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 12, 8, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, kRgba5, 15, kBytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, -4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, -4, 4, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, -1, 0, 0, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 3, 0, 0, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 2, 4, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 2, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, kRgba3, 16, kBytes)),
      BAD(INVALID_OPERATION, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, 16, kBytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage2D(GL_PROXY_TEXTURE_2D, 0, 0, 0, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_ENUM, CompressedTexSubImage2D(GL_TEXTURE_RECTANGLE, 0, 0, 0, 4, 4, kRgba5, 16, kBytes)),
      BAD(INVALID_OPERATION, TexSubImage2D(GL_TEXTURE_2D, 0, 3, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_OPERATION, TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 3, 4, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_OPERATION, CopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 4, 0, 0, 4, 4)),
      BAD(INVALID_OPERATION, CopyTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 0, 0, 4, 3)),
      BAD(INVALID_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 1, kRgb1, 0, 0, 6, 6, 1)),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, kRgb1, 6, 6, 1, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, kRgb1, 4, 4, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_ENUM, TexImage1D(GL_TEXTURE_1D, 0, kRgb1, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_ENUM, TexImage3D(GL_TEXTURE_3D, 0, kRgb1, 4, 4, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_ENUM, TexImage2D(GL_TEXTURE_RECTANGLE, 0, kRgb1, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes)),
      BAD(INVALID_ENUM, CopyTexImage1D(GL_TEXTURE_1D, 0, kRgb1, 0, 0, 4, 0)),
      // The last one is INVALID_OPERATION in OSMesa (reference/DEVIATIONS.md).
      BAD(INVALID_ENUM, CompressedTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 1, kRgba5, 16, kBytes)),
  };
  // clang-format on
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    std::vector<GLubyte> blocks(4 * 3 * 16, 0x3c);
    gl->CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgba5, 14, 10, 0, GLsizei(blocks.size()), blocks.data());
    CHECK(gl->GetError() == GL_NO_ERROR);
    const std::vector<GLubyte> before = texels(*gl, 0, 14, 10);
    const bool ours = gl == &softgl_library();
    expect_refused(*gl, std::span(calls).first(std::size(calls) - (ours ? 0 : 1)), [&] {
      GLint size = 0;
      gl->GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
      CHECK(size == 192);
    });
    CHECK(texels(*gl, 0, 14, 10) == before);
    // What lies at the edges need not be whole blocks.
    gl->CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 12, 8, 2, 2, kRgba5, 16, kBytes);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 12, 8, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
    gl->CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 0, 4, kRgba5, 0, kBytes);
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
}

TEST_CASE("Queries tell of compressed images what OSMesa tells", "[spec][textures][compressed]") {
  for (const GLenum format :
       {kRgb1, kRgba1, kRgba3, kRgba5, GLenum(GL_COMPRESSED_SRGB_S3TC_DXT1_EXT),
        GLenum(GL_COMPRESSED_RED_RGTC1), GLenum(GL_COMPRESSED_SIGNED_RG_RGTC2),
        GLenum(GL_COMPRESSED_LUMINANCE_LATC1_EXT), GLenum(GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT),
        GLenum(GL_COMPRESSED_RGB_FXT1_3DFX), GLenum(GL_COMPRESSED_RGBA_FXT1_3DFX)}) {
    std::vector<GLint> answers[2];
    for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
      CurrentContext context(*gl);
      std::vector<GLint>& all = answers[gl == &osmesa_library()];
      for (const GLenum target : {GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D}) {
        gl->TexImage2D(target, 0, GLint(format), 9, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
        for (const GLenum name :
             {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_COMPRESSED,
              GL_TEXTURE_COMPRESSED_IMAGE_SIZE, GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE,
              GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_RED_TYPE,
              GL_TEXTURE_LUMINANCE_TYPE_ARB}) {
          GLint value = -1;
          gl->GetTexLevelParameteriv(target, 0, name, &value);
          all.push_back(value);
          all.push_back(GLint(gl->GetError()));
        }
      }
      gl->CompressedTexImage2D(GL_PROXY_TEXTURE_2D, 0, format, 1 << 16, 4, 0, size_in_blocks(format, 1 << 16),
                               nullptr);
      GLint width = -1;
      gl->GetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
      all.push_back(width);
      all.push_back(GLint(gl->GetError()));
    }
    INFO("format " << format);
    CHECK(answers[0] == answers[1]);
  }
}

TEST_CASE("Lists and buffer objects hold compressed images", "[spec][textures][compressed][list]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  std::vector<GLubyte> blocks(4 * 4 * 16), back(blocks.size());
  for (size_t i = 0; i < blocks.size(); ++i) blocks[i] = GLubyte(i * 37);
  const std::vector<GLubyte> kept = blocks;
  gl.NewList(1, GL_COMPILE);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgba3, 16, 16, 0, GLsizei(blocks.size()), blocks.data());
  gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 12, 12, 4, 4, kRgba3, 16, blocks.data());
  gl.EndList();
  std::fill(blocks.begin(), blocks.end(), GLubyte(0));
  gl.CallList(1);
  gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
  CHECK(std::equal(kept.begin(), kept.end() - 16, back.begin()));
  CHECK(std::equal(kept.begin(), kept.begin() + 16, back.end() - 16));

  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  gl.BufferData(GL_PIXEL_UNPACK_BUFFER, GLsizeiptr(kept.size()), kept.data(), GL_STATIC_DRAW);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgba5, 16, 16, 0, GLsizei(kept.size()), nullptr);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgba5, 16, 16, 0, GLsizei(kept.size()),
                          reinterpret_cast<const void*>(1));
  CHECK(gl.GetError() == GL_INVALID_OPERATION); // more than the buffer holds
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, nullptr);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, reinterpret_cast<void*>(16));
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
  CHECK(back == kept);
}

TEST_CASE("Images that are compressed here come near to what was given",
          "[spec][textures][compressed][deviation]") {
  // A ramp in each component, and an alpha that is whole, none, or between.
  constexpr int kSize = 16;
  std::vector<GLubyte> image(kSize * kSize * 4);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      GLubyte* p = &image[size_t(y * kSize + x) * 4];
      p[0] = GLubyte(x * 16), p[1] = GLubyte(100 + x * 4), p[2] = GLubyte(255 - x * 8);
      p[3] = GLubyte(y < 4 ? 255 : y < 8 ? (x & 1) * 255 : x * 17);
    }
  const Gl& gl = softgl_library();
  for (const GLenum format : kFormats) {
    INFO("format " << format);
    CurrentContext context(gl);
    gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
    const std::vector<GLubyte> rgba = texels(gl, 0, kSize, kSize);
    int worst = 0, worst_alpha = 0;
    for (size_t i = 0; i < rgba.size(); ++i) {
      const int alpha = image[i | 3];
      if ((i & 3) == 3) {
        const int wanted = format == kRgb1 ? 255 : format == kRgba1 ? (alpha < 128 ? 0 : 255) : alpha;
        worst_alpha = std::max(worst_alpha, std::abs(wanted - rgba[i]));
      } else if (format != kRgba1 || alpha >= 128) {
        worst = std::max(worst, std::abs(image[i] - rgba[i]));
      }
    }
    CHECK(worst <= 9);
    CHECK(worst_alpha <= (format == kRgba3 ? 8 : format == kRgba5 ? 4 : 0));
    // The smaller levels are compressed, too.
    GLint compressed = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 4, GL_TEXTURE_COMPRESSED, &compressed);
    CHECK(compressed == GL_TRUE);
    if (format != kRgba1) CHECK(std::abs(texels(gl, 4, 1, 1)[0] - 120) <= 9);
    // The blocks are what the texels are: another texture of them is the same.
    std::vector<GLubyte> blocks(kSize * kSize);
    GLint size = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
    REQUIRE(size_t(size) <= blocks.size());
    gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, blocks.data());
    gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, kSize, kSize, 0, size, blocks.data());
    CHECK(texels(gl, 0, kSize, kSize) == rgba);
    // A part that is replaced leaves the other blocks as they are.
    const std::vector<GLubyte> white(4 * 4 * 4, 255);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, white.data());
    const std::vector<GLubyte> after = texels(gl, 0, kSize, kSize);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize * 4; ++x) {
        const size_t i = size_t(y * kSize * 4 + x);
        const bool inside = x / 16 == 1 && y / 4 == 1;
        if (after[i] != (inside ? 255 : rgba[i])) FAIL_CHECK("texel " << x / 4 << ", " << y);
      }
  }
}

TEST_CASE("FXT1 images are compressed here in blocks of 8x4", "[spec][textures][compressed]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  std::vector<GLubyte> image(16 * 8 * 4), back(image.size());
  for (const bool alpha : {false, true})
    for (const GLenum format : {GL_COMPRESSED_RGB_FXT1_3DFX, GL_COMPRESSED_RGBA_FXT1_3DFX}) {
      for (size_t i = 0; i < 16 * 8; ++i) {
        const int x = int(i % 16), y = int(i / 16);
        const int texel[4] = {x * 16, 255 - y * 16, 128, alpha ? (y & 1 ? 255 : x * 16) : 255};
        for (size_t k = 0; k < 4; ++k) image[4 * i + k] = GLubyte(texel[k]);
      }
      gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
      gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
      double sum = 0;
      for (size_t i = 0; i < image.size(); ++i) {
        const int wanted = i % 4 == 3 && format == GL_COMPRESSED_RGB_FXT1_3DFX ? 255 : image[i];
        sum += (wanted - back[i]) * (wanted - back[i]);
        if (i % 4 == 3 && wanted == 255 && !alpha) CHECK(back[i] == 255);
      }
      CHECK(sum / double(image.size()) < (alpha && format == GL_COMPRESSED_RGBA_FXT1_3DFX ? 1500 : 300));
      GLubyte blocks[2 * 2 * 16];
      gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, blocks);
      gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, 16, 8, 0, sizeof blocks, blocks);
      std::vector<GLubyte> again(image.size());
      gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, again.data());
      CHECK(again == back);
      gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 8, 4, format, 16, blocks);
      CHECK(gl.GetError() == GL_INVALID_OPERATION); // no whole blocks
      gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 8, 4, 8, 4, format, 16, blocks);
      CHECK(gl.GetError() == GL_NO_ERROR);
    }
  // One color is what it is, as near as five bits come.
  std::fill(image.begin(), image.end(), GLubyte(255));
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_FXT1_3DFX, 16, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                image.data());
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, back.data());
  CHECK(back == image);
}

TEST_CASE("Images of one and two components are compressed here, too", "[spec][textures][compressed]") {
  constexpr int kSize = 8;
  std::vector<GLbyte> image(kSize * kSize * 4), back(image.size());
  for (size_t i = 0; i < image.size(); ++i) image[i] = GLbyte(int(i / 4) * 2 - (i & 1 ? 100 : 10));
  const Gl& gl = softgl_library();
  for (const GLenum format :
       {GL_COMPRESSED_SIGNED_RED_RGTC1, GL_COMPRESSED_SIGNED_RG_RGTC2,
        GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT, GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT}) {
    CurrentContext context(gl);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), kSize, kSize, 0, GL_RGBA, GL_BYTE, image.data());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_BYTE, back.data());
    const bool green = format == GL_COMPRESSED_SIGNED_RG_RGTC2,
               alpha = format == GL_COMPRESSED_SIGNED_LUMINANCE_ALPHA_LATC2_EXT;
    for (size_t i = 0; i < image.size(); i += 4) {
      CHECK(std::abs(image[i] - back[i]) <= 5);
      CHECK((green ? std::abs(image[i + 1] - back[i + 1]) <= 5 : back[i + 1] == 0));
      CHECK((alpha ? std::abs(image[i + 3] - back[i + 3]) <= 5 : back[i + 3] == 127));
    }
  }
}

TEST_CASE("LATC is read as it is sampled", "[spec][textures][compressed][deviation]") {
  // Its blocks are those of RGTC.
  const GLubyte block[8] = {0xf5, 0x99, 0x12, 0x34, 0x56, 0x78, 0x9a, 0xbc};
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLfloat read[2][16];
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_SIGNED_RED_RGTC1, 4, 4, 0, 8, block);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, read[0]);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_SIGNED_LUMINANCE_LATC1_EXT, 4, 4, 0, 8, block);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, read[1]);
  CHECK(std::equal(read[0], read[0] + 16, read[1]));
}

TEST_CASE("Compressed textures cannot be drawn to", "[spec][textures][compressed]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    CurrentContext context(*gl);
    GLuint framebuffer = 0, texture = 0;
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GLint(kRgba5), 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBytes);
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    CHECK(gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  }
}

} // namespace softgl::test
