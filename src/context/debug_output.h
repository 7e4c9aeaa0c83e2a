// Debug output (GL_KHR_debug, 5.5): messages, which of them a program wants, and where they go.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/gl_types.h"

namespace softgl {

struct Context;

constexpr int kMaxDebugMessageLength = 4096; // with the null behind it
constexpr int kMaxDebugLoggedMessages = 10;
constexpr int kMaxDebugGroupDepth = 64; // the group that is always there counts
constexpr int kMaxLabelLength = 256;

bool is_debug_source(GLenum source);
bool is_debug_type(GLenum type);
bool is_debug_severity(GLenum severity);

struct DebugMessage {
  GLenum source, type;
  GLuint id;
  GLenum severity;
  std::string text;
};

/// Which messages are made: at first all but those of GL_DEBUG_SEVERITY_LOW.
class DebugFilter {
public:
  DebugFilter();
  bool passes(const DebugMessage& message) const;
  /// GL_DONT_CARE: all sources, types or severities.
  void set(GLenum source, GLenum type, GLenum severity, bool enabled);
  /// Of all severities.
  void set_id(GLenum source, GLenum type, GLuint id, bool enabled);

private:
  static constexpr int kSources = 6, kTypes = 9;
  uint8_t of_kind_[kSources][kTypes];                // a bit for each severity
  std::map<std::array<uint32_t, 3>, uint8_t> of_id_; // source, type and id
};

struct DebugGroup {
  DebugMessage begun; // what it was pushed with
  DebugFilter filter;
};

struct DebugOutput {
  GLDEBUGPROC callback = nullptr;
  const void* user_parameter = nullptr;
  std::vector<DebugMessage> log; // the oldest first
  DebugFilter filter;            // of the group that is always there
  std::vector<DebugGroup> groups;
  const char* wrong_argument = nullptr; // of the call that raised the error that waits; null for none

  ~DebugOutput() { watch(false); }
  DebugFilter& active_filter() { return groups.empty() ? filter : groups.back().filter; }
  /// Whether errors shall become messages: the doors look out for them while some context wants it.
  void watch(bool wanted);

private:
  bool watching_ = false;
};

/// Hands the message to the callback, or to the log, if debug output is on and its filter lets it pass. A
/// full log drops it. Throws std::bad_alloc.
void send_debug_message(Context& context, DebugMessage message);

} // namespace softgl
