#include "api/call_trace.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <string>
#include <utility>

#include "api/argument_conversion.h"
#include "api/trace_tables.h"
#include "commands/get_conversion.h"
#include "context/context.h"

namespace softgl {

constinit thread_local bool inside_traced_call = false;

namespace {

constexpr int kMostValues = 64; // of an array

const char* text_at(uint32_t place) { return kTraceText + place; }

const char* find_name(uint8_t group, uint32_t value) {
  const TraceName *const first = kTraceNames + kTraceGroups[group], *const last =
                                                                        kTraceNames + kTraceGroups[group + 1];
  const TraceName* found =
      std::lower_bound(first, last, value, [](const TraceName& n, uint32_t v) { return n.value < v; });
  return found != last && found->value == value ? text_at(found->name) : nullptr;
}

/// A name of the group; else any, for what stands in the place of a name and is not of the group.
const char* name_of(uint8_t group, uint32_t value) {
  const char* name = group != kNoNames ? find_name(group, value) : nullptr;
  return name ? name : find_name(kAnyName, value);
}

uint8_t group_of_values(uint32_t parameter) {
  const TraceValueGroup *const first = kTraceValueGroups, *const last = first + kTraceValueGroupCount;
  const TraceValueGroup* found = std::lower_bound(
      first, last, parameter, [](const TraceValueGroup& g, uint32_t p) { return g.parameter < p; });
  return found != last && found->parameter == parameter ? found->group : kNoNames;
}

/// GL_COLOR_BUFFER_BIT|GL_DEPTH_BUFFER_BIT; what has no name in hexadecimal.
void put_bits(TraceText& text, uint8_t group, uint32_t bits) {
  const char* whole = group != kNoNames ? find_name(group, bits) : nullptr;
  if (whole) return text.put(whole);
  if (bits == 0) return text.put('0');
  const char* between = "";
  for (uint32_t bit = 1u << 31; bit != 0; bit >>= 1) {
    const char* name = bits & bit && group != kNoNames ? find_name(group, bit) : nullptr;
    if (!name) continue;
    text.put(between);
    text.put(name);
    between = "|";
    bits &= ~bit;
  }
  if (bits) text.print("%s0x%x", between, bits);
}

void put_string(TraceText& text, uint64_t pointer) {
  const auto* next = reinterpret_cast<const char*>(pointer);
  if (!next) return text.put("NULL");
  text.put('"');
  for (char c; read_program_memory(&c, next, 1) && c; ++next) text.put(c < ' ' || c == '"' ? '?' : c);
  text.put('"');
}

void put_floating(TraceText& text, uint8_t group, double value, int digits) {
  const bool whole = value >= 0 && value <= 4294967295.0 && value == double(uint32_t(value));
  const char* name = whole && group != kNoNames ? name_of(group, uint32_t(value)) : nullptr;
  name ? text.put(name) : text.print("%.*g", digits, value);
}

void put_value(TraceText& text, TraceType type, uint8_t group, uint64_t value) {
  const auto low = uint32_t(value);
  switch (type) {
  case TraceType::Void: return;
  case TraceType::Float: return put_floating(text, group, std::bit_cast<double>(value), 9);
  case TraceType::Double: return put_floating(text, group, std::bit_cast<double>(value), 17);
  case TraceType::Bits: return put_bits(text, group, low);
  case TraceType::Boolean: return low <= 1 ? text.put(low ? "GL_TRUE" : "GL_FALSE") : text.print("%u", low);
  case TraceType::Enum: {
    const char* name = name_of(group, low);
    return name ? text.put(name) : text.print("0x%04x", low);
  }
  case TraceType::Pointer:
    return value ? text.print("0x%llx", static_cast<unsigned long long>(value)) : text.put("NULL");
  case TraceType::String: return put_string(text, value);
  default: break;
  }
  if (const char* name = group != kNoNames ? name_of(group, low) : nullptr) return text.put(name);
  if (type == TraceType::UnsignedLong)
    text.print("%llu", static_cast<unsigned long long>(value));
  else
    text.print("%lld", static_cast<long long>(value));
}

template <class T> uint64_t value_at(const unsigned char* memory) {
  T value;
  std::memcpy(&value, memory, sizeof value);
  return traced_value(value);
}

struct ElementType {
  size_t bytes;
  uint64_t (*read)(const unsigned char* memory);
};
ElementType element_type(TraceType type) {
  switch (type) {
  case TraceType::Byte: return {1, value_at<GLbyte>};
  case TraceType::UnsignedByte:
  case TraceType::Boolean: return {1, value_at<GLubyte>};
  case TraceType::Short: return {2, value_at<GLshort>};
  case TraceType::UnsignedShort: return {2, value_at<GLushort>};
  case TraceType::Int: return {4, value_at<GLint>};
  case TraceType::Float: return {4, value_at<GLfloat>};
  case TraceType::Double: return {8, value_at<GLdouble>};
  case TraceType::Long:
  case TraceType::UnsignedLong:
  case TraceType::Pointer:
  case TraceType::String: return {8, value_at<uint64_t>};
  default: return {4, value_at<GLuint>};
  }
}

/// {1, 2, 3}; the pointer where there is nothing to be read.
void put_values(TraceText& text, TraceType type, uint8_t group, uint64_t pointer, int64_t count) {
  unsigned char memory[kMostValues * 8];
  const ElementType element = element_type(type);
  const auto shown = size_t(std::clamp<int64_t>(count, 0, kMostValues));
  if (!pointer || shown == 0 ||
      !read_program_memory(memory, reinterpret_cast<const void*>(pointer), shown * element.bytes))
    return put_value(text, TraceType::Pointer, kNoNames, pointer);
  for (size_t i = 0; i < shown; ++i) {
    text.put(i ? ", " : "{");
    put_value(text, type, group, element.read(memory + i * element.bytes));
  }
  text.put(count > kMostValues ? ", ...}" : "}");
}

TraceType type_of_lists(GLenum type) {
  switch (type) {
  case GL_BYTE: return TraceType::Byte;
  case GL_UNSIGNED_BYTE: return TraceType::UnsignedByte;
  case GL_SHORT: return TraceType::Short;
  case GL_UNSIGNED_SHORT: return TraceType::UnsignedShort;
  case GL_INT: return TraceType::Int;
  case GL_UNSIGNED_INT: return TraceType::UnsignedInt;
  case GL_FLOAT: return TraceType::Float;
  default: return TraceType::Pointer; // GL_2_BYTES and so on: numbers that are cut up
  }
}

/// {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, 0}
void put_attributes(TraceText& text, uint8_t group, uint64_t pointer) {
  const auto* next = reinterpret_cast<const GLint*>(pointer);
  GLint pair[2];
  if (!next) return text.put("NULL");
  text.put('{');
  for (int i = 0; i < kMostValues && read_program_memory(pair, next, 4) && pair[0] != 0; ++i, next += 2) {
    if (!read_program_memory(pair, next, 8)) break;
    put_value(text, TraceType::Enum, group, uint32_t(pair[0]));
    text.put(", ");
    put_value(text, TraceType::Int, group_of_values(uint32_t(pair[0])), uint64_t(pair[1]));
    text.put(", ");
  }
  text.put("0}");
}

/// The values that argument `i` points to.
void put_array(TraceText& text, const TraceParameter& p, const uint64_t* arguments, int i) {
  const auto before = i > 0 ? uint32_t(arguments[i - 1]) : 0;
  const uint8_t group = p.group == kNamesOfParameter ? group_of_values(before) : p.group;
  switch (p.length) {
  case TraceLength::Fixed: return put_values(text, p.type, group, arguments[i], p.operand);
  case TraceLength::Argument:
    return put_values(text, p.type, group, arguments[i], GLint(arguments[p.operand]));
  case TraceLength::Parameter:
    return put_values(text, p.type, group, arguments[i], int64_t(count_of(CountTable(p.operand), before)));
  case TraceLength::State:
    return put_values(text, p.type, group, arguments[i], state_value_count(*current_context, before));
  case TraceLength::Lists: {
    const TraceType type = type_of_lists(GLenum(arguments[1]));
    return put_values(text, type, kNoNames, arguments[i],
                      type == TraceType::Pointer ? 0 : GLint(arguments[0]));
  }
  case TraceLength::Attributes: return put_attributes(text, p.group, arguments[i]);
  case TraceLength::Value: return;
  }
}

void put_argument(TraceText& text, const TraceParameter& p, const uint64_t* arguments, int i) {
  if (p.length == TraceLength::Value) {
    const bool by_name = p.group == kNamesOfParameter && i > 0;
    put_value(text, p.type, by_name ? group_of_values(uint32_t(arguments[i - 1])) : p.group, arguments[i]);
  } else if (p.out) {
    put_value(text, TraceType::Pointer, kNoNames, arguments[i]);
  } else {
    put_array(text, p, arguments, i);
  }
}

/// The context in which the call may raise an error; null where there is none. OSMesa's functions raise none,
/// and may delete it; glGetError gives out the one that waits.
Context* context_of_errors(const char* name) {
  Context* c = current_context;
  const bool watched = name[0] == 'g' && std::strcmp(name, "glGetError") != 0;
  return watched && !(c->guard & kNoContext) ? c : nullptr;
}

GLenum begin_call(const char* name) {
  inside_traced_call = true;
  Context* c = context_of_errors(name);
  return c ? std::exchange(c->error, GLenum(GL_NO_ERROR)) : GL_NO_ERROR;
}

/// The error that the call raised; the one that waited before is back in its place.
GLenum end_call(const char* name, GLenum error_before) {
  GLenum raised = GL_NO_ERROR;
  if (Context* c = context_of_errors(name)) {
    raised = c->error;
    if (error_before != GL_NO_ERROR) c->error = error_before;
  }
  inside_traced_call = false;
  return raised;
}

void put_call(TraceText& text, const TraceCall& row, const uint64_t* arguments) {
  text.put(text_at(row.name));
  text.put('(');
  for (int i = 0; i < row.parameter_count; ++i) {
    if (i) text.put(", ");
    put_argument(text, kTraceParameters[row.parameter + i], arguments, i);
  }
  text.put(')');
}

/// A parameter has the name that set_error() was given: the scalar form of "params" is "param".
bool has_name(const TraceParameter& p, const char* name) {
  const char* own = text_at(p.name);
  return std::strcmp(own, name) == 0 || (std::strcmp(own, "param") == 0 && std::strcmp(name, "params") == 0);
}

/// ": cap = GL_FOG_MODE", the argument that is to blame. An error of a list that is played has none.
void put_wrong_argument(TraceText& text, const TraceCall& row, const uint64_t* arguments, const char* name) {
  for (int i = 0; name && i < row.parameter_count; ++i) {
    const TraceParameter& p = kTraceParameters[row.parameter + i];
    if (!has_name(p, name)) continue;
    text.print(": %s = ", text_at(p.name));
    return put_argument(text, p, arguments, i);
  }
}

/// The message of an error (GL_KHR_debug): which one, the call, and the argument that is to blame. Where
/// memory ends there is none.
void report_error(GLenum error, auto&& put) noexcept try {
  Context& c = *current_context;
  if (error == GL_NO_ERROR || !c.client.debug_output) return;
  TraceText text;
  put_value(text, TraceType::Enum, kAnyName, error);
  text.put(": ");
  put(text);
  const size_t size = std::min(text.size(), size_t(kMaxDebugMessageLength - 1));
  send_debug_message(c, {GL_DEBUG_SOURCE_API, GL_DEBUG_TYPE_ERROR, error, GL_DEBUG_SEVERITY_HIGH,
                         std::string(text.data(), size)});
} catch (const std::bad_alloc&) {}

void put_error(TraceText& text, GLenum error) {
  if (error == GL_NO_ERROR) return;
  text.put(" ! ");
  put_value(text, TraceType::Enum, kAnyName, error);
}

} // namespace

uint32_t begin_traced_call(TracedCall call, const uint64_t* arguments) {
  const TraceCall& row = kTraceCalls[int(call)];
  if (tracing) {
    TraceText text;
    put_call(text, row, arguments);
    trace_call(text);
  }
  return begin_call(text_at(row.name));
}

void end_traced_call(TracedCall call, const uint64_t* arguments, uint64_t result, uint32_t error_before) {
  const TraceCall& row = kTraceCalls[int(call)];
  const char* name = text_at(row.name);
  const GLenum error = end_call(name, error_before);
  report_error(error, [&](TraceText& text) {
    put_call(text, row, arguments);
    put_wrong_argument(text, row, arguments, current_context->debug.wrong_argument);
  });
  if (!tracing) return;
  TraceText text;
  const char* between = " = ";
  if (row.result != TraceType::Void) {
    text.put(between);
    put_value(text, row.result, row.result_group, result);
    between = ", ";
  }
  const bool filled = error == GL_NO_ERROR && (name[0] != 'g' || !(current_context->guard & kNoContext));
  for (int i = 0; filled && i < row.parameter_count; ++i) {
    const TraceParameter& p = kTraceParameters[row.parameter + i];
    if (!p.out || !arguments[i]) continue;
    text.put(between);
    put_array(text, p, arguments, i);
    between = ", ";
  }
  put_error(text, error);
  trace_result(name, text);
}

uint32_t begin_unsupported_call(const char* name) {
  if (tracing) {
    TraceText text;
    text.put(name);
    text.put("(?)");
    trace_call(text);
  }
  return begin_call(name);
}

void end_unsupported_call(const char* name, uint32_t error_before) {
  const GLenum error = end_call(name, error_before);
  report_error(error, [&](TraceText& text) { text.put(name); });
  if (!tracing) return;
  TraceText text;
  put_error(text, error);
  trace_result(name, text);
}

} // namespace softgl
