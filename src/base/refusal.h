// Why a command refuses its arguments: the error, and the argument that is to blame.
#pragma once

#include <initializer_list>

#include "base/gl_types.h"

namespace softgl {

struct Refusal {
  GLenum error = GL_NO_ERROR;     // none: it does not
  const char* argument = nullptr; // as gl.xml names it; null where none is to blame alone
  explicit operator bool() const { return error != GL_NO_ERROR; }
};

struct ArgumentCheck {
  const char* argument;
  bool wrong;
};
/// The first argument that is wrong; null if none is.
inline const char* first_wrong(std::initializer_list<ArgumentCheck> arguments) {
  for (const ArgumentCheck& check : arguments)
    if (check.wrong) return check.argument;
  return nullptr;
}

} // namespace softgl
