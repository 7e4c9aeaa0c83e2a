// An OpenGL library, loaded at run time: the same scene source runs on softgl and on Debian's libOSMesa.
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>
#include <softgl/softgl.h>

#include <string>

namespace softgl::test {

/// All functions of GL 1.5 and of OSMesa, by their name without the prefix "gl" ("OSMesa" stays).
struct Gl {
#define GL_FUNCTION(name) decltype(&::gl##name) name = nullptr;
#include "support/gl_functions.inc"
#undef GL_FUNCTION
  using Proc = void (*)();
  void* (*OSMesaCreateContext)(GLenum format, void* share) = nullptr;
  void* (*OSMesaCreateContextExt)(GLenum format, GLint depth, GLint stencil, GLint accum,
                                  void* share) = nullptr;
  void* (*OSMesaCreateContextAttribs)(const int* attributes, void* share) = nullptr;
  void (*OSMesaDestroyContext)(void* context) = nullptr;
  GLboolean (*OSMesaMakeCurrent)(void* context, void* buffer, GLenum type, GLsizei width,
                                 GLsizei height) = nullptr;
  void* (*OSMesaGetCurrentContext)() = nullptr;
  void (*OSMesaPixelStore)(GLint pname, GLint value) = nullptr;
  void (*OSMesaGetIntegerv)(GLint pname, GLint* value) = nullptr;
  GLboolean (*OSMesaGetDepthBuffer)(void* context, GLint* width, GLint* height, GLint* bytes,
                                    void** buffer) = nullptr;
  GLboolean (*OSMesaGetColorBuffer)(void* context, GLint* width, GLint* height, GLint* format,
                                    void** buffer) = nullptr;
  Proc (*OSMesaGetProcAddress)(const char* name) = nullptr;
  void (*OSMesaColorClamp)(GLboolean enable) = nullptr;
  void (*OSMesaPostprocess)(void* context, const char* filter, unsigned value) = nullptr;

  std::string name; // "softgl" or "OSMesa", for messages
  std::string path;
};

constexpr GLenum kOSMesaRgba = GL_RGBA, kOSMesaBgra = 1, kOSMesaArgb = 2, kOSMesaRgb = GL_RGB,
                 kOSMesaRgb565 = 5;
constexpr GLint kOSMesaYUp = 0x11, kOSMesaRowLength = 0x10;

/// Loads a library with RTLD_LOCAL; throws std::runtime_error with the reason when it or a function is
/// missing.
Gl load_gl(const std::string& name, const std::string& path);

/// softgl's drop-in library of this build ($SOFTGL_TEST_LIBRARY names another) and the system's OSMesa
/// ($SOFTGL_TEST_OSMESA). Loaded at the first call.
const Gl& softgl_library();
const Gl& osmesa_library();

} // namespace softgl::test
