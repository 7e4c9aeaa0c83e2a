// Map1, Map2, MapGrid1, MapGrid2 and GetMap (GL 1.5, 5.1 and 6.1.3).
#include "context/evaluator_maps.h"

#include <type_traits>
#include <utility>

#include "commands/generated/commands.h"
#include "commands/get_conversion.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

/// A direction of a map as the client gives it; the stride counts values.
template <class T> struct GivenDirection {
  T first, last;
  GLint stride, order;
};

/// What the arguments of a direction are called.
struct DirectionNames {
  const char *last, *stride, *order;
};
constexpr DirectionNames kNamesOfMap1 = {"u2", "stride", "order"},
                         kNamesOfMap2[2] = {{"u2", "ustride", "uorder"}, {"v2", "vstride", "vorder"}};

/// The argument that is wrong; null if none is. The last of a domain as a float may be the first.
template <class T>
const char* wrong_argument(const GivenDirection<T>& d, int components, const DirectionNames& names) {
  return first_wrong({{names.last, (d.first == d.last || float(d.first) == float(d.last)) &&
                                       !SOFTGL_FAULT(empty_domain_taken)},
                      {names.stride, d.stride < components && !SOFTGL_FAULT(small_stride_taken)},
                      {names.order, d.order < 1 || d.order > kMaxEvaluatorOrder}});
}

template <class T> EvaluatorDomain domain_of(const GivenDirection<T>& d) {
  const float first = float(d.first), last = float(d.last);
  return {d.order, first, last, 1.0f / (last - first)};
}

template <class T> void set_map(Context& c, int dimensions, GLenum target, const GivenDirection<T>& u,
                                const GivenDirection<T>& v, const T* from) {
  const int components = map_components(target, dimensions);
  if (!components) return set_error(c, GL_INVALID_ENUM, "target");
  const DirectionNames& names_of_u = dimensions == 1 ? kNamesOfMap1 : kNamesOfMap2[0];
  if (const char* wrong = wrong_argument(u, components, names_of_u))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (const char* wrong = wrong_argument(v, components, kNamesOfMap2[1]))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (c.state.texture.active_unit != 0 && !SOFTGL_FAULT(map_in_any_unit))
    return set_error(c, GL_INVALID_OPERATION);
  std::unique_ptr<float[]> points(new float[size_t(u.order) * size_t(v.order) * size_t(components)]);
  float* to = points.get();
  for (ptrdiff_t i = 0; i < u.order; ++i)
    for (ptrdiff_t j = 0; j < v.order; ++j) {
      const T* point = from + i * u.stride + j * v.stride;
      if (SOFTGL_FAULT(map_stride_ignored)) point = from + (i * v.order + j) * components;
      for (int k = 0; k < components; ++k) *to++ = float(point[k]);
    }
  EvaluatorMap& map = c.evaluator_maps.map[dimensions - 1][target - first_map_target(dimensions)];
  if (SOFTGL_FAULT(map_replaced_once) && map.points) return;
  map.u = domain_of(u);
  map.v = domain_of(v);
  map.points = std::move(points);
}

/// The direction that a map of one dimension does not have.
template <class T> constexpr GivenDirection<T> kNoDirection{0, 1, 4, 1};

template <class T> T converted(float value) {
  if constexpr (std::is_integral_v<T>)
    return to_integer(double(value), Conversion::Float);
  else
    return T(value);
}

template <class T> void get_map(Context& c, GLenum target, GLenum query, T* out) {
  const int dimensions = map_components(target, 1) ? 1 : 2;
  const int components = map_components(target, dimensions);
  if (!components) return set_error(c, GL_INVALID_ENUM, "target");
  const int index = int(target - first_map_target(dimensions));
  const EvaluatorMap& map = c.evaluator_maps.map[dimensions - 1][index];
  const EvaluatorDomain* const direction[2] = {&map.u, &map.v};
  switch (query) {
  case GL_COEFF: {
    const float* points = c.evaluator_maps.points(dimensions, index);
    const int count = map.u.order * map.v.order * components;
    for (int i = 0; i < count; ++i) out[i] = converted<T>(points[i]);
    return;
  }
  case GL_ORDER:
    for (int d = 0; d < dimensions; ++d) out[d] = T(direction[d]->order);
    return;
  case GL_DOMAIN:
    for (int d = 0; d < dimensions; ++d) {
      out[2 * d] = converted<T>(direction[d]->first);
      out[2 * d + 1] = converted<T>(direction[d]->last);
    }
    return;
  default: set_error(c, GL_INVALID_ENUM, "query");
  }
}

} // namespace

namespace gl {

void Map1f(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order,
           const GLfloat* points) {
  set_map(c, 1, target, {u1, u2, stride, order}, kNoDirection<GLfloat>, points);
}
void Map1d(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
           const GLdouble* points) {
  set_map(c, 1, target, {u1, u2, stride, order}, kNoDirection<GLdouble>, points);
}
void Map2f(Context& c, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
           GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points) {
  set_map(c, 2, target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}
void Map2d(Context& c, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
           GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points) {
  set_map(c, 2, target, {u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, points);
}

void GetMapfv(Context& c, GLenum target, GLenum query, GLfloat* v) { get_map(c, target, query, v); }
void GetMapdv(Context& c, GLenum target, GLenum query, GLdouble* v) { get_map(c, target, query, v); }
void GetMapiv(Context& c, GLenum target, GLenum query, GLint* v) { get_map(c, target, query, v); }

void MapGrid1(Context& c, GLint n, GLfloat u1, GLfloat u2) {
  if (n < 1) return set_error(c, GL_INVALID_VALUE, "un");
  c.state.evaluator.grid1 = {n, u1, u2};
}
void MapGrid2(Context& c, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2) {
  if (const char* wrong = first_wrong({{"un", un < 1}, {"vn", vn < 1}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  c.state.evaluator.grid2[0] = {un, u1, u2};
  c.state.evaluator.grid2[1] = {vn, v1, v2};
}

} // namespace gl
} // namespace softgl
