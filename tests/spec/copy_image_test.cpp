// glCopyImageSubData and glCopyImageSubDataNV (GL_ARB_copy_image, GL_NV_copy_image).
#include <catch2/catch.hpp>

#include <cstring>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"
#include "support/random.h"

using namespace softgl::test;

namespace {

struct Format {
  GLenum internal, format, type; // as it is read back, bit by bit
  int bytes;                     // of a texel, or of a block
  bool compressed = false;
};

const std::vector<std::vector<Format>> kClasses = {
    {{GL_RGBA32F, GL_RGBA, GL_FLOAT, 16},
     {GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 0, 0, 16, true},
     {GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 0, 0, 16, true},
     {GL_COMPRESSED_RG_RGTC2, 0, 0, 16, true}},
    {{GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT, 8},
     {GL_RG32F, GL_RG, GL_FLOAT, 8},
     {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 0, 0, 8, true},
     {GL_COMPRESSED_RED_RGTC1, 0, 0, 8, true}},
    {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4},
     {GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4},
     {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4},
     {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, 4}},
    {{GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2}, {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2}},
    {{GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1}},
    {{GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2}},
    {{GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 3}},
    {{GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2}},
    {{GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4}},
};

constexpr int kSide = 16, kDepth = 4;

struct Image {
  Format format;
  GLenum target;
  GLuint name;
  int layers() const { return target == GL_TEXTURE_CUBE_MAP ? 6 : target == GL_TEXTURE_3D ? kDepth : 1; }
  int rows() const { return target == GL_TEXTURE_1D ? 1 : kSide; }
};

std::vector<GLubyte> random_bytes(Random& r) {
  std::vector<GLubyte> bytes(kSide * kSide * kDepth * 16);
  for (GLubyte& b : bytes) b = GLubyte(r.bits() >> 24);
  for (size_t i = 3; i < bytes.size(); i += 4)
    bytes[i] = GLubyte(bytes[i] & 0x3f); // no float that is no number
  return bytes;
}

void make(const Gl& gl, const Image& image, const GLubyte* bytes) {
  const Format& f = image.format;
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.BindTexture(image.target, image.name);
  gl.TexParameteri(image.target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  if (f.compressed) {
    const GLsizei size = kSide * kSide / 16 * f.bytes;
    gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, f.internal, kSide, kSide, 0, size, bytes);
    return;
  }
  switch (image.target) {
  case GL_TEXTURE_1D:
    gl.TexImage1D(GL_TEXTURE_1D, 0, GLint(f.internal), kSide, 0, f.format, f.type, bytes);
    return;
  case GL_TEXTURE_3D:
    gl.TexImage3D(GL_TEXTURE_3D, 0, GLint(f.internal), kSide, kSide, kDepth, 0, f.format, f.type, bytes);
    return;
  case GL_TEXTURE_CUBE_MAP:
    for (GLenum face = 0; face < 6; ++face)
      gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GLint(f.internal), kSide, kSide, 0, f.format,
                    f.type, bytes + 32 * face);
    return;
  default: gl.TexImage2D(image.target, 0, GLint(f.internal), kSide, kSide, 0, f.format, f.type, bytes);
  }
}

std::vector<GLubyte> contents(const Gl& gl, const Image& image) {
  std::vector<GLubyte> bytes(kSide * kSide * 6 * 16);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.BindTexture(image.target, image.name);
  if (image.format.compressed)
    gl.GetCompressedTexImage(image.target, 0, bytes.data());
  else if (image.target == GL_TEXTURE_CUBE_MAP)
    for (GLenum face = 0; face < 6; ++face)
      gl.GetTexImage(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, image.format.format, image.format.type,
                     bytes.data() + kSide * kSide * 16 * face);
  else
    gl.GetTexImage(image.target, 0, image.format.format, image.format.type, bytes.data());
  return bytes;
}

Image random_image(Random& r, const std::vector<Format>& formats, GLuint name) {
  const Format format = formats[size_t(r.integer(0, int(formats.size()) - 1))];
  if (format.compressed) return {format, GL_TEXTURE_2D, name};
  const bool depth = format.format == GL_DEPTH_COMPONENT || format.format == GL_DEPTH_STENCIL;
  return {format,
          depth ? GLenum(GL_TEXTURE_2D)
                : r.pick<GLenum>({GL_TEXTURE_2D, GL_TEXTURE_2D, GL_TEXTURE_1D, GL_TEXTURE_3D,
                                  GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE}),
          name};
}

} // namespace

TEST_CASE("Bits go from image to image as in OSMesa", "[spec][copy_image]") {
  const Gl* const libraries[] = {&softgl_library(), &osmesa_library()};
  CurrentContext contexts[] = {CurrentContext(*libraries[0]), CurrentContext(*libraries[1])};
  Random r(11);
  GLuint name = 1;
  int copied = 0;
  for (int trial = 0; trial < 120; ++trial, name += 2) {
    const auto& formats = kClasses[size_t(r.integer(0, int(kClasses.size()) - 1))];
    const Image from = random_image(r, formats, name), to = random_image(r, formats, name + 1);
    const std::vector<GLubyte> first = random_bytes(r), second = random_bytes(r);
    const int from_step = from.format.compressed ? 4 : 1, to_step = to.format.compressed ? 4 : 1;
    // In elements: texels or blocks.
    const int most_columns = kSide / std::max(from_step, to_step);
    const int most_rows = std::min(from.rows(), to.rows()) /
                          (from.rows() == 1 || to.rows() == 1 ? 1 : std::max(from_step, to_step));
    const int columns = r.integer(1, most_columns),
              rows = r.integer(1, from_step + to_step > 2 ? std::max(most_rows / 4, 1) : most_rows),
              layers = r.integer(1, std::min(from.layers(), to.layers()));
    const auto place = [&](int size, int step, int elements) {
      return r.integer(0, std::max(size / step - elements, 0)) * step;
    };
    const int x = place(kSide, from_step, columns), y = place(from.rows(), from_step, rows),
              z = r.integer(0, from.layers() - layers);
    const int to_x = place(kSide, to_step, columns), to_y = place(to.rows(), to_step, rows),
              to_z = r.integer(0, to.layers() - layers);
    std::vector<GLubyte> results[2];
    for (int i = 0; i < 2; ++i) {
      const Gl& gl = *libraries[i];
      make(gl, from, first.data());
      make(gl, to, second.data());
      gl.CopyImageSubData(from.name, from.target, 0, x, y, z, to.name, to.target, 0, to_x, to_y, to_z,
                          columns * from_step, rows * from_step, layers);
      results[i] = contents(gl, to);
      REQUIRE(contents(gl, from).size() == results[i].size());
    }
    INFO("trial " << trial << std::hex << " " << from.format.internal << " " << from.target << " to "
                  << to.format.internal << " " << to.target);
    const GLenum ours = libraries[0]->GetError(), theirs = libraries[1]->GetError();
    CHECK(ours == theirs);
    copied += ours == GL_NO_ERROR;
    CHECK(results[0] == results[1]);
  }
  CHECK(copied > 90);
}

REFUSAL_TEST_CASE("Images are not copied where an argument is wrong", "[spec][copy_image]") {
  static const BadCall bad_calls[] = {
#define COPY(from, from_target, from_level, x, y, z, to, to_target, to_level, to_x, to_y, to_z, w, h, d) \
  CopyImageSubData(from, GL_##from_target, from_level, x, y, z, to, GL_##to_target, to_level, to_x, to_y, \
                   to_z, w, h, d)
      BAD(INVALID_VALUE, COPY(0, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(77, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(77, RENDERBUFFER, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_ENUM, COPY(1, TEXTURE_CUBE_MAP_POSITIVE_X, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_ENUM, COPY(1, PROXY_TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_ENUM, COPY(1, TEXTURE_3D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE,
          COPY(1, TEXTURE_2D, 1, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)), // no such level
      BAD(INVALID_OPERATION,
          COPY(1, TEXTURE_2D, 0, 0, 0, 0, 3, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)), // other bits
      BAD(INVALID_VALUE, COPY(1, TEXTURE_2D, 0, -1, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(1, TEXTURE_2D, 0, 0, 8, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 9, 1)),
      BAD(INVALID_VALUE, COPY(1, TEXTURE_2D, 0, 0, 0, 1, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 15, 0, 0, 2, 1, 1)),
      BAD(INVALID_VALUE, COPY(1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 2)),
      BAD(INVALID_VALUE,
          COPY(4, TEXTURE_2D, 0, 1, 0, 0, 4, TEXTURE_2D, 0, 0, 0, 0, 4, 4, 1)), // inside a block
      BAD(INVALID_VALUE, COPY(4, TEXTURE_2D, 0, 0, 0, 0, 4, TEXTURE_2D, 0, 0, 2, 0, 4, 4, 1)),
      BAD(INVALID_VALUE, COPY(4, TEXTURE_2D, 0, 0, 0, 0, 4, TEXTURE_2D, 0, 8, 8, 0, 5, 4, 1)),
      BAD(INVALID_VALUE, COPY(1, RENDERBUFFER, 1, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_OPERATION,
          COPY(2, RENDERBUFFER, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)), // 4 samples
#undef COPY
  };
  const auto prepare = [](const Gl& gl, Random& r) {
    const std::vector<GLubyte> bytes = random_bytes(r);
    make(gl, {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4}, GL_TEXTURE_2D, 1}, bytes.data());
    make(gl, {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4}, GL_TEXTURE_2D, 2}, bytes.data());
    make(gl, {{GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 3}, GL_TEXTURE_2D, 3}, bytes.data());
    make(gl, {{GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 0, 0, 16, true}, GL_TEXTURE_2D, 4}, bytes.data());
    GLuint renderbuffers[2];
    gl.GenRenderbuffers(2, renderbuffers);
    for (GLuint i = 0; i < 2; ++i) {
      gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers[i]);
      gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, i ? 4 : 0, GL_RGBA8, 16, 16);
    }
  };
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    Random r(3);
    CurrentContext context(*gl);
    prepare(*gl, r);
    expect_refused(*gl, bad_calls);
    gl->CopyImageSubData(1, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 0, 0, 0, 0, 4, 1); // nothing
    CHECK(gl->GetError() == GL_NO_ERROR);
  }
  const Gl& gl = softgl_library();
  Random r(3);
  CurrentContext context(gl);
  prepare(gl, r);
  make(gl, {{GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4}, GL_TEXTURE_2D, 9}, random_bytes(r).data());
  static const BadCall further_calls[] = {
#define COPY(form, from, from_target, from_level, x, y, z, to, to_target, to_level, to_x, to_y, to_z, w, h, \
             d) \
  CopyImageSubData##form(from, GL_##from_target, from_level, x, y, z, to, GL_##to_target, to_level, to_x, \
                         to_y, to_z, w, h, d)
      // What OSMesa does not look at, or in another order.
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, -1, 4, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 4, -1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 4, 4, -1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, -1, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, -1, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, -1, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, -1, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 77, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, -1, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_ENUM, COPY(, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_1D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_OPERATION,
          COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 9, TEXTURE_2D, 0, 0, 0, 0, 4, 4, 1)), // one format
      BAD(INVALID_ENUM, COPY(NV, 1, TEXTURE_1D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_ENUM, COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_1D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, -1, 4, 1)),
      BAD(INVALID_VALUE, COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 4, -1, 1)),
      BAD(INVALID_VALUE, COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 4, 4, -1)),
      BAD(INVALID_VALUE, COPY(NV, 77, TEXTURE_2D, 0, 0, 0, 0, 2, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
      BAD(INVALID_VALUE, COPY(NV, 1, TEXTURE_2D, 0, 0, 0, 0, 77, TEXTURE_2D, 0, 0, 0, 0, 1, 1, 1)),
#undef COPY
  };
  expect_refused(gl, further_calls);
  gl.CopyImageSubDataNV(1, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 8, 8, 0, 4, 4, 1);
  CHECK(gl.GetError() == GL_NO_ERROR);
  gl.Begin(GL_POINTS);
  gl.CopyImageSubDataNV(1, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 8, 8, 0, 4, 4, 1);
  gl.End();
  CHECK(gl.GetError() == GL_INVALID_OPERATION);
}

TEST_CASE("Renderbuffers are copied from and to, with all their samples", "[spec][copy_image]") {
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    for (const GLsizei samples : {0, 4}) {
      CurrentContext context(gl);
      GLuint renderbuffers[3], framebuffers[2];
      gl.GenRenderbuffers(3, renderbuffers);
      gl.GenFramebuffers(2, framebuffers);
      for (int i = 0; i < 3; ++i) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffers[i]);
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, i < 2 ? samples : 0, GL_RGBA8, 80, 80);
      }
      const auto attach = [&](GLuint framebuffer, GLuint renderbuffer) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
      };
      attach(framebuffers[0], renderbuffers[0]);
      gl.Viewport(0, 0, 80, 80);
      gl.ClearColor(0, 0, 1, 1);
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.Color3f(1, 0, 0);
      gl.Begin(GL_TRIANGLES); // whose edge goes through pixels
      gl.Vertex2f(-1, -1), gl.Vertex2f(1, -1), gl.Vertex2f(-0.7f, 1);
      gl.End();
      attach(framebuffers[0], renderbuffers[1]);
      gl.ClearColor(0, 1, 0, 1);
      gl.Clear(GL_COLOR_BUFFER_BIT);
      gl.CopyImageSubData(renderbuffers[0], GL_RENDERBUFFER, 0, 3, 5, 0, renderbuffers[1], GL_RENDERBUFFER, 0,
                          10, 2, 0, 66, 70, 1);
      attach(framebuffers[1], renderbuffers[2]);
      gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
      gl.BlitFramebuffer(0, 0, 80, 80, 0, 0, 80, 80, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
      std::vector<GLubyte> pixels(80 * 80 * 4);
      gl.ReadPixels(0, 0, 80, 80, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
      CHECK(gl.GetError() == GL_NO_ERROR);
      const auto pixel = [&](int x, int y) { return &pixels[size_t(y * 80 + x) * 4]; };
      CHECK((pixel(9, 30)[1] == 255 && pixel(76, 30)[1] == 255 && pixel(30, 1)[1] == 255));
      CHECK((pixel(10, 2)[0] == 255 && pixel(75, 71)[2] == 255));
      int mixed = 0;
      for (int i = 0; i < 80 * 80; ++i) mixed += pixels[size_t(i) * 4] > 0 && pixels[size_t(i) * 4] < 255;
      CHECK((samples ? mixed > 20 : mixed == 0));
      if (samples) continue;
      // To a texture and back.
      std::vector<GLubyte> texels(80 * 80 * 4, 7);
      gl.BindTexture(GL_TEXTURE_2D, 1);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 80, 80, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
      gl.CopyImageSubData(renderbuffers[2], GL_RENDERBUFFER, 0, 0, 0, 0, 1, GL_TEXTURE_2D, 0, 0, 0, 0, 80, 40,
                          1);
      gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
      CHECK(std::memcmp(texels.data(), pixels.data(), 80 * 40 * 4) == 0);
      CHECK(texels.back() == 7);
      gl.CopyImageSubData(1, GL_TEXTURE_2D, 0, 0, 39, 0, renderbuffers[2], GL_RENDERBUFFER, 0, 0, 79, 0, 80,
                          1, 1);
      gl.ReadPixels(0, 79, 80, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
      CHECK(std::memcmp(texels.data(), pixel(0, 39), 80 * 4) == 0);
    }
  }
}

TEST_CASE("What was drawn to a texture is copied, and what was copied is drawn on", "[spec][copy_image]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  Random r(4);
  for (GLuint name : {1u, 2u})
    make(gl, {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4}, GL_TEXTURE_2D, name}, random_bytes(r).data());
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 1, 0);
  gl.ClearColor(1, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.CopyImageSubData(1, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 0, 0, 0, 16, 16, 1);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 2, 0);
  GLubyte pixel[4] = {};
  gl.ReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK((pixel[0] == 255 && pixel[1] == 0));
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, 4, 4);
  gl.ClearColor(0, 1, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.CopyImageSubData(2, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 8, 8, 0, 4, 4,
                      1); // inside one image
  gl.ReadPixels(9, 9, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK((pixel[0] == 0 && pixel[1] == 255));
  gl.ReadPixels(13, 9, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK((pixel[0] == 255 && pixel[1] == 0));
  CHECK(gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("A texture without the mipmaps that its filter wants is not copied", "[spec][copy_image]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    CurrentContext context(*gl);
    Random r(4);
    for (GLuint name : {1u, 2u}) {
      make(*gl, {{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4}, GL_TEXTURE_2D, name}, random_bytes(r).data());
      gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    }
    gl->CopyImageSubData(1, GL_TEXTURE_2D, 0, 0, 0, 0, 2, GL_TEXTURE_2D, 0, 0, 0, 0, 16, 16, 1);
    CHECK(gl->GetError() == GL_INVALID_OPERATION);
  }
}
