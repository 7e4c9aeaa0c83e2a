// Calls that are watched: for the trace (SOFTGL_TRACE), or for messages of errors (GL_KHR_debug). Every door
// begins with SOFTGL_TRACED, which costs one branch when nobody watches.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "api/generated/traced_calls.h"
#include "base/trace_file.h"

namespace softgl {

/// True while the thread is inside a traced call: what that calls is not the program's.
extern constinit thread_local bool inside_traced_call
    __attribute__((tls_model("initial-exec"), visibility("hidden")));

/// Returns the error that waited before the call: it is put aside to see whether the call raises one.
[[gnu::cold]] uint32_t begin_traced_call(TracedCall call, const uint64_t* arguments);
[[gnu::cold]] void end_traced_call(TracedCall call, const uint64_t* arguments, uint64_t result,
                                   uint32_t error_before);

/// A value as the tables' types read it: integers extended to 64 bits, floating-point numbers as a double.
template <class T> uint64_t traced_value(T value) {
  if constexpr (std::is_pointer_v<T>)
    return reinterpret_cast<uintptr_t>(value);
  else if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<uint64_t>(double(value));
  else
    return uint64_t(value);
}

/// Calls the door once more, between the two halves of its line.
template <class Result, class... Arguments> [[gnu::cold, gnu::noinline]] Result
traced_call(TracedCall call, Result (*door)(Arguments...), std::type_identity_t<Arguments>... arguments) {
  const uint64_t values[] = {traced_value(arguments)..., 0};
  const uint32_t error_before = begin_traced_call(call, values);
  if constexpr (std::is_void_v<Result>) {
    door(arguments...);
    end_traced_call(call, values, 0, error_before);
  } else {
    const Result result = door(arguments...);
    end_traced_call(call, values, traced_value(result), error_before);
    return result;
  }
}

/// A call of a function that is there for its name only: nothing is known of its arguments.
[[gnu::cold]] uint32_t begin_unsupported_call(const char* name);
[[gnu::cold]] void end_unsupported_call(const char* name, uint32_t error_before);

} // namespace softgl

#define SOFTGL_TRACED(door, ...) \
  if (__builtin_expect(softgl::calls_watched.load(std::memory_order_relaxed), 0)) \
    if (!softgl::inside_traced_call) \
  return softgl::traced_call(softgl::TracedCall::door, door __VA_OPT__(, ) __VA_ARGS__)
