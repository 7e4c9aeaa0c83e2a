// Calls with arguments that GL must refuse.
#pragma once

#include <catch2/catch.hpp>
#include <span>
#include <vector>

#include "spec/object_snapshot.h"
#include "support/gl.h"

namespace softgl::test {

struct BadCall {
  const char* text;
  GLenum error;
  void (*run)(const Gl& gl);
};
// clang-format off
#define BAD(error, call) {#call, GL_##error, [](const Gl& gl) { gl.call; }}
// clang-format on

/// Every test case of refused calls: error_rows_test.cpp runs them all, and looks at each call.
inline std::vector<void (*)()>& refusal_cases() {
  static std::vector<void (*)()> cases;
  return cases;
}
struct RefusalCase {
  explicit RefusalCase(void (*run)()) { refusal_cases().push_back(run); }
};
/// Makes the calls in place of expect_refused(), while it is set.
inline void (*refusal_observer)(const Gl& gl, const BadCall& call) = nullptr;

/// TEST_CASE for what calls expect_refused().
#define REFUSAL_TEST_CASE_OF(function, registration, ...) \
  static void function(); \
  static const softgl::test::RefusalCase registration(function); \
  TEST_CASE(__VA_ARGS__) { function(); } \
  static void function()
#define REFUSAL_TEST_CASE(...) \
  REFUSAL_TEST_CASE_OF(INTERNAL_CATCH_UNIQUE_NAME(refusals), INTERNAL_CATCH_UNIQUE_NAME(registration), \
                       __VA_ARGS__)

/// Each call gives its error, once; `unchanged` then checks that it has done nothing else.
template <class Check> void expect_refused(const Gl& gl, std::span<const BadCall> calls, Check unchanged) {
  for (const BadCall& bad : calls) {
    INFO(bad.text);
    if (refusal_observer) {
      refusal_observer(gl, bad);
      continue;
    }
    bad.run(gl);
    CHECK(gl.GetError() == bad.error);
    CHECK(gl.GetError() == GL_NO_ERROR);
    unchanged();
  }
}

/// The same, where state and objects of the context that is current must stay as they are.
inline void expect_refused(const Gl& gl, std::span<const BadCall> calls) {
  if (refusal_observer) return expect_refused(gl, calls, [] {});
  const auto everything = [&] {
    StateSnapshot snapshot = take_snapshot(gl, false);
    add_objects(gl, snapshot);
    return snapshot;
  };
  const StateSnapshot before = everything();
  expect_refused(gl, calls, [&] { CHECK(compare_snapshots(before, everything()) == ""); });
}

} // namespace softgl::test
