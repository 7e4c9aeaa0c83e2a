#include "fuzz/any_command.h"

#include <cstdio>
#include <utility>
#include <vector>

#include "api/generated/traced_calls.h"

namespace softgl::test {
namespace {

template <class T> T value_of(const Argument& argument) {
  if constexpr (std::is_pointer_v<T>)
    return reinterpret_cast<T>(argument.pointer);
  else if constexpr (std::is_floating_point_v<T>)
    return T(argument.real);
  else
    return T(argument.whole);
}

template <auto Member> struct Caller;
template <class R, class... A, R (*Gl::*Member)(A...)> struct Caller<Member> {
  static_assert(sizeof...(A) <= kMostParameters);
  template <size_t... I>
  static uint64_t call_with(const Gl& gl, const Argument* arguments, std::index_sequence<I...>) {
    (void)arguments; // of commands without parameters
    if constexpr (std::is_void_v<R>)
      return (gl.*Member)(value_of<A>(arguments[I])...), 0;
    else if constexpr (std::is_pointer_v<R>)
      return reinterpret_cast<uintptr_t>((gl.*Member)(value_of<A>(arguments[I])...));
    else
      return uint64_t((gl.*Member)(value_of<A>(arguments[I])...));
  }
  static uint64_t call(const Gl& gl, const Argument* arguments) {
    return call_with(gl, arguments, std::index_sequence_for<A...>());
  }
};

const char* name_of(uint32_t value) {
  for (const TraceName& name : names_of_group(kAnyName))
    if (name.value == value) return kTraceText + name.name;
  return nullptr;
}

} // namespace

std::span<const AnyCommand> any_commands() {
  static const std::vector<AnyCommand> commands = [] {
    std::vector<AnyCommand> all;
    const auto add = [&](const char* name, TracedCall call, auto function) {
      const TraceCall& traced = kTraceCalls[int(call)];
      all.push_back({name, traced.parameter_count, kTraceParameters + traced.parameter, function});
    };
#define GL_FUNCTION(name) add(#name, TracedCall::gl##name, Caller<&Gl::name>::call);
#include "support/gl_functions.inc"
#undef GL_FUNCTION
    return all;
  }();
  return commands;
}

std::span<const TraceName> names_of_group(uint8_t group) {
  return {kTraceNames + kTraceGroups[group], kTraceNames + kTraceGroups[group + 1]};
}

uint8_t group_of_parameter(uint32_t parameter) {
  for (int i = 0; i < kTraceValueGroupCount; ++i)
    if (kTraceValueGroups[i].parameter == parameter) return kTraceValueGroups[i].group;
  return kNoNames;
}

std::string text_of(const AnyCommand& command, const Argument* arguments) {
  std::string text = "gl" + std::string(command.name) + "(";
  char buffer[64];
  for (int i = 0; i < command.parameter_count; ++i) {
    const TraceParameter& p = command.parameters[i];
    const Argument& a = arguments[i];
    if (i) text += ", ";
    if (p.length != TraceLength::Value || p.type == TraceType::Pointer)
      std::snprintf(buffer, sizeof buffer, "%p", a.pointer);
    else if (p.type == TraceType::Float || p.type == TraceType::Double)
      std::snprintf(buffer, sizeof buffer, "%.9g", a.real);
    else if (const char* name = name_of(uint32_t(a.whole)))
      std::snprintf(buffer, sizeof buffer, "%s", name);
    else
      std::snprintf(buffer, sizeof buffer, p.type == TraceType::Enum ? "0x%llx" : "%lld",
                    static_cast<long long>(a.whole));
    text += buffer;
  }
  return text + ")";
}

} // namespace softgl::test
