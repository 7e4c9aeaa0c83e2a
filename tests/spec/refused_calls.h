// Calls with arguments that GL must refuse.
#pragma once

#include <catch2/catch.hpp>
#include <span>

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

/// Each call gives its error, once; `unchanged` then checks that it has done nothing else.
template <class Check> void expect_refused(const Gl& gl, std::span<const BadCall> calls, Check unchanged) {
  for (const BadCall& bad : calls) {
    INFO(bad.text);
    bad.run(gl);
    CHECK(gl.GetError() == bad.error);
    CHECK(gl.GetError() == GL_NO_ERROR);
    unchanged();
  }
}

/// The same, where state and objects of the context that is current must stay as they are.
inline void expect_refused(const Gl& gl, std::span<const BadCall> calls) {
  const auto everything = [&] {
    StateSnapshot snapshot = take_snapshot(gl, false);
    add_objects(gl, snapshot);
    return snapshot;
  };
  const StateSnapshot before = everything();
  expect_refused(gl, calls, [&] { CHECK(compare_snapshots(before, everything()) == ""); });
}

} // namespace softgl::test
