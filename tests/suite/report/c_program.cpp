#include "report/c_program.h"

#include <cmath>
#include <stdexcept>

#include "expect/machine.h"

namespace softgl::suite {
namespace {

// Calls that go together: one call, or the calls of one triangle between Begin and End. What opens and closes
// stays.
struct Unit {
  std::vector<Call> calls;
  bool fixed = false;
};

std::vector<Unit> units_of(const Script& script) {
  std::vector<Unit> units;
  bool triangles = false, inside = false;
  int vertices = 0;
  for (const Call& call : script.calls) {
    const bool opens = call.command == Command::Begin, closes = call.command == Command::End;
    if (opens) inside = true, triangles = call.e(0) == GL_TRIANGLES, vertices = 0;
    if (closes) inside = false;
    const bool new_unit = !inside || opens || units.empty() || units.back().fixed ||
                          (triangles && vertices % 3 == 0 && vertices);
    if (new_unit) units.push_back({}), vertices = 0;
    units.back().calls.push_back(call);
    units.back().fixed =
        opens || closes || call.command == Command::NewList || call.command == Command::EndList;
    const std::string name = facts_of(call.command).name;
    if (inside && name.starts_with("Vertex")) vertices++;
  }
  return units;
}

Script joined(const std::vector<Unit>& units) {
  Script s;
  for (const Unit& unit : units) s.calls.insert(s.calls.end(), unit.calls.begin(), unit.calls.end());
  return s;
}

Script without_empty_primitives(const Script& script) {
  Script s;
  for (const Call& call : script.calls) {
    if (call.command == Command::End && !s.calls.empty() && s.calls.back().command == Command::Begin)
      s.calls.pop_back();
    else
      s.calls.push_back(call);
  }
  return s;
}

} // namespace

Script minimized(const Script& script, const RunOptions& options, const SubjectFacts& facts,
                 Verdict* verdict) {
  int runs = 0;
  const auto fails = [&](const std::vector<Unit>& units) {
    if (++runs > 120) return false;
    const Script s = joined(units);
    try {
      const Expectation expected = expected_picture(s, kWindowWidth, kWindowHeight, facts.precision);
      const ChildResult child = run_in_child(options.subject, {s}, options.seconds);
      if (!child.fault.empty() || !child.pictures[0].fault.empty()) return false;
      const Verdict v = judge(expected, child.pictures[0].color, facts.precision);
      if (v.pass) return false;
      *verdict = v;
      return true;
    } catch (const std::logic_error&) { // the machine cannot play what is left
      return false;
    }
  };
  std::vector<Unit> units = units_of(script);
  // The window that is cleared, and the projection, stay: without them another thing would fail.
  for (size_t i = 0; i < prologue().calls.size(); i++) units[i].fixed = true;
  if (!fails(units)) return script;
  for (size_t length = units.size() / 2; length > 0; length /= 2)
    for (size_t first = 0; first < units.size();) {
      std::vector<Unit> fewer;
      for (size_t i = 0; i < units.size(); i++)
        if (i < first || i >= first + length || units[i].fixed) fewer.push_back(units[i]);
      if (fewer.size() < units.size() && fails(fewer))
        units = std::move(fewer);
      else
        first += length;
    }
  runs = 0;
  fails(units); // the verdict of what is left
  return without_empty_primitives(joined(units));
}

std::string c_program(const Test& test, const Script& script, const Verdict& v) {
  const int low = int(std::floor(v.low - 0.52)), high = int(std::ceil(v.high + 0.52));
  const std::string x = std::to_string(v.x), y = std::to_string(v.y), width = std::to_string(kWindowWidth);
  return "/* " + test.name + "\n * OpenGL 1.5, " + test.section + ": " + test.sentence + "\n *\n" +
         " *     cc failure.c -lOSMesa && ./a.out\n *     cc -DUSE_EGL failure.c -lEGL -lGL && ./a.out\n "
         "*/\n" +
         R"(#include <stdio.h>
#ifdef USE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#else
#include <GL/osmesa.h>
#include <GL/glext.h>
#endif

#define SIZE )" +
         width + R"(

static unsigned char window[SIZE * SIZE * 4];

)" + paint_in_c(script) +
         R"(static int make_context(void) {
#ifdef USE_EGL
  static const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
                                  EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 16, EGL_NONE};
  static const EGLint size[] = {EGL_WIDTH, SIZE, EGL_HEIGHT, SIZE, EGL_NONE};
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  EGLConfig config;
  EGLint count = 0;
  if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return 0;
  EGLSurface surface = eglCreatePbufferSurface(display, config, size);
  return eglMakeCurrent(display, surface, surface, eglCreateContext(display, config, EGL_NO_CONTEXT, NULL));
#else
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
  return context && OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, SIZE, SIZE);
#endif
}

int main(void) {
  if (!make_context()) return 2;
)" + to_c(script, "  ") +
         R"(  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, window);
  const int got = window[4 * ()" +
         y + " * SIZE + " + x + ") + " + std::to_string(v.component) + R"(];
  printf("pixel )" +
         x + "," + y + ": " + std::vector<const char*>{"red", "green", "blue", "alpha"}[size_t(v.component)] +
         " is %d, expected " + std::to_string(std::max(low, 0)) + " to " +
         std::to_string(std::min(high, 255)) +
         R"(\n", got);
  return got < )" +
         std::to_string(low) + " || got > " + std::to_string(high) + ";\n}\n";
}

} // namespace softgl::suite
