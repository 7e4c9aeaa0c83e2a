// Buffer objects that are mapped in parts (GL_ARB_map_buffer_range) and copied (GL_ARB_copy_buffer).
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

constexpr GLsizeiptr kBytes = 64;

GLintptr number(Random& r) { return r.chance(10) ? r.integer(-3, 80) : r.integer(0, 40); }

/// A random command, good or not; what it answers.
std::string random_command(const Gl& gl, Random& r) {
  const GLenum target = r.pick<GLenum>({GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_ARRAY_BUFFER}),
               other = r.pick<GLenum>({GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER});
  const GLintptr a = number(r), b = number(r), size = number(r);
  GLbitfield access =
      r.pick<GLbitfield>({GL_MAP_READ_BIT, GL_MAP_WRITE_BIT, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT});
  if (r.chance(40))
    access |= r.pick<GLbitfield>({GL_MAP_FLUSH_EXPLICIT_BIT, GL_MAP_UNSYNCHRONIZED_BIT, 0x4000});
  switch (r.integer(0, 4)) {
  case 0: gl.CopyBufferSubData(target, other, a, b, size); return "";
  case 1: {
    auto* bytes = static_cast<GLubyte*>(gl.MapBufferRange(target, a, size, access));
    if (bytes && (access & GL_MAP_WRITE_BIT)) bytes[0] = GLubyte(a), bytes[size - 1] = GLubyte(b);
    return bytes ? "mapped" : "no";
  }
  case 2: gl.FlushMappedBufferRange(target, a, size); return "";
  case 3: return gl.UnmapBuffer(target) ? "unmapped" : "no";
  default: {
    GLint values[5] = {};
    const GLenum names[5] = {GL_BUFFER_SIZE, GL_BUFFER_MAPPED, GL_BUFFER_ACCESS_FLAGS, GL_BUFFER_MAP_OFFSET,
                             GL_BUFFER_MAP_LENGTH};
    std::string text;
    for (int i = 0; i < 5; ++i) gl.GetBufferParameteriv(target, names[i], &values[i]);
    for (const GLint v : values) text += std::to_string(v) + ",";
    return text;
  }
  }
}

TEST_CASE("buffers are mapped and copied as OSMesa's are", "[spec][buffers]") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::string answers[2];
    for (int i = 0; i < 2; ++i) {
      const Gl& gl = i ? osmesa_library() : softgl_library();
      CurrentContext context(gl);
      Random r(seed);
      std::string bytes(kBytes, 0);
      for (char& byte : bytes) byte = char(r.bits());
      const GLenum targets[] = {GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_ARRAY_BUFFER,
                                GL_PIXEL_PACK_BUFFER};
      for (GLuint k = 0; k < 4; ++k) {
        gl.BindBuffer(targets[k], k == 3 ? 1 : k + 1);
        if (k < 3) gl.BufferData(targets[k], kBytes, bytes.data(), GL_STATIC_DRAW);
      }
      for (int k = 0; k < 16; ++k) {
        answers[i] += random_command(gl, r);
        answers[i] += " " + std::to_string(gl.GetError()) + "\n";
      }
      for (const GLenum target : targets) {
        gl.UnmapBuffer(target);
        while (gl.GetError() != GL_NO_ERROR) {}
        gl.GetBufferSubData(target, 0, kBytes, bytes.data());
        answers[i] += bytes;
      }
    }
    INFO("seed " << seed);
    CHECK((answers[0] == answers[1]));
  }
}

TEST_CASE("a draw keeps the vertices that a buffer had", "[spec][buffers]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const GLfloat whole[6] = {-1, -1, 3, -1, -1, 3}, nowhere[6] = {};
  gl.BindBuffer(GL_COPY_READ_BUFFER, 2);
  gl.BufferData(GL_COPY_READ_BUFFER, sizeof nowhere, nowhere, GL_STATIC_DRAW);
  gl.BindBuffer(GL_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof whole, whole, GL_STATIC_DRAW);
  gl.VertexPointer(2, GL_FLOAT, 0, nullptr);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, sizeof whole);
  GLubyte pixel[4] = {};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK(int(pixel[0]) == 255);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  CHECK(int(pixel[0]) == 0);
}

} // namespace
} // namespace softgl::test
