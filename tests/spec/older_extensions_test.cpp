// Small extensions of other vendors that share what OpenGL 1.5 and newer extensions have: GL_MESA_window_pos,
// GL_IBM_rasterpos_clip, GL_IBM_multimode_draw_arrays, GL_S3_s3tc, GL_OES_read_format, GL_ARB_debug_output,
// GL_EXT_debug_label.
#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "spec/refused_calls.h"
#include "spec/state_snapshot.h"

namespace softgl::test {
namespace {

std::vector<float> raster_position(const Gl& gl) {
  std::vector<float> v(5);
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, v.data());
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, &v[4]);
  return v;
}

/// What both libraries answer, in contexts of their own.
template <class Script> auto same_answer(Script script) {
  const auto answer = [&](const Gl& gl) {
    CurrentContext context(gl);
    auto result = script(gl);
    CHECK(gl.GetError() == GL_NO_ERROR);
    return result;
  };
  const auto ours = answer(softgl_library());
  CHECK(ours == answer(osmesa_library()));
  return ours;
}

std::vector<GLubyte> window_pixels(const Gl& gl) {
  std::vector<GLubyte> pixels(64 * 64 * 4);
  gl.ReadPixels(0, 0, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

} // namespace

TEST_CASE("the window position has a w of its own", "[spec][raster]") {
  const auto positions = same_answer([](const Gl& gl) {
    const GLdouble d[4] = {1.5, 2, 0.25, 3};
    const GLfloat f[4] = {2.5f, -1, 2, 0};
    const GLint i[4] = {3, 4, 0, -2};
    const GLshort s[4] = {5, 6, 1, 7};
    std::vector<std::vector<float>> seen;
    const auto see = [&] { seen.push_back(raster_position(gl)); };
    gl.DepthRange(0.5, 0.75);
    gl.WindowPos4dMESA(d[0], d[1], d[2], d[3]), see();
    gl.WindowPos4fMESA(f[0], f[1], f[2], f[3]), see();
    gl.WindowPos4iMESA(i[0], i[1], i[2], i[3]), see();
    gl.WindowPos4sMESA(s[0], s[1], s[2], s[3]), see();
    gl.WindowPos4dvMESA(d), see();
    gl.WindowPos4fvMESA(f), see();
    gl.WindowPos4ivMESA(i), see();
    gl.NewList(1, GL_COMPILE);
    gl.WindowPos4svMESA(s);
    gl.EndList();
    gl.CallList(1), see();
    gl.WindowPos2f(8, 9), see();
    return seen;
  });
  CHECK(positions[0] == std::vector<float>{1.5f, 2, 0.5625f, 3, 1});
  CHECK(positions[8][3] == 1);
}

TEST_CASE("the raster position may lie beside the view volume", "[spec][raster]") {
  const auto positions = same_answer([](const Gl& gl) {
    std::vector<std::vector<float>> seen;
    const GLfloat points[][4] = {{5, -7, 0, 1}, {0, 0, 2, 1}, {5, 0, -3, 1}, {9, 0, 0, -1}, {0.5f, 0, 0, 1}};
    for (const bool on : {false, true}) {
      on ? gl.Enable(GL_RASTER_POSITION_UNCLIPPED_IBM) : gl.Disable(GL_RASTER_POSITION_UNCLIPPED_IBM);
      for (const GLfloat* p : points) gl.RasterPos4fv(p), seen.push_back(raster_position(gl));
    }
    const GLdouble plane[4] = {1, 0, 0, 0};
    gl.ClipPlane(GL_CLIP_PLANE0, plane);
    gl.Enable(GL_CLIP_PLANE0);
    gl.RasterPos2f(-5, 0), seen.push_back(raster_position(gl));
    return seen;
  });
  CHECK(positions[0][4] == 0);
  CHECK(positions[5][4] == 1);
  CHECK(positions[6][4] == 0);  // z clips as ever
  CHECK(positions[10][4] == 0); // and so do the program's planes
}

TEST_CASE("whether the raster position is clipped is saved with what can be enabled",
          "[spec][raster][deviation]") {
  const auto restored = [](const Gl& gl, GLbitfield group) {
    CurrentContext context(gl);
    gl.PushAttrib(group);
    gl.Enable(GL_RASTER_POSITION_UNCLIPPED_IBM);
    gl.PopAttrib();
    CHECK(gl.GetError() == GL_NO_ERROR);
    return !gl.IsEnabled(GL_RASTER_POSITION_UNCLIPPED_IBM);
  };
  for (const GLbitfield group : {GL_TRANSFORM_BIT, GL_ENABLE_BIT}) CHECK(restored(softgl_library(), group));
  CHECK(restored(osmesa_library(), GL_ENABLE_BIT));
  CHECK_FALSE(restored(osmesa_library(), GL_TRANSFORM_BIT));
  CHECK_FALSE(restored(softgl_library(), GL_FOG_BIT));
}

TEST_CASE("draws of several modes are draws one by one", "[spec][arrays]") {
  const GLfloat positions[][2] = {{-0.9f, -0.9f}, {0.9f, -0.9f}, {0, 0.2f},
                                  {-0.8f, 0.8f},  {0.8f, 0.7f},  {0.3f, 0.5f}};
  const GLenum modes[] = {GL_TRIANGLES, GL_ZERO, GL_LINE_STRIP, GL_ZERO, GL_POINTS, GL_ZERO};
  const GLint firsts[] = {0, 3, 2};
  const GLsizei counts[] = {3, 3, 0};
  const GLubyte indices[] = {0, 1, 2, 3, 4, 5};
  const void* const where[] = {indices, indices + 3, indices};
  const auto draws = [&](const Gl& gl, bool elements, bool in_list) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, positions);
    if (in_list) gl.NewList(1, GL_COMPILE);
    elements ? gl.MultiModeDrawElementsIBM(modes, counts, GL_UNSIGNED_BYTE, where, 3, 8)
             : gl.MultiModeDrawArraysIBM(modes, firsts, counts, 3, 8);
    if (in_list) gl.EndList(), gl.CallList(1);
    return window_pixels(gl);
  };
  const auto picture = same_answer([&](const Gl& gl) { return draws(gl, false, false); });
  CHECK(picture != std::vector<GLubyte>(picture.size()));
  for (const bool elements : {false, true})
    for (const bool in_list : {false, true})
      CHECK(picture == same_answer([&](const Gl& gl) { return draws(gl, elements, in_list); }));
}

TEST_CASE("the older names of S3TC store what the newer ones do", "[spec][textures]") {
  GLubyte texels[16 * 4];
  for (int i = 0; i < 64; ++i) texels[i] = GLubyte(7 * i);
  const auto blocks = [&](const Gl& gl, GLenum format) {
    CurrentContext context(gl);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format), 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    GLint name = 0, size = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &name);
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &size);
    std::vector<int> kept = {name, size};
    GLubyte bytes[16] = {};
    gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, bytes);
    kept.insert(kept.end(), bytes, bytes + size);
    gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, 4, 4, 0, size, bytes);
    GLubyte read[64];
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read);
    kept.insert(kept.end(), read, read + 64);
    CHECK(gl.GetError() == GL_NO_ERROR);
    return kept;
  };
  constexpr GLenum kRgb[] = {0x83A0, 0x83A1}, kRgba[] = {0x83A2, 0x83A3}; // GL_RGB_S3TC, ..., GL_RGBA4_S3TC
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    for (const GLenum name : kRgb) CHECK(blocks(*gl, name) == blocks(*gl, GL_COMPRESSED_RGB_S3TC_DXT1_EXT));
    for (const GLenum name : kRgba) CHECK(blocks(*gl, name) == blocks(*gl, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT));
  }
}

TEST_CASE("colors are best read as they are stored", "[spec][pixels]") { // GL_OES_read_format
  const auto preferred = [](const Gl& gl) {
    std::vector<GLint> v(2);
    gl.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_FORMAT, &v[0]);
    gl.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE, &v[1]);
    return v;
  };
  CHECK(same_answer(preferred) == std::vector<GLint>{GL_RGBA, GL_UNSIGNED_BYTE});
  for (const GLint format : {GL_RGBA8,       GL_RGB8,       GL_RGB565,       GL_RGBA4,
                             GL_RGB5_A1,     GL_RGB10_A2,   GL_RGBA16,       GL_RGBA16F,
                             GL_RGBA32F,     GL_R8,         GL_RG8,          GL_ALPHA8,
                             GL_LUMINANCE8,  GL_INTENSITY8, GL_SRGB8_ALPHA8, GL_R11F_G11F_B10F,
                             GL_RGBA8_SNORM, GL_R16F,       GL_RG32F,        GL_RGBA16_SNORM,
                             GL_R16}) {
    INFO("format " << format);
    same_answer([&](const Gl& gl) {
      GLuint framebuffer = 0, texture = 0;
      gl.GenFramebuffers(1, &framebuffer);
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      gl.GenTextures(1, &texture);
      gl.BindTexture(GL_TEXTURE_2D, texture);
      gl.TexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
      return preferred(gl);
    });
  }
  CurrentContext context(softgl_library());
  GLuint incomplete = 0;
  softgl_library().GenFramebuffers(1, &incomplete);
  softgl_library().BindFramebuffer(GL_FRAMEBUFFER, incomplete);
  CHECK(preferred(softgl_library()) == std::vector<GLint>{GL_NONE, GL_NONE});
  CHECK(softgl_library().GetError() == GL_NO_ERROR);
  const auto of_window = [&](const Gl& gl, GLenum format) {
    void* const context = gl.OSMesaCreateContextExt(format, 0, 0, 0, nullptr);
    std::vector<GLubyte> memory(8 * 8 * 4);
    REQUIRE(gl.OSMesaMakeCurrent(context, memory.data(), GL_UNSIGNED_BYTE, 8, 8));
    const auto answer = preferred(gl);
    gl.OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    gl.OSMesaDestroyContext(context);
    return answer;
  };
  for (const GLenum format : {kOSMesaRgba, kOSMesaBgra})
    CHECK(of_window(softgl_library(), format) == of_window(osmesa_library(), format));
}

TEST_CASE("messages of errors have their older names", "[spec][debug]") { // GL_ARB_debug_output
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  const std::string names[] = {"DebugMessageControl", "DebugMessageInsert", "DebugMessageCallback",
                               "GetDebugMessageLog"};
  for (const std::string& name : names) {
    INFO(name);
    CHECK(gl.OSMesaGetProcAddress(("gl" + name + "ARB").c_str()) != nullptr);
  }
  const auto insert = reinterpret_cast<decltype(&glDebugMessageInsertARB)>(
      gl.OSMesaGetProcAddress("glDebugMessageInsertARB"));
  gl.Enable(GL_DEBUG_OUTPUT);
  insert(GL_DEBUG_SOURCE_APPLICATION_ARB, GL_DEBUG_TYPE_OTHER_ARB, 7, GL_DEBUG_SEVERITY_HIGH_ARB, -1, "here");
  GLchar text[16] = "";
  CHECK(gl.GetDebugMessageLog(1, 16, nullptr, nullptr, nullptr, nullptr, nullptr, text) == 1);
  CHECK(std::string(text) == "here");
}

TEST_CASE("labels have their older names", "[spec][debug]") { // GL_EXT_debug_label
  const auto labels = same_answer([](const Gl& gl) {
    gl.BindTexture(GL_TEXTURE_2D, 5);
    gl.BindBuffer(GL_ARRAY_BUFFER, 6);
    std::vector<std::string> seen;
    const auto see = [&](GLenum type, GLuint object) {
      GLchar text[16] = "?";
      GLsizei length = -1;
      gl.GetObjectLabelEXT(type, object, 16, &length, text);
      seen.push_back(text + (" " + std::to_string(length)));
    };
    see(GL_TEXTURE, 5);
    gl.LabelObjectEXT(GL_TEXTURE, 5, 0, "a texture");
    gl.LabelObjectEXT(GL_BUFFER_OBJECT_EXT, 6, 3, "buffer");
    see(GL_TEXTURE, 5), see(GL_BUFFER_OBJECT_EXT, 6);
    gl.ObjectLabel(GL_TEXTURE, 5, -1, "another");
    see(GL_TEXTURE, 5);
    gl.LabelObjectEXT(GL_TEXTURE, 5, 0, nullptr);
    see(GL_TEXTURE, 5);
    return seen;
  });
  CHECK(labels == std::vector<std::string>{" 0", "a texture 9", "buf 3", "another 7", " 0"});
}

REFUSAL_TEST_CASE("older extensions refuse what is wrong in one argument", "[spec][errors]") {
  const Gl& gl = softgl_library();
  CurrentContext context(gl);
  gl.BindTexture(GL_TEXTURE_2D, 5);
  static const GLenum points[1] = {GL_POINTS}, none[1] = {99};
  static const GLint negative[1] = {-1}, zero[1] = {0};
  static const GLsizei one[1] = {1};
  static const GLubyte indices[4] = {};
  static const void* const where[1] = {indices};
  static GLchar text[4];
  static const std::string long_text(300, 'x');
  static const BadCall calls[] = {
      BAD(INVALID_ENUM, MultiModeDrawArraysIBM(none, zero, one, 1, 0)),
      BAD(INVALID_VALUE, MultiModeDrawArraysIBM(points, negative, one, 1, 0)),
      BAD(INVALID_VALUE, MultiModeDrawArraysIBM(points, zero, one, -1, 0)),
      BAD(INVALID_ENUM, MultiModeDrawElementsIBM(none, one, GL_UNSIGNED_BYTE, where, 1, 0)),
      BAD(INVALID_ENUM, MultiModeDrawElementsIBM(points, one, GL_FLOAT, where, 1, 0)),
      BAD(INVALID_VALUE, MultiModeDrawElementsIBM(points, one, GL_UNSIGNED_BYTE, where, -1, 0)),
      BAD(INVALID_ENUM, LabelObjectEXT(GL_BUFFER, 5, 0, "x")),
      BAD(INVALID_OPERATION, LabelObjectEXT(GL_TEXTURE, 77, 0, "x")),
      BAD(INVALID_VALUE, LabelObjectEXT(GL_TEXTURE, 5, -1, "x")),
      BAD(INVALID_VALUE, LabelObjectEXT(GL_TEXTURE, 5, 300, long_text.c_str())),
      BAD(INVALID_VALUE, LabelObjectEXT(GL_TEXTURE, 5, 0, long_text.c_str())),
      BAD(INVALID_ENUM, GetObjectLabelEXT(GL_BUFFER, 5, 4, nullptr, text)),
      BAD(INVALID_OPERATION, GetObjectLabelEXT(GL_TEXTURE, 77, 4, nullptr, text)),
      BAD(INVALID_VALUE, GetObjectLabelEXT(GL_TEXTURE, 5, -1, nullptr, text)),
  };
  expect_refused(gl, calls);
  GLuint incomplete = 0;
  gl.GenFramebuffers(1, &incomplete);
  gl.BindFramebuffer(GL_FRAMEBUFFER, incomplete);
  static const BadCall draws[] = {
      BAD(INVALID_FRAMEBUFFER_OPERATION, WindowPos4fMESA(1, 2, 3, 4)),
      BAD(INVALID_FRAMEBUFFER_OPERATION, MultiModeDrawArraysIBM(points, zero, one, 1, 0)),
      BAD(INVALID_FRAMEBUFFER_OPERATION,
          MultiModeDrawElementsIBM(points, one, GL_UNSIGNED_BYTE, where, 1, 0)),
  };
  expect_refused(gl, draws);
}

} // namespace softgl::test
