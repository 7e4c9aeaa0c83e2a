#include "report/c_program.h"

#include <algorithm>
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
    const bool works = call.error == GL_NO_ERROR;
    const bool opens = works && call.command == Command::Begin,
               closes = works && call.command == Command::End;
    if (opens) inside = true, triangles = call.e(0) == GL_TRIANGLES, vertices = 0;
    if (closes) inside = false;
    const bool new_unit = !inside || opens || units.empty() || units.back().fixed ||
                          (triangles && vertices % 3 == 0 && vertices);
    if (new_unit) units.push_back({}), vertices = 0;
    units.back().calls.push_back(call);
    units.back().fixed =
        opens || closes || (works && (call.command == Command::NewList || call.command == Command::EndList));
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
  const auto is = [](const Call& call, Command command) {
    return call.command == command && call.error == GL_NO_ERROR;
  };
  for (const Call& call : script.calls) {
    if (is(call, Command::End) && !s.calls.empty() && is(s.calls.back(), Command::Begin))
      s.calls.pop_back();
    else
      s.calls.push_back(call);
  }
  return s;
}

} // namespace

namespace {

// Draws shorter scripts, some at a time, and finds the first that still fails.
class Trial {
public:
  Trial(const RunOptions& options, const SubjectFacts& facts) : options_(options), facts_(facts) {}
  bool over() const { return scripts_ >= kMinimizerScripts; }

  /// The index of the first script that fails as the first one of all did, or -1. Scripts behind it do not
  /// count.
  int first_failure(const std::vector<Script>& scripts, Minimized* result) {
    scripts_ += int(scripts.size());
    const ChildResult child = run_in_child(options_.subject, scripts, options_.seconds);
    if (!child.fault.empty()) scripts_ += kMinimizerScripts / 10; // it may have hung: not often
    for (size_t i = 0; i < scripts.size(); i++) {
      try {
        if (fails(scripts[i], child.pictures[i], result)) return int(i);
      } catch (const std::logic_error&) {} // the machine cannot play what is left
    }
    return -1;
  }

private:
  // What a fault says without its numbers.
  static std::string kind_of(const std::string& fault) { return fault.substr(0, fault.find('[')); }

  bool fails(const Script& script, const DrawnPicture& drawn, Minimized* result) {
    Claims claims = Claims::Unknown;
    const Expectation expected =
        expected_picture(script, kWindowWidth, kWindowHeight, facts_.precision, &claims);
    if (!drawn.fault.empty()) {
      if (!is_wrong_answer(drawn.fault)) return false;
      if (whole_) kind_ = kind_of(drawn.fault);
      // A call that is gone may have made the error or the answer right.
      else if (kind_of(drawn.fault) != kind_ || claims != Claims::Right)
        return false;
      whole_ = false, result->fault = drawn.fault;
      return true;
    }
    if (!kind_.empty()) return false;
    const Verdict v = judge(expected, drawn.color, facts_.precision);
    if (v.pass || v.wrong_pixels == 0) return false;
    whole_ = false, result->verdict = v;
    return true;
  }

  bool whole_ = true; // nothing is cut yet
  std::string kind_;  // of the fault; empty if pixels are wrong
  const RunOptions& options_;
  const SubjectFacts& facts_;
  int scripts_ = 0;
};

std::vector<Unit> without(const std::vector<Unit>& units, size_t first, size_t length) {
  std::vector<Unit> fewer;
  for (size_t i = 0; i < units.size(); i++)
    if (i < first || i >= first + length || units[i].fixed) fewer.push_back(units[i]);
  return fewer;
}

} // namespace

bool is_wrong_answer(const std::string& fault) {
  return fault.starts_with("the calls raise the GL error") ||
         (fault.starts_with("gl") && fault.find(" should ") != std::string::npos);
}

Minimized minimized(const Script& script, const RunOptions& options, const SubjectFacts& facts) {
  Minimized result{script, {}, "", false, false};
  Trial trial(options, facts);
  if (trial.first_failure({script}, &result) < 0) return result;
  result.fails_again = true;
  std::vector<Unit> units = units_of(script);
  // The window that is cleared, and the projection, stay: without them another thing would fail.
  for (size_t i = 0; i < prologue().calls.size(); i++) units[i].fixed = true;
  size_t together = 1; // more where little can go, and none of them is drawn in vain
  for (size_t length = units.size() / 2; length > 0 && !trial.over();) {
    bool shorter = false;
    for (size_t first = 0; first < units.size() && !trial.over();) {
      std::vector<std::vector<Unit>> candidates;
      std::vector<size_t> starts;
      std::vector<Script> scripts;
      size_t next = first;
      for (; next < units.size() && scripts.size() < together; next += length) {
        candidates.push_back(without(units, next, length));
        if (candidates.back().size() == units.size()) {
          candidates.pop_back();
          continue;
        }
        starts.push_back(next), scripts.push_back(joined(candidates.back()));
      }
      const int found = scripts.empty() ? -1 : trial.first_failure(scripts, &result);
      first = found < 0 ? next : starts[size_t(found)];
      together = found >= 0 ? 1 : std::min<size_t>(2 * together, 8);
      if (found >= 0) units = std::move(candidates[size_t(found)]), shorter = true;
    }
    // At the end single calls are tried until none can go.
    if (length > 1 || !shorter) length /= 2;
  }
  result.is_minimal = !trial.over();
  result.script = without_empty_primitives(joined(units));
  return result;
}

namespace {

// The end of main: reads the pixel of the verdict.
std::string pixel_in_c(const Verdict& v) {
  const int low = std::max(int(std::floor(v.low - 0.52)), 0),
            high = std::min(int(std::ceil(v.high + 0.52)), 255);
  const std::string x = std::to_string(v.x), y = std::to_string(v.y);
  return R"(  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, window);
  const int got = window[4 * ()" +
         y + " * SIZE + " + x + ") + " + std::to_string(v.component) + R"(];
  printf("pixel )" +
         x + "," + y + ": " + std::vector<const char*>{"red", "green", "blue", "alpha"}[size_t(v.component)] +
         " is %d, expected " + std::to_string(low) + " to " + std::to_string(high) +
         R"(\n", got);
  return got < )" +
         std::to_string(low) + " || got > " + std::to_string(high) + ";\n}\n";
}

} // namespace

std::string c_program(const Test& test, const Script& script, const Verdict* verdict, const std::string& name,
                      const SubjectName& subject, const std::string& note) {
  const size_t slash = subject.library.rfind('/');
  const std::string library =
      slash == std::string::npos
          ? "-l:" + subject.library
          : subject.library + " -Wl,-rpath," + (slash == 0 ? "/" : subject.library.substr(0, slash));
  const std::string build = "cc " + name + ".c -o " + name + " " +
                            (subject.binding == Binding::OSMesa ? library : "-DUSE_EGL -lEGL -lGL");
  const std::string width = std::to_string(kWindowWidth), what = verdict ? "the pixel" : "an answer";
  return "/* " + test.name + "\n * OpenGL 1.5, " + test.section + ": " + test.sentence + "\n" + note +
         " *\n *     " + build + " && ./" + name + "\n *\n" + " * It ends with 1 if " + what +
         " is wrong, 0 if not, 2 without a context. Any library of "
         "OSMesa's ABI\n"
         " * can be linked with it, and with -DUSE_EGL any EGL (-lEGL -lGL). */\n" +
         R"(#include <stdio.h>
#include <string.h>

#define GL_GLEXT_PROTOTYPES
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

)" + answers_in_c(script, !verdict) +
         paint_in_c(script) + special_in_c(script) +
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
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 16, NULL);
  return context && OSMesaMakeCurrent(context, window, GL_UNSIGNED_BYTE, SIZE, SIZE);
#endif
}

int main(void) {
  if (!make_context()) return 2;
)" + to_c(script, "  ") +
         (verdict ? pixel_in_c(*verdict) : "  expectError(GL_NO_ERROR);\n  return wrong;\n}\n");
}

} // namespace softgl::suite
