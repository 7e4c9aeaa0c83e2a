// EGL with a pbuffer, without EGL's headers: a display without a screen where Mesa offers one, else the
// default.
#include <cstdint>
#include <stdexcept>

#include "gl/subject.h"

namespace softgl::suite {
namespace {

constexpr int32_t kSurfaceType = 0x3033, kPbufferBit = 1, kRenderableType = 0x3040, kOpenGlBit = 8,
                  kRedSize = 0x3024, kGreenSize = 0x3023, kBlueSize = 0x3022, kAlphaSize = 0x3021,
                  kDepthSize = 0x3025, kStencilSize = 0x3026, kNone = 0x3038, kWidth = 0x3057,
                  kHeight = 0x3056;
constexpr unsigned kOpenGlApi = 0x30A2, kPlatformSurfaceless = 0x31DD;

struct EglSubject final : Subject {
  void* library;
  AnyFunction (*get_proc_address)(const char*);
  void* (*create_context)(void*, void*, void*, const int32_t*);
  unsigned (*destroy_context)(void*, void*);
  unsigned (*make_current)(void*, void*, void*, void*);
  void *display = nullptr, *config = nullptr, *surface = nullptr, *context = nullptr;

  template <class F> F find(const char* name) {
    const AnyFunction f = symbol(library, name);
    if (!f) throw std::runtime_error(std::string("EGL has no ") + name);
    return reinterpret_cast<F>(f);
  }

  explicit EglSubject(const std::string& path) : library(open_library(path)) {
    get_proc_address = find<decltype(get_proc_address)>("eglGetProcAddress");
    create_context = find<decltype(create_context)>("eglCreateContext");
    destroy_context = find<decltype(destroy_context)>("eglDestroyContext");
    make_current = find<decltype(make_current)>("eglMakeCurrent");
    open_display();
    if (!find<unsigned (*)(unsigned)>("eglBindAPI")(kOpenGlApi))
      throw std::runtime_error("EGL does not offer OpenGL");
    // Depth, alpha and stencil if there are any; a window without them is tested, too.
    const auto choose =
        find<unsigned (*)(void*, const int32_t*, void**, int32_t, int32_t*)>("eglChooseConfig");
    for (const int32_t more : {1, 0}) {
      const int32_t wanted[] = {kSurfaceType, kPbufferBit, kRenderableType, kOpenGlBit, kRedSize,   1,
                                kGreenSize,   1,           kBlueSize,       1,          kAlphaSize, more,
                                kDepthSize,   more,        kStencilSize,    more,       kNone};
      int32_t count = 0;
      if (choose(display, wanted, &config, 1, &count) && count > 0) break;
      config = nullptr;
    }
    if (!config) throw std::runtime_error("EGL has no configuration");
    const int32_t size[] = {kWidth, kWindowWidth, kHeight, kWindowHeight, kNone};
    surface = find<void* (*)(void*, void*, const int32_t*)>("eglCreatePbufferSurface")(display, config, size);
    if (!surface) throw std::runtime_error("eglCreatePbufferSurface gave none");
  }

  void open_display() {
    const auto initialize = find<unsigned (*)(void*, int32_t*, int32_t*)>("eglInitialize");
    const auto without_screen = reinterpret_cast<void* (*)(unsigned, void*, const int32_t*)>(
        get_proc_address("eglGetPlatformDisplayEXT"));
    if (without_screen) display = without_screen(kPlatformSurfaceless, nullptr, nullptr);
    if (display && initialize(display, nullptr, nullptr)) return;
    display = find<void* (*)(void*)>("eglGetDisplay")(nullptr);
    if (!display || !initialize(display, nullptr, nullptr)) throw std::runtime_error("EGL has no display");
  }

  void renew() override {
    if (context) make_current(display, nullptr, nullptr, nullptr), destroy_context(display, context);
    context = create_context(display, config, nullptr, nullptr);
    if (!context) throw std::runtime_error("eglCreateContext gave none");
    if (!make_current(display, surface, surface, context)) throw std::runtime_error("eglMakeCurrent failed");
    gl = load_functions([&](const char* name) {
      const AnyFunction exported = symbol(library, name);
      return exported ? exported : get_proc_address(name);
    });
  }
};

} // namespace

std::unique_ptr<Subject> open_egl(const std::string& library) {
  return std::make_unique<EglSubject>(library);
}

} // namespace softgl::suite
