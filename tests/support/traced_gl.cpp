#include "support/traced_gl.h"

#include <cctype>
#include <cstring>
#include <initializer_list>
#include <string>
#include <type_traits>

namespace softgl::test {

namespace {

const Gl* real_gl;
CallFilter* active;

// How many values a pointer argument of this function points to, as far as its name tells.
int values_of(const char* name) {
  const std::string n = name;
  if (n.find("Matrix") != std::string::npos) return 16;
  if (n == "DrawElements" || n == "DrawRangeElements" || n.find("Pointer") != std::string::npos ||
      n.find("Image") != std::string::npos)
    return 0;
  if (n.size() > 3 && n.back() == 'v') {
    for (size_t i = n.size() - 1; i > n.size() - 4; i--)
      if (std::isdigit(static_cast<unsigned char>(n[i]))) return n[i] - '0';
    if (n.find("Coord") != std::string::npos || n.find("Index") != std::string::npos) return 1;
    return 4;
  }
  return 0;
}

template <class T> void print_value(FILE* f, const char* name, T value) {
  if constexpr (std::is_same_v<T, float> || std::is_same_v<T, double>) {
    std::fprintf(f, "%.9g", double(value));
  } else if constexpr (std::is_pointer_v<T>) {
    using Pointee = std::remove_cv_t<std::remove_pointer_t<T>>;
    const int count = value ? values_of(name) : 0;
    if constexpr (std::is_arithmetic_v<Pointee>) {
      if (count) {
        std::fprintf(f, "{");
        for (int i = 0; i < count; i++) std::fprintf(f, i ? ", " : ""), print_value(f, "", value[i]);
        std::fprintf(f, "}");
        return;
      }
    }
    std::fprintf(f, "%p", reinterpret_cast<const void*>(value));
  } else if constexpr (std::is_same_v<T, GLenum>) {
    std::fprintf(f, value > 9 ? "0x%04x" : "%u", value);
  } else {
    std::fprintf(f, "%lld", static_cast<long long>(value));
  }
}

// A Begin that is left out takes everything up to its End with it, and an End stays with its Begin.
bool wanted(const char* name, int number) {
  const bool skip = active->skip && number < int(active->skip->size()) && (*active->skip)[size_t(number)];
  if (!std::strcmp(name, "Begin") || !std::strcmp(name, "End")) active->in_primitive = name[0] == 'B';
  if (!std::strcmp(name, "Begin")) return active->primitive_skipped = skip, !skip;
  if (!std::strcmp(name, "End")) {
    const bool made = !active->primitive_skipped;
    active->primitive_skipped = false;
    return made;
  }
  // What a new buffer holds before the first Clear is undefined: a difference there means nothing.
  if (!std::strcmp(name, "Clear") && !active->cleared) return active->cleared = true;
  // OSMesa has an answer of its own to a list that lacks an attribute at first: primitives in lists stay
  // whole.
  if (!std::strcmp(name, "NewList") || !std::strcmp(name, "EndList")) active->in_list = name[0] == 'N';
  if (active->in_list && active->in_primitive) return !active->primitive_skipped;
  // Without these the rest would read memory that nobody owns, crash OSMesa (an EndList alone), leave another
  // framebuffer bound than the one that is compared, or draw what is known to differ (smooth quads).
  for (const char* part :
       {"Pointer", "Buffer", "Framebuffer", "Interleaved", "ShadeModel", "NewList", "EndList"})
    if (std::strstr(name, part)) return true;
  return !skip && !active->primitive_skipped;
}

template <auto Member> struct Wrapped;
template <class R, class... A, R (*Gl::*Member)(A...)> struct Wrapped<Member> {
  static inline const char* name = "";
  static R call(A... arguments) {
    const int number = active->next++;
    if (!wanted(name, number)) return R();
    if (active->print) {
      std::fprintf(active->print, "/* %4d */ gl%s(", number, name);
      bool first = true;
      ((std::fprintf(active->print, first ? "" : ", "), first = false,
        print_value(active->print, name, arguments)),
       ...);
      std::fprintf(active->print, ");\n");
    }
    return (real_gl->*Member)(arguments...);
  }
};

} // namespace

Gl traced(const Gl& real, CallFilter& filter) {
  Gl gl = real;
  real_gl = &real;
  active = &filter;
#define GL_FUNCTION(function) \
  Wrapped<& Gl::function>::name = #function; \
  gl.function = &Wrapped<&Gl::function>::call;
#include "support/gl_functions.inc"
#undef GL_FUNCTION
  gl.GetError = real.GetError;
  gl.Finish = real.Finish;
  return gl;
}

} // namespace softgl::test
