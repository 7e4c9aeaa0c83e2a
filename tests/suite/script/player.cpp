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

std::vector<std::byte> doubles(const std::vector<double>& numbers) {
  std::vector<std::byte> bytes(sizeof(double) * numbers.size());
  if (!numbers.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

// Turns an argument of a call into one of a function of C.
struct Converter {
  std::vector<std::unique_ptr<std::vector<std::byte>>>& memory;

  template <class T> T convert(const Argument& a) {
    if constexpr (std::is_pointer_v<T>) {
      using Element = std::remove_cv_t<std::remove_pointer_t<T>>;
      auto bytes = std::make_unique<std::vector<std::byte>>();
      if constexpr (std::is_void_v<Element>)
        *bytes = bytes_of(a.memory_type, a.numbers);
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

  template <class... P, size_t... I>
  void invoke(void (*function)(P...), const Call& call, std::index_sequence<I...>) {
    function(convert<P>(call.arguments[I])...);
  }
  template <class... P> void invoke(void (*function)(P...), const Call& call) {
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
#include "script/commands.inc"
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
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
    default: paint(call); break;
    }
  }
}

} // namespace softgl::suite
