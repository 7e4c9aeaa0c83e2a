// Messages of the program, the log, filters and groups (GL_KHR_debug, 5.5 and 6.1.15).
#include <algorithm>
#include <cstring>

#include "commands/generated/commands.h"
#include "context/context.h"

namespace softgl {
namespace {

/// The characters of a text; a negative length: up to its null.
size_t length_of(GLsizei length, const GLchar* text) {
  return length < 0 ? strnlen(text, size_t(kMaxDebugMessageLength)) : size_t(length);
}

bool is_of_the_program(GLenum source) {
  return source == GL_DEBUG_SOURCE_APPLICATION || source == GL_DEBUG_SOURCE_THIRD_PARTY;
}

} // namespace

namespace gl {

void DebugMessageControl(Context& c, GLenum source, GLenum type, GLenum severity, GLsizei count,
                         const GLuint* ids, GLboolean enabled) {
  if (count < 0) return set_error(c, GL_INVALID_VALUE, "count");
  if (const char* wrong =
          first_wrong({{"source", source != GL_DONT_CARE && !is_debug_source(source)},
                       {"type", type != GL_DONT_CARE && !is_debug_type(type)},
                       {"severity", severity != GL_DONT_CARE && !is_debug_severity(severity)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  if (count == 0) return c.debug.active_filter().set(source, type, severity, enabled);
  if (source == GL_DONT_CARE || type == GL_DONT_CARE || severity != GL_DONT_CARE)
    return set_error(c, GL_INVALID_OPERATION);
  for (GLsizei i = 0; ids && i < count; ++i) c.debug.active_filter().set_id(source, type, ids[i], enabled);
}

void DebugMessageInsert(Context& c, GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                        const GLchar* buf) {
  if (const char* wrong = first_wrong({{"source", !is_of_the_program(source)},
                                       {"type", !is_debug_type(type)},
                                       {"severity", !is_debug_severity(severity)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  if (!buf) return;
  const size_t size = length_of(length, buf);
  if (size >= size_t(kMaxDebugMessageLength))
    return set_error(c, GL_INVALID_VALUE, length < 0 ? "buf" : "length");
  send_debug_message(c, {source, type, id, severity, std::string(buf, size)});
}

void DebugMessageCallback(Context& c, GLDEBUGPROC callback, const void* userParam) {
  c.debug.callback = callback;
  c.debug.user_parameter = userParam;
}

GLuint GetDebugMessageLog(Context& c, GLuint count, GLsizei bufSize, GLenum* sources, GLenum* types,
                          GLuint* ids, GLenum* severities, GLsizei* lengths, GLchar* messageLog) {
  if (bufSize < 0 && messageLog) return set_error(c, GL_INVALID_VALUE, "bufSize"), 0;
  std::vector<DebugMessage>& log = c.debug.log;
  size_t n = 0, room = messageLog ? size_t(bufSize) : 0;
  for (; n < count && n < log.size(); ++n) {
    const DebugMessage& m = log[n];
    const size_t size = m.text.size() + 1;
    if (messageLog) {
      if (size > room) break;
      std::memcpy(messageLog, m.text.c_str(), size);
      messageLog += size, room -= size;
    }
    if (sources) sources[n] = m.source;
    if (types) types[n] = m.type;
    if (ids) ids[n] = m.id;
    if (severities) severities[n] = m.severity;
    if (lengths) lengths[n] = GLsizei(size);
  }
  log.erase(log.begin(), log.begin() + ptrdiff_t(n));
  return GLuint(n);
}

void PushDebugGroup(Context& c, GLenum source, GLuint id, GLsizei length, const GLchar* message) {
  if (!is_of_the_program(source)) return set_error(c, GL_INVALID_ENUM, "source");
  if (!message) return;
  const size_t size = length_of(length, message);
  if (size >= size_t(kMaxDebugMessageLength))
    return set_error(c, GL_INVALID_VALUE, length < 0 ? "message" : "length");
  std::vector<DebugGroup>& groups = c.debug.groups;
  if (groups.size() + 1 >= size_t(kMaxDebugGroupDepth)) return set_error(c, GL_STACK_OVERFLOW);
  DebugMessage begun{source, GL_DEBUG_TYPE_PUSH_GROUP, id, GL_DEBUG_SEVERITY_NOTIFICATION,
                     std::string(message, size)};
  groups.push_back({begun, c.debug.active_filter()});
  send_debug_message(c, std::move(begun));
}

void PopDebugGroup(Context& c) {
  std::vector<DebugGroup>& groups = c.debug.groups;
  if (groups.empty()) return set_error(c, GL_STACK_UNDERFLOW);
  DebugMessage ended = std::move(groups.back().begun);
  groups.pop_back();
  ended.type = GL_DEBUG_TYPE_POP_GROUP;
  send_debug_message(c, std::move(ended));
}

} // namespace gl
} // namespace softgl
