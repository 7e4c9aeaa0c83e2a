#include <stdexcept>
#include <vector>

#include "gl/subject.h"

namespace softgl::suite {
namespace {

struct OSMesaSubject final : Subject {
  using CreateContext = void* (*)(GLenum, GLint, GLint, GLint, void*);
  using MakeCurrent = GLboolean (*)(void*, void*, GLenum, GLsizei, GLsizei);
  using DestroyContext = void (*)(void*);
  using GetProcAddress = AnyFunction (*)(const char*);

  void* library;
  CreateContext create_context;
  MakeCurrent make_current;
  DestroyContext destroy_context;
  GetProcAddress get_proc_address;
  void* context = nullptr;
  std::vector<GLubyte> buffer = std::vector<GLubyte>(4 * kWindowWidth * kWindowHeight);

  explicit OSMesaSubject(const std::string& path) : library(open_library(path)) {
    const auto find = [&](const char* name) {
      const AnyFunction f = symbol(library, name);
      if (!f) throw std::runtime_error(path + " has no " + name);
      return f;
    };
    create_context = reinterpret_cast<CreateContext>(find("OSMesaCreateContextExt"));
    make_current = reinterpret_cast<MakeCurrent>(find("OSMesaMakeCurrent"));
    destroy_context = reinterpret_cast<DestroyContext>(find("OSMesaDestroyContext"));
    get_proc_address = reinterpret_cast<GetProcAddress>(symbol(library, "OSMesaGetProcAddress"));
  }

  void renew() override {
    if (context) destroy_context(context);
    context = create_context(GL_RGBA, 24, 8, 16, nullptr);
    if (!context) throw std::runtime_error("OSMesaCreateContextExt returned NULL");
    if (!make_current(context, buffer.data(), GL_UNSIGNED_BYTE, kWindowWidth, kWindowHeight))
      throw std::runtime_error("OSMesaMakeCurrent returned GL_FALSE");
    gl = load_functions([&](const char* name) {
      const AnyFunction exported = symbol(library, name);
      return exported || !get_proc_address ? exported : get_proc_address(name);
    });
  }
};

} // namespace

std::unique_ptr<Subject> open_osmesa(const std::string& library) {
  return std::make_unique<OSMesaSubject>(library);
}

} // namespace softgl::suite
