// GLX with a pixmap, without the headers of X: programs that only use the suite on OSMesa need none of it.
#include <stdexcept>

#include "gl/subject.h"

namespace softgl::suite {
namespace {

constexpr int kGlxRgba = 4, kGlxRedSize = 8, kGlxGreenSize = 9, kGlxBlueSize = 10, kGlxDepthSize = 12,
              kGlxStencilSize = 13;

// XVisualInfo of <X11/Xutil.h>.
struct VisualInfo {
  void* visual;
  unsigned long id;
  int screen, depth, visual_class;
  unsigned long red_mask, green_mask, blue_mask;
  int colormap_size, bits_per_rgb;
};

struct GlxSubject final : Subject {
  void *library, *x11;
  void* (*create_context)(void*, VisualInfo*, void*, int);
  void (*destroy_context)(void*, void*);
  int (*make_current)(void*, unsigned long, void*);
  AnyFunction (*get_proc_address)(const unsigned char*);
  void *display = nullptr, *context = nullptr;
  VisualInfo* visual = nullptr;
  unsigned long drawable = 0;

  template <class F> F find(void* from, const char* name) {
    const AnyFunction f = symbol(from, name);
    if (!f) throw std::runtime_error(std::string("there is no ") + name);
    return reinterpret_cast<F>(f);
  }

  explicit GlxSubject(const std::string& path)
      : library(open_library(path)), x11(open_library("libX11.so.6")) {
    create_context = find<decltype(create_context)>(library, "glXCreateContext");
    destroy_context = find<decltype(destroy_context)>(library, "glXDestroyContext");
    make_current = find<decltype(make_current)>(library, "glXMakeCurrent");
    get_proc_address = reinterpret_cast<decltype(get_proc_address)>(symbol(library, "glXGetProcAddressARB"));
    display = find<void* (*)(const char*)>(x11, "XOpenDisplay")(nullptr);
    if (!display) throw std::runtime_error("there is no X display");
    const auto choose = find<VisualInfo* (*)(void*, int, int*)>(library, "glXChooseVisual");
    for (int more : {1, 0}) { // depth and stencil if there are any
      int wanted[] = {kGlxRgba, kGlxRedSize,   1,    kGlxGreenSize,   1,    kGlxBlueSize,
                      1,        kGlxDepthSize, more, kGlxStencilSize, more, 0};
      visual = choose(display, 0, wanted);
      if (visual) break;
    }
    if (!visual) throw std::runtime_error("GLX has no visual");
    const unsigned long root =
        find<unsigned long (*)(void*, int)>(x11, "XRootWindow")(display, visual->screen);
    const unsigned long pixmap = find<unsigned long (*)(void*, unsigned long, unsigned, unsigned, unsigned)>(
        x11, "XCreatePixmap")(display, root, kWindowWidth, kWindowHeight, unsigned(visual->depth));
    drawable = find<unsigned long (*)(void*, VisualInfo*, unsigned long)>(library, "glXCreateGLXPixmap")(
        display, visual, pixmap);
  }

  void renew() override {
    if (context) make_current(display, 0, nullptr), destroy_context(display, context);
    context = create_context(display, visual, nullptr, 1);
    if (!context) throw std::runtime_error("glXCreateContext gave none");
    if (!make_current(display, drawable, context)) throw std::runtime_error("glXMakeCurrent failed");
    gl = load_functions([&](const char* name) {
      const AnyFunction exported = symbol(library, name);
      return exported || !get_proc_address ? exported
                                           : get_proc_address(reinterpret_cast<const unsigned char*>(name));
    });
  }
};

} // namespace

std::unique_ptr<Subject> open_glx(const std::string& library) {
  return std::make_unique<GlxSubject>(library);
}

} // namespace softgl::suite
