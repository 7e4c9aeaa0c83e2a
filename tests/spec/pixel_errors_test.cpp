// The errors that GL 1.5 names for pixels, the framebuffer, occlusion queries and the queries of state. Each
// is raised by a call that is wrong in nothing else, and changes nothing.
#include <catch2/catch.hpp>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

unsigned char bytes[1 << 16];
GLfloat floats[512];
GLdouble doubles[16];
GLuint names[512];
GLushort shorts[512];
GLint numbers[16];

// A window without depth, stencil and accumulation buffer.
class BareContext {
public:
  explicit BareContext(const Gl& gl)
      : gl_(gl), context_(gl.OSMesaCreateContextExt(kOSMesaRgba, 0, 0, 0, nullptr)) {
    REQUIRE(gl.OSMesaMakeCurrent(context_, buffer_, GL_UNSIGNED_BYTE, 16, 16));
  }
  ~BareContext() {
    gl_.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    gl_.OSMesaDestroyContext(context_);
  }
  BareContext(const BareContext&) = delete;

private:
  const Gl& gl_;
  void* context_;
  unsigned char buffer_[16 * 16 * 4] = {};
};

} // namespace

REFUSAL_TEST_CASE("pixel storage, transfer and maps refuse what is wrong in one argument",
                  "[spec][errors]") { // 3.6.1 to 3.6.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, PixelStorei(GL_ZOOM_X, 1)),
      BAD(INVALID_ENUM, PixelStoref(0, 1)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_SKIP_ROWS, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_SKIP_PIXELS, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_SKIP_IMAGES, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_IMAGE_HEIGHT, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_ALIGNMENT, 16)),
      BAD(INVALID_VALUE, PixelStorei(GL_PACK_ROW_LENGTH, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_PACK_SKIP_PIXELS, -1)),
      BAD(INVALID_VALUE, PixelStorei(GL_PACK_SKIP_IMAGES, -1)),
      BAD(INVALID_VALUE, PixelStoref(GL_PACK_IMAGE_HEIGHT, -1)),
      BAD(INVALID_VALUE, PixelStoref(GL_PACK_ALIGNMENT, 6)),
      BAD(INVALID_ENUM, PixelTransferi(GL_PIXEL_MAP_R_TO_R, 1)),
      BAD(INVALID_ENUM, PixelTransferf(GL_MAP1_COLOR_4, 1)),
      BAD(INVALID_ENUM, PixelMapfv(GL_MAP_COLOR, 2, floats)),
      BAD(INVALID_VALUE, PixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, floats)),
      BAD(INVALID_VALUE, PixelMapfv(GL_PIXEL_MAP_R_TO_R, 257, floats)),
      BAD(INVALID_VALUE, PixelMapfv(GL_PIXEL_MAP_I_TO_R, 3, floats)),
      BAD(INVALID_ENUM, PixelMapuiv(0, 2, names)),
      BAD(INVALID_VALUE, PixelMapuiv(GL_PIXEL_MAP_S_TO_S, 5, names)),
      BAD(INVALID_VALUE, PixelMapuiv(GL_PIXEL_MAP_A_TO_A, -1, names)),
      BAD(INVALID_ENUM, PixelMapusv(GL_RGBA, 2, shorts)),
      BAD(INVALID_VALUE, PixelMapusv(GL_PIXEL_MAP_I_TO_I, 12, shorts)),
      BAD(INVALID_VALUE, PixelMapusv(GL_PIXEL_MAP_G_TO_G, 500, shorts)),
      BAD(INVALID_ENUM, GetPixelMapfv(GL_RGBA, floats)),
      BAD(INVALID_ENUM, GetPixelMapuiv(GL_PIXEL_MAP_A_TO_A + 1, names)),
      BAD(INVALID_ENUM, GetPixelMapusv(0, shorts)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("drawing, copying and reading pixels refuse what is wrong in one argument",
                  "[spec][errors]") { // 3.6.4, 3.7, 4.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, DrawPixels(-1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, DrawPixels(1, -1, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, DrawPixels(1, 1, GL_RGBA8, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, DrawPixels(1, 1, GL_RGBA, GL_DOUBLE, bytes)),
      BAD(INVALID_ENUM, DrawPixels(1, 1, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_ENUM, DrawPixels(1, 1, GL_DEPTH_COMPONENT, GL_BITMAP, bytes)),
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2, bytes)),
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_LUMINANCE, GL_UNSIGNED_SHORT_5_6_5_REV, bytes)),
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_RGB, GL_UNSIGNED_INT_10_10_10_2, bytes)),
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_BGR, GL_UNSIGNED_SHORT_1_5_5_5_REV, bytes)),
      BAD(INVALID_ENUM, DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_FLOAT, bytes)),
      BAD(INVALID_VALUE, CopyPixels(0, 0, -1, 1, GL_COLOR)),
      BAD(INVALID_VALUE, CopyPixels(0, 0, 1, -1, GL_DEPTH)),
      BAD(INVALID_ENUM, CopyPixels(0, 0, 1, 1, GL_RGBA)),
      BAD(INVALID_VALUE, Bitmap(-1, 1, 0, 0, 1, 1, bytes)),
      BAD(INVALID_VALUE, Bitmap(1, -1, 0, 0, 1, 1, bytes)),
      BAD(INVALID_ENUM, ReadPixels(0, 0, 1, 1, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8_REV, bytes)),
      BAD(INVALID_ENUM, ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, Accum(GL_MODULATE, 1)),
      BAD(INVALID_OPERATION, Accum(GL_ACCUM, 1)), // the window has no accumulation buffer
      BAD(INVALID_OPERATION, Accum(GL_RETURN, 1)),
      BAD(INVALID_VALUE, Clear(GL_COLOR_BUFFER_BIT | GL_FOG_BIT)),
      BAD(INVALID_ENUM, DrawBuffer(GL_COLOR)),
      BAD(INVALID_OPERATION, DrawBuffer(GL_BACK_RIGHT)),
      BAD(INVALID_OPERATION, DrawBuffer(GL_FRONT_RIGHT)),
      BAD(INVALID_OPERATION, DrawBuffer(GL_AUX1)),
      BAD(INVALID_ENUM, ReadBuffer(GL_DEPTH)),
      BAD(INVALID_OPERATION, ReadBuffer(GL_AUX3)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("pixels of buffers that the window does not have are refused",
                  "[spec][errors]") { // 4.3.1, 4.3.2
  const Gl& gl = softgl_library();
  BareContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, DrawPixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
      BAD(INVALID_OPERATION, CopyPixels(0, 0, 1, 1, GL_STENCIL)),
      BAD(INVALID_OPERATION, CopyPixels(0, 0, 1, 1, GL_DEPTH)),
      BAD(INVALID_OPERATION, CopyPixels(0, 0, 1, 1, GL_DEPTH_STENCIL)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, bytes)),
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes)),
      BAD(INVALID_OPERATION, CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 4, 4, 0)),
      BAD(INVALID_OPERATION, CopyTexImage1D(GL_TEXTURE_1D, 0, GL_DEPTH_COMPONENT24, 0, 0, 4, 0)),
      BAD(INVALID_OPERATION, Accum(GL_LOAD, 1)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("pixels of a buffer object lie inside of it",
                  "[spec][errors]") { // GL_ARB_pixel_buffer_object
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 1);
  gl.BufferData(GL_PIXEL_UNPACK_BUFFER, 64, bytes, GL_STATIC_DRAW);
  static const BadCall unpack[] = {
      BAD(INVALID_OPERATION, DrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_OPERATION, Bitmap(64, 64, 0, 0, 0, 0, nullptr)),
      BAD(INVALID_OPERATION,
          TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_OPERATION, TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_OPERATION, PolygonStipple(nullptr)),
      BAD(INVALID_OPERATION, PixelMapfv(GL_PIXEL_MAP_R_TO_R, 32, nullptr)),
      BAD(INVALID_OPERATION, PixelMapuiv(GL_PIXEL_MAP_R_TO_R, 32, nullptr)),
      BAD(INVALID_OPERATION, PixelMapusv(GL_PIXEL_MAP_R_TO_R, 64, nullptr)),
  };
  expect_refused(gl, unpack);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 1);
  static const BadCall pack[] = {
      BAD(INVALID_OPERATION, ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_OPERATION, GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr)),
      BAD(INVALID_OPERATION, GetPolygonStipple(nullptr)),
  };
  expect_refused(gl, pack, [] {});
}

REFUSAL_TEST_CASE("occlusion queries refuse what is wrong in one argument",
                  "[spec][errors]") { // 4.1.7, 6.1.12
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BeginQuery(GL_SAMPLES_PASSED, 3);
  gl.EndQuery(GL_SAMPLES_PASSED);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, BeginQuery(GL_QUERY_RESULT, 1)),
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, 0)),
      BAD(INVALID_ENUM, EndQuery(GL_FLOAT)),
      BAD(INVALID_OPERATION, EndQuery(GL_SAMPLES_PASSED)),
      BAD(INVALID_VALUE, GenQueries(-1, names)),
      BAD(INVALID_VALUE, DeleteQueries(-1, names)),
      BAD(INVALID_ENUM, GetQueryiv(GL_QUERY_RESULT, GL_CURRENT_QUERY, numbers)),
      BAD(INVALID_ENUM, GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_RESULT, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectiv(0, GL_QUERY_RESULT, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectuiv(9, GL_QUERY_RESULT, names)),
      BAD(INVALID_ENUM, GetQueryObjectiv(3, GL_CURRENT_QUERY, numbers)),
      BAD(INVALID_ENUM, GetQueryObjectuiv(3, GL_SAMPLES_PASSED, names)),
  };
  expect_refused(gl, calls);
  gl.BeginQuery(GL_SAMPLES_PASSED, 4);
  static const BadCall counting[] = {
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, 3)),
      BAD(INVALID_OPERATION, BeginQuery(GL_SAMPLES_PASSED, 4)),
      BAD(INVALID_OPERATION, GetQueryObjectiv(4, GL_QUERY_RESULT, numbers)),
      BAD(INVALID_OPERATION, GetQueryObjectuiv(4, GL_QUERY_RESULT_AVAILABLE, names)),
      BAD(INVALID_OPERATION, GenQueries(1, names)),
      BAD(INVALID_OPERATION, DeleteQueries(1, names)),
  };
  expect_refused(gl, counting);
}

REFUSAL_TEST_CASE("queries of state refuse names that they do not know", "[spec][errors]") { // 6.1
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, GetBooleanv(GL_RGBA, bytes)),
      BAD(INVALID_ENUM, GetIntegerv(0, numbers)),
      BAD(INVALID_ENUM, GetFloatv(GL_AMBIENT, floats)),
      BAD(INVALID_ENUM, GetDoublev(GL_TEXTURE_WIDTH, doubles)),
      BAD(INVALID_ENUM, GetInteger64v(GL_RGBA, reinterpret_cast<GLint64*>(bytes))),
      BAD(INVALID_ENUM, IsEnabled(GL_RGBA)),
      BAD(INVALID_ENUM, GetClipPlane(GL_CLIP_PLANE0 + 8, doubles)),
      BAD(INVALID_ENUM, GetClipPlane(0, doubles)),
      BAD(INVALID_ENUM, GetLightfv(GL_LIGHT0 + 8, GL_AMBIENT, floats)),
      BAD(INVALID_ENUM, GetLightiv(GL_LIGHT0, GL_EMISSION, numbers)),
      BAD(INVALID_ENUM, GetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, floats)),
      BAD(INVALID_ENUM, GetMaterialiv(GL_BACK, GL_POSITION, numbers)),
      BAD(INVALID_ENUM, GetPointerv(GL_ARRAY_BUFFER, reinterpret_cast<void**>(bytes))),
      BAD(INVALID_ENUM, GetString(0)),
      BAD(INVALID_ENUM, GetStringi(GL_VENDOR, 0)),
      BAD(INVALID_VALUE, GetStringi(GL_EXTENSIONS, 1000)),
      BAD(INVALID_ENUM, Enable(GL_RGBA)),
      BAD(INVALID_ENUM, Disable(GL_LIGHT0 + 8)),
      BAD(INVALID_ENUM, Enable(GL_CLIP_PLANE0 + 8)),
      BAD(INVALID_ENUM, Hint(GL_GENERATE_MIPMAP, GL_FASTEST)),
      BAD(INVALID_ENUM, Hint(GL_TEXTURE_COMPRESSION_HINT, GL_TRUE)),
  };
  expect_refused(gl, calls);
}
