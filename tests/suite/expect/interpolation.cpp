#include "expect/interpolation.h"

#include <stdexcept>

namespace softgl::suite {
namespace {

// Texture coordinates that do not change: of a point, or of a raster position.
TexturePoint constant_point(const Vec4& v) {
  TexturePoint point;
  const double c[3] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; i++) point.coordinate[i] = v.w == 0 ? 0 : c[i] / v.w;
  return point;
}

// Texture coordinates of a triangle (equation 3.6, which is to be used for them) and their changes from pixel
// to pixel.
struct TextureTriangle {
  Vec3 corner[3];
  double w[3];
  Vec4 coordinate[3];

  bool constant() const {
    for (int i = 1; i < 3; i++)
      if (coordinate[i].x != coordinate[0].x || coordinate[i].y != coordinate[0].y ||
          coordinate[i].z != coordinate[0].z || coordinate[i].w != coordinate[0].w)
        return false;
    return true;
  }
  void at(double x, double y, double str[3]) const {
    const Vec3 p{x, y, 0};
    const double area = cross2(corner[0], corner[1], corner[2]);
    const double linear[3] = {cross2(p, corner[1], corner[2]) / area, cross2(corner[0], p, corner[2]) / area,
                              cross2(corner[0], corner[1], p) / area};
    double sum[4] = {};
    for (int i = 0; i < 3; i++) {
      const double weight = linear[i] / w[i]; // the sum of the weights goes out in the division by q
      sum[0] += weight * coordinate[i].x, sum[1] += weight * coordinate[i].y,
          sum[2] += weight * coordinate[i].z, sum[3] += weight * coordinate[i].w;
    }
    for (int i = 0; i < 3; i++) str[i] = sum[i] / sum[3];
  }
  TexturePoint point(int x, int y, double slack) const {
    if (constant()) return constant_point(coordinate[0]);
    TexturePoint result;
    bool first = true;
    Interval along[2][3];
    for (const auto& [dx, dy] : {std::pair{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
      double here[3];
      at(x + 0.5 + dx * slack, y + 0.5 + dy * slack, here);
      for (int i = 0; i < 3; i++)
        result.coordinate[i] = first ? Interval(here[i]) : spec::hull(result.coordinate[i], here[i]);
      first = false;
    }
    double middle[3];
    at(x + 0.5, y + 0.5, middle);
    for (int axis = 0; axis < 2; axis++)
      for (int side = -1; side <= 1; side += 2) {
        double there[3];
        at(x + 0.5 + (axis == 0) * side, y + 0.5 + (axis == 1) * side, there);
        for (int i = 0; i < 3; i++) {
          const Interval change = std::abs(there[i] - middle[i]);
          along[axis][i] = side < 0 ? change : spec::hull(along[axis][i], change);
        }
      }
    for (int i = 0; i < 3; i++)
      result.change[i] = {std::max(along[0][i].low, along[1][i].low),
                          std::max(along[0][i].high, along[1][i].high)};
    return result;
  }
};

} // namespace

double cross2(const Vec3& o, const Vec3& a, const Vec3& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

ColorBounds hull_of(const ColorBounds& a, const ColorBounds& b) {
  ColorBounds c;
  for (int i = 0; i < 4; i++) c.primary[i] = spec::hull(a.primary[i], b.primary[i]);
  for (int i = 0; i < 3; i++) c.secondary[i] = spec::hull(a.secondary[i], b.secondary[i]);
  return c;
}

Interval weighted(const Interval* values, const double* weights, int count) {
  Interval sum;
  for (int i = 0; i < count; i++) {
    sum.low += weights[i] * (weights[i] < 0 ? values[i].high : values[i].low);
    sum.high += weights[i] * (weights[i] < 0 ? values[i].low : values[i].high);
  }
  return sum;
}

ColorBounds weighted(const ColorBounds* const* colors, const double* weights, int count) {
  ColorBounds result;
  std::vector<Interval> values(static_cast<size_t>(count));
  const auto component = [&](auto get) {
    for (int i = 0; i < count; i++) values[size_t(i)] = get(*colors[i]);
    return weighted(values.data(), weights, count);
  };
  for (int c = 0; c < 4; c++)
    result.primary[c] = component([c](const ColorBounds& b) { return b.primary[c]; });
  for (int c = 0; c < 3; c++)
    result.secondary[c] = component([c](const ColorBounds& b) { return b.secondary[c]; });
  return result;
}

void divide_by_w(const double* w, const double* weights, double* result, int count) {
  double sum = 0;
  for (int i = 0; i < count; i++) sum += result[i] = weights[i] / w[i];
  for (int i = 0; i < count; i++) result[i] /= sum;
}

FogBetween::FogBetween(const FogState& fog, const std::vector<LitVertex>& vertices) : fog_(fog) {
  for (const LitVertex& v : vertices)
    distance_.push_back(v.fog_distance), factor_.push_back(fog_factor(fog, v.fog_distance));
}

Interval FogBetween::at(const double* linear, const double* perspective) const {
  if (!fog_.on) return 1;
  const auto between = [&](const std::vector<Interval>& values) {
    const int count = int(values.size());
    return spec::hull(weighted(values.data(), linear, count), weighted(values.data(), perspective, count));
  };
  return spec::hull(fog_factor(fog_, between(distance_)), spec::clamped(between(factor_), 0, 1));
}

Interval FogBetween::anywhere() const {
  Interval all = factor_[0];
  for (const Interval& f : factor_) all = spec::hull(all, f);
  return all;
}

std::array<TexturePoint, kTextureUnits> constant_texture(const State& state,
                                                         const std::array<Vec4, kTextureUnits>& at) {
  std::array<TexturePoint, kTextureUnits> points;
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u))) points[u] = constant_point(at[u]);
  return points;
}

void refuse_varying(const State& state, const std::array<Vec4, kTextureUnits>& a,
                    const std::array<Vec4, kTextureUnits>& b) {
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u)) &&
        (a[u].x != b[u].x || a[u].y != b[u].y || a[u].z != b[u].z || a[u].w != b[u].w))
      throw std::logic_error("texture coordinates that vary along a line or in a polygon of many corners");
}

TexturePoint texture_in_triangle(const std::vector<LitVertex>& v, size_t unit, int x, int y, double slack) {
  return TextureTriangle{{v[0].window, v[1].window, v[2].window},
                         {v[0].w, v[1].w, v[2].w},
                         {v[0].texture[unit], v[1].texture[unit], v[2].texture[unit]}}
      .point(x, y, slack);
}

} // namespace softgl::suite
