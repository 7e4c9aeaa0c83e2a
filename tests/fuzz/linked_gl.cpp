#include "fuzz/linked_gl.h"

#include <GL/osmesa.h>

#include <stdexcept>

namespace softgl::test {

const Gl& linked_gl() {
  static const Gl gl = [] {
    Gl found;
    const auto find = [](auto& pointer, const char* name) {
      pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(::OSMesaGetProcAddress(name));
      if (!pointer) throw std::runtime_error(std::string("no ") + name);
    };
#define GL_FUNCTION(function) find(found.function, "gl" #function);
#include "support/gl_functions.inc"
#undef GL_FUNCTION
    find(found.OSMesaCreateContextExt, "OSMesaCreateContextExt");
    find(found.OSMesaDestroyContext, "OSMesaDestroyContext");
    find(found.OSMesaMakeCurrent, "OSMesaMakeCurrent");
    found.name = "softgl";
    return found;
  }();
  return gl;
}

} // namespace softgl::test
