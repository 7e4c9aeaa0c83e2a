// A GL's answers become colors in its window, so that one verdict judges all.
#include <algorithm>
#include <stdexcept>

#include "gl/gl_table.h"
#include "script/pixel_types.h"

namespace softgl::suite {
namespace {

// How a stack is filled and emptied.
struct StackCommands {
  GLenum depth;
  bool matrices, client, names;
  const char *push, *pop; // in C
};
const StackCommands& stack_commands(GLenum depth) {
  static const StackCommands commands[] = {
      {GL_ATTRIB_STACK_DEPTH, false, false, false, "glPushAttrib(0)", "glPopAttrib()"},
      {GL_CLIENT_ATTRIB_STACK_DEPTH, false, true, false, "glPushClientAttrib(0)", "glPopClientAttrib()"},
      {GL_NAME_STACK_DEPTH, false, false, true, "glPushName(0)", "glPopName()"},
      {GL_MODELVIEW_STACK_DEPTH, true, false, false, "glPushMatrix()", "glPopMatrix()"},
      {GL_PROJECTION_STACK_DEPTH, true, false, false, "glPushMatrix()", "glPopMatrix()"},
      {GL_TEXTURE_STACK_DEPTH, true, false, false, "glPushMatrix()", "glPopMatrix()"}};
  for (const StackCommands& c : commands)
    if (c.depth == depth) return c;
  throw std::logic_error("a stack that the player does not know");
}

// Memory of `count` elements that say that nobody wrote them.
std::vector<std::byte> untouched_memory(const PixelType& type, int count) {
  return bytes_of(type.type, std::vector<double>(size_t(count), untouched_element(type)));
}

const char* c_type(const PixelType& type) {
  switch (type.type) {
  case GL_FLOAT: return "GLfloat";
  case GL_BYTE: return "GLbyte";
  case GL_SHORT: return "GLshort";
  case GL_INT: return "GLint";
  }
  return type.bytes == 1 ? "GLubyte" : type.bytes == 2 ? "GLushort" : "GLuint";
}

std::string text(double number) {
  std::string s = std::to_string(number);
  while (s.ends_with('0')) s.pop_back();
  return s.ends_with('.') ? s + "0" : s;
}

// The i-th component of "memory" as C computes it.
std::string c_component(const PixelType& type, bool index) {
  const std::string fields = std::to_string(type.fields);
  if (type.fields > 1) {
    std::string shifts, masks;
    for (int i = 0; i < type.fields; i++) {
      shifts += (i ? ", " : "") + std::to_string(type.shift(i));
      masks += (i ? ", " : "") + std::to_string(int(type.greatest(i)));
    }
    return "(memory[i / " + fields + "] >> (int[]){" + shifts + "}[i % " + fields + "] & (int[]){" + masks +
           "}[i % " + fields + "]) / (double)(int[]){" + masks + "}[i % " + fields + "]";
  }
  if (index) return "memory[i] / 255.0";
  if (type.is_float) return "memory[i]";
  return (type.is_signed ? "(2.0 * memory[i] + 1) / " : "memory[i] / ") + text(type.greatest(0));
}

} // namespace

void Player::paint(double x, double y, double size, double red, double green, double blue) {
  gl_.PushAttrib(GL_COLOR_BUFFER_BIT | GL_SCISSOR_BIT);
  gl_.Enable(GL_SCISSOR_TEST), gl_.Scissor(GLint(x), GLint(y), GLsizei(size), GLsizei(size));
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.ClearColor(GLclampf(red), GLclampf(green), GLclampf(blue), 1), gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.PopAttrib();
}

std::vector<GLubyte> Player::read_colors(int x, int y, int width, int height) {
  std::vector<GLubyte> bytes(size_t(4 * width * height));
  gl_.ReadPixels(x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

void Player::paint_elements(const Call& call, size_t first, const std::vector<std::byte>& bytes,
                            bool swapped) {
  const PixelType& type = pixel_type(call.e(first - 2));
  const int columns = int(call.n(first + 2)), size = int(call.n(first + 3));
  for (size_t i = 0; i < bytes.size() / size_t(type.bytes) * size_t(type.fields); i++) {
    const auto from = bytes.begin() + long(i) / type.fields * type.bytes;
    std::vector<std::byte> element(from, from + type.bytes);
    if (swapped) std::reverse(element.begin(), element.end());
    const double gray =
        painted_component(type, is_index(call.e(first - 3)), element.data(), int(i) % type.fields);
    paint(call.n(first) + int(i) % columns * size, call.n(first + 1) + int(i) / columns * size, size, gray,
          gray, gray);
  }
}

bool Player::stack_is_right(GLenum depth, GLenum limit) {
  const StackCommands& stack = stack_commands(depth);
  const auto is = [&](int entries, GLenum error) {
    GLint got = -1;
    gl_.GetIntegerv(depth, &got);
    const GLenum raised = gl_.GetError();
    return got == entries && raised == error;
  };
  const auto push = [&] {
    stack.matrices ? gl_.PushMatrix()
    : stack.client ? gl_.PushClientAttrib(0)
    : stack.names  ? gl_.PushName(0)
                   : gl_.PushAttrib(0);
  };
  const auto pop = [&] {
    stack.matrices ? gl_.PopMatrix()
    : stack.client ? gl_.PopClientAttrib()
    : stack.names  ? gl_.PopName()
                   : gl_.PopAttrib();
  };
  const int bottom = stack.matrices;
  GLint most = 0;
  gl_.GetIntegerv(limit, &most);
  if (!is(bottom, GL_NO_ERROR) || most > 100000) return false;
  for (int i = bottom; i < most; i++) push();
  bool right = is(most, GL_NO_ERROR);
  push(), right = is(most, GL_STACK_OVERFLOW) && right;
  for (int i = bottom; i < most; i++) pop();
  right = is(bottom, GL_NO_ERROR) && right;
  pop();
  return is(bottom, GL_STACK_UNDERFLOW) && right;
}

void Player::paint(const Call& call) {
  const auto n = [&](size_t i) { return GLint(call.n(i)); };
  const auto judge = [&](double value, size_t low) {
    const bool right = value >= call.n(low) && value <= call.n(low + 1);
    paint(call.n(low + 2), call.n(low + 3), kPaintedSquare, !right, right, 0);
  };
  GLint integers[16] = {};
  GLfloat floats[16] = {};
  switch (call.command) {
  case Command::Raises: break;
  case Command::PaintError: paint(n(0), n(1), kPaintedSquare, painted_error(gl_.GetError()), 0, 0); break;
  case Command::PaintInteger: gl_.GetIntegerv(call.e(0), integers), judge(integers[0], 1); break;
  case Command::PaintEqual: {
    GLint others[16] = {};
    gl_.GetIntegerv(call.e(0), integers), gl_.GetIntegerv(call.e(2), others);
    const bool same = integers[n(1)] == others[n(3)];
    paint(n(4), n(5), kPaintedSquare, !same, same, 0);
    break;
  }
  case Command::PaintStack: {
    const bool names = stack_commands(call.e(0)).names; // a stack of names is there while something selects
    GLuint hits[4] = {};
    if (names) gl_.SelectBuffer(4, hits), gl_.RenderMode(GL_SELECT);
    const bool right = stack_is_right(call.e(0), call.e(1));
    if (names) gl_.RenderMode(GL_RENDER);
    paint(n(2), n(3), kPaintedSquare, !right, right, 0);
    break;
  }
  case Command::PaintFeedback: paint_feedback(call); break;
  case Command::PaintSelection: paint_selection(call); break;
  case Command::PaintTexLevel:
    if (!gl_.GetTexLevelParameteriv) return;
    gl_.GetTexLevelParameteriv(call.e(0), n(1), call.e(2), integers), judge(integers[0], 3);
    break;
  case Command::PaintTexParameter:
    if (!gl_.GetTexParameterfv) return;
    gl_.GetTexParameterfv(call.e(0), call.e(1), floats), judge(double(floats[0]), 2);
    break;
  case Command::PaintTexEnv:
    if (!gl_.GetTexEnviv) return;
    gl_.GetTexEnviv(call.e(0), call.e(1), integers), judge(integers[0], 2);
    break;
  case Command::PaintPixels: {
    std::vector<std::byte> bytes = untouched_memory(pixel_type(call.e(5)), n(6));
    gl_.ReadPixels(n(0), n(1), n(2), n(3), call.e(4), call.e(5), bytes.data());
    paint_elements(call, 7, bytes, call.n(11) != 0);
    break;
  }
  case Command::PaintQuery: {
    GLuint count = 0;
    if (!gl_.GetQueryObjectuiv) return;
    gl_.GetQueryObjectuiv(GLuint(call.n(0)), GL_QUERY_RESULT, &count);
    for (int byte = 0; byte < 2; byte++) {
      const double gray = (count >> 8 * byte & 255) / 255.0;
      paint(call.n(1) + byte * kPaintedSquare, call.n(2), kPaintedSquare, gray, gray, gray);
    }
    break;
  }
  case Command::PaintSame: {
    const std::vector<GLubyte> one = read_colors(n(0), n(1), n(4), n(5)),
                               other = read_colors(n(2), n(3), n(4), n(5));
    paint(call.n(6), call.n(7), kPaintedSquare, one != other, one == other, 0);
    break;
  }
  case Command::PaintRising: {
    bool rises = true;
    int last = 0;
    for (int i = 0; i < n(4); i++) {
      const int red = read_colors(n(0) + i * n(2), n(1) + i * n(3), 1, 1)[0];
      rises &= red >= last, last = red;
    }
    paint(call.n(5), call.n(6), kPaintedSquare, !rises, rises, 0);
    break;
  }
  case Command::PaintTexImage: {
    if (!gl_.GetTexImage) return;
    std::vector<std::byte> bytes = untouched_memory(pixel_type(call.e(3)), n(4));
    gl_.GetTexImage(call.e(0), n(1), call.e(2), call.e(3), bytes.data());
    paint_elements(call, 5, bytes, false);
    break;
  }
  default: throw std::logic_error("a call that the player does not know");
  }
}

std::string paint_in_c(const Script& script) {
  const bool paints = std::any_of(script.calls.begin(), script.calls.end(),
                                  [](const Call& c) { return c.command > Command::Raises; });
  return !paints ? "" : R"(static void paint(int x, int y, int size, double red, double green, double blue) {
  glPushAttrib(GL_COLOR_BUFFER_BIT | GL_SCISSOR_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, size, size);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(red, green, blue, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glPopAttrib();
}

)";
}

std::string paint_to_c(const Call& call, const std::string& indent) {
  const auto n = [&](size_t i) { return c_argument(call, i); };
  const auto judged = [&](const std::string& variable, const std::string& query, size_t low) {
    const std::string right = "answer[0] >= " + n(low) + " && answer[0] <= " + n(low + 1);
    return indent + "{ " + variable + " answer[16] = {0}; " + query + "; paint(" + n(low + 2) + ", " +
           n(low + 3) + ", " + std::to_string(kPaintedSquare) + ", !(" + right + "), " + right + ", 0); }\n";
  };
  const auto elements = [&](const std::string& query, size_t first) {
    const PixelType& type = pixel_type(call.e(first - 2));
    const std::string count = n(first - 1), size = n(first + 3), columns = n(first + 2);
    return indent + "{\n" + indent + "  " + c_type(type) + " memory[" + count + "];\n" + indent +
           "  for (int i = 0; i < " + count + "; i++) memory[i] = " + text(untouched_element(type)) + ";\n" +
           indent + "  " + query + "\n" + indent + "  for (int i = 0; i < " + count + " * " +
           std::to_string(type.fields) + "; i++) {\n" + indent +
           "    const double gray = " + c_component(type, is_index(call.e(first - 3))) + ";\n" + indent +
           "    paint(" + n(first) + " + i % " + columns + " * " + size + ", " + n(first + 1) + " + i / " +
           columns + " * " + size + ", " + size + ", gray, gray, gray);\n" + indent + "  }\n" + indent +
           "}\n";
  };
  switch (call.command) {
  case Command::Raises: return indent + "/* The next call raises " + n(0) + ". */\n";
  case Command::PaintError:
    return indent + "{ const GLenum error = glGetError(); paint(" + n(0) + ", " + n(1) + ", " +
           std::to_string(kPaintedSquare) + ", error ? (error - 0x4ff) / 16.0 : 1.0, 0, 0); }\n";
  case Command::PaintInteger: return judged("GLint", "glGetIntegerv(" + n(0) + ", answer)", 1);
  case Command::PaintEqual:
    return indent + "{ GLint a[16] = {0}, b[16] = {0}; glGetIntegerv(" + n(0) + ", a); glGetIntegerv(" +
           n(2) + ", b); paint(" + n(4) + ", " + n(5) + ", " + std::to_string(kPaintedSquare) + ", a[" +
           n(1) + "] != b[" + n(3) + "], a[" + n(1) + "] == b[" + n(3) + "], 0); }\n";
  case Command::PaintStack: {
    const StackCommands& stack = stack_commands(call.e(0));
    const std::string bottom = std::to_string(stack.matrices), inner = indent + "  ";
    const auto repeated = [&](const char* what) {
      return inner + "for (int i = " + bottom + "; i < most; i++) " + what + ";\n";
    };
    const auto is = [&](const std::string& entries, const char* error) {
      return inner + "glGetIntegerv(" + n(0) + ", &depth);\n" + inner + "right = depth == " + entries +
             " && glGetError() == " + error + " && right;\n";
    };
    const std::string selects = inner + "GLuint hits[4];\n" + inner + "glSelectBuffer(4, hits);\n" + inner +
                                "glRenderMode(GL_SELECT);\n",
                      renders = inner + "glRenderMode(GL_RENDER);\n";
    return indent + "{\n" + inner + "GLint depth = 0, most = 0, right = 1;\n" + (stack.names ? selects : "") +
           inner + "glGetIntegerv(" + n(1) + ", &most);\n" + repeated(stack.push) +
           is("most", "GL_NO_ERROR") + inner + stack.push + ";\n" + is("most", "GL_STACK_OVERFLOW") +
           repeated(stack.pop) + is(bottom, "GL_NO_ERROR") + inner + stack.pop + ";\n" +
           is(bottom, "GL_STACK_UNDERFLOW") + (stack.names ? renders : "") + inner + "paint(" + n(2) + ", " +
           n(3) + ", " + std::to_string(kPaintedSquare) + ", !right, right, 0);\n" + indent + "}\n";
  }
  case Command::PaintFeedback: return indent + "paintFeedback(" + n(0) + ", " + n(1) + ");\n";
  case Command::PaintSelection: return indent + "paintSelection(" + n(0) + ");\n";
  case Command::PaintTexLevel:
    return judged("GLint", "glGetTexLevelParameteriv(" + n(0) + ", " + n(1) + ", " + n(2) + ", answer)", 3);
  case Command::PaintTexParameter:
    return judged("GLfloat", "glGetTexParameterfv(" + n(0) + ", " + n(1) + ", answer)", 2);
  case Command::PaintTexEnv: return judged("GLint", "glGetTexEnviv(" + n(0) + ", " + n(1) + ", answer)", 2);
  case Command::PaintQuery:
    return indent + "{ GLuint count = 0; glGetQueryObjectuiv(" + n(0) + ", GL_QUERY_RESULT, &count);\n" +
           indent +
           "  for (int i = 0; i < 2; i++) { const double gray = (count >> 8 * i & 255) / 255.0; paint(" +
           n(1) + " + 8 * i, " + n(2) + ", 8, gray, gray, gray); } }\n";
  case Command::PaintSame:
    return indent + "{ static GLubyte one[" + n(4) + " * " + n(5) + " * 4], other[sizeof one];\n" + indent +
           "  glReadPixels(" + n(0) + ", " + n(1) + ", " + n(4) + ", " + n(5) +
           ", GL_RGBA, GL_UNSIGNED_BYTE, one);\n" + indent + "  glReadPixels(" + n(2) + ", " + n(3) + ", " +
           n(4) + ", " + n(5) + ", GL_RGBA, GL_UNSIGNED_BYTE, other);\n" + indent +
           "  const int same = memcmp(one, other, sizeof one) == 0; paint(" + n(6) + ", " + n(7) +
           ", 8, !same, same, 0); }\n";
  case Command::PaintRising:
    return indent + "{ int rises = 1, last = 0;\n" + indent + "  for (int i = 0; i < " + n(4) +
           "; i++) { GLubyte c[4]; glReadPixels(" + n(0) + " + i * " + n(2) + ", " + n(1) + " + i * " + n(3) +
           ", 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, c); rises &= c[0] >= last; last = c[0]; }\n" + indent +
           "  paint(" + n(5) + ", " + n(6) + ", 8, !rises, rises, 0); }\n";
  case Command::PaintPixels: {
    std::string query = "glReadPixels(" + n(0) + ", " + n(1) + ", " + n(2) + ", " + n(3) + ", " + n(4) +
                        ", " + n(5) + ", memory);";
    if (call.n(11) != 0) // the program reads the elements as the window has them
      query += "\n" + indent + "  for (int i = 0; i < " + n(6) +
               "; i++) for (size_t k = 0; k < sizeof memory[0] / 2; k++) { char* c = (char*)&memory[i]; "
               "const char b = c[k]; "
               "c[k] = c[sizeof memory[0] - 1 - k]; c[sizeof memory[0] - 1 - k] = b; }";
    return elements(query, 7);
  }
  case Command::PaintTexImage:
    return elements("glGetTexImage(" + n(0) + ", " + n(1) + ", " + n(2) + ", " + n(3) + ", memory);", 5);
  default: throw std::logic_error("nothing that is painted");
  }
}

} // namespace softgl::suite
