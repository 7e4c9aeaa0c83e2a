// Calls with arguments that GL must refuse.
#pragma once

#include <catch2/catch.hpp>
#include <span>

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

} // namespace softgl::test
