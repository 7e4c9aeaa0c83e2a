// What a script claims of a GL's answers, as functions of C.
#include <algorithm>

#include "script/script.h"

namespace softgl::suite {

namespace {

// A function that compares the numbers of a query. `parameters` and `arguments` lead to the answer.
std::string compares_numbers(const std::string& name, const std::string& parameters,
                             const std::string& arguments, const std::string& type) {
  return "static void expect" + name + "(" + parameters + R"(, const GLfloat* expected, int count) {
  )" + type +
         R"( got[64] = {0};
  gl)" + name +
         "(" + arguments + R"(, got);
  for (int i = 0; i < count; i++) {
    const double size = expected[i] < 0 ? -expected[i] : expected[i], off = (double)got[i] - expected[i];
    const double most = 5e-5 * (size < 0.02 ? 0.02 : size);
    if (off >= -most && off <= most) continue;
    if (!wrong) printf("gl)" +
         name + R"((0x%04x)[%d] is %g, expected %g\n", name, i, (double)got[i], expected[i]);
    wrong = 1;
  }
}

)";
}

// A function that compares a boolean.
std::string compares_boolean(const std::string& name) {
  return "static void expect" + name + R"((GLuint name, GLboolean expected) {
  const GLboolean got = gl)" +
         name + R"((name);
  if (got != expected && !wrong) printf("gl)" +
         name + R"((0x%04x) is %d, expected %d\n", name, got, expected);
  wrong |= got != expected;
}

)";
}

} // namespace

std::string answers_in_c(const Script& script, bool all_errors) {
  const auto any = [&](const auto& is) { return std::any_of(script.calls.begin(), script.calls.end(), is); };
  const bool errors = all_errors || any([](const Call& c) { return c.error != GL_NO_ERROR; });
  std::string text;
  if (errors)
    text += R"(static void expectError(GLenum expected) {
  const GLenum got = glGetError();
  if (got != expected && !wrong) printf("glGetError is 0x%04x, expected 0x%04x\n", got, expected);
  wrong |= got != expected;
}

)";
  const auto answers = [&](Command command) {
    return any([&](const Call& c) { return c.command == command && c.error == GL_NO_ERROR; });
  };
  if (answers(Command::GetFloatv)) text += compares_numbers("GetFloatv", "GLenum name", "name", "GLfloat");
  if (answers(Command::GetMapfv))
    text += compares_numbers("GetMapfv", "GLenum map, GLenum name", "map, name", "GLfloat");
  if (answers(Command::GetQueryiv))
    text += compares_numbers("GetQueryiv", "GLenum target, GLenum name", "target, name", "GLint");
  if (answers(Command::GetQueryObjectuiv))
    text += compares_numbers("GetQueryObjectuiv", "GLuint query, GLenum name", "query, name", "GLuint");
  for (const Command command : {Command::IsEnabled, Command::IsList, Command::IsQuery})
    if (answers(command)) text += compares_boolean(facts_of(command).name);
  return text.empty() ? "" : "static int wrong = 0;\n\n" + text;
}

} // namespace softgl::suite
