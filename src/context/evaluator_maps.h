// The maps of evaluators (GL 1.5, 5.1). They are in no attribute group (table 6.26).
#pragma once

#include <memory>

#include "base/gl_types.h"

namespace softgl {

constexpr int kMaxEvaluatorOrder = 30; // GL_MAX_EVAL_ORDER
constexpr int kEvaluatorTargets = 9;   // GL_MAP1_COLOR_4 to GL_MAP1_VERTEX_4, and as many of GL_MAP2

/// What a map gives, in the order of the targets' names; also its bit in EvaluatorState.
enum EvaluatorTarget : int {
  kMapColor4,
  kMapIndex,
  kMapNormal,
  kMapTexCoord1,
  kMapTexCoord2,
  kMapTexCoord3,
  kMapTexCoord4,
  kMapVertex3,
  kMapVertex4
};

/// Values of a control point (table 5.1).
constexpr int kEvaluatorComponents[kEvaluatorTargets] = {4, 1, 3, 1, 2, 3, 4, 3, 4};

/// GL_MAP1_COLOR_4 for 1 dimension, GL_MAP2_COLOR_4 for 2; the other targets follow.
constexpr GLenum first_map_target(int dimensions) {
  return dimensions == 1 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4;
}
/// Values of a control point of that target; 0: no target of maps with so many dimensions.
constexpr int map_components(GLenum target, int dimensions) {
  const GLenum i = target - first_map_target(dimensions);
  return i < GLenum(kEvaluatorTargets) ? kEvaluatorComponents[i] : 0;
}

/// The parameter u of a map, or v.
struct EvaluatorDomain {
  GLint order = 1; // control points in this direction
  float first = 0, last = 1;
  float per_unit = 1; // 1 / (last - first)
};

/// One map. A map of one dimension has order 1 in v. Control point i of u and j of v begins at value
/// (i * order of v + j) * components.
struct EvaluatorMap {
  EvaluatorDomain u, v;
  std::unique_ptr<float[]> points; // null: the initial one
};

/// The control point of every map of that target before one is given.
inline const float* initial_control_point(int target) {
  static constexpr float kOnes[4] = {1, 1, 1, 1}, kUp[3] = {0, 0, 1}, kOrigin[4] = {0, 0, 0, 1};
  return target == kMapColor4 || target == kMapIndex ? kOnes : target == kMapNormal ? kUp : kOrigin;
}

struct EvaluatorMaps {
  EvaluatorMap map[2][kEvaluatorTargets]; // of one dimension, and of two

  const float* points(int dimensions, int target) const {
    const EvaluatorMap& m = map[dimensions - 1][target];
    return m.points ? m.points.get() : initial_control_point(target);
  }
};

} // namespace softgl
