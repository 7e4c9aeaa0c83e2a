// A scene as data: the calls that draw it. One script is played on a GL, on the specification's machine, and
// printed as a program.
#pragma once

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace softgl::suite {

enum class Command : uint16_t {
#define SUITE_COMMAND(name, kinds) name,
#define SUITE_COMMAND_NOT_IN_LISTS SUITE_COMMAND
#define SUITE_PAINT SUITE_COMMAND
#define SUITE_QUERY SUITE_COMMAND
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_PAINT
#undef SUITE_QUERY
  Count
};

/// What is known of a command: its name without "gl", the letters of commands.inc, whether lists hold it, and
/// whether it is a query.
struct CommandFacts {
  const char* name;
  const char* kinds;
  bool in_lists, query;
};
const CommandFacts& facts_of(Command command);

/// Numbers behind a pointer, as V{1, 2, 3}.
struct V : std::vector<double> {
  using std::vector<double>::vector;
};
/// Elements behind a pointer to void.
struct Memory {
  GLenum type; // one of pixel_types.h, GL_BITMAP
  std::vector<double> elements;
};

struct Argument {
  double number = 0;
  std::vector<double> numbers;
  GLenum memory_type = GL_NONE; // of elements behind a pointer to void
  Argument() = default;
  Argument(double n) : number(n) {}
  Argument(float n) : number(double(n)) {}
  Argument(int n) : number(n) {}
  Argument(unsigned n) : number(n) {}
  Argument(V v) : numbers(std::move(v)) {}
  Argument(Memory m) : numbers(std::move(m.elements)), memory_type(m.type) {}
};

struct Call {
  Command command;
  std::vector<Argument> arguments;
  GLenum error = GL_NO_ERROR; // that it must raise; it changes nothing else then
  double n(size_t i) const { return arguments[i].number; }
  GLenum e(size_t i) const { return GLenum(arguments[i].number); }
  const std::vector<double>& v(size_t i) const { return arguments[i].numbers; }
};

/// Calls, in their order. It has a function for every command: script.Vertex3f(1, 2, 3).
struct Script {
  std::vector<Call> calls;

#define SUITE_COMMAND(name, kinds) \
  template <class... A> void name(A... a) { calls.push_back({Command::name, {Argument(a)...}}); }
#define SUITE_COMMAND_NOT_IN_LISTS SUITE_COMMAND
#define SUITE_PAINT SUITE_COMMAND
#define SUITE_QUERY SUITE_COMMAND
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_PAINT
#undef SUITE_QUERY

  /// The last call is wrong: it must raise the error and do nothing.
  void raises(GLenum error) { calls.back().error = error; }
  void append(const Script& other) { calls.insert(calls.end(), other.calls.begin(), other.calls.end()); }
};

struct GlTable;

/// Plays scripts on a GL. It owns the memory that pointers of the calls lead to, and must live as long as the
/// GL may read it.
class Player {
public:
  explicit Player(const GlTable& gl);
  ~Player();
  /// The first command that the GL does not have, or null; nothing is played then.
  const char* missing(const Script& script) const;
  void play(const Script& script);
  /// The first error or query that came out otherwise than the script says; empty if there is none.
  const std::string& fault() const { return fault_; }

private:
  void paint(const Call& call);
  bool stack_is_right(GLenum depth, GLenum limit);
  void paint(double x, double y, double size, double red, double green, double blue);
  void paint_feedback(const Call& call);
  void paint_selection(const Call& call);
  std::vector<GLubyte> read_colors(int x, int y, int width, int height);
  void paint_elements(const Call& call, size_t first, const std::vector<std::byte>& bytes, bool swapped);
  void check_error(const Call& call);
  void check_query(const Call& call);
  void check_numbers(const Call& call);

  const GlTable& gl_;
  bool inside_ = false;        // between Begin and End, where no error can be asked for
  GLenum error_ = GL_NO_ERROR; // that is still to come, and whose it is
  const char* erroneous_ = "";
  std::string fault_;
  std::vector<std::unique_ptr<std::vector<std::byte>>> memory_;
  GLint mode_result_ = 0; // of the last glRenderMode that raised no error
  GLenum feedback_type_ = GL_2D;
  const std::vector<std::byte>*feedback_ = nullptr, *selection_ = nullptr; // buffers
};

/// The calls as statements of C, one a line. What they paint needs paint_in_c before.
std::string to_c(const Script& script, const char* indent);
/// An argument of a call in C.
std::string c_argument(const Call& call, size_t i);
/// Functions of C that ask what the script's errors and queries claim, for scripts that need them; the first
/// wrong answer makes "wrong" 1. `all_errors`: the end of the program asks for errors, too.
std::string answers_in_c(const Script& script, bool all_errors);
/// A function of C that paints a square, for scripts that need it.
std::string paint_in_c(const Script& script);
/// PaintPixels and the like as a statement.
std::string paint_to_c(const Call& call, const std::string& indent);
/// Functions of C for scripts that select or feed back: the buffers, and what is painted of them.
std::string special_in_c(const Script& script);

/// Pixels of the squares that say whether a GL answers right, and their red for an error.
constexpr int kPaintedSquare = 8;
constexpr double painted_error(GLenum error) { return error == GL_NO_ERROR ? 1 : (error - 0x4ff) / 16.0; }

} // namespace softgl::suite
