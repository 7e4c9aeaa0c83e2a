// The fragments of polygons (3.5).
#include <functional>
#include <stdexcept>

#include "expect/coverage.h"
#include "expect/interpolation.h"

namespace softgl::suite {

struct Rasterizer::Polygon {
  const std::vector<LitVertex>& vertices;
  bool back;
  std::vector<const ColorBounds*> colors;
  Interval offset;
  FogBetween fog;
  size_t depth_source;
};

namespace {

void include(size_t& hash, double value) { hash = hash * 1000003 ^ std::hash<double>()(value); }

// What depths of a filled polygon come from.
size_t depth_source_of(const std::vector<LitVertex>& vertices) {
  size_t hash = vertices.size();
  for (const LitVertex& v : vertices)
    include(hash, v.window.x), include(hash, v.window.y), include(hash, v.window.z);
  return std::max<size_t>(hash, 1);
}

Interval plus(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }

} // namespace

double Rasterizer::slack() const {
  return std::ldexp(1, -std::clamp(precision_.subpixel_bits, 4, 16)) +
         2 * spec::kAccuracy * std::max(picture_.width, picture_.height);
}

void Rasterizer::polygon(const State& state, const std::vector<LitVertex>& vertices) {
  double area = 0; // equation 2.6, twice
  for (size_t i = 0; i < vertices.size(); i++) {
    const Vec3 &a = vertices[i].window, &b = vertices[(i + 1) % vertices.size()].window;
    area += a.x * b.y - b.x * a.y;
  }
  const PolygonState& p = state.polygon;
  if (std::abs(area) < 1e-9) { // nothing is inside, but there may be edges
    if (p.mode[0] == GL_FILL && p.mode[1] == GL_FILL) return;
    if (p.mode[0] != p.mode[1] || p.cull) throw std::logic_error("a polygon whose face is not known");
  }
  const bool back = spec::faces_back(area, p.front_face == GL_CW);
  const GLenum culled = p.cull ? p.cull_face : GL_NONE;
  if (culled == GL_FRONT_AND_BACK || culled == GLenum(back ? GL_BACK : GL_FRONT)) return;

  if (p.mode[back] != GL_FILL) {
    polygon_outline(state, vertices, back);
    return;
  }
  Polygon polygon{vertices,
                  back,
                  {},
                  polygon_offset(state, back, vertices),
                  {state.fog, vertices},
                  depth_source_of(vertices)};
  std::vector<Vec3> corners;
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const LitVertex& v : vertices) {
    polygon.colors.push_back(back ? &v.back : &v.front), corners.push_back(v.window);
    left = std::min(left, v.window.x), right = std::max(right, v.window.x);
    bottom = std::min(bottom, v.window.y), top = std::max(top, v.window.y);
  }
  const double sign = area > 0 ? 1 : -1;
  for (int y = std::max(0, int(bottom) - 1); y < std::min(picture_.height, int(top) + 2); y++)
    for (int x = std::max(0, int(left) - 1); x < std::min(picture_.width, int(right) + 2); x++) {
      const Vec3 center{x + 0.5, y + 0.5, 0};
      double inside = 1e9;
      for (size_t i = 0; i < vertices.size(); i++) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double edge = std::hypot(b.x - a.x, b.y - a.y);
        if (edge > 0) inside = std::min(inside, sign * cross2(a, b, center) / edge);
      }
      Fragment f;
      f.nominal = inside > 0;
      if (p.smooth) { // 3.5.3
        const Coverage coverage = covered_by_polygon(corners, x, y, slack());
        if (coverage == Coverage::None) continue;
        f.certain = coverage == Coverage::All;
        f.coverage = f.certain ? Interval(1) : Interval(0, 1);
      } else {
        if (inside <= -1.5 * slack()) continue;
        f.certain = inside > 1.5 * slack();
      }
      polygon_fragment(state, polygon, x, y, f);
    }
}

void Rasterizer::polygon_outline(const State& state, std::vector<LitVertex> vertices, bool back) { // 3.5.4
  const Interval offset = polygon_offset(state, back, vertices);
  for (LitVertex& v : vertices)
    if (back) v.front = v.back;
  if (state.line.stippled && state.line.stipple_pattern != 0xffff)
    throw std::logic_error("edges whose order the specification leaves open");
  for (size_t i = 0; i < vertices.size(); i++) {
    const LitVertex& next = vertices[(i + 1) % vertices.size()];
    if (!vertices[i].boundary) continue;
    if (state.polygon.mode[back] == GL_POINT) {
      point(state, vertices[i], offset);
      continue;
    }
    line(state, vertices[i], next, 0, offset);
  }
}

// 3.5.5; each three vertices have a slope (equation 3.7 or 3.8).
Interval Rasterizer::polygon_offset(const State& state, bool back, const std::vector<LitVertex>& v) const {
  const PolygonState& p = state.polygon;
  const GLenum mode = p.mode[back];
  if (!(mode == GL_POINT ? p.offset_point : mode == GL_LINE ? p.offset_line : p.offset_fill)) return 0;
  Interval slope;
  bool first = true;
  for (size_t i = 0; i < v.size(); i++)
    for (size_t j = i + 1; j < v.size(); j++)
      for (size_t k = j + 1; k < v.size(); k++) {
        const Vec3 &a = v[i].window, &b = v[j].window, &c = v[k].window;
        const double area = cross2(a, b, c);
        if (std::abs(area) < 1e-6) continue;
        const double dx = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area;
        const double dy = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area;
        const Interval here{std::max(std::abs(dx), std::abs(dy)), std::hypot(dx, dy)};
        slope = first ? here : spec::hull(slope, here);
        first = false;
      }
  // The least difference is a step of the depth buffer or more; how much more is open.
  const double step = std::ldexp(1, -precision_.depth_bits);
  const Interval least_difference{step, std::max(4 * step, std::ldexp(1, -20))};
  return plus(slope * Interval(p.offset_factor), least_difference * Interval(p.offset_units));
}

void Rasterizer::polygon_fragment(const State& state, const Polygon& polygon, int x, int y, Fragment f) {
  if (state.polygon.stippled && !state.polygon_stipple[size_t(x % 32 + y % 32 * 32)]) return; // 3.5.2
  const std::vector<LitVertex>& vertices = polygon.vertices;
  const int count = int(vertices.size());
  f.depth_source = polygon.depth_source, f.depth_offset = polygon.offset;
  if (count > 3 && lights_fragments(state)) throw std::logic_error("a lit polygon that is no triangle");
  if (count > 3) {
    // "we require only that a convex combination of the values of the datum at the polygon's vertices can be
    // used"
    f.color = *polygon.colors[0], f.depth = vertices[0].window.z, f.fog = polygon.fog.anywhere();
    f.texture = constant_texture(state, vertices[0].texture);
    for (int i = 1; i < count; i++) {
      refuse_varying(state, vertices[0].texture, vertices[size_t(i)].texture);
      f.color = hull_of(f.color, *polygon.colors[size_t(i)]);
      f.depth = spec::hull(f.depth, vertices[size_t(i)].window.z);
    }
    f.depth = plus(f.depth, polygon.offset);
    fragment(state, x, y, f);
    return;
  }
  const Vec3 &a = vertices[0].window, &b = vertices[1].window, &c = vertices[2].window;
  const double area = cross2(a, b, c), w[3] = {vertices[0].w, vertices[1].w, vertices[2].w};
  // Data of an antialiased polygon are integrated over the pixel's square, or sampled at its center (3.5.3).
  const double reach = slack() + (state.polygon.smooth ? 0.5 : 0);
  bool first = true;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
    const Vec3 p{x + 0.5 + dx * reach, y + 0.5 + dy * reach, 0};
    const double linear[3] = {cross2(p, b, c) / area, cross2(a, p, c) / area, cross2(a, b, p) / area};
    double perspective[3];
    divide_by_w(w, linear, perspective, 3);
    // "equation 3.6 may be approximated": either is right for colors.
    const auto color_by = [&](const double* weights) {
      return lights_fragments(state)
                 ? lit_fragment(state, vertices, weights, polygon.back, precision_.unit_normals)
                 : weighted(polygon.colors.data(), weights, 3);
    };
    const ColorBounds color = hull_of(color_by(linear), color_by(perspective));
    const Interval fog = polygon.fog.at(linear, perspective);
    const double depth = linear[0] * a.z + linear[1] * b.z + linear[2] * c.z;
    f.color = first ? color : hull_of(f.color, color);
    f.depth = first ? Interval(depth) : spec::hull(f.depth, depth);
    f.fog = first ? fog : spec::hull(f.fog, fog);
    first = false;
  }
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u))) f.texture[u] = texture_in_triangle(vertices, u, x, y, slack());
  f.depth = plus(f.depth, polygon.offset);
  fragment(state, x, y, f);
}

} // namespace softgl::suite
