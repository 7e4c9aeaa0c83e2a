// Data between vertices (3.4.1, 3.5.1), and what the specification leaves open of them.
#pragma once

#include "expect/primitive.h"

namespace softgl::suite {

/// Twice the area of a triangle in the window; above 0 if it runs counterclockwise.
double cross2(const Vec3& o, const Vec3& a, const Vec3& b);

ColorBounds hull_of(const ColorBounds& a, const ColorBounds& b);
/// Sums of values with weights, which may be below 0 outside of the primitive.
Interval weighted(const Interval* values, const double* weights, int count);
ColorBounds weighted(const ColorBounds* const* colors, const double* weights, int count);
/// From the weights of window coordinates to those of equation 3.6.
void divide_by_w(const double* w, const double* weights, double* result, int count);

/// The factors of fog at the vertices of a primitive, and between them: "f need not be computed at each
/// fragment" (3.10).
class FogBetween {
public:
  FogBetween(const FogState& fog, const std::vector<LitVertex>& vertices);
  Interval at(const double* linear, const double* perspective) const;
  /// Of any convex combination.
  Interval anywhere() const;

private:
  const FogState& fog_;
  std::vector<Interval> distance_, factor_;
};

/// Texture coordinates that do not change: of a point, or of a raster position.
std::array<TexturePoint, kTextureUnits> constant_texture(const State& state,
                                                         const std::array<Vec4, kTextureUnits>& at);
/// Throws std::logic_error if the coordinates differ: the machine does not interpolate them along lines and
/// in polygons of more than three corners.
void refuse_varying(const State& state, const std::array<Vec4, kTextureUnits>& a,
                    const std::array<Vec4, kTextureUnits>& b);
/// Coordinates of a pixel of a triangle, which is off by `slack` at most, and how they change from pixel to
/// pixel.
TexturePoint texture_in_triangle(const std::vector<LitVertex>& triangle, size_t unit, int x, int y,
                                 double slack);

} // namespace softgl::suite
