// SOFTGL_TRACE: what the trace says of calls, errors, draws and flushes.
#include <catch2/catch.hpp>

#include <dlfcn.h>
#include <sys/wait.h>

#include <algorithm>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/traced_program.h"

using namespace softgl::test;

namespace {

constexpr int kSize = 64;

/// Draws in a context with a 64x64 surface.
std::function<void(const Gl&)> in_context(std::function<void(const Gl&)> draw) {
  return [draw](const Gl& gl) {
    std::vector<unsigned char> buffer(size_t(kSize) * kSize * 4);
    void* context = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
    gl.OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, kSize, kSize);
    draw(gl);
    gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    gl.OSMesaDestroyContext(context);
  };
}

constexpr const char* kBegin = "OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL) = POINTER\n"
                               "OSMesaMakeCurrent(POINTER, POINTER, GL_UNSIGNED_BYTE, 64, 64) = GL_TRUE\n";
constexpr const char* kEnd = "OSMesaMakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0) = GL_TRUE\n"
                             "OSMesaDestroyContext(POINTER)\n";

std::string trace_in_context(const std::function<void(const Gl&)>& draw) {
  const TracedRun run = run_traced(in_context(draw));
  CHECK(run.status == 0);
  CHECK(run.errors == "");
  return comparable_trace(run.trace);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

} // namespace

TEST_CASE("the trace has calls, draws and flushes in the specification's names", "[trace]") {
  const std::string trace = trace_in_context([](const Gl& gl) {
    const float position[] = {0, 0, 1, 0}, third = 1.0f / 3, matrix[16] = {1};
    const double plane[] = {0.1, 0, 0, 1};
    const int ambient[] = {2147483647, 0, 0, -1};
    const GLubyte lists[] = {1, 2};
    const GLuint names[] = {1, 2};
    GLuint made[2];
    GLint viewport[4];
    GLfloat color[4];
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
    gl.LightModeliv(GL_LIGHT_MODEL_AMBIENT, ambient);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, third);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_DEPTH_TEST);
    gl.LoadMatrixf(matrix);
    gl.LoadIdentity();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    gl.PushAttrib(0);
    gl.PopAttrib();
    gl.ClipPlane(GL_CLIP_PLANE1, plane);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_FALSE, 7);
    gl.BlendFunc(GL_ONE, GL_ZERO);
    gl.StencilOp(GL_ZERO, GL_KEEP, GL_INCR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
    gl.Fogi(GL_FOG_MODE, GL_EXP2);
    gl.Fogf(GL_FOG_DENSITY, third);
    gl.Hint(GL_FOG_HINT, GL_NICEST);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    gl.CallLists(2, GL_UNSIGNED_BYTE, lists);
    gl.GenTextures(2, made);
    gl.DeleteTextures(2, names);
    gl.GetIntegerv(GL_VIEWPORT, viewport);
    gl.GetIntegerv(GL_MATRIX_MODE, viewport);
    gl.GetLightfv(GL_LIGHT0, GL_DIFFUSE, color);
    gl.IsEnabled(GL_FOG);
    gl.GenLists(3);
    gl.GetString(GL_VENDOR);
    gl.RenderMode(GL_RENDER);
    gl.OSMesaPixelStore(kOSMesaYUp, 1);
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(0, 0, 1);
    gl.Vertex2f(0.25f, -0.0f);
    gl.Vertex3d(0.1, 1e300, 0);
    gl.Vertex2s(-1, 1);
    gl.End();
    gl.Disable(GL_LIGHTING);
    gl.Finish();
    gl.GetError();
  });
  const char* const expected =
      "glLightfv(GL_LIGHT0, GL_POSITION, {0, 0, 1, 0})\n"
      "glLightModeliv(GL_LIGHT_MODEL_AMBIENT, {2147483647, 0, 0, -1})\n"
      "glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE)\n"
      "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 0.333333343)\n"
      "glEnable(GL_LIGHTING)\n"
      "glEnable(GL_LIGHT0)\n"
      "glEnable(GL_DEPTH_TEST)\n"
      "glLoadMatrixf({1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})\n"
      "glLoadIdentity()\n"
      "glClear(GL_COLOR_BUFFER_BIT|GL_DEPTH_BUFFER_BIT)\n"
      "glPushAttrib(GL_ALL_ATTRIB_BITS)\n"
      "glPushAttrib(0)\n"
      "glPopAttrib()\n"
      "glClipPlane(GL_CLIP_PLANE1, {0.10000000000000001, 0, 0, 1})\n"
      "glColorMask(GL_TRUE, GL_TRUE, GL_FALSE, 7)\n"
      "glBlendFunc(GL_ONE, GL_ZERO)\n"
      "glStencilOp(GL_ZERO, GL_KEEP, GL_INCR)\n"
      "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)\n"
      "glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL)\n"
      "glFogi(GL_FOG_MODE, GL_EXP2)\n"
      "glFogf(GL_FOG_DENSITY, 0.333333343)\n"
      "glHint(GL_FOG_HINT, GL_NICEST)\n"
      "glPixelStorei(GL_UNPACK_ALIGNMENT, 1)\n"
      "glTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 0, GL_RGB, GL_UNSIGNED_BYTE, NULL)\n"
      "glCallLists(2, GL_UNSIGNED_BYTE, {1, 2})\n"
      "glGenTextures(2, POINTER) = {1, 2}\n"
      "glDeleteTextures(2, {1, 2})\n"
      "glGetIntegerv(GL_VIEWPORT, POINTER) = {0, 0, 64, 64}\n"
      "glGetIntegerv(GL_MATRIX_MODE, POINTER) = {GL_MODELVIEW}\n"
      "glGetLightfv(GL_LIGHT0, GL_DIFFUSE, POINTER) = {1, 1, 1, 1}\n"
      "glIsEnabled(GL_FOG) = GL_FALSE\n"
      "glGenLists(3) = 1\n"
      "glGetString(GL_VENDOR) = \"softgl\"\n"
      "glRenderMode(GL_RENDER)\n"
      "  flush 0 draws, 1 clears, 0 primitives, N bytes, 1 rounds, N workers, N us\n"
      "... glRenderMode = 0\n"
      "OSMesaPixelStore(OSMESA_Y_UP, GL_TRUE)\n"
      "glBegin(GL_TRIANGLES)\n"
      "glNormal3f(0, 0, 1)\n"
      "glVertex2f(0.25, -0)\n"
      "glVertex3d(0.10000000000000001, 1.0000000000000001e+300, 0)\n"
      "glVertex2s(-1, 1)\n"
      "glEnd()\n"
      "glDisable(GL_LIGHTING)\n"
      "  draw GL_TRIANGLES: 3 vertices, 1 primitives; attributes position normal; vertex lit:1 two_sided; "
      "raster box:0,0,64,64 two_sided; fragment depth:less,write mask:rg-a rgba8 z24s8\n"
      "glFinish()\n"
      "  flush 1 draws, 0 clears, 1 primitives, N bytes, 1 rounds, N workers, N us\n"
      "glGetError() = GL_NO_ERROR\n";
  CHECK(trace == std::string(kBegin) + expected + kEnd);
}

TEST_CASE("the trace shows every error with the call that raised it", "[trace]") {
  const std::string trace = trace_in_context([](const Gl& gl) {
    auto* nowhere = reinterpret_cast<GLuint*>(0xabcdef0);
    gl.Enable(77);
    gl.Enable(GL_RASTERIZER_DISCARD);
    gl.DeleteTextures(-1, nowhere);
    gl.GetIntegerv(GL_POINTS, reinterpret_cast<GLint*>(nowhere));
    gl.Begin(GL_POINTS);
    gl.GenTextures(2, nowhere);
    gl.Materialf(GL_FRONT, GL_DIFFUSE, 1);
    gl.End();
    gl.GetError();
    gl.GetError();
    gl.Flush();
    gl.OSMesaGetProcAddress("glNoSuchFunction");
    void* library = dlopen(gl.path.c_str(), RTLD_NOW | RTLD_NOLOAD);
    reinterpret_cast<void (*)()>(dlsym(library, "glAttachShader"))(); // there by its name only
  });
  CHECK(trace == std::string(kBegin) +
                     "glEnable(0x004d) ! GL_INVALID_ENUM\n"
                     "glEnable(GL_RASTERIZER_DISCARD) ! GL_INVALID_ENUM\n"
                     "glDeleteTextures(-1, POINTER) ! GL_INVALID_VALUE\n"
                     "glGetIntegerv(0x0000, POINTER) ! GL_INVALID_ENUM\n"
                     "glBegin(GL_POINTS)\n"
                     "glGenTextures(2, POINTER) ! GL_INVALID_OPERATION\n"
                     "glMaterialf(GL_FRONT, GL_DIFFUSE, 1) ! GL_INVALID_ENUM\n"
                     "glEnd()\n"
                     "glGetError() = GL_INVALID_ENUM\n"
                     "glGetError() = GL_NO_ERROR\n"
                     "glFlush()\n"
                     "OSMesaGetProcAddress(\"glNoSuchFunction\") = NULL\n"
                     "glAttachShader(?) ! GL_INVALID_OPERATION\n" +
                     kEnd);
}

TEST_CASE("the trace shows what vertex programs and fragments of a draw do", "[trace]") {
  const std::string trace = trace_in_context([](const Gl& gl) {
    for (GLenum capability : {GL_NORMALIZE, GL_CLIP_PLANE0, GL_FOG, GL_BLEND, GL_SCISSOR_TEST, GL_CULL_FACE})
      gl.Enable(capability);
    gl.Scissor(0, 0, 32, 16);
    gl.Begin(GL_QUAD_STRIP);
    for (int i = 0; i < 6; ++i) gl.Vertex2i(i / 2, i % 2);
    gl.End();
    gl.Begin(GL_LINE_LOOP);
    for (int i = 0; i < 3; ++i) gl.Vertex2i(i, i);
    gl.End();
    gl.RasterPos2f(-1, -1);
    const GLubyte bits = 0x80;
    gl.Bitmap(1, 1, 0, 0, 0, 0, &bits);
  });
  std::string draws;
  for (const std::string& line : lines_of(trace))
    if (line.rfind("  draw", 0) == 0) draws += line + "\n";
  CHECK(draws ==
        "  draw GL_LINE_LOOP|GL_QUAD_STRIP: 9 vertices, 5 primitives; attributes position; vertex "
        "normalize fog clip_planes:1; "
        "raster box:0,48,32,64 cull:cw; fragment fog:exp mask:rgba rgba8 z24s8\n"
        "  draw pixels 0,63,1,64; raster box:0,48,32,64 cull:cw; fragment fog:exp mask:rgba rgba8 z24s8\n");
}

TEST_CASE("the trace of several threads has whole lines", "[trace]") {
  constexpr int kCalls = 300;
  const TracedRun run = run_traced([](const Gl& gl) {
    std::vector<std::thread> threads;
    for (int t = 0; t < 2; ++t)
      threads.emplace_back([&gl, t] {
        in_context([t](const Gl& library) {
          for (int i = 0; i < kCalls; ++i) {
            library.Color3us(GLushort(t), GLushort(i), 0);
            library.IsList(GLuint(i + 1));
          }
        })(gl);
      });
    for (std::thread& thread : threads) thread.join();
  });
  CHECK(run.status == 0);
  int calls[2] = {}, next[2] = {}, results = 0;
  const std::regex color("(\\[[0-9]+\\] )?glColor3us\\(([01]), ([0-9]+), 0\\)"),
      query("(\\[[0-9]+\\] )?glIsList\\([0-9]+\\)( = GL_FALSE)?"),
      late("(\\[[0-9]+\\] )?\\.\\.\\. glIsList = GL_FALSE"),
      other("(softgl|(\\[[0-9]+\\] )?(\\.\\.\\. )?OSMesa).*");
  for (const std::string& line : lines_of(run.trace)) {
    std::smatch match;
    if (std::regex_match(line, match, color)) {
      const int thread = std::stoi(match[2]);
      CHECK(std::stoi(match[3]) == next[thread]++);
      ++calls[thread];
    } else {
      INFO(line);
      const bool whole = std::regex_match(line, query) || std::regex_match(line, late);
      CHECK((whole || std::regex_match(line, other)));
      results += whole && line.find("= GL_FALSE") != std::string::npos;
    }
  }
  CHECK(calls[0] == kCalls);
  CHECK(calls[1] == kCalls);
  CHECK(results == 2 * kCalls);
  CHECK(run.trace.back() == '\n');
}

TEST_CASE("the call in which a program dies is the last of its trace", "[trace]") {
  const TracedRun run = run_traced(in_context([](const Gl& gl) {
    gl.Begin(GL_POINTS);
    gl.Vertex3fv(reinterpret_cast<const GLfloat*>(0x10));
  }));
  CHECK(run.status != 0);
  CHECK(comparable_trace(run.trace) == std::string(kBegin) + "glBegin(GL_POINTS)\nglVertex3fv(0x10)");
}

TEST_CASE("a trace that cannot be written does not stop the program", "[trace]") {
  const TracedRun run = run_traced(in_context([](const Gl& gl) { gl.Finish(); }), "/no/such/folder/trace");
  CHECK(run.status == 0);
  CHECK(run.errors == "softgl: cannot write the trace to /no/such/folder/trace: No such file or directory\n");
  const TracedRun full = run_traced(in_context([](const Gl& gl) { gl.Finish(); }), "/dev/full");
  CHECK(full.status == 0);
  CHECK(full.errors == "softgl: the trace ends here, it cannot be written: No space left on device\n");
}
