// Between NewList and EndList: turns commands into records and vertices into runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

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

  struct Free {
    void operator()(float* p) const { std::free(p); }
  };
  std::unique_ptr<float, Free> vertices; // the builder's chunk while a list is compiled

  bool last_was_error = false;   // the last record stands for an error: nothing to execute
  std::vector<uint64_t> scratch; // takes the arguments of a command that only raises an error
  uint64_t emergency[32];        // the same when there is no memory: more than any command's arguments
};

} // namespace softgl
