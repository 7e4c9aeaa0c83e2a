// The modelview, projection and texture matrix stacks (GL 1.5, 2.11.2).
#pragma once

#include <vector>

#include "state/state.h"

namespace softgl {

constexpr int kMaxModelviewDepth = 32, kMaxProjectionDepth = 32, kMaxTextureDepth = 10;

/// A matrix with what is known of its shape; OSMesa chooses its inverse by these flags (osmesa-facts 5, item 10).
struct Matrix {
  glm::mat4 m{1.0f};
  uint32_t flags = 0; // MatrixFlag, kept as OSMesa keeps them: they decide LSBs of lit colours
};

struct MatrixStack {
  std::vector<Matrix> entry{Matrix{}}; // back() is the current matrix; never empty
  Matrix& top() { return entry.back(); }
  const Matrix& top() const { return entry.back(); }
};

struct MatrixStacks {
  MatrixStack modelview, projection, texture[kMaxTextureUnits];
};

} // namespace softgl
