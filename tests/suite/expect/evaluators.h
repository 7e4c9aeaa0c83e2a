// The maps of evaluators (5.1) in double.
#pragma once

#include <array>
#include <vector>

#include "script/script.h"

namespace softgl::suite {

/// The targets of table 5.1, from the constant GL_MAP1_COLOR_4 or GL_MAP2_COLOR_4 on.
enum EvaluatorTarget {
  kColorMap,
  kIndexMap,
  kNormalMap,
  kTexture1Map,
  kTexture4Map = 6,
  kVertex3Map,
  kVertex4Map
};
constexpr int kEvaluatorTargets = 9;

struct EvaluatorMap {
  int components = 4, order[2] = {1, 1};     // in u and v
  double domain[4] = {0, 1, 0, 1};           // u1, u2, v1, v2
  std::vector<double> points = {0, 0, 0, 1}; // of v first
  /// The value at a place of the domain; as many numbers as there are components.
  std::vector<double> at(double u, double v) const;
  /// The derivatives by u and v of the unit square.
  std::vector<double> along(int direction, double u, double v) const;
};

struct EvaluatorGrid {
  int count = 1;
  double first = 0, last = 1;
  double at(int i) const { return i == count ? last : first + i * (last - first) / count; }
};

/// What glPushAttrib saves.
struct EvaluatorState {
  bool on[2][kEvaluatorTargets] = {}; // of one and of two dimensions
  bool auto_normal = false;
  EvaluatorGrid grid1, grid2[2];
};

struct EvaluatorMaps {
  EvaluatorMaps();
  EvaluatorMap map[2][kEvaluatorTargets];
};

/// The dimensions of a map's constant, or 0.
int map_dimensions(GLenum target);
inline int map_index(GLenum target) {
  return int(target - (map_dimensions(target) == 1 ? GL_MAP1_COLOR_4 : GL_MAP2_COLOR_4));
}

} // namespace softgl::suite
