// EGL on a library of OSMesa's ABI, for programs that draw to X windows with EGL and OpenGL, as the hacks of
// xscreensaver do. The program is started with LD_PRELOAD="libegl_on_osmesa.so LIBRARY": its EGL functions
// come from here, its OpenGL functions from LIBRARY. Nothing reaches the window. Two variables say what is
// wanted:
//   EGL_ON_OSMESA_FRAME=N    at the Nth eglSwapBuffers the picture is written, and the program ends
//   EGL_ON_OSMESA_FILE=FILE  width, height (int32), then the rows of RGBA bytes from the bottom
// Two runs draw the same: stable_process.cpp fixes time, process numbers and children.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <unistd.h>
#include <vector>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <X11/Xlib.h>

#include "clients/stable_process.h"

namespace {

[[noreturn]] void fail(const char* message) {
  std::fprintf(stderr, "egl_on_osmesa: %s\n", message);
  _exit(1);
}

template <class Function> Function* function_of(const char* name) {
  void* symbol = dlsym(RTLD_DEFAULT, name);
  if (!symbol) fail(name);
  return reinterpret_cast<Function*>(symbol);
}

using OsmesaContext = void*;
constexpr int kOsmesaRgba = 0x1908, kUnsignedByte = 0x1401;
constexpr int kDepthBits = 24, kStencilBits = 8;

/// A window and the memory that is drawn to in its place.
struct Surface {
  Window window;
  unsigned width = 0, height = 0;
  std::vector<unsigned char> pixels;
};

// A program of one thread, with one display.
Display* display = nullptr;
OsmesaContext current_context = nullptr;
Surface* current_surface = nullptr;
int only_config;

/// Gives the memory the window's size. Waits for the server: what has happened to the window meanwhile comes
/// before the next frame in every run.
void fit(Surface& surface) {
  static auto sync = function_of<decltype(XSync)>("XSync");
  static auto geometry = function_of<decltype(XGetGeometry)>("XGetGeometry");
  sync(display, False);
  Window root;
  int x, y;
  unsigned width, height, border, depth;
  if (!geometry(display, surface.window, &root, &x, &y, &width, &height, &border, &depth)) fail("no window");
  if (width == surface.width && height == surface.height) return;
  surface.width = width;
  surface.height = height;
  surface.pixels.assign(size_t{4} * width * height, 0);
}

void make_current(OsmesaContext context, Surface& surface) {
  static auto make =
      function_of<unsigned char(OsmesaContext, void*, unsigned, int, int)>("OSMesaMakeCurrent");
  fit(surface);
  if (!make(context, surface.pixels.data(), kUnsignedByte, int(surface.width), int(surface.height)))
    fail("OSMesaMakeCurrent refuses");
  current_context = context;
  current_surface = &surface;
}

void write_picture(const Surface& surface) {
  const char* path = std::getenv("EGL_ON_OSMESA_FILE");
  std::FILE* file = path ? std::fopen(path, "wb") : nullptr;
  if (!file) fail("EGL_ON_OSMESA_FILE cannot be written");
  const int32_t size[2] = {int32_t(surface.width), int32_t(surface.height)};
  std::fwrite(size, sizeof size, 1, file);
  std::fwrite(surface.pixels.data(), 1, surface.pixels.size(), file);
  if (std::fclose(file) != 0) fail("EGL_ON_OSMESA_FILE cannot be written");
}

int asked_for(const EGLint* attributes, EGLint name) {
  for (; attributes && *attributes != EGL_NONE; attributes += 2)
    if (*attributes == name) return attributes[1];
  return 0;
}

} // namespace

extern "C" {

EGLDisplay eglGetDisplay(EGLNativeDisplayType native) {
  display = reinterpret_cast<Display*>(native);
  return display;
}
EGLDisplay eglGetPlatformDisplay(EGLenum, void* native, const EGLAttrib*) {
  display = static_cast<Display*>(native);
  return display;
}
EGLBoolean eglInitialize(EGLDisplay, EGLint* major, EGLint* minor) {
  if (major) *major = 1;
  if (minor) *minor = 5;
  return EGL_TRUE;
}
EGLBoolean eglTerminate(EGLDisplay) { return EGL_TRUE; }
EGLBoolean eglBindAPI(EGLenum api) { return api == EGL_OPENGL_API; }
EGLint eglGetError() { return EGL_SUCCESS; }
const char* eglQueryString(EGLDisplay, EGLint name) { return name == EGL_VERSION ? "1.5" : ""; }

EGLBoolean eglChooseConfig(EGLDisplay, const EGLint* attributes, EGLConfig* configs, EGLint size,
                           EGLint* count) {
  *count = asked_for(attributes, EGL_SAMPLES) > 1 ? 0 : 1;
  if (configs && size > 0 && *count) *configs = &only_config;
  return EGL_TRUE;
}

EGLBoolean eglGetConfigAttrib(EGLDisplay, EGLConfig, EGLint attribute, EGLint* value) {
  switch (attribute) {
  case EGL_RED_SIZE:
  case EGL_GREEN_SIZE:
  case EGL_BLUE_SIZE:
  case EGL_ALPHA_SIZE: *value = 8; break;
  case EGL_BUFFER_SIZE: *value = 32; break;
  case EGL_DEPTH_SIZE: *value = kDepthBits; break;
  case EGL_STENCIL_SIZE: *value = kStencilBits; break;
  case EGL_CONFIG_ID: *value = 1; break;
  case EGL_CONFIG_CAVEAT:
  case EGL_TRANSPARENT_TYPE: *value = EGL_NONE; break;
  case EGL_SURFACE_TYPE: *value = EGL_WINDOW_BIT; break;
  case EGL_RENDERABLE_TYPE: *value = EGL_OPENGL_BIT; break;
  case EGL_COLOR_BUFFER_TYPE: *value = EGL_RGB_BUFFER; break;
  case EGL_NATIVE_VISUAL_ID: {
    static auto id = function_of<decltype(XVisualIDFromVisual)>("XVisualIDFromVisual");
    *value = EGLint(id(DefaultVisual(display, DefaultScreen(display))));
    break;
  }
  default: *value = 0;
  }
  return EGL_TRUE;
}

EGLContext eglCreateContext(EGLDisplay, EGLConfig, EGLContext share, const EGLint*) {
  static auto create =
      function_of<OsmesaContext(unsigned, int, int, int, OsmesaContext)>("OSMesaCreateContextExt");
  return create(kOsmesaRgba, kDepthBits, kStencilBits, 0, share);
}
EGLBoolean eglDestroyContext(EGLDisplay, EGLContext context) {
  static auto destroy = function_of<void(OsmesaContext)>("OSMesaDestroyContext");
  if (context == current_context) current_context = nullptr;
  destroy(context);
  return EGL_TRUE;
}

EGLSurface eglCreatePlatformWindowSurface(EGLDisplay, EGLConfig, void* window, const EGLAttrib*) {
  return new Surface{*static_cast<Window*>(window), 0, 0, {}};
}
EGLSurface eglCreateWindowSurface(EGLDisplay, EGLConfig, EGLNativeWindowType window, const EGLint*) {
  return new Surface{Window(window), 0, 0, {}};
}
// The context may draw to the memory up to its end.
EGLBoolean eglDestroySurface(EGLDisplay, EGLSurface) { return EGL_TRUE; }

EGLBoolean eglMakeCurrent(EGLDisplay, EGLSurface surface, EGLSurface, EGLContext context) {
  if (surface && context) make_current(context, *static_cast<Surface*>(surface));
  return EGL_TRUE;
}

EGLBoolean eglSwapBuffers(EGLDisplay, EGLSurface) {
  static auto finish = function_of<void()>("glFinish");
  static const char* last = std::getenv("EGL_ON_OSMESA_FRAME");
  if (!current_context) fail("nothing is current");
  finish();
  if (softgl::test::end_of_frame() == (last ? std::atoi(last) : 1)) {
    write_picture(*current_surface);
    _exit(0);
  }
  make_current(current_context, *current_surface);
  return EGL_TRUE;
}

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
  static auto find =
      function_of<__eglMustCastToProperFunctionPointerType(const char*)>("OSMesaGetProcAddress");
  return find(name);
}

} // extern "C"
