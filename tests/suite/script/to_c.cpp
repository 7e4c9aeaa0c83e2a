#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>

#include "script/pixel_types.h"

namespace softgl::suite {
namespace {

// Constants that scripts use. Small values have several names: the letters m and z of commands.inc tell them
// apart.
const std::map<GLenum, const char*>& constant_names() {
  static const std::map<GLenum, const char*> names = {
#define NAME(constant) {constant, #constant},
#include "script/constants.inc"
#undef NAME
  };
  return names;
}

const char* const kModes[] = {"GL_POINTS",     "GL_LINES",          "GL_LINE_LOOP",    "GL_LINE_STRIP",
                              "GL_TRIANGLES",  "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN", "GL_QUADS",
                              "GL_QUAD_STRIP", "GL_POLYGON"};

std::string number(double value, bool single) {
  // The shortest text that gives the same number.
  char text[40];
  const auto end = single ? std::to_chars(text, text + sizeof text, float(value)).ptr
                          : std::to_chars(text, text + sizeof text, value).ptr;
  const std::string s(text, end);
  const bool whole = s.find_first_of(".en") == std::string::npos;
  if (single) return whole ? s + ".0f" : s + "f";
  return whole ? s + ".0" : s;
}

std::string mask_bits(GLbitfield bits, bool of_client) {
  using Names = std::vector<std::pair<GLbitfield, const char*>>;
  static const Names server = {{GL_COLOR_BUFFER_BIT, "GL_COLOR_BUFFER_BIT"},
                               {GL_DEPTH_BUFFER_BIT, "GL_DEPTH_BUFFER_BIT"},
                               {GL_STENCIL_BUFFER_BIT, "GL_STENCIL_BUFFER_BIT"},
                               {GL_LIGHTING_BIT, "GL_LIGHTING_BIT"},
                               {GL_CURRENT_BIT, "GL_CURRENT_BIT"},
                               {GL_ENABLE_BIT, "GL_ENABLE_BIT"},
                               {GL_TRANSFORM_BIT, "GL_TRANSFORM_BIT"},
                               {GL_POLYGON_BIT, "GL_POLYGON_BIT"},
                               {GL_TEXTURE_BIT, "GL_TEXTURE_BIT"},
                               {GL_PIXEL_MODE_BIT, "GL_PIXEL_MODE_BIT"},
                               {GL_ACCUM_BUFFER_BIT, "GL_ACCUM_BUFFER_BIT"},
                               {GL_SCISSOR_BIT, "GL_SCISSOR_BIT"},
                               {GL_POINT_BIT, "GL_POINT_BIT"},
                               {GL_LINE_BIT, "GL_LINE_BIT"},
                               {GL_POLYGON_STIPPLE_BIT, "GL_POLYGON_STIPPLE_BIT"},
                               {GL_FOG_BIT, "GL_FOG_BIT"},
                               {GL_VIEWPORT_BIT, "GL_VIEWPORT_BIT"},
                               {GL_LIST_BIT, "GL_LIST_BIT"},
                               {GL_EVAL_BIT, "GL_EVAL_BIT"}};
  static const Names client = {{GL_CLIENT_PIXEL_STORE_BIT, "GL_CLIENT_PIXEL_STORE_BIT"},
                               {GL_CLIENT_VERTEX_ARRAY_BIT, "GL_CLIENT_VERTEX_ARRAY_BIT"}};
  if (bits == GL_ALL_ATTRIB_BITS && !of_client) return "GL_ALL_ATTRIB_BITS";
  std::string text;
  for (const auto& [bit, name] : of_client ? client : server)
    if (bits & bit) text += (text.empty() ? "" : " | ") + std::string(name), bits &= ~bit;
  return bits || text.empty() ? std::to_string(bits) : text;
}

const char* error_name(GLenum error) {
  switch (error) {
  case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
  case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
  case GL_STACK_OVERFLOW: return "GL_STACK_OVERFLOW";
  case GL_STACK_UNDERFLOW: return "GL_STACK_UNDERFLOW";
  default: return "GL_INVALID_OPERATION";
  }
}

std::string list(const std::vector<double>& numbers, const char* type, bool real) {
  std::string text = "(const " + std::string(type) + "[]){";
  for (size_t i = 0; i < numbers.size(); i++)
    text += (i ? ", " : "") +
            (real ? number(numbers[i], type == std::string("GLfloat")) : std::to_string(int64_t(numbers[i])));
  return text + "}";
}

std::string vector_argument(const Call& call, const Argument& a) {
  const std::string name = facts_of(call.command).name;
  if (facts_of(call.command).query) return list(a.numbers, "GLfloat", true);
  if ((name.ends_with("Textures") || name.ends_with("Queries")) && call.arguments.size() == 2)
    return list(a.numbers, "GLuint", false);
  if (call.command == Command::ClipPlane || name.ends_with("d") || name.ends_with("dv"))
    return list(a.numbers, "GLdouble", true);
  static const std::pair<const char*, const char*> types[] = {
      {"ubv", "GLubyte"}, {"usv", "GLushort"}, {"uiv", "GLuint"},         {"bv", "GLbyte"},
      {"sv", "GLshort"},  {"iv", "GLint"},     {"EdgeFlagv", "GLboolean"}};
  for (const auto& [suffix, type] : types)
    if (name.ends_with(suffix)) return list(a.numbers, type, false);
  return list(a.numbers, "GLfloat", true);
}

std::string memory_argument(const Argument& a) {
  switch (a.memory_type) {
  case GL_FLOAT: return list(a.numbers, "GLfloat", true);
  case GL_DOUBLE: return list(a.numbers, "GLdouble", true);
  case GL_SHORT: return list(a.numbers, "GLshort", false);
  case GL_BYTE: return list(a.numbers, "GLbyte", false);
  case GL_INT: return list(a.numbers, "GLint", false);
  case GL_NONE:
  case GL_BITMAP: break;
  default:
    if (pixel_type(a.memory_type).bytes == 2) return list(a.numbers, "GLushort", false);
    if (pixel_type(a.memory_type).bytes == 4) return list(a.numbers, "GLuint", false);
  }
  return a.numbers.empty() ? "NULL" : list(a.numbers, "GLubyte", false);
}

} // namespace

std::string c_argument(const Call& call, size_t i) {
  const Argument& a = call.arguments[i];
  const auto whole = [&] { return std::to_string(int64_t(a.number)); };
  switch (facts_of(call.command).kinds[i]) {
  case 'e': {
    const auto found = constant_names().find(GLenum(a.number));
    if (a.number == 0 || a.number == 1 || found == constant_names().end()) return whole();
    return found->second;
  }
  case 'm': return kModes[std::min(size_t(a.number), std::size(kModes) - 1)];
  case 'z':
    if (a.number == 0) return "GL_ZERO";
    if (a.number == 1) return "GL_ONE";
    return constant_names().at(GLenum(a.number));
  case 'b': return mask_bits(GLbitfield(a.number), call.command == Command::PushClientAttrib);
  case 'B': return a.number != 0 ? "GL_TRUE" : "GL_FALSE";
  case 'f': return number(a.number, true);
  case 'd': return number(a.number, false);
  case 'v': return vector_argument(call, a);
  case 'o': // special_in_c
    if (call.error != GL_NO_ERROR) return call.command == Command::FeedbackBuffer ? "fed" : "selected";
    return call.command == Command::FeedbackBuffer
               ? "feedbackMemory(" + std::to_string(a.numbers.size()) + ", " + c_argument(call, 1) + ")"
               : "selectionMemory(" + std::to_string(a.numbers.size()) + ")";
  case 'p': return memory_argument(a);
  default: break;
  }
  return whole();
}

const CommandFacts& facts_of(Command command) {
  static const CommandFacts facts[] = {
#define SUITE_COMMAND(name, kinds) {#name, kinds, true, false},
#define SUITE_COMMAND_NOT_IN_LISTS(name, kinds) {#name, kinds, false, false},
#define SUITE_QUERY(name, kinds) {#name, kinds, false, true},
#define SUITE_PAINT SUITE_COMMAND_NOT_IN_LISTS
#include "script/commands.inc"
#undef SUITE_COMMAND
#undef SUITE_COMMAND_NOT_IN_LISTS
#undef SUITE_QUERY
#undef SUITE_PAINT
  };
  return facts[size_t(command)];
}

std::string to_c(const Script& script, const char* indent) {
  std::string text;
  bool inside = false;        // between Begin and End, where no error can be asked for
  GLenum error = GL_NO_ERROR; // that is still to come
  for (const Call& call : script.calls) {
    if (call.command >= Command::Raises) { // the first of paint_commands.inc
      text += paint_to_c(call, indent);
      continue;
    }
    const CommandFacts& facts = facts_of(call.command);
    const bool returns = call.command == Command::RenderMode && call.error == GL_NO_ERROR;
    const bool expects = facts.query && call.error == GL_NO_ERROR;
    text += indent + std::string(expects ? "expect" : returns ? "result = gl" : "gl") + facts.name + "(";
    for (size_t i = 0; i < call.arguments.size(); i++) {
      // What raises an error writes no answer.
      const bool answer = facts.query && !expects && i + 1 == call.arguments.size();
      if (!answer)
        text += (i ? ", " : "") + c_argument(call, i);
      else if (facts.kinds[i] == 'v')
        text += ", (void*)(GLuint[64]){0}";
    }
    const std::vector<double>& numbers = call.arguments.empty() ? V() : call.arguments.back().numbers;
    if (expects && !numbers.empty()) text += ", " + std::to_string(numbers.size());
    text += ");\n";
    if (call.error == GL_NO_ERROR) {
      if (call.command == Command::Begin) inside = true;
      if (call.command == Command::End) inside = false;
    } else if (error == GL_NO_ERROR) { // 2.5: a flag that is set stays
      error = call.error;
    }
    if (inside || error == GL_NO_ERROR) continue;
    text += indent + std::string("expectError(") + error_name(error) + ");\n";
    error = GL_NO_ERROR;
  }
  return text;
}

} // namespace softgl::suite
