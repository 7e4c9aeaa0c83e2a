#include "gl/gl_table.h"

namespace softgl::suite {

GlTable load_functions(const Resolver& resolve) {
  GlTable gl;
#define SUITE_COMMAND(name, kinds) gl.name = reinterpret_cast<decltype(gl.name)>(resolve("gl" #name));
#define SUITE_COMMAND_NOT_IN_LISTS SUITE_COMMAND
#define SUITE_QUERY SUITE_COMMAND
#include "script/commands.inc"
  SUITE_COMMAND(GetString, "")
  SUITE_COMMAND(GetError, "")
  SUITE_COMMAND(GetIntegerv, "")
  SUITE_COMMAND(ReadPixels, "")
  SUITE_COMMAND(GetTexImage, "")
  SUITE_COMMAND(GetTexLevelParameteriv, "")
  SUITE_COMMAND(GetTexParameterfv, "")
  SUITE_COMMAND(GetTexEnviv, "")
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_QUERY
  return gl;
}

const char* missing_query(const GlTable& gl) {
  if (!gl.GetString) return "glGetString";
  if (!gl.GetError) return "glGetError";
  if (!gl.GetIntegerv) return "glGetIntegerv";
  if (!gl.ReadPixels) return "glReadPixels";
  return nullptr;
}

} // namespace softgl::suite
