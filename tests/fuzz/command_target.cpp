#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "fuzz/arguments.h"
#include "fuzz/targets.h"

namespace softgl::test {
namespace {

constexpr int kMostCommands = 300;

// A command that is left out where it would take long or read memory that is not there.
class Guard {
public:
  explicit Guard(const Gl& gl) : gl_(gl) {}

  bool allows(std::string_view name, const Arguments& arguments) {
    // A list that calls two lists that call it is played 2^64 times.
    if (name == "NewList") compiling_ = compiles_ = true;
    if (name == "EndList") compiling_ = false;
    if (name.starts_with("CallList")) return !compiling_;
    // A list copies the whole of an image, of any size; and glEndList may have failed.
    const auto is_huge = [](const Argument& a) { return a.whole == 5000 || a.whole == 20000; };
    if (compiles_ && std::count_if(arguments.begin(), arguments.end(), is_huge) > 1) return false;
    // Any index may lie in a buffer, and arrays may lie in the program's memory, which has room for 256.
    if (name.find("DrawElements") != name.npos || name.find("DrawRangeElements") != name.npos) {
      const size_t type = name.starts_with("Multi") ? 2 : name.find("Range") != name.npos ? 4 : 2;
      return arguments[type].whole == GL_UNSIGNED_BYTE || !element_buffer();
    }
    return true;
  }

private:
  bool element_buffer() const {
    GLint bound = 1; // between Begin and End there is no answer, and no draw
    gl_.GetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &bound);
    return bound != 0;
  }

  const Gl& gl_;
  bool compiling_ = false, compiles_ = false; // since the last glNewList; since any
};

} // namespace

void fault(const char* what) {
  std::fprintf(stderr, "fault: %s\n", what);
  std::abort();
}

void fuzz_commands(const Gl& gl, std::span<const uint8_t> bytes) {
  Choices choices(bytes);
  const int stencil = choices.pick({8, 0}), accumulation = choices.pick({0, 16});
  void* context =
      gl.OSMesaCreateContextExt(kOSMesaRgba, choices.pick({24, 16, 0}), stencil, accumulation, nullptr);
  std::vector<float> colors(64 * 48 * 4);
  const GLenum type = choices.pick<GLenum>({GL_UNSIGNED_BYTE, GL_FLOAT, GL_UNSIGNED_SHORT});
  if (!context || !gl.OSMesaMakeCurrent(context, colors.data(), type, 64, 48)) fault("no context");
  prepare_objects(gl, choices);
  Guard guard(gl);
  const auto commands = any_commands();
  for (int i = 0; i < kMostCommands && !choices.ended(); ++i) {
    const AnyCommand& command = commands[size_t(choices.integer(0, int(commands.size()) - 1))];
    const Arguments arguments = choose_arguments(command, choices);
    if (guard.allows(command.name, arguments)) command.call(gl, arguments.data());
  }
  gl.EndList();
  gl.End();
  gl.Finish();
  int errors = 0;
  while (gl.GetError() != GL_NO_ERROR)
    if (++errors > 10) fault("glGetError does not come to an end");
  gl.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl.OSMesaDestroyContext(context);
}

} // namespace softgl::test
