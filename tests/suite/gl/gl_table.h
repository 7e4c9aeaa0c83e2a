// The functions of OpenGL 1.1 that the suite calls, found at run time in the library under test.
#pragma once

#include <functional>

#include "script/script.h"

namespace softgl::suite {

using AnyFunction = void (*)();
/// Gives the function with this name, or null.
using Resolver = std::function<AnyFunction(const char* name)>;

struct GlTable {
#define SUITE_COMMAND(name, kinds) decltype(&::gl##name) name = nullptr;
#define SUITE_COMMAND_NOT_IN_LISTS SUITE_COMMAND
#define SUITE_QUERY SUITE_COMMAND
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_QUERY
  // What the suite asks, beside what scripts hold.
  decltype(&::glGetString) GetString = nullptr;
  decltype(&::glGetError) GetError = nullptr;
  decltype(&::glGetIntegerv) GetIntegerv = nullptr;
  decltype(&::glReadPixels) ReadPixels = nullptr;
  decltype(&::glGetTexImage) GetTexImage = nullptr;
  decltype(&::glGetTexLevelParameteriv) GetTexLevelParameteriv = nullptr;
  decltype(&::glGetTexParameterfv) GetTexParameterfv = nullptr;
  decltype(&::glGetTexEnviv) GetTexEnviv = nullptr;
};

/// Functions that the library does not have stay null.
GlTable load_functions(const Resolver& resolve);
/// What the suite cannot do without: GetString, GetError, GetIntegerv, ReadPixels. The name of a missing one,
/// or null.
const char* missing_query(const GlTable& gl);

} // namespace softgl::suite
