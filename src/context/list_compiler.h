// Between NewList and EndList: turns commands into records and vertices into runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "base/gl_types.h"
#include "context/vertex_builder.h"

namespace softgl {

struct DisplayList;

struct ListCompiler {
  std::shared_ptr<DisplayList> list; // null: no list is being compiled
  GLuint name = 0;
  GLenum mode = GL_COMPILE;
  int depth = 0; // of CallList, while playing

  // While a list is compiled Context::builder and Context::guard belong to it; these are the ones of
  // execution.
  VertexBuilder executing_builder;
  uint32_t executing_guard = 0;

  bool failed = false; // memory has ended: nothing is kept any more, and EndList keeps the old list
  uint64_t unkept[32]; // takes the arguments of a command that is not kept: more than any one's
};

} // namespace softgl
