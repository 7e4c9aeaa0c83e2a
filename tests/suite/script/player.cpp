#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "gl/gl_table.h"
#include "script/pixel_types.h"

namespace softgl::suite {
namespace {

GLenum type_of_element(GLfloat) { return GL_FLOAT; }
GLenum type_of_element(GLint) { return GL_INT; }
GLenum type_of_element(GLuint) { return GL_UNSIGNED_INT; }
GLenum type_of_element(GLubyte) { return GL_UNSIGNED_BYTE; }
GLenum type_of_element(GLbyte) { return GL_BYTE; }
GLenum type_of_element(GLshort) { return GL_SHORT; }
GLenum type_of_element(GLushort) { return GL_UNSIGNED_SHORT; }

std::vector<std::byte> doubles(const std::vector<double>& numbers) {
  std::vector<std::byte> bytes(sizeof(double) * numbers.size());
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// Turns an argument of a call into one of a function of C.
struct Converter {
  std::vector<std::unique_ptr<std::vector<std::byte>>>& memory;
  GLint result = 0; // of the last function that has one

  template <class T> T convert(const Argument& a) {
    if constexpr (std::is_pointer_v<T>) {
      using Element = std::remove_cv_t<std::remove_pointer_t<T>>;
      auto bytes = std::make_unique<std::vector<std::byte>>();
      if constexpr (std::is_void_v<Element>)
        *bytes = a.memory_type == GL_DOUBLE ? doubles(a.numbers) : bytes_of(a.memory_type, a.numbers);
      else if constexpr (std::is_same_v<Element, GLdouble>)
        *bytes = doubles(a.numbers);
      else
        *bytes = bytes_of(type_of_element(Element{}), a.numbers);
      if (bytes->empty()) return nullptr;
      memory.push_back(std::move(bytes));
      return reinterpret_cast<T>(memory.back()->data());
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<T>(a.number);
    } else {
      return static_cast<T>(static_cast<int64_t>(a.number));
    }
  }

  template <class R, class... P, size_t... I>
  void invoke(R (*function)(P...), const Call& call, std::index_sequence<I...>) {
    if constexpr (std::is_void_v<R>)
      function(convert<P>(call.arguments[I])...);
    else
      result = GLint(function(convert<P>(call.arguments[I])...));
  }
  template <class R, class... P> void invoke(R (*function)(P...), const Call& call) {
    invoke(function, call, std::index_sequence_for<P...>{});
  }
};

} // namespace

Player::Player(const GlTable& gl) : gl_(gl) {}
Player::~Player() = default;

const char* Player::missing(const Script& script) const {
  for (const Call& call : script.calls) {
    bool there = false;
    switch (call.command) {
#define SUITE_COMMAND(name, kinds) \
  case Command::name: \
    there = gl_.name != nullptr; \
    break;
#define SUITE_COMMAND_NOT_IN_LISTS SUITE_COMMAND
#define SUITE_QUERY SUITE_COMMAND
#include "script/commands.inc"
#undef SUITE_QUERY
    default: there = true; // what is painted
    }
    if (!there) return facts_of(call.command).name;
  }
  return nullptr;
}

void Player::play(const Script& script) {
  Converter converter{memory_};
  for (const Call& call : script.calls) {
    switch (call.command) {
#undef SUITE_COMMAND
#define SUITE_COMMAND(name, kinds) \
  case Command::name: \
    converter.invoke(gl_.name, call); \
    break;
#define SUITE_QUERY(name, kinds) \
  case Command::name: \
    break;
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_QUERY
    default: paint(call); break;
    }
    if (facts_of(call.command).query) check_query(call);
    if (call.error == GL_NO_ERROR) {
      const std::vector<std::byte>* last = memory_.empty() ? nullptr : memory_.back().get();
      if (call.command == Command::RenderMode) mode_result_ = converter.result;
      if (call.command == Command::FeedbackBuffer) feedback_ = last, feedback_type_ = call.e(1);
      if (call.command == Command::SelectBuffer) selection_ = last;
    }
    check_error(call);
  }
}

void Player::check_error(const Call& call) {
  if (call.error == GL_NO_ERROR) {
    if (call.command == Command::Begin) inside_ = true;
    if (call.command == Command::End) inside_ = false;
  } else if (error_ == GL_NO_ERROR) { // 2.5: a flag that is set stays
    error_ = call.error, erroneous_ = facts_of(call.command).name;
  }
  if (inside_ || error_ == GL_NO_ERROR) return;
  const GLenum got = gl_.GetError();
  if (got != error_ && fault_.empty()) {
    char text[120];
    std::snprintf(text, sizeof text, "gl%s raises the GL error 0x%04x and should raise 0x%04x", erroneous_,
                  got, error_);
    fault_ = text;
  }
  error_ = GL_NO_ERROR;
}

void Player::check_query(const Call& call) {
  bool got = false;
  switch (call.command) {
  case Command::IsEnabled: got = gl_.IsEnabled(call.e(0)) != GL_FALSE; break;
  case Command::IsList: got = gl_.IsList(call.e(0)) != GL_FALSE; break;
  case Command::IsQuery: got = gl_.IsQuery(call.e(0)) != GL_FALSE; break;
  default: check_numbers(call); return;
  }
  if (got == (call.n(1) != 0) || call.error != GL_NO_ERROR || !fault_.empty()) return;
  char text[120];
  std::snprintf(text, sizeof text, "gl%s(0x%04x) is wrong: %d, should be %d", facts_of(call.command).name,
                call.e(0), got, !got);
  fault_ = text;
}

void Player::check_numbers(const Call& call) {
  const std::vector<double>& wanted = call.arguments.back().numbers;
  const size_t count = std::max<size_t>(wanted.size(), 64);
  std::vector<GLfloat> got(count, -98765.0f); // of a GL that answers nothing
  std::vector<GLint> integers(count, -98765);
  std::vector<GLuint> naturals(count, 98765);
  switch (call.command) {
  case Command::GetFloatv: gl_.GetFloatv(call.e(0), got.data()); break;
  case Command::GetMapfv: gl_.GetMapfv(call.e(0), call.e(1), got.data()); break;
  case Command::GetQueryiv:
    gl_.GetQueryiv(call.e(0), call.e(1), integers.data());
    std::copy(integers.begin(), integers.end(), got.begin());
    break;
  default:
    gl_.GetQueryObjectuiv(call.e(0), call.e(1), naturals.data());
    std::copy(naturals.begin(), naturals.end(), got.begin());
  }
  if (call.error != GL_NO_ERROR) return;
  for (size_t i = 0; i < wanted.size(); i++) {
    if (std::abs(double(got[i]) - wanted[i]) <= 5e-5 * std::max(std::abs(wanted[i]), 0.02)) continue;
    char text[120];
    std::snprintf(text, sizeof text, "gl%s(0x%04x)[%zu] is wrong: %.9g, should be %.9g",
                  facts_of(call.command).name, call.e(0), i, double(got[i]), wanted[i]);
    if (fault_.empty()) fault_ = text;
  }
}

} // namespace softgl::suite
