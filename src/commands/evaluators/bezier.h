// Bezier curves and surfaces (GL 1.5, 5.1). The results are OSMesa's to the last bit: the order of the
// operations is part of what these functions promise.
#pragma once

namespace softgl {

/// Control points of 1 to 4 values (`components`), one behind the other; those of a surface in rows of
/// `v_order`. Orders are 1 to kMaxEvaluatorOrder.
struct BezierSurface {
  const float* points;
  int components, u_order, v_order;
};

/// The point for u in [0,1] (beyond that the same polynomial). Writes `components` values.
void curve_point(const float* points, int components, int order, float u, float* out);
/// The point for (u, v).
void surface_point(const BezierSurface& surface, float u, float v, float* out);

/// The same point, computed another way together with the partial derivatives, of which only the directions
/// and signs are right: they lack the factors of the degrees. Each of the three is `components` values. Both
/// orders are at least 2.
void surface_tangents(const BezierSurface& surface, float u, float v, float* point, float* along_u,
                      float* along_v);

} // namespace softgl
