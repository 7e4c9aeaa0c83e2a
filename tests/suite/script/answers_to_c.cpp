// What a script claims of a GL's answers, as functions of C.
#include <algorithm>

#include "script/script.h"

namespace softgl::suite {

std::string answers_in_c(const Script& script, bool all_errors) {
  const auto any = [&](const auto& is) { return std::any_of(script.calls.begin(), script.calls.end(), is); };
  const bool errors = all_errors || any([](const Call& c) { return c.error != GL_NO_ERROR; });
  const bool floats = any([](const Call& c) { return c.command == Command::GetFloatv; });
  const bool switches = any([](const Call& c) { return c.command == Command::IsEnabled; });
  if (!errors && !floats && !switches) return "";
  std::string text = "static int wrong = 0;\n\n";
  if (errors)
    text += R"(static void expectError(GLenum expected) {
  const GLenum got = glGetError();
  if (got != expected && !wrong) printf("glGetError is 0x%04x, expected 0x%04x\n", got, expected);
  wrong |= got != expected;
}

)";
  if (floats)
    text += R"(static void expectGetFloatv(GLenum name, const GLfloat* expected, int count) {
  GLfloat got[16] = {0};
  glGetFloatv(name, got);
  for (int i = 0; i < count; i++) {
    const double size = expected[i] < 0 ? -expected[i] : expected[i], off = got[i] - expected[i];
    const double most = 5e-5 * (size < 0.02 ? 0.02 : size);
    if (off >= -most && off <= most) continue;
    if (!wrong) printf("glGetFloatv(0x%04x)[%d] is %g, expected %g\n", name, i, got[i], expected[i]);
    wrong = 1;
  }
}

)";
  if (switches)
    text += R"(static void expectIsEnabled(GLenum name, GLboolean expected) {
  const GLboolean got = glIsEnabled(name);
  if (got != expected && !wrong) printf("glIsEnabled(0x%04x) is %d, expected %d\n", name, got, expected);
  wrong |= got != expected;
}

)";
  return text;
}

} // namespace softgl::suite
