// EvalCoord, EvalPoint and EvalMesh (GL 1.5, 5.1).
#include <cmath>
#include <cstring>

#include "commands/evaluators/bezier.h"
#include "commands/generated/commands.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/vertex_stream.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

constexpr uint32_t bit(EvaluatorTarget target) { return 1u << target; }

/// The map of the most values among those of a kind that are enabled, whose targets are first..last; -1:
/// none.
int highest(uint32_t enabled, EvaluatorTarget first, EvaluatorTarget last) {
  for (int target = last; target >= first; --target)
    if (enabled >> target & 1) return target;
  return -1;
}
int vertex_map(uint32_t enabled) {
  if (SOFTGL_FAULT(vertex_3_wins) && enabled & bit(kMapVertex3)) return kMapVertex3;
  return highest(enabled, kMapVertex3, kMapVertex4);
}

/// A place in the domain; of one dimension: u alone.
struct Coordinates {
  int dimensions;
  float u, v;
};
float in_unit_interval(const EvaluatorDomain& domain, float u) {
  if (SOFTGL_FAULT(map_domain_ignored)) return u;
  return (u - domain.first) * domain.per_unit;
}

BezierSurface surface_of(const Context& c, int target) {
  const EvaluatorMap& map = c.evaluator_maps.map[1][target];
  return {c.evaluator_maps.points(2, target), kEvaluatorComponents[target], map.u.order, map.v.order};
}

/// Overwrites as many of the four values as the map has.
void evaluate(const Context& c, int target, const Coordinates& at, float* out) {
  const EvaluatorMap& map = c.evaluator_maps.map[at.dimensions - 1][target];
  const float u = in_unit_interval(map.u, at.u);
  if (at.dimensions == 1)
    curve_point(c.evaluator_maps.points(1, target), kEvaluatorComponents[target], map.u.order, u, out);
  else
    surface_point(surface_of(c, target), u, in_unit_interval(map.v, at.v), out);
}

/// The vertex and the normal that GL_AUTO_NORMAL asks for: of length 1, or 0 where the surface has none.
void evaluate_with_normal(const Context& c, int target, const Coordinates& at, float* vertex, float* normal) {
  const EvaluatorMap& map = c.evaluator_maps.map[1][target];
  if (map.u.order < 2 || map.v.order < 2) { // a point or a curve
    evaluate(c, target, at, vertex);
    normal[0] = normal[1] = normal[2] = 0;
    return;
  }
  float a[4], b[4]; // along u, along v
  surface_tangents(surface_of(c, target), in_unit_interval(map.u, at.u), in_unit_interval(map.v, at.v),
                   vertex, a, b);
  if (target == kMapVertex4 && !SOFTGL_FAULT(auto_normal_before_w)) { // of (x, y, z) / w, times w squared
    for (int k = 0; k < 3; ++k) {
      a[k] = a[k] * vertex[3] - a[3] * vertex[k];
      b[k] = b[k] * vertex[3] - b[3] * vertex[k];
    }
  }
  normal[0] = a[1] * b[2] - a[2] * b[1];
  normal[1] = a[2] * b[0] - a[0] * b[2];
  normal[2] = a[0] * b[1] - a[1] * b[0];
  const float squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  float scale = squared != 0 ? 1.0f / std::sqrt(squared) : 1.0f;
  // The derivatives are those of the unit square; a domain that runs backwards turns them round.
  if ((map.u.per_unit < 0) != (map.v.per_unit < 0)) scale = -scale;
  if (SOFTGL_FAULT(auto_normal_turned)) scale = -scale;
  for (int k = 0; k < 3; ++k) normal[k] *= scale;
}

/// The vertex of a place, if a map of vertices is enabled. What else is evaluated is the vertex's alone:
/// afterwards the values that were current before are current.
void evaluate_vertex(Context& c, const Coordinates& at) {
  if (c.builder.mode == kNoPrimitive) return; // a vertex outside Begin and End is undefined: none
  const EvaluatorState& state = c.state.evaluator;
  const uint32_t enabled = at.dimensions == 1 ? state.map1_enabled : state.map2_enabled;
  const int vertex_target = vertex_map(enabled);
  if (vertex_target < 0) return;
  struct Attribute {
    int slot;
    float before[4];
  } changed[4];
  int count = 0;
  const auto set = [&](int slot, const float* v) {
    Attribute& attribute = changed[count++];
    attribute.slot = slot;
    std::memcpy(attribute.before, current_value(c, slot), sizeof attribute.before);
    set_attribute4(c, slot, v[0], v[1], v[2], v[3]);
  };
  const auto set_evaluated = [&](int slot, int target) {
    float value[4] = {0, 0, 0, 1};
    evaluate(c, target, at, value);
    set(slot, value);
  };
  if (enabled & bit(kMapColor4)) set_evaluated(kColor, kMapColor4);
  if (enabled & bit(kMapIndex)) set_evaluated(kColorIndex, kMapIndex);
  if (const int target =
          highest(enabled, kMapTexCoord1, SOFTGL_FAULT(texture_4_ignored) ? kMapTexCoord3 : kMapTexCoord4);
      target >= 0)
    set_evaluated(kTexCoord0, target);
  float vertex[4] = {0, 0, 0, 1};
  if (at.dimensions == 2 && state.auto_normal && !SOFTGL_FAULT(auto_normal_ignored)) {
    float normal[4] = {0, 0, 0, 1};
    evaluate_with_normal(c, vertex_target, at, vertex, normal);
    set(kNormal, normal);
  } else {
    if (enabled & bit(kMapNormal) && !SOFTGL_FAULT(normal_map_ignored)) set_evaluated(kNormal, kMapNormal);
    evaluate(c, vertex_target, at, vertex);
  }
  emit_vertex4(c, vertex[0], vertex[1], vertex[2], vertex[3]);
  for (int i = 0; i < count && !SOFTGL_FAULT(evaluated_values_stay); ++i) {
    const float* v = changed[i].before;
    set_attribute4(c, changed[i].slot, v[0], v[1], v[2], v[3]);
  }
}

float grid_step(const GridDirection& grid) { return (grid.last - grid.first) / float(grid.count); }
/// Of value i of a grid, computed as `sum`: exact at both ends of the grid, which 5.1 requires.
float exact_at_ends(const GridDirection& grid, int64_t i, float sum) {
  if (SOFTGL_FAULT(grid_from_0)) return sum - grid.first;
  return i == 0 ? grid.first : i == grid.count ? grid.last : sum;
}
float grid_value(const GridDirection& grid, GLint i) {
  return exact_at_ends(grid, i, float(i) * grid_step(grid) + grid.first);
}

/// Calls visit(value i, value i + 1) for i = first..last. Each value is the sum of the one before and the
/// step, as OSMesa has it.
template <class Visit>
void for_each_value(const GridDirection& grid, GLint first, int64_t last, Visit visit) {
  const float step = grid_step(grid);
  float sum = grid.first + float(first) * step;
  for (int64_t i = first; i <= last; ++i, sum += step)
    visit(exact_at_ends(grid, i, sum), exact_at_ends(grid, i + 1, sum + step));
}

/// The primitive of a strip of a filled mesh. The specification says a strip of quadrilaterals. Where only
/// its triangles are seen, they are OSMesa's.
GLenum filled_strip(const Context& c) {
  if (SOFTGL_FAULT(mesh_of_triangles)) return GL_TRIANGLE_STRIP;
  const bool whole = c.state.lighting.shade_model == GL_FLAT || !c.state.polygon.all_filled();
  return whole ? GL_QUAD_STRIP : GL_TRIANGLE_STRIP;
}

} // namespace

namespace gl {

void EvalCoord1(Context& c, GLfloat u) { evaluate_vertex(c, {1, u, 0}); }
void EvalCoord2(Context& c, GLfloat u, GLfloat v) { evaluate_vertex(c, {2, u, v}); }

void EvalPoint1(Context& c, GLint i) { EvalCoord1(c, grid_value(c.state.evaluator.grid1, i)); }
void EvalPoint2(Context& c, GLint i, GLint j) {
  const GridDirection* grid = c.state.evaluator.grid2;
  EvalCoord2(c, grid_value(grid[0], i), grid_value(grid[1], j));
}

void EvalMesh1(Context& c, GLenum mode, GLint i1, GLint i2) {
  if (mode != GL_POINT && mode != GL_LINE && !SOFTGL_FAULT(mesh_of_any_mode))
    return set_error(c, GL_INVALID_ENUM, "mode");
  if (vertex_map(c.state.evaluator.map1_enabled) < 0) return;
  Begin(c, mode == GL_POINT ? GL_POINTS : GL_LINE_STRIP);
  for_each_value(c.state.evaluator.grid1, SOFTGL_FAULT(mesh_whole) ? 0 : i1, i2,
                 [&](float u, float) { EvalCoord1(c, u); });
  End(c);
}

void EvalMesh2(Context& c, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2) {
  if (mode != GL_POINT && mode != GL_LINE && mode != GL_FILL) return set_error(c, GL_INVALID_ENUM, "mode");
  if (vertex_map(c.state.evaluator.map2_enabled) < 0) return;
  const GridDirection &in_u = c.state.evaluator.grid2[0], &in_v = c.state.evaluator.grid2[1];
  switch (mode) {
  case GL_POINT:
    Begin(c, GL_POINTS);
    for_each_value(in_v, j1, j2, [&](float v, float) {
      for_each_value(in_u, i1, i2, [&](float u, float) { EvalCoord2(c, u, v); });
    });
    End(c);
    break;
  case GL_LINE:
    for_each_value(in_v, j1, SOFTGL_FAULT(mesh_line_lost) ? j2 - 1 : j2, [&](float v, float) {
      Begin(c, GL_LINE_STRIP);
      for_each_value(in_u, i1, i2, [&](float u, float) { EvalCoord2(c, u, v); });
      End(c);
    });
    for_each_value(in_u, i1, i2, [&](float u, float) {
      Begin(c, GL_LINE_STRIP);
      for_each_value(in_v, j1, j2, [&](float v, float) { EvalCoord2(c, u, v); });
      End(c);
    });
    break;
  default: {
    const GLenum strip = filled_strip(c);
    for_each_value(in_v, j1, int64_t(j2) - (SOFTGL_FAULT(mesh_strip_lost) ? 2 : 1), [&](float v, float next) {
      Begin(c, strip);
      for_each_value(in_u, i1, i2, [&](float u, float) {
        EvalCoord2(c, u, v);
        EvalCoord2(c, u, next);
      });
      End(c);
    });
  }
  }
}

} // namespace gl
} // namespace softgl
