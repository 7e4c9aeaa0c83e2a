#include "commands/evaluators/bezier.h"

#include <algorithm>

#include "base/assert.h"
#include "context/evaluator_maps.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

/// Horner's scheme in s = 1 - t: p = (..(s * p0 + w1 * p1) * s + w2 * p2) * s + ..., where w_i is the
/// binomial coefficient times t^i.
struct Horner {
  int order;
  float s, weight[kMaxEvaluatorOrder];

  Horner(float t, int order) : order(order), s(1.0f - t) {
    if (order < 2) return;
    float binomial = float(order - 1), power = t;
    weight[1] = binomial * power;
    power = t * t;
    for (int i = 2; i < order; ++i, power *= t) {
      binomial *= float(order - i);
      binomial *= 1.0f / float(i);
      weight[i] = binomial * power;
    }
  }

  /// `step`: from a control point to the next, in values.
  void point(const float* points, int step, int components, float* out) const {
    for (int k = 0; k < components; ++k) {
      float p = points[k];
      for (int i = 1; i < order - (SOFTGL_FAULT(last_point_ignored) && order > 2 ? 1 : 0); ++i)
        p = s * p + weight[i] * points[i * step + k];
      out[k] = p;
    }
  }
};

/// De Casteljau's scheme for one component: a net of values that shrinks.
class Net {
public:
  Net(const BezierSurface& surface, int component, float u, float v)
      : u_count_(surface.u_order), v_count_(surface.v_order), row_(surface.v_order), u_(u), v_(v),
        us_(1.0f - u), vs_(1.0f - v) {
    const float* from = surface.points + component;
    for (int i = 0; i < u_count_ * v_count_; ++i) value_[i] = from[i * surface.components];
  }

  /// One control point less in both directions, until there are two in one of them.
  void shrink() {
    while (std::min(u_count_, v_count_) > 2) {
      for (int i = 0; i + 1 < u_count_; ++i)
        for (int j = 0; j < v_count_; ++j) {
          at(i, j) = between_u(at(i, j), at(i + 1, j));
          if (j > 0) at(i, j - 1) = between_v(at(i, j - 1), at(i, j));
        }
      --u_count_, --v_count_;
    }
  }

  void finish(float& point, float& along_u, float& along_v) {
    if (u_count_ == 2 && v_count_ == 2) {
      const float a = at(0, 0), b = at(0, 1), c = at(1, 0), d = at(1, 1);
      along_u = between_v(c - a, d - b);
      along_v = between_u(b - a, d - c);
      point = between_u(between_v(a, b), between_v(c, d));
    } else if (u_count_ == 2) {
      float difference[kMaxEvaluatorOrder], value[kMaxEvaluatorOrder];
      for (int j = 0; j < v_count_; ++j) {
        difference[j] = at(1, j) - at(0, j);
        value[j] = between_u(at(0, j), at(1, j));
      }
      for (int count = v_count_; count > 2; --count)
        for (int j = 0; j + 1 < count; ++j) {
          difference[j] = between_v(difference[j], difference[j + 1]);
          value[j] = between_v(value[j], value[j + 1]);
        }
      along_v = value[1] - value[0];
      along_u = between_v(difference[0], difference[1]);
      point = between_v(value[0], value[1]);
    } else {
      float difference[kMaxEvaluatorOrder], value[kMaxEvaluatorOrder];
      for (int i = 0; i < u_count_; ++i) {
        difference[i] = at(i, 1) - at(i, 0);
        value[i] = between_v(at(i, 0), at(i, 1));
      }
      for (int count = u_count_; count > 2; --count)
        for (int i = 0; i + 1 < count; ++i) {
          difference[i] = between_u(difference[i], difference[i + 1]);
          value[i] = between_u(value[i], value[i + 1]);
        }
      along_u = value[1] - value[0];
      along_v = between_u(difference[0], difference[1]);
      point = between_u(value[0], value[1]);
    }
  }

private:
  float& at(int i, int j) { return value_[i * row_ + j]; }
  float between_u(float a, float b) const { return us_ * a + u_ * b; }
  float between_v(float a, float b) const { return vs_ * a + v_ * b; }

  int u_count_, v_count_, row_;
  float u_, v_, us_, vs_;
  float value_[kMaxEvaluatorOrder * kMaxEvaluatorOrder];
};

} // namespace

void curve_point(const float* points, int components, int order, float u, float* out) {
  Horner(u, order).point(points, components, components, out);
}

void surface_point(const BezierSurface& s, float u, float v, float* out) {
  const Horner in_u(u, s.u_order), in_v(v, s.v_order);
  const int k = s.components;
  float curve[4 * kMaxEvaluatorOrder]; // control points of the curve in the direction of the higher order
  if (s.v_order > s.u_order) {
    for (int j = 0; j < s.v_order; ++j) in_u.point(s.points + j * k, s.v_order * k, k, curve + j * k);
    in_v.point(curve, k, k, out);
  } else {
    for (int i = 0; i < s.u_order; ++i) in_v.point(s.points + i * s.v_order * k, k, k, curve + i * k);
    in_u.point(curve, k, k, out);
  }
}

void surface_tangents(const BezierSurface& s, float u, float v, float* point, float* along_u,
                      float* along_v) {
  SOFTGL_ASSERT(s.u_order >= 2 && s.v_order >= 2);
  for (int k = 0; k < s.components; ++k) {
    Net net(s, k, u, v);
    net.shrink();
    net.finish(point[k], along_u[k], along_v[k]);
  }
}

} // namespace softgl
