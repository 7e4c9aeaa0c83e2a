// Buffer objects as the memory of pixel commands (GL_ARB_pixel_buffer_object).
#include <catch2/catch.hpp>

#include <cstring>
#include <string>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

constexpr size_t kBytes = 4096;
const void* at(size_t offset) { return reinterpret_cast<const void*>(offset); }
void* place(size_t offset) { return reinterpret_cast<void*>(offset); }

/// Buffer 1 to read pixels from, with random bytes, and buffer 2 to write them to.
void make_buffers(const Gl& gl, Random& r) {
  std::vector<GLubyte> bytes(kBytes);
  for (GLubyte& b : bytes) b = GLubyte(r.bits());
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 1);
  gl.BufferData(GL_PIXEL_UNPACK_BUFFER, kBytes, bytes.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 2);
  gl.BufferData(GL_PIXEL_PACK_BUFFER, kBytes, bytes.data(), GL_STREAM_READ);
}

std::string contents(const Gl& gl, GLenum target) {
  std::string bytes(kBytes, 0);
  gl.GetBufferSubData(target, 0, kBytes, bytes.data());
  return bytes;
}

/// A random command on pixels, at a random place of a buffer that holds them or not.
void random_command(const Gl& gl, Random& r) {
  const size_t offset = size_t(r.integer(0, 300)) * (r.chance(70) ? 4 : 1) + (r.chance(10) ? 3000 : 0);
  const GLenum format = r.pick<GLenum>({GL_RGBA, GL_RGB, GL_LUMINANCE_ALPHA}),
               type = r.pick<GLenum>({GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT});
  const GLsizei w = r.integer(1, 12), h = r.integer(1, 12);
  const bool in_list = r.chance(20);
  switch (r.integer(0, 9)) {
  case 0: gl.PixelStorei(GL_UNPACK_ROW_LENGTH, r.chance(50) ? r.integer(12, 20) : 0); break;
  case 1: gl.PixelStorei(GL_PACK_SKIP_ROWS, r.integer(0, 3)); break;
  case 2:
  case 3:
    if (in_list) gl.NewList(1, GL_COMPILE);
    gl.DrawPixels(w, h, format, type, at(offset));
    if (in_list) gl.EndList(), gl.CallList(1);
    break;
  case 4: gl.Bitmap(w, h, 0, 0, 1, 1, static_cast<const GLubyte*>(at(offset))); break;
  case 5: gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, w, h, 0, format, type, at(offset)); break;
  case 6: gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, format, type, at(offset)); break;
  case 7: gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, place(offset)); break;
  case 8: gl.ReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, place(offset)); break;
  default:
    if (r.chance(50))
      gl.GetPolygonStipple(static_cast<GLubyte*>(place(offset)));
    else
      gl.PolygonStipple(static_cast<const GLubyte*>(at(offset)));
  }
}

TEST_CASE("pixels come from buffers and go to buffers as OSMesa's do", "[spec][pixels][buffers]") {
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::string packed[2], errors[2], picture[2];
    for (int i = 0; i < 2; ++i) {
      const Gl& gl = i ? osmesa_library() : softgl_library();
      CurrentContext context(gl);
      Random r(seed);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    std::vector<GLubyte>(64, 77).data());
      make_buffers(gl, r);
      for (int k = 0; k < 12; ++k) {
        random_command(gl, r);
        errors[i] += std::to_string(gl.GetError()) + " ";
      }
      packed[i] = contents(gl, GL_PIXEL_PACK_BUFFER);
      gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
      gl.PixelStorei(GL_PACK_SKIP_ROWS, 0);
      picture[i].resize(16 * 16 * 4);
      gl.ReadPixels(0, 0, 16, 16, GL_RGBA, GL_UNSIGNED_BYTE, picture[i].data());
    }
    INFO("seed " << seed);
    CHECK(errors[0] == errors[1]);
    CHECK((packed[0] == packed[1]));
    CHECK((picture[0] == picture[1]));
  }
}

TEST_CASE("pixel maps come from buffers and go to buffers", "[spec][pixels][buffers]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    const GLushort map[4] = {65535, 300, 7, 0};
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 1);
    gl->BufferData(GL_PIXEL_UNPACK_BUFFER, sizeof map, map, GL_STATIC_DRAW);
    gl->BindBuffer(GL_PIXEL_PACK_BUFFER, 2);
    gl->BufferData(GL_PIXEL_PACK_BUFFER, sizeof map, nullptr, GL_STATIC_DRAW);
    for (const bool in_list : {false, true}) {
      if (in_list && gl == &osmesa_library()) break; // it reads from address 0
      if (in_list) gl->NewList(1, GL_COMPILE);
      gl->PixelMapusv(GL_PIXEL_MAP_R_TO_R, in_list ? 2 : 4, nullptr);
      if (in_list) gl->EndList(), gl->CallList(1);
      GLushort read[4] = {};
      gl->GetPixelMapusv(GL_PIXEL_MAP_R_TO_R, nullptr);
      gl->GetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, sizeof read, read);
      CHECK(std::memcmp(map, read, in_list ? 4 : 8) == 0);
      CHECK(gl->GetError() == GL_NO_ERROR);
    }
    gl->PixelMapusv(GL_PIXEL_MAP_G_TO_G, 5, nullptr);
    CHECK(gl->GetError() == GL_INVALID_OPERATION);
  }
}

REFUSAL_TEST_CASE("a pixel command refuses a buffer that is mapped or does not hold its pixels",
                  "[spec][errors][buffers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  Random r(1);
  make_buffers(gl, r);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  REQUIRE(gl.GetError() == GL_NO_ERROR);
  const std::string before = contents(gl, GL_PIXEL_PACK_BUFFER);
  const auto unchanged = [&] { CHECK((contents(gl, GL_PIXEL_PACK_BUFFER) == before)); };
  const BadCall outside[] = {
      BAD(INVALID_OPERATION, DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, at(kBytes - 63))),
      BAD(INVALID_OPERATION, DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, at(~size_t(3)))),
      BAD(INVALID_OPERATION, DrawPixels(4, 4, GL_RGBA, GL_FLOAT, at(2))),
      BAD(INVALID_OPERATION, Bitmap(8, 8, 0, 0, 0, 0, static_cast<const GLubyte*>(at(kBytes - 28)))),
      BAD(INVALID_OPERATION,
          TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, at(0))),
      BAD(INVALID_OPERATION, TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_RGBA, GL_FLOAT, at(kBytes))),
      BAD(INVALID_OPERATION, PolygonStipple(static_cast<const GLubyte*>(at(kBytes - 127)))),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, place(kBytes - 255))),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT, place(1))),
      BAD(INVALID_OPERATION, GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, place(kBytes - 60))),
      BAD(INVALID_OPERATION, GetPolygonStipple(static_cast<GLubyte*>(place(kBytes - 127)))),
      BAD(INVALID_OPERATION, GetPixelMapfv(GL_PIXEL_MAP_R_TO_R, static_cast<GLfloat*>(place(kBytes)))),
  };
  expect_refused(gl, outside, unchanged);
  // Skipped rows whose size no number holds.
  for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS})
    gl.PixelStorei(name, 0x7fffffff);
  const BadCall huge[] = {
      BAD(INVALID_OPERATION, DrawPixels(2, 2, GL_RGBA, GL_FLOAT, at(0))),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 2, 2, GL_RGBA, GL_FLOAT, place(0))),
  };
  expect_refused(gl, huge, unchanged);
  for (const GLenum name : {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS})
    gl.PixelStorei(name, 0);
  gl.MapBuffer(GL_PIXEL_UNPACK_BUFFER, GL_READ_ONLY);
  gl.MapBuffer(GL_PIXEL_PACK_BUFFER, GL_READ_ONLY);
  const BadCall mapped[] = {
      BAD(INVALID_OPERATION, DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, at(0))),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, place(0))),
  };
  expect_refused(gl, mapped, [] {});
}

TEST_CASE("a list reads the buffer when it is compiled, and then refuses what it does not hold",
          "[spec][errors][buffers]") {
  for (const Gl* library : {&softgl_library(), &osmesa_library()}) {
    const Gl& gl = *library;
    CurrentContext context(gl);
    const uint32_t pixel = 0xff0000ff;
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    gl.BufferData(GL_PIXEL_UNPACK_BUFFER, sizeof pixel, &pixel, GL_STATIC_DRAW);
    gl.NewList(1, GL_COMPILE);
    gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    CHECK(gl.GetError() == GL_NO_ERROR);
    gl.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    CHECK(gl.GetError() == GL_INVALID_OPERATION);
    gl.EndList();
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl.DeleteBuffers(1, &buffer);
    gl.CallList(1);
    const GLenum error = gl.GetError();
    if (library == &softgl_library()) CHECK(error == GL_NO_ERROR); // OSMesa: GL_OUT_OF_MEMORY
    uint32_t drawn = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &drawn);
    CHECK(drawn == pixel);
  }
}

TEST_CASE("the bindings of pixel buffers belong to the client's pixel store", "[spec][state][buffers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 5);
  gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 6);
  gl.PopClientAttrib();
  GLint name = 0;
  gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &name);
  CHECK(name == 5);
  const GLuint deleted = 5;
  gl.DeleteBuffers(1, &deleted);
  gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &name);
  CHECK(name == 0);
}

} // namespace
} // namespace softgl::test
