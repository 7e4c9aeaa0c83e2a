// From a vertex to its window coordinates and colors (2.11 to 2.14), and from vertices to primitives (2.6.1).
#include "expect/calls.h"
#include "expect/clipping.h"

namespace softgl::suite {

ColorBounds Machine::lit_color(const spec::Vec3Interval& eye, const spec::Vec3Interval& normal,
                               int face) const {
  const LightingState& l = state_.lighting;
  if (l.lighting) return suite::lit_color(l, l.material[face], eye, face ? -normal : normal);
  ColorBounds color;
  const Vec4& c = state_.current.color;
  const double plain[4] = {c.x, c.y, c.z, c.w};
  for (int i = 0; i < 4; i++) color.primary[i] = spec::clamped(plain[i], 0, 1);
  return color;
}

LitVertex Machine::transform(const Vec4& object) const {
  const CurrentState& current = state_.current;
  const LightingState& lighting = state_.lighting;
  if (!current.edge_known || (!lighting.lighting && !current.color_known) ||
      (lighting.lighting && !current.normal_known))
    throw std::logic_error("a vertex takes a value that an array left undefined");
  const Matrix4& m = state_.modelview.back();
  LitVertex v;
  v.eye4 = m * object, v.clip = state_.projection.back() * v.eye4, v.boundary = current.edge;
  const Interval by_w = v.eye4.w == 0 ? 1 : 1 / v.eye4.w;
  const spec::Vec3Interval eye{row_times(m, 0, object) * by_w, row_times(m, 1, object) * by_w,
                               row_times(m, 2, object) * by_w};
  const Interval distance = spec::length(eye);
  v.fog_distance = state_.fog.source == GL_FOG_COORD
                       ? current.fog_coordinate
                       : spec::hull(spec::widened(std::abs(v.eye4.z), 1e-4), distance); // 3.10: either
  const PointState& p = state_.point;
  const double d = distance.middle();
  v.point_size =
      std::clamp(p.size / std::sqrt(p.attenuation[0] + p.attenuation[1] * d + p.attenuation[2] * d * d),
                 p.least, p.greatest);
  const Vec3 n = spec::transform_normal(m, current.normal, state_.transform.rescale_normal, false);
  const double accuracy = 4 * kMatrixAccuracy * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  spec::Vec3Interval normal{spec::widened(n.x, accuracy), spec::widened(n.y, accuracy),
                            spec::widened(n.z, accuracy)};
  if (state_.transform.normalize) normal = spec::unit(normal);
  v.eye = eye, v.normal = normal;
  std::copy(lighting.material, lighting.material + 2, v.material);
  generate_coordinates(object, v.eye4, {normal.x.middle(), normal.y.middle(), normal.z.middle()}, v);
  v.front = lit_color(eye, normal, 0);
  v.back = lighting.lighting && lighting.model.two_sided ? lit_color(eye, normal, 1) : v.front;
  return v;
}

void Machine::to_window(LitVertex& v) const { // 2.11.1
  const ViewportState& p = state_.viewport;
  const Vec4& c = v.clip;
  v.window = {p.box[0] + (c.x / c.w + 1) * p.box[2] / 2, p.box[1] + (c.y / c.w + 1) * p.box[3] / 2,
              p.near + (c.z / c.w + 1) / 2 * (p.far - p.near)};
  v.w = c.w;
}

void Machine::draw_polygon(const std::vector<int>& corners, int provoking, bool edge_flags) {
  std::vector<LitVertex> polygon;
  for (int i : corners) {
    polygon.push_back(vertices_[size_t(i)]);
    if (!edge_flags) polygon.back().boundary = true;
  }
  if (state_.lighting.shade_model == GL_FLAT) {
    const LitVertex from = polygon[size_t(provoking)];
    for (LitVertex& v : polygon) v.front = from.front, v.back = from.back;
  }
  polygon = clip_polygon(state_, std::move(polygon));
  for (LitVertex& v : polygon) to_window(v);
  if (polygon.empty()) return;
  if (render_mode_.mode == GL_RENDER)
    raster_.polygon(state_, polygon);
  else
    receive_polygon(render_mode_, state_.polygon, polygon);
}

void Machine::draw_line(int from, int to, bool begins, Interval along) {
  LitVertex a = vertices_[size_t(from)], b = vertices_[size_t(to)];
  if (state_.lighting.shade_model == GL_FLAT) a.front = b.front;
  if (!clip_line(state_, a, b)) return;
  to_window(a), to_window(b);
  if (render_mode_.mode == GL_RENDER)
    raster_.line(state_, a, b, along);
  else
    receive(begins ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN, {a, b});
}

void Machine::end() {
  const int n = int(vertices_.size());
  switch (mode_) { // table 2.12 says which vertex gives a flat polygon its color
  case GL_POINTS:
    for (LitVertex& p : vertices_) {
      if (!is_inside(state_, p)) continue;
      to_window(p);
      if (render_mode_.mode == GL_RENDER)
        raster_.point(state_, p);
      else
        receive(GL_POINT_TOKEN, {p});
    }
    break;
  case GL_LINES:
    for (int i = 0; i + 1 < n; i += 2) draw_line(i, i + 1, true);
    break;
  case GL_LINE_STRIP:
  case GL_LINE_LOOP: {
    Interval along; // each line may have a fragment more or less
    for (int i = 0; i + 1 < n + (mode_ == GL_LINE_LOOP && n > 2); i++) {
      const int next = (i + 1) % n;
      draw_line(i, next, i == 0, along);
      if (!state_.line.stippled) continue;
      LitVertex a = vertices_[size_t(i)], b = vertices_[size_t(next)];
      to_window(a), to_window(b);
      const double more = Rasterizer::fragments_of(a, b);
      along = {along.low + more - 1, along.high + more + 1};
    }
    break;
  }
  case GL_TRIANGLES:
    for (int i = 0; i + 2 < n; i += 3) draw_polygon({i, i + 1, i + 2}, 2, true);
    break;
  case GL_TRIANGLE_STRIP:
    for (int i = 0; i + 2 < n; i++)
      draw_polygon(i % 2 ? std::vector{i + 1, i, i + 2} : std::vector{i, i + 1, i + 2}, 2, false);
    break;
  case GL_TRIANGLE_FAN:
    for (int i = 1; i + 1 < n; i++) draw_polygon({0, i, i + 1}, 2, false);
    break;
  case GL_QUADS:
    for (int i = 0; i + 3 < n; i += 4) draw_polygon({i, i + 1, i + 2, i + 3}, 3, true);
    break;
  case GL_QUAD_STRIP:
    for (int i = 0; i + 3 < n; i += 2) draw_polygon({i, i + 1, i + 3, i + 2}, 2, false);
    break;
  case GL_POLYGON: {
    std::vector<int> all;
    for (int i = 0; i < n; i++) all.push_back(i);
    if (n > 2) draw_polygon(all, 0, true);
    break;
  }
  }
  vertices_.clear();
}

} // namespace softgl::suite
