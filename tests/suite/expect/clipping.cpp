#include "expect/clipping.h"

#include <stdexcept>

namespace softgl::suite {
namespace {

constexpr int kViewPlanes = 6;

bool is_used(const State& state, int plane) {
  return plane < kViewPlanes || state.transform.clip_enabled[plane - kViewPlanes];
}

// Not less than 0 in the half space that stays.
double distance(const State& state, const LitVertex& v, int plane) {
  const Vec4& c = v.clip;
  switch (plane) {
  case 0: return c.w + c.x;
  case 1: return c.w - c.x;
  case 2: return c.w + c.y;
  case 3: return c.w - c.y;
  case 4: return c.w + c.z;
  case 5: return c.w - c.z;
  }
  const Vec4& p = state.transform.clip_plane[plane - kViewPlanes];
  return p.x * v.eye4.x + p.y * v.eye4.y + p.z * v.eye4.z + p.w * v.eye4.w;
}

// (1 - t) a + t b; the t of the subject has the accuracy of 2.1.1.
Interval between(Interval a, Interval b, double t) {
  const double error = 4 * spec::kAccuracy;
  return spec::hull(
      Interval{a.low + (t - error) * (b.low - a.low), a.high + (t - error) * (b.high - a.high)},
      Interval{a.low + (t + error) * (b.low - a.low), a.high + (t + error) * (b.high - a.high)});
}
Vec4 between(const Vec4& a, const Vec4& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w)};
}
ColorBounds between(const ColorBounds& a, const ColorBounds& b, double t) {
  ColorBounds c;
  for (int i = 0; i < 4; i++) c.primary[i] = between(a.primary[i], b.primary[i], t);
  for (int i = 0; i < 3; i++) c.secondary[i] = between(a.secondary[i], b.secondary[i], t);
  return c;
}
spec::Vec3Interval between(const spec::Vec3Interval& a, const spec::Vec3Interval& b, double t) {
  return {between(a.x, b.x, t), between(a.y, b.y, t), between(a.z, b.z, t)};
}
LitVertex between(const LitVertex& a, const LitVertex& b, double t) {
  LitVertex v;
  v.eye4 = between(a.eye4, b.eye4, t), v.clip = between(a.clip, b.clip, t);
  v.front = between(a.front, b.front, t), v.back = between(a.back, b.back, t);
  v.fog_distance = between(a.fog_distance, b.fog_distance, t);
  v.point_size = a.point_size + t * (b.point_size - a.point_size);
  v.eye = between(a.eye, b.eye, t), v.normal = between(a.normal, b.normal, t);
  std::copy(a.material, a.material + 2, v.material);
  for (size_t u = 0; u < v.texture.size(); u++) v.texture[u] = between(a.texture[u], b.texture[u], t);
  return v;
}

} // namespace

bool is_inside(const State& state, const LitVertex& vertex) {
  for (int plane = 0; plane < kViewPlanes + kClipPlanes; plane++) {
    if (!is_used(state, plane)) continue;
    const double d = distance(state, vertex, plane);
    if (std::abs(d) < 1e-3) throw std::logic_error("a point on a clip plane");
    if (d < 0) return false;
  }
  return true;
}

bool clip_line(const State& state, LitVertex& a, LitVertex& b) {
  for (int plane = 0; plane < kViewPlanes + kClipPlanes; plane++) {
    if (!is_used(state, plane)) continue;
    const double da = distance(state, a, plane), db = distance(state, b, plane);
    if (da < 0 && db < 0) return false;
    if (da < 0) a = between(a, b, da / (da - db));
    if (db < 0) b = between(b, a, db / (db - da));
  }
  return true;
}

std::vector<LitVertex> clip_polygon(const State& state, std::vector<LitVertex> polygon) {
  for (int plane = 0; plane < kViewPlanes + kClipPlanes; plane++) {
    if (!is_used(state, plane)) continue;
    std::vector<LitVertex> kept;
    for (size_t i = 0; i < polygon.size(); i++) {
      const LitVertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = distance(state, a, plane), db = distance(state, b, plane);
      if (da >= 0) kept.push_back(a);
      if ((da < 0) == (db < 0)) continue;
      kept.push_back(between(a, b, da / (da - db)));
      // "edges introduced by clipping are flagged as boundary", what is left of an edge keeps its flag
      kept.back().boundary = da >= 0 || a.boundary;
    }
    polygon = std::move(kept);
  }
  if (polygon.size() < 3) polygon.clear();
  return polygon;
}

} // namespace softgl::suite
