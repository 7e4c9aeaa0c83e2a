// Texture formats of floats, signed components, one and two components and sRGB (GL_ARB_texture_float,
// GL_ARB_texture_rg, GL_EXT_texture_snorm, GL_EXT_packed_float, GL_EXT_texture_shared_exponent,
// GL_EXT_texture_sRGB): what queries say, and pixels of half and packed floats.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

constexpr GLint kFormats[] = {GL_RGBA32F,
                              GL_RGB32F,
                              GL_ALPHA32F_ARB,
                              GL_INTENSITY32F_ARB,
                              GL_LUMINANCE32F_ARB,
                              GL_LUMINANCE_ALPHA32F_ARB,
                              GL_RGBA16F,
                              GL_RGB16F,
                              GL_ALPHA16F_ARB,
                              GL_INTENSITY16F_ARB,
                              GL_LUMINANCE16F_ARB,
                              GL_LUMINANCE_ALPHA16F_ARB,
                              GL_RED,
                              GL_RG,
                              GL_R8,
                              GL_RG8,
                              GL_R16,
                              GL_RG16,
                              GL_R16F,
                              GL_RG16F,
                              GL_R32F,
                              GL_RG32F,
                              GL_R11F_G11F_B10F,
                              GL_RGB9_E5,
                              GL_RED_SNORM,
                              GL_RG_SNORM,
                              GL_RGB_SNORM,
                              GL_RGBA_SNORM,
                              GL_R8_SNORM,
                              GL_RG8_SNORM,
                              GL_RGB8_SNORM,
                              GL_RGBA8_SNORM,
                              GL_R16_SNORM,
                              GL_RG16_SNORM,
                              GL_RGB16_SNORM,
                              GL_RGBA16_SNORM,
                              GL_ALPHA_SNORM,
                              GL_LUMINANCE_SNORM,
                              GL_LUMINANCE_ALPHA_SNORM,
                              GL_INTENSITY_SNORM,
                              GL_ALPHA8_SNORM,
                              GL_LUMINANCE8_SNORM,
                              GL_LUMINANCE8_ALPHA8_SNORM,
                              GL_INTENSITY8_SNORM,
                              GL_ALPHA16_SNORM,
                              GL_LUMINANCE16_SNORM,
                              GL_LUMINANCE16_ALPHA16_SNORM,
                              GL_INTENSITY16_SNORM,
                              GL_SRGB,
                              GL_SRGB8,
                              GL_SRGB_ALPHA,
                              GL_SRGB8_ALPHA8,
                              GL_SLUMINANCE,
                              GL_SLUMINANCE8,
                              GL_SLUMINANCE_ALPHA,
                              GL_SLUMINANCE8_ALPHA8,
                              GL_RGBA8,
                              GL_LUMINANCE8,
                              GL_DEPTH_COMPONENT24};

std::vector<GLint> sizes_and_types(const Gl& gl, GLenum target) {
  std::vector<GLint> all;
  for (const GLint format : kFormats) {
    const GLenum client = format == GL_DEPTH_COMPONENT24 ? GL_DEPTH_COMPONENT : GL_RGBA;
    gl.TexImage2D(target, 0, format, 4, 4, 0, client, GL_FLOAT, nullptr);
    for (const GLenum name :
         {GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
          GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_DEPTH_SIZE,
          GL_TEXTURE_SHARED_SIZE, GL_TEXTURE_RED_TYPE, GL_TEXTURE_GREEN_TYPE, GL_TEXTURE_BLUE_TYPE,
          GL_TEXTURE_ALPHA_TYPE, GL_TEXTURE_LUMINANCE_TYPE_ARB, GL_TEXTURE_INTENSITY_TYPE_ARB,
          GL_TEXTURE_DEPTH_TYPE}) {
      GLint value = -1;
      gl.GetTexLevelParameteriv(target, 0, name, &value);
      all.push_back(value);
    }
    all.push_back(GLint(gl.GetError()));
  }
  return all;
}

} // namespace

TEST_CASE("Sizes and types of components are those of OSMesa", "[spec][textures][float]") {
  for (const GLenum target : {GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D}) {
    std::vector<GLint> answers[2];
    for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
      CurrentContext context(*gl);
      answers[gl == &osmesa_library()] = sizes_and_types(*gl, target);
    }
    CHECK(answers[0] == answers[1]);
  }
}

TEST_CASE("Generic compressed formats of sRGB become their base format", "[spec][textures][float]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLint pairs[][2] = {{GL_COMPRESSED_SRGB, GL_RGB},
                            {GL_COMPRESSED_SRGB_ALPHA, GL_RGBA},
                            {GL_COMPRESSED_SLUMINANCE, GL_LUMINANCE},
                            {GL_COMPRESSED_SLUMINANCE_ALPHA, GL_LUMINANCE_ALPHA}};
  for (const auto& [generic, base] : pairs) {
    GLint format = 0;
    gl.TexImage2D(GL_TEXTURE_2D, 0, generic, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    CHECK(format == base);
  }
}

REFUSAL_TEST_CASE("Packed floats are three components", "[spec][errors][textures][float]") {
  static const GLubyte bytes[64] = {};
  // clang-format off
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_INT_10F_11F_11F_REV, bytes)),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_BGR, GL_UNSIGNED_INT_10F_11F_11F_REV, bytes)),
      BAD(INVALID_ENUM, TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGBA, GL_UNSIGNED_INT_5_9_9_9_REV, bytes)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RED, GL_UNSIGNED_INT_10F_11F_11F_REV, const_cast<GLubyte*>(bytes))),
      BAD(INVALID_OPERATION, TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_REPEAT)),
  };
  // clang-format on
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    const StateSnapshot before = take_snapshot(*gl, false);
    expect_refused(*gl, calls, [&] { CHECK(compare_snapshots(before, take_snapshot(*gl, false)) == ""); });
    GLint decode = 0;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
    gl->GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, &decode);
    CHECK(decode == GL_SKIP_DECODE_EXT);
  }
}

TEST_CASE("Pixels of half and packed floats keep their values", "[spec][textures][float]") {
  const GLfloat values[2][4] = {{0.5f, 1.5f, -2, 0.25f}, {1, 0, 65504, 5.9604645e-8f}};
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLushort half[8];
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 2, 1, 0, GL_RGBA, GL_FLOAT, values);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_HALF_FLOAT, half);
  const GLushort expected[8] = {0x3800, 0x3e00, 0xc000, 0x3400, 0x3c00, 0, 0x7bff, 1};
  for (int i = 0; i < 8; ++i) CHECK(half[i] == expected[i]);
  GLfloat back[8];
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, 2, 1, 0, GL_RGBA, GL_HALF_FLOAT, half);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, back);
  for (int i = 0; i < 8; ++i) CHECK(back[i] == values[i / 4][i % 4]);
  // Bytes in the other order.
  gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
  const GLushort swapped[4] = {0x0038, 0x003e, 0x00c0, 0x0034};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, 1, 1, 0, GL_RGBA, GL_HALF_FLOAT, swapped);
  gl.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, back);
  for (int i = 0; i < 4; ++i) CHECK(back[i] == values[0][i]);

  GLuint word = 0;
  const GLfloat three[3] = {0.5f, 1.5f, 3};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (const auto& [format, type] :
       {std::pair<GLint, GLenum>{GL_R11F_G11F_B10F, GL_UNSIGNED_INT_10F_11F_11F_REV},
        {GL_RGB9_E5, GL_UNSIGNED_INT_5_9_9_9_REV}}) {
    gl.TexImage2D(GL_TEXTURE_2D, 0, format, 1, 1, 0, GL_RGB, GL_FLOAT, three);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, type, &word);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, 1, 1, 0, GL_RGB, type, &word);
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_FLOAT, back);
    for (int i = 0; i < 3; ++i) CHECK(back[i] == three[i]);
  }
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("The lowest signed integer reads as minus one", "[spec][textures][float][deviation]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLbyte lowest[4] = {-128, -127, 127, 0};
  GLfloat back[4];
  GLbyte bytes[4];
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8_SNORM, 1, 1, 0, GL_RGBA, GL_BYTE, lowest);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, back);
  CHECK((back[0] == -1 && back[1] == -1 && back[2] == 1 && back[3] == 0));
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_BYTE, bytes);
  CHECK((bytes[0] == -128 && bytes[1] == -127));
}

TEST_CASE("Mipmaps of sRGB textures average what is stored", "[spec][textures][float][deviation]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLubyte texels[4][4] = {{0, 0, 0, 0}, {200, 200, 200, 200}, {0, 0, 0, 0}, {200, 200, 200, 200}};
  GLubyte back[4];
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  gl.GetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, back);
  for (const GLubyte v : back) CHECK((v >= 99 && v <= 101));
}

} // namespace softgl::test
