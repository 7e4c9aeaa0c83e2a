#include "context/debug_output.h"

#include <utility>

#include "base/trace_file.h"
#include "context/context.h"

namespace softgl {
namespace {

constexpr GLenum kSeverities[] = {GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM, GL_DEBUG_SEVERITY_LOW,
                                  GL_DEBUG_SEVERITY_NOTIFICATION};
constexpr uint8_t kAllSeverities = 15, kAtFirst = 1 | 2 | 8;

/// The bits of a severity, or of all.
uint8_t bits_of(GLenum severity) {
  for (int i = 0; i < 4; ++i)
    if (kSeverities[i] == severity) return uint8_t(1 << i);
  return kAllSeverities;
}

int index_of_type(GLenum type) {
  return int(type >= GL_DEBUG_TYPE_MARKER ? 6 + type - GL_DEBUG_TYPE_MARKER : type - GL_DEBUG_TYPE_ERROR);
}

uint8_t changed(uint8_t bits, uint8_t by, bool enabled) { return uint8_t(enabled ? bits | by : bits & ~by); }

} // namespace

bool is_debug_source(GLenum source) {
  return source >= GL_DEBUG_SOURCE_API && source <= GL_DEBUG_SOURCE_OTHER;
}
bool is_debug_type(GLenum type) {
  return (type >= GL_DEBUG_TYPE_ERROR && type <= GL_DEBUG_TYPE_OTHER) ||
         (type >= GL_DEBUG_TYPE_MARKER && type <= GL_DEBUG_TYPE_POP_GROUP);
}
bool is_debug_severity(GLenum severity) { return bits_of(severity) != kAllSeverities; }

DebugFilter::DebugFilter() {
  for (auto& types : of_kind_)
    for (uint8_t& bits : types) bits = kAtFirst;
}

bool DebugFilter::passes(const DebugMessage& m) const {
  const auto id = of_id_.find({m.source, m.type, m.id});
  const uint8_t bits =
      id != of_id_.end() ? id->second : of_kind_[m.source - GL_DEBUG_SOURCE_API][index_of_type(m.type)];
  return bits & bits_of(m.severity);
}

void DebugFilter::set(GLenum source, GLenum type, GLenum severity, bool enabled) {
  const uint8_t by = bits_of(severity);
  for (int s = 0; s < kSources; ++s)
    for (int t = 0; t < kTypes; ++t)
      if ((source == GL_DONT_CARE || source == GLenum(GL_DEBUG_SOURCE_API + s)) &&
          (type == GL_DONT_CARE || t == index_of_type(type)))
        of_kind_[s][t] = changed(of_kind_[s][t], by, enabled);
  for (auto& [kind, bits] : of_id_)
    if ((source == GL_DONT_CARE || source == kind[0]) && (type == GL_DONT_CARE || type == kind[1]))
      bits = changed(bits, by, enabled);
}

void DebugFilter::set_id(GLenum source, GLenum type, GLuint id, bool enabled) {
  of_id_[{source, type, id}] = enabled ? kAllSeverities : 0;
}

void DebugOutput::watch(bool wanted) {
  if (wanted != watching_) watch_calls(wanted);
  watching_ = wanted;
}

void send_debug_message(Context& c, DebugMessage message) {
  DebugOutput& d = c.debug;
  if (!c.client.debug_output || !d.active_filter().passes(message)) return;
  if (d.callback)
    d.callback(message.source, message.type, message.id, message.severity, GLsizei(message.text.size()),
               message.text.c_str(), d.user_parameter);
  else if (d.log.size() < size_t(kMaxDebugLoggedMessages))
    d.log.push_back(std::move(message));
}

} // namespace softgl
