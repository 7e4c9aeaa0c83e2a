#include "support/gl.h"
#include "test_paths.h"

#include <cstdlib>
#include <dlfcn.h>
#include <stdexcept>

namespace softgl::test {

Gl load_gl(const std::string& name, const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error("cannot load " + name + ": " + dlerror());
  Gl gl;
  gl.name = name;
  gl.path = path;
  auto find = [&](auto& pointer, const char* symbol) {
    void* address = dlsym(library, symbol);
    if (!address && gl.OSMesaGetProcAddress) // of some extensions
      address = reinterpret_cast<void*>(gl.OSMesaGetProcAddress(symbol));
    if (!address) throw std::runtime_error(path + " does not export " + symbol);
    pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(address);
  };
#define OSMESA_FUNCTION(function) find(gl.function, #function);
  OSMESA_FUNCTION(OSMesaCreateContext)
  OSMESA_FUNCTION(OSMesaCreateContextExt)
  OSMESA_FUNCTION(OSMesaCreateContextAttribs)
  OSMESA_FUNCTION(OSMesaDestroyContext)
  OSMESA_FUNCTION(OSMesaMakeCurrent)
  OSMESA_FUNCTION(OSMesaGetCurrentContext)
  OSMESA_FUNCTION(OSMesaPixelStore)
  OSMESA_FUNCTION(OSMesaGetIntegerv)
  OSMESA_FUNCTION(OSMesaGetDepthBuffer)
  OSMESA_FUNCTION(OSMesaGetColorBuffer)
  OSMESA_FUNCTION(OSMesaGetProcAddress)
  OSMESA_FUNCTION(OSMesaColorClamp)
  OSMESA_FUNCTION(OSMesaPostprocess)
#undef OSMESA_FUNCTION
#define GL_FUNCTION(function) find(gl.function, "gl" #function);
#include "support/gl_functions.inc"
#undef GL_FUNCTION
  return gl;
}

static std::string path_from(const char* variable, const char* otherwise) {
  const char* value = std::getenv(variable);
  return value && *value ? value : otherwise;
}

const Gl& softgl_library() {
  static const Gl gl = load_gl("softgl", path_from("SOFTGL_TEST_LIBRARY", SOFTGL_TEST_LIBRARY));
  return gl;
}

const Gl& osmesa_library() {
  static const Gl gl =
      load_gl("OSMesa", path_from("SOFTGL_TEST_OSMESA", "/usr/lib/x86_64-linux-gnu/libOSMesa.so.8"));
  return gl;
}

} // namespace softgl::test
