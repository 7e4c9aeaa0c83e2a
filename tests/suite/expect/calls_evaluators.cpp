// Evaluators (5.1).
#include <algorithm>
#include <cmath>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

constexpr int kComponents[kEvaluatorTargets] = {4, 1, 3, 1, 2, 3, 4, 3, 4};

// Bernstein's polynomials of a degree (equation 5.1), or their derivatives.
std::vector<double> bernstein(int degree, double u) {
  std::vector<double> b;
  double binomial = 1;
  for (int i = 0; i <= degree; i++) {
    b.push_back(binomial * std::pow(u, i) * std::pow(1 - u, degree - i));
    binomial = binomial * (degree - i) / (i + 1);
  }
  return b;
}
std::vector<double> derived_bernstein(int degree, double u) {
  std::vector<double> b(size_t(degree) + 1);
  if (degree == 0) return b;
  const std::vector<double> lower = bernstein(degree - 1, u);
  for (int i = 0; i <= degree; i++)
    b[size_t(i)] = degree * ((i > 0 ? lower[size_t(i - 1)] : 0) - (i < degree ? lower[size_t(i)] : 0));
  return b;
}

std::vector<double> sum(const EvaluatorMap& map, const std::vector<double>& in_u,
                        const std::vector<double>& in_v) {
  std::vector<double> value(size_t(map.components));
  for (size_t i = 0; i < in_u.size(); i++)
    for (size_t j = 0; j < in_v.size(); j++)
      for (size_t k = 0; k < value.size(); k++)
        value[k] += in_u[i] * in_v[j] * map.points[(i * in_v.size() + j) * value.size() + k];
  return value;
}

double in_unit(const double* domain, double u) { return (u - domain[0]) / (domain[1] - domain[0]); }

// The map with the most coordinates of those that are on, or -1.
int most_of(const bool* on, int first, int last) {
  for (int i = last; i >= first; i--)
    if (on[i]) return i;
  return -1;
}

} // namespace

int map_dimensions(GLenum target) {
  if (target >= GL_MAP1_COLOR_4 && target < GL_MAP1_COLOR_4 + kEvaluatorTargets) return 1;
  return target >= GL_MAP2_COLOR_4 && target < GL_MAP2_COLOR_4 + kEvaluatorTargets ? 2 : 0;
}

EvaluatorMaps::EvaluatorMaps() {
  for (auto& dimension : map)
    for (int i = 0; i < kEvaluatorTargets; i++) {
      dimension[i].components = kComponents[i];
      if (i == kColorMap || i == kIndexMap) dimension[i].points = {1, 1, 1, 1};
      if (i == kNormalMap) dimension[i].points = {0, 0, 1};
      dimension[i].points.resize(size_t(kComponents[i]));
    }
}

std::vector<double> EvaluatorMap::at(double u, double v) const {
  return sum(*this, bernstein(order[0] - 1, in_unit(domain, u)),
             bernstein(order[1] - 1, in_unit(domain + 2, v)));
}

std::vector<double> EvaluatorMap::along(int direction, double u, double v) const {
  const double x = in_unit(domain, u), y = in_unit(domain + 2, v);
  return direction == 0 ? sum(*this, derived_bernstein(order[0] - 1, x), bernstein(order[1] - 1, y))
                        : sum(*this, bernstein(order[0] - 1, x), derived_bernstein(order[1] - 1, y));
}

// glMap1 and glMap2: target, then first, last, stride, order for each dimension, then the points.
void Machine::set_map(const Call& call, int dimensions) {
  EvaluatorMap& map = evaluator_maps_.map[dimensions - 1][map_index(call.e(0))];
  int stride[2] = {0, 0};
  map.order[1] = 1;
  for (int d = 0; d < dimensions; d++) {
    const size_t first = size_t(1 + 4 * d);
    map.domain[2 * d] = call.n(first), map.domain[2 * d + 1] = call.n(first + 1);
    stride[d] = int(call.n(first + 2)), map.order[d] = int(call.n(first + 3));
  }
  const std::vector<double>& from = call.arguments.back().numbers;
  map.points.clear();
  for (int i = 0; i < map.order[0]; i++)
    for (int j = 0; j < map.order[1]; j++)
      for (int k = 0; k < map.components; k++)
        map.points.push_back(from.at(size_t(i * stride[0] + j * stride[1] + k)));
}

// What is evaluated is the vertex's alone: what was current stays current.
void Machine::evaluate(int dimensions, double u, double v) {
  const bool* on = state_.evaluators.on[dimensions - 1];
  const EvaluatorMap* maps = evaluator_maps_.map[dimensions - 1];
  const int vertex = most_of(on, kVertex3Map, kVertex4Map), texture = most_of(on, kTexture1Map, kTexture4Map);
  if (vertex < 0) return;
  if (!open_) throw std::logic_error("an evaluation that is not between glBegin and glEnd");
  const CurrentState current = state_.current;
  const LightingState lighting = state_.lighting;
  if (on[kColorMap]) {
    const std::vector<double> c = maps[kColorMap].at(u, v);
    color(c[0], c[1], c[2], c[3]);
  }
  if (texture >= 0) state_.current.texture_coordinate[0] = vec4(maps[texture].at(u, v));
  const std::vector<double> position = maps[vertex].at(u, v);
  if (dimensions == 2 && state_.evaluators.auto_normal) {
    std::vector<double> a = maps[vertex].along(0, u, v), b = maps[vertex].along(1, u, v);
    if (vertex == kVertex4Map) // of (x, y, z) / w
      for (std::vector<double>* d : {&a, &b})
        for (size_t k = 0; k < 3; k++)
          (*d)[k] = ((*d)[k] * position[3] - position[k] * (*d)[3]) / (position[3] * position[3]);
    const Vec3 normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    if (dot(normal, normal) < 1e-6) throw std::logic_error("a surface that has no normal");
    state_.current.normal = spec::unit(normal), state_.current.normal_known = true;
  } else if (on[kNormalMap]) {
    const std::vector<double> n = maps[kNormalMap].at(u, v);
    state_.current.normal = {n[0], n[1], n[2]}, state_.current.normal_known = true;
  }
  vertices_.push_back(transform(vec4(position)));
  state_.current = current, state_.lighting = lighting;
}

void Machine::evaluate_mesh(const Call& call) {
  const int dimensions = call.command == Command::EvalMesh1 ? 1 : 2;
  const bool* on = state_.evaluators.on[dimensions - 1];
  if (most_of(on, kVertex3Map, kVertex4Map) < 0) return;
  const GLenum mode = call.e(0);
  const int p1 = int(call.n(1)), p2 = int(call.n(2));
  Script s;
  if (dimensions == 1) {
    s.Begin(mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
    for (int i = p1; i <= p2; i++) s.EvalPoint1(i);
    s.End();
  } else {
    const int q1 = int(call.n(3)), q2 = int(call.n(4));
    switch (mode) {
    case GL_FILL:
      for (int i = q1; i < q2; i++) {
        s.Begin(GL_QUAD_STRIP);
        for (int j = p1; j <= p2; j++) s.EvalPoint2(j, i), s.EvalPoint2(j, i + 1);
        s.End();
      }
      break;
    case GL_LINE:
      for (int i = q1; i <= q2; i++) {
        s.Begin(GL_LINE_STRIP);
        for (int j = p1; j <= p2; j++) s.EvalPoint2(j, i);
        s.End();
      }
      for (int i = p1; i <= p2; i++) {
        s.Begin(GL_LINE_STRIP);
        for (int j = q1; j <= q2; j++) s.EvalPoint2(i, j);
        s.End();
      }
      break;
    default:
      s.Begin(GL_POINTS);
      for (int i = q1; i <= q2; i++)
        for (int j = p1; j <= p2; j++) s.EvalPoint2(j, i);
      s.End();
    }
  }
  for (const Call& c : s.calls) play_vertices(c) || play_evaluators(c);
}

bool Machine::enable_map(GLenum name, bool on) {
  if (name == GL_AUTO_NORMAL)
    state_.evaluators.auto_normal = on;
  else if (const int dimensions = map_dimensions(name))
    state_.evaluators.on[dimensions - 1][map_index(name)] = on;
  else
    return false;
  return true;
}

std::vector<double> Machine::map_answer(GLenum target, GLenum query) const {
  const int dimensions = map_dimensions(target);
  if (dimensions == 0) return {};
  const EvaluatorMap& map = evaluator_maps_.map[dimensions - 1][map_index(target)];
  if (query == GL_ORDER) return {map.order, map.order + dimensions};
  if (query == GL_DOMAIN) return {map.domain, map.domain + 2 * dimensions};
  return map.points;
}

bool Machine::play_evaluators(const Call& call) {
  const EvaluatorState& e = state_.evaluators;
  const auto place = [&](size_t i) { return values_of(call)[i]; };
  switch (call.command) {
  case Command::Map1f:
  case Command::Map1d: set_map(call, 1); return true;
  case Command::Map2f:
  case Command::Map2d: set_map(call, 2); return true;
  case Command::MapGrid1f:
  case Command::MapGrid1d: state_.evaluators.grid1 = {int(call.n(0)), call.n(1), call.n(2)}; return true;
  case Command::MapGrid2f:
  case Command::MapGrid2d:
    for (size_t d = 0; d < 2; d++)
      state_.evaluators.grid2[d] = {int(call.n(3 * d)), call.n(3 * d + 1), call.n(3 * d + 2)};
    return true;
  case Command::EvalCoord1f:
  case Command::EvalCoord1d:
  case Command::EvalCoord1fv:
  case Command::EvalCoord1dv: evaluate(1, place(0), 0); return true;
  case Command::EvalCoord2f:
  case Command::EvalCoord2d:
  case Command::EvalCoord2fv:
  case Command::EvalCoord2dv: evaluate(2, place(0), place(1)); return true;
  case Command::EvalPoint1: evaluate(1, e.grid1.at(int(call.n(0))), 0); return true;
  case Command::EvalPoint2:
    evaluate(2, e.grid2[0].at(int(call.n(0))), e.grid2[1].at(int(call.n(1))));
    return true;
  case Command::EvalMesh1:
  case Command::EvalMesh2: evaluate_mesh(call); return true;
  default: return false;
  }
}

} // namespace softgl::suite
