// The modelview, projection and texture matrix stacks (GL 1.5, 2.11.2).
#pragma once

#include <vector>

#include "context/matrix.h"
#include "context/state.h"

namespace softgl {

constexpr int kMaxModelviewDepth = 32, kMaxProjectionDepth = 32, kMaxTextureDepth = 10;

struct MatrixStack {
  std::vector<Matrix> entry = std::vector<Matrix>(1); // back() is the current matrix; never empty
  Matrix& top() { return entry.back(); }
  const Matrix& top() const { return entry.back(); }
  int depth() const { return int(entry.size()); }
};

struct MatrixStacks {
  MatrixStack modelview, projection, texture[kMaxTextureUnits];

  /// The stack that the matrix commands change.
  MatrixStack& current(const State& state) {
    switch (state.transform.matrix_mode) {
    case GL_PROJECTION: return projection;
    case GL_TEXTURE: return texture[state.texture.active_unit];
    default: return modelview;
    }
  }
};

} // namespace softgl
