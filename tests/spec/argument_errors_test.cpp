// Arguments that no other test of errors has: with them each enum and each size of each command is refused
// once (GL 1.5, 2.5), and each state in which the specification forbids a command has its call
// (error_rows.tsv).
#include <catch2/catch.hpp>

#include <string>

#include "spec/refused_calls.h"

using namespace softgl::test;

namespace {

unsigned char bytes[4096];
GLfloat floats[64];
GLdouble doubles[64];
GLint numbers[64];
const void* const index_arrays[1] = {bytes};
const GLsizei counts[1] = {1};
const GLint firsts[1] = {0}, bases[1] = {0};
const std::string long_text(5000, 'x');

} // namespace

REFUSAL_TEST_CASE("queries refuse each of their names", "[spec][errors]") { // 6.1.3
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, GetMapfv(GL_MAP1_VERTEX_3, GL_POSITION, floats)),
      BAD(INVALID_ENUM, GetMapdv(GL_VERTEX_ARRAY, GL_COEFF, doubles)),
      BAD(INVALID_ENUM, GetMapiv(GL_MAP2_NORMAL, GL_NORMALIZE, numbers)),
      BAD(INVALID_ENUM, GetLightfv(GL_LIGHT0, GL_SHININESS, floats)),
      BAD(INVALID_ENUM, GetLightiv(GL_LIGHT0 + 8, GL_AMBIENT, numbers)),
      BAD(INVALID_ENUM, GetMaterialfv(GL_BACK, GL_POSITION, floats)),
      BAD(INVALID_ENUM, GetMaterialiv(GL_FRONT_AND_BACK, GL_AMBIENT, numbers)),
      BAD(INVALID_ENUM, GetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_TEXTURE_WRAP_S, floats)),
      BAD(INVALID_OPERATION,
          GetTexLevelParameterfv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, floats)),
      BAD(INVALID_ENUM, GetTexEnvfv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, floats)),
      BAD(INVALID_ENUM, GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, floats)),
      BAD(INVALID_ENUM, GetTexGenfv(GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_MODE, floats)),
      BAD(INVALID_ENUM, GetTexGendv(GL_Q + 1, GL_EYE_PLANE, doubles)),
      BAD(INVALID_ENUM, GetTexGendv(GL_Q, GL_TEXTURE_ENV_MODE, doubles)),
      BAD(INVALID_ENUM, GetTexGeniv(GL_S, GL_TEXTURE_GEN_S, numbers)),
      BAD(INVALID_OPERATION, GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, numbers)), // 2.9: buffer 0
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("commands of state refuse each of their names", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, ProvokingVertex(GL_FLAT)),              // GL_ARB_provoking_vertex
      BAD(INVALID_ENUM, ClampColor(GL_CLAMP_TO_EDGE, GL_TRUE)), // GL_ARB_color_buffer_float
      BAD(INVALID_ENUM, ClampColor(GL_CLAMP_READ_COLOR, 2)),
      BAD(INVALID_ENUM, StencilOp(GL_KEEP, GL_KEEP, GL_FRONT)), // 4.1.5
      BAD(INVALID_ENUM, StencilOp(GL_KEEP, GL_LESS, GL_KEEP)),
      BAD(INVALID_ENUM, StencilOpSeparate(GL_FRONT, GL_SET, GL_KEEP, GL_KEEP)),
      BAD(INVALID_ENUM, StencilOpSeparate(GL_FRONT, GL_KEEP, GL_SET, GL_KEEP)),
      BAD(INVALID_ENUM, BlendFuncSeparate(GL_MIN, GL_ONE, GL_ONE, GL_ONE)), // 4.1.8
      BAD(INVALID_ENUM, BlendFuncSeparate(GL_ONE, GL_SRC_ALPHA_SATURATE, GL_ONE, GL_ONE)),
      BAD(INVALID_ENUM, ReadBuffer(GL_FOG)),                            // 4.3.2
      BAD(INVALID_VALUE, LightModelf(GL_LIGHT_MODEL_TERMS_SOFTGL, -1)), // GL_SOFTGL_phong_illumination
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("a parameter of several values has no scalar form", "[spec][errors]") { // 2.14.2, 3.8.13
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, Lightf(GL_LIGHT1, GL_AMBIENT, 1)),
      BAD(INVALID_ENUM, Lighti(GL_LIGHT1, GL_DIFFUSE, 1)),
      BAD(INVALID_ENUM, Lightf(GL_LIGHT1, GL_SPECULAR, 1)),
      BAD(INVALID_ENUM, Lighti(GL_LIGHT1, GL_SPOT_DIRECTION, 1)),
      BAD(INVALID_ENUM, Materialf(GL_BACK, GL_DIFFUSE, 1)),
      BAD(INVALID_ENUM, Materiali(GL_BACK, GL_SPECULAR, 1)),
      BAD(INVALID_ENUM, Materialf(GL_BACK, GL_EMISSION, 1)),
      BAD(INVALID_ENUM, Materiali(GL_BACK, GL_AMBIENT_AND_DIFFUSE, 1)),
      BAD(INVALID_ENUM, PointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1)),
      BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1)),
      BAD(INVALID_ENUM, TexGend(GL_S, GL_EYE_PLANE, 1)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("values that the text refuses by name", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP)), // 2.11.4
      BAD(INVALID_ENUM, TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP)),
      BAD(INVALID_VALUE, PixelStorei(GL_UNPACK_ALIGNMENT, 3)), // 3.6.1
      BAD(INVALID_VALUE, PixelStorei(GL_PACK_ALIGNMENT, 0)),
      BAD(INVALID_ENUM, CopyTexImage2D(GL_TEXTURE_2D, 0, 4, 0, 0, 4, 4, 0)), // 3.8.2
      BAD(INVALID_ENUM, TexSubImage2D(GL_PROXY_TEXTURE_CUBE_MAP, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE,
                                      bytes)), // 3.8.11
      BAD(INVALID_ENUM, GetTexImage(GL_PROXY_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM,
          CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_ALPHA, 4, 4, 0, 16, bytes)), // 3.8.3
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_LUMINANCE, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM,
          CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_LUMINANCE_ALPHA, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, CompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_INTENSITY, 4, 4, 0, 16, bytes)),
      BAD(INVALID_ENUM, TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_LINEAR)), // 3.8.4
      BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGBA)),    // 3.8.13
      BAD(INVALID_ENUM, TexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_ALPHA, GL_ONE_MINUS_SRC_COLOR)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("several draws at once may not be fewer than none", "[spec][errors]") { // 2.8
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, MultiDrawArrays(GL_POINTS, firsts, counts, -1)),
      BAD(INVALID_VALUE, MultiDrawElements(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, -1)),
      BAD(INVALID_VALUE,
          MultiDrawElementsBaseVertex(GL_POINTS, counts, GL_UNSIGNED_BYTE, index_arrays, -1, bases)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("images of three dimensions refuse each argument", "[spec][errors]") { // 3.8.1, 3.8.2
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                nullptr);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE,
          TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, -1, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM,
          TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_INTENSITY, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 4, 4, 4, 0, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_VALUE,
          TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, -4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 5, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage3D(GL_TEXTURE_3D, 0, 5, 0, 0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_VALUE, TexSubImage3D(GL_TEXTURE_3D, 0, 0, 5, 0, 4, 0, 4, GL_RGBA, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM,
          TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_INTENSITY, GL_UNSIGNED_BYTE, bytes)),
      BAD(INVALID_ENUM, TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 4, 4, 4, GL_RGBA, GL_BITMAP, bytes)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, 0, 0, 4, -1)),
      BAD(INVALID_VALUE, CopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 4, 0, 0, 4, 4)),
      BAD(INVALID_VALUE, CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, -4,
                                                 GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, bytes)),
      BAD(INVALID_VALUE,
          CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, -1, bytes)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("storage of one and three dimensions refuses each argument",
                  "[spec][errors][texture_storage]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D}) gl.BindTexture(target, target);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, TexStorage1D(GL_TEXTURE_1D, 0, GL_RGBA8, 4)),
      BAD(INVALID_ENUM, TexStorage1D(GL_TEXTURE_1D, 1, GL_RGBA, 4)),
      BAD(INVALID_VALUE, TexStorage1D(GL_TEXTURE_1D, 1, GL_RGBA8, 0)),
      BAD(INVALID_OPERATION, TexStorage1D(GL_TEXTURE_1D, 4, GL_RGBA8, 4)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 0, 4)),
      BAD(INVALID_VALUE, TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 4, 0)),
      BAD(INVALID_VALUE, TexStorage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 4, 4, 4)),
      BAD(INVALID_ENUM, TexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA, 4, 4, 4)),
      BAD(INVALID_ENUM, TexStorage3D(GL_TEXTURE_3D, 1, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 4, 4, 4)),
      BAD(INVALID_VALUE, TexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 0, 4, 4)),
      BAD(INVALID_VALUE, TexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 4, 0, 4)),
      BAD(INVALID_VALUE, TexStorage3D(GL_TEXTURE_3D, 1, GL_RGBA8, 4, 4, 0)),
      BAD(INVALID_OPERATION, TexStorage3D(GL_TEXTURE_3D, 4, GL_RGBA8, 4, 4, 4)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("attachments refuse each argument",
                  "[spec][errors][framebuffers]") { // GL_ARB_framebuffer_object
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.BindTexture(GL_TEXTURE_1D, 7);
  gl.BindTexture(GL_TEXTURE_3D, 8);
  GLuint renderbuffer = 0;
  gl.GenRenderbuffers(1, &renderbuffer);
  gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, FramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR, GL_TEXTURE_1D, 7, 0)),
      BAD(INVALID_ENUM, FramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FOG, 7, 0)),
      BAD(INVALID_VALUE, FramebufferTexture1D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_1D, 7, -1)),
      BAD(INVALID_ENUM, FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR, GL_TEXTURE_3D, 8, 0, 0)),
      BAD(INVALID_ENUM, FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FOG, 8, 0, 0)),
      BAD(INVALID_VALUE, FramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, 8, 99, 0)),
      BAD(INVALID_ENUM, FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR, 8, 0, 0)),
      BAD(INVALID_VALUE, RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, -1, 4)),
  };
  expect_refused(gl, calls);
}

REFUSAL_TEST_CASE("texts are not longer than allowed", "[spec][errors][debug]") { // GL_KHR_debug
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindTexture(GL_TEXTURE_2D, 77);
  static const BadCall calls[] = {
      BAD(INVALID_VALUE, DebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_OTHER, 0,
                                            GL_DEBUG_SEVERITY_HIGH, 5000, long_text.c_str())),
      BAD(INVALID_VALUE, PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, 5000, long_text.c_str())),
      BAD(INVALID_VALUE, ObjectLabel(GL_TEXTURE, 77, 5000, long_text.c_str())),
      BAD(INVALID_VALUE, GetObjectPtrLabel(bytes, -1, nullptr, nullptr)),
  };
  expect_refused(gl, calls, [] {});
  for (int i = 1; i < 64; ++i) gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, 1, "x");
  static const BadCall deepest[] = {
      BAD(STACK_OVERFLOW, PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, 1, "x"))};
  expect_refused(gl, deepest, [] {});
}

REFUSAL_TEST_CASE("what is open is not opened once more", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  static const BadCall begin[] = {
    BAD(INVALID_OPERATION, Begin(GL_POINTS); gl.Begin(GL_LINES); gl.End())
  }; // 2.6.3
  expect_refused(gl, begin);
  static const BadCall list[] = {
    BAD(INVALID_OPERATION, NewList(1, GL_COMPILE); gl.NewList(2, GL_COMPILE); gl.EndList())
  }; // 5.4
  expect_refused(gl, list, [] {});
  CHECK(gl.IsList(2) == GL_FALSE);
  gl.LockArraysEXT(0, 4); // GL_EXT_compiled_vertex_array
  static const BadCall lock[] = {BAD(INVALID_OPERATION, LockArraysEXT(0, 8))};
  expect_refused(gl, lock);
  gl.UnlockArraysEXT();
}

REFUSAL_TEST_CASE("a mapped buffer, or one that is too small, gives and takes nothing",
                  "[spec][errors]") { // 2.9
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 1);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 64, bytes, GL_STATIC_DRAW);
  gl.MapBuffer(GL_ELEMENT_ARRAY_BUFFER, GL_READ_ONLY);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, floats);
  static const void* const offsets[1] = {nullptr};
  static const BadCall draws[] = {
      BAD(INVALID_OPERATION, DrawElementsBaseVertex(GL_POINTS, 1, GL_UNSIGNED_BYTE, nullptr, 0)),
      BAD(INVALID_OPERATION, DrawRangeElementsBaseVertex(GL_POINTS, 0, 1, 1, GL_UNSIGNED_BYTE, nullptr, 0)),
      BAD(INVALID_OPERATION,
          MultiDrawElementsBaseVertex(GL_POINTS, counts, GL_UNSIGNED_BYTE, offsets, 1, bases)),
  };
  expect_refused(gl, draws);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 2); // GL_ARB_pixel_buffer_object
  gl.BufferData(GL_PIXEL_PACK_BUFFER, 0, nullptr, GL_STATIC_DRAW);
  static const BadCall packs[] = {
      BAD(INVALID_OPERATION, GetPixelMapuiv(GL_PIXEL_MAP_I_TO_R, nullptr)),
      BAD(INVALID_OPERATION, GetPixelMapusv(GL_PIXEL_MAP_I_TO_R, nullptr)),
  };
  expect_refused(gl, packs, [] {});
}

REFUSAL_TEST_CASE("an incomplete framebuffer is accumulated to and copied from as little as drawn to",
                  "[spec][errors][framebuffers]") { // GL_ARB_framebuffer_object, 4.4.4.2
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  static const BadCall calls[] = {
      BAD(INVALID_FRAMEBUFFER_OPERATION, Accum(GL_LOAD, 1)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, CopyTexSubImage1D(GL_TEXTURE_1D, 0, 0, 0, 0, 4)),
  };
  expect_refused(gl, calls);
}
