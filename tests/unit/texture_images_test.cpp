// Upload and read back of texture images, byte by byte against the live OSMesa: every internal format, client
// format and type.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <vector>

#include "support/random.h"
#include "texture_context.h"

using namespace softgl::test;

namespace {

constexpr GLint kInternalFormats[] = {1,
                                      2,
                                      3,
                                      4,
                                      GL_ALPHA,
                                      GL_ALPHA4,
                                      GL_ALPHA8,
                                      GL_ALPHA12,
                                      GL_ALPHA16,
                                      GL_LUMINANCE,
                                      GL_LUMINANCE4,
                                      GL_LUMINANCE8,
                                      GL_LUMINANCE12,
                                      GL_LUMINANCE16,
                                      GL_LUMINANCE_ALPHA,
                                      GL_LUMINANCE4_ALPHA4,
                                      GL_LUMINANCE6_ALPHA2,
                                      GL_LUMINANCE8_ALPHA8,
                                      GL_LUMINANCE12_ALPHA4,
                                      GL_LUMINANCE12_ALPHA12,
                                      GL_LUMINANCE16_ALPHA16,
                                      GL_INTENSITY,
                                      GL_INTENSITY4,
                                      GL_INTENSITY8,
                                      GL_INTENSITY12,
                                      GL_INTENSITY16,
                                      GL_RGB,
                                      GL_R3_G3_B2,
                                      GL_RGB4,
                                      GL_RGB5,
                                      GL_RGB8,
                                      GL_RGB10,
                                      GL_RGB12,
                                      GL_RGB16,
                                      GL_RGBA,
                                      GL_RGBA2,
                                      GL_RGBA4,
                                      GL_RGB5_A1,
                                      GL_RGBA8,
                                      GL_RGB10_A2,
                                      GL_RGBA12,
                                      GL_RGBA16,
                                      GL_DEPTH_COMPONENT,
                                      GL_DEPTH_COMPONENT16,
                                      GL_DEPTH_COMPONENT24,
                                      GL_DEPTH_COMPONENT32};
constexpr GLenum kFormats[] = {GL_RGBA,  GL_RGB, GL_BGRA,  GL_BGR,  GL_LUMINANCE,      GL_LUMINANCE_ALPHA,
                               GL_ALPHA, GL_RED, GL_GREEN, GL_BLUE, GL_DEPTH_COMPONENT};
constexpr GLenum kTypes[] = {GL_UNSIGNED_BYTE,
                             GL_BYTE,
                             GL_UNSIGNED_SHORT,
                             GL_SHORT,
                             GL_UNSIGNED_INT,
                             GL_INT,
                             GL_FLOAT,
                             GL_UNSIGNED_BYTE_3_3_2,
                             GL_UNSIGNED_BYTE_2_3_3_REV,
                             GL_UNSIGNED_SHORT_5_6_5,
                             GL_UNSIGNED_SHORT_5_6_5_REV,
                             GL_UNSIGNED_SHORT_4_4_4_4,
                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                             GL_UNSIGNED_SHORT_5_5_5_1,
                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                             GL_UNSIGNED_INT_8_8_8_8,
                             GL_UNSIGNED_INT_8_8_8_8_REV,
                             GL_UNSIGNED_INT_10_10_10_2,
                             GL_UNSIGNED_INT_2_10_10_10_REV};

struct Upload {
  GLint internal_format;
  GLenum format, type;
  int width, height;
  bool swap;
  int alignment, row_length, skip_pixels, skip_rows;
  bool transfer;
  std::vector<unsigned char> pixels;
};

std::vector<unsigned char> random_pixels(Random& r, GLenum type) {
  std::vector<unsigned char> bytes(4096);
  for (auto& b : bytes) b = (unsigned char)(r.bits() >> 24);
  if (type == GL_FLOAT)
    for (size_t i = 0; i + 4 <= bytes.size(); i += 4) {
      const float v = r.chance(10)   ? float(r.integer(-1, 2))
                      : r.chance(30) ? float(r.integer(0, 510)) / 510.0f
                                     : r.real(-0.2f, 1.2f);
      std::memcpy(&bytes[i], &v, 4);
    }
  if (r.chance(10)) std::fill(bytes.begin(), bytes.end(), r.chance(50) ? 0 : 255);
  return bytes;
}

/// What the upload and the queries of a level give, as one string of bytes.
std::vector<unsigned char> upload(TextureContext& c, const Upload& u, GLenum get_format, GLenum get_type,
                                  bool mipmap) {
  c.bind();
  const Gl& gl = c.gl;
  GLuint name;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, mipmap);
  gl.PixelStorei(GL_UNPACK_SWAP_BYTES, u.swap);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, u.alignment);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, u.row_length);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, u.skip_pixels);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, u.skip_rows);
  gl.PixelTransferf(GL_RED_SCALE, u.transfer ? 0.7f : 1.0f);
  gl.PixelTransferf(GL_ALPHA_BIAS, u.transfer ? 0.1f : 0.0f);
  gl.PixelTransferf(GL_DEPTH_SCALE, u.transfer ? 0.7f : 1.0f);
  gl.TexImage2D(GL_TEXTURE_2D, 0, u.internal_format, u.width, u.height, 0, u.format, u.type, u.pixels.data());
  std::vector<unsigned char> result;
  auto add = [&](const void* p, size_t n) {
    result.insert(result.end(), static_cast<const unsigned char*>(p),
                  static_cast<const unsigned char*>(p) + n);
  };
  GLenum error = gl.GetError();
  add(&error, sizeof error);
  gl.PixelStorei(GL_UNPACK_SWAP_BYTES, 0);
  gl.PixelTransferf(GL_RED_SCALE, 1);
  gl.PixelTransferf(GL_ALPHA_BIAS, 0);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  if (error == GL_NO_ERROR) {
    for (GLenum query : {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE,
                         GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE,
                         GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_DEPTH_SIZE}) {
      GLint value = -1;
      gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, query, &value);
      add(&value, sizeof value);
    }
    std::vector<unsigned char> image(4096, 0xa5);
    gl.GetTexImage(GL_TEXTURE_2D, mipmap ? 1 : 0, get_format, get_type, image.data());
    add(image.data(), image.size());
    error = gl.GetError();
    add(&error, sizeof error);
  }
  gl.DeleteTextures(1, &name);
  return result;
}

std::string compare_uploads(uint64_t seed, int count, bool mipmap) {
  TextureContext ours(softgl_library()), theirs(osmesa_library());
  Random r(seed);
  int failures = 0;
  std::string text;
  for (int i = 0; i < count && failures < 20; ++i) {
    Upload u;
    u.internal_format = kInternalFormats[r.integer(0, int(std::size(kInternalFormats)) - 1)];
    u.format = kFormats[r.integer(0, int(std::size(kFormats)) - 1)];
    u.type = kTypes[r.integer(0, int(std::size(kTypes)) - 1)];
    const bool depth =
        u.internal_format == GL_DEPTH_COMPONENT ||
        (u.internal_format >= GL_DEPTH_COMPONENT16 && u.internal_format <= GL_DEPTH_COMPONENT32);
    if (depth) u.format = GL_DEPTH_COMPONENT;
    u.width = r.integer(1, mipmap ? 12 : 7), u.height = r.integer(1, mipmap ? 12 : 7);
    u.swap = r.chance(15);
    u.alignment = r.pick({1, 2, 4, 8});
    u.row_length = r.chance(20) ? u.width + r.integer(0, 3) : 0;
    u.skip_pixels = r.chance(20) ? r.integer(0, 2) : 0;
    u.skip_rows = r.chance(20) ? r.integer(0, 2) : 0;
    u.transfer = r.chance(10);
    // OSMesa forgets skipped pixels when it swaps bytes or transfers (a defect).
    if (u.swap || u.transfer) u.skip_pixels = u.skip_rows = u.row_length = 0;
    u.pixels = random_pixels(r, u.type);
    if (depth && u.swap) u.swap = false;              // ignored by OSMesa for some pairs of types
    if (u.swap && u.type == GL_FLOAT) u.swap = false; // swapped floats could be anything, NaN too
    GLenum get_format = kFormats[r.integer(0, int(std::size(kFormats)) - 2)];
    if (depth) get_format = GL_DEPTH_COMPONENT;
    const GLenum get_type = kTypes[r.integer(0, depth ? 6 : int(std::size(kTypes)) - 1)];
    auto a = upload(ours, u, get_format, get_type, mipmap),
         b = upload(theirs, u, get_format, get_type, mipmap);
    // OSMesa returns 1.0 as 0 where it goes through floats (2^32 wraps); ours are the maxima of the type.
    if (get_type == GL_UNSIGNED_INT || get_type == GL_INT)
      for (size_t k = 40; k + 8 <= std::min(a.size(), b.size()); k += 4) {
        uint32_t x, y;
        std::memcpy(&x, &a[k], 4), std::memcpy(&y, &b[k], 4);
        if ((x == 0xffffffffu && y == 0) || (x == 0x80000001u && y == 0x7fffffffu) ||
            (x == 0x7fffffffu && y == 0x80000000u))
          std::memcpy(&a[k], &y, 4);
      }
    if (a == b) continue;
    ++failures;
    size_t at = 0;
    while (at < std::min(a.size(), b.size()) && a[at] == b[at]) ++at;
    std::string ours_text, theirs_text;
    for (size_t k = at & ~size_t(3); k < std::min({a.size(), b.size(), (at & ~size_t(3)) + 24}); ++k) {
      char hex[8];
      std::snprintf(hex, sizeof hex, "%02x ", a[k]), ours_text += hex;
      std::snprintf(hex, sizeof hex, "%02x ", b[k]), theirs_text += hex;
    }
    std::ostringstream message;
    message << "internal " << std::hex << u.internal_format << " format " << u.format << " type " << u.type
            << " swap " << u.swap << " transfer " << u.transfer << " size " << std::dec << u.width << "x"
            << u.height << " read as " << std::hex << get_format << " " << get_type << " differs at "
            << std::dec << at << " of " << a.size() << "/" << b.size() << ": ours " << ours_text << " theirs "
            << theirs_text << '\n';
    text += message.str();
  }
  return text;
}

} // namespace

TEST_CASE("texture images are stored and read back as OSMesa does", "[texture]") {
  CHECK(compare_uploads(1, 20000, false) == "");
}
TEST_CASE("mipmaps are generated as OSMesa does", "[texture]") {
  CHECK(compare_uploads(2, 4000, true) == "");
}

// All levels of cube maps of random sizes and formats, as 16-bit numbers.
static std::vector<GLushort> cube_levels(const Gl& gl) {
  TextureContext c(gl);
  Random r(3);
  std::vector<GLushort> levels;
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_GENERATE_MIPMAP, GL_TRUE);
  for (int i = 0; i < 60; ++i) {
    const GLint format = r.pick({GL_RGBA16, GL_LUMINANCE16_ALPHA16, GL_RGB12, GL_RGBA8, GL_RGB10_A2});
    const int size = r.integer(2, 60);
    std::vector<GLushort> texels(size_t(size) * size_t(size) * 4);
    for (int face = 0; face < 6; ++face) {
      const GLenum target = GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face);
      for (GLushort& t : texels) t = GLushort(r.bits() >> 40);
      gl.TexImage2D(target, 0, format, size, size, 0, GL_RGBA, GL_UNSIGNED_SHORT, texels.data());
      for (int level = 1, s = size / 2; s > 0; ++level, s /= 2) {
        std::vector<GLushort> reduced(size_t(s) * size_t(s) * 4);
        gl.GetTexImage(target, level, GL_RGBA, GL_UNSIGNED_SHORT, reduced.data());
        levels.insert(levels.end(), reduced.begin(), reduced.end());
      }
    }
  }
  CHECK(gl.GetError() == GL_NO_ERROR);
  return levels;
}
TEST_CASE("mipmaps of cube maps are generated as OSMesa does", "[texture]") {
  const bool same = cube_levels(softgl_library()) == cube_levels(osmesa_library());
  CHECK(same);
}
