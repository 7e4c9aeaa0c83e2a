#include "gl/subject.h"

#include <dlfcn.h>

#include <stdexcept>

namespace softgl::suite {

SubjectName parse_subject(const std::string& text) {
  const size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon),
                    path = colon == std::string::npos ? "" : text.substr(colon + 1);
  if (colon != std::string::npos && path.empty())
    throw std::invalid_argument("--gl " + text + ": the path behind the colon is missing");
  if (kind == "softgl" && colon == std::string::npos)
    return {Binding::OSMesa, "libsoftgl.so." SOFTGL_SUITE_LIBRARY_VERSION, text};
  if (kind == "osmesa") {
    if (path.empty()) throw std::invalid_argument("--gl osmesa needs a path: osmesa:libOSMesa.so.8");
    return {Binding::OSMesa, path, text};
  }
  if (kind == "egl") return {Binding::Egl, path.empty() ? "libEGL.so.1" : path, text};
  if (kind == "glx") return {Binding::Glx, path.empty() ? "libGL.so.1" : path, text};
  throw std::invalid_argument("--gl " + text + ": expected osmesa:PATH, egl[:PATH], glx[:PATH] or softgl");
}

std::unique_ptr<Subject> open_subject(const SubjectName& name) {
  switch (name.binding) {
  case Binding::OSMesa: return open_osmesa(name.library);
  case Binding::Egl: return open_egl(name.library);
  case Binding::Glx: return open_glx(name.library);
  }
  return nullptr;
}

void* open_library(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw std::runtime_error(dlerror());
  return library;
}

AnyFunction symbol(void* library, const char* name) {
  return reinterpret_cast<AnyFunction>(dlsym(library, name));
}

} // namespace softgl::suite
