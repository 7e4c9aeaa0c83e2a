// From a vertex to its window coordinates and colors (2.11 to 2.14), and from vertices to primitives (2.6.1).
#include "expect/calls.h"

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
  const Matrix4& m = state_.modelview.back();
  const Vec4 eye4 = m * object;
  const Vec4 clip = state_.projection.back() * eye4;
  if (clip.w <= 0 || std::abs(clip.z) > clip.w) throw std::logic_error("a vertex outside of the view");
  const Interval by_w = 1 / eye4.w;
  const spec::Vec3Interval eye{row_times(m, 0, object) * by_w, row_times(m, 1, object) * by_w,
                               row_times(m, 2, object) * by_w};
  LitVertex v;
  const int* p = state_.viewport;
  v.window = {p[0] + (clip.x / clip.w + 1) * p[2] / 2, p[1] + (clip.y / clip.w + 1) * p[3] / 2,
              (clip.z / clip.w + 1) / 2};
  v.w = clip.w;
  v.fog_distance = spec::hull(spec::widened(std::abs(eye4.z), 1e-4), spec::length(eye)); // 3.10: either
  const bool normalize = state_.transform.normalize;
  const Vec3 n = spec::transform_normal(m, state_.current.normal, state_.transform.rescale_normal, false);
  const double accuracy = 4 * kMatrixAccuracy * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  spec::Vec3Interval normal{spec::widened(n.x, accuracy), spec::widened(n.y, accuracy),
                            spec::widened(n.z, accuracy)};
  if (normalize) normal = spec::unit(normal);
  v.eye = eye, v.normal = normal;
  std::copy(state_.lighting.material, state_.lighting.material + 2, v.material);
  generate_coordinates(object, eye4, {normal.x.middle(), normal.y.middle(), normal.z.middle()}, v);
  v.front = lit_color(eye, normal, 0);
  v.back = state_.lighting.lighting && state_.lighting.model.two_sided ? lit_color(eye, normal, 1) : v.front;
  return v;
}

void Machine::end() {
  const std::vector<LitVertex>& v = vertices_;
  const int n = int(v.size());
  const auto polygon = [&](std::vector<int> corners, int provoking) {
    std::vector<LitVertex> p;
    for (int i : corners) p.push_back(v[size_t(i)]);
    raster_.polygon(state_, p, provoking);
  };
  const auto line = [&](int a, int b) { raster_.line(state_, v[size_t(a)], v[size_t(b)], 1); };
  switch (mode_) { // table 2.12 says which vertex gives a flat polygon its color
  case GL_POINTS:
    for (const LitVertex& p : v) raster_.point(state_, p);
    break;
  case GL_LINES:
    for (int i = 0; i + 1 < n; i += 2) line(i, i + 1);
    break;
  case GL_LINE_STRIP:
  case GL_LINE_LOOP:
    for (int i = 0; i + 1 < n; i++) line(i, i + 1);
    if (mode_ == GL_LINE_LOOP && n > 2) line(n - 1, 0);
    break;
  case GL_TRIANGLES:
    for (int i = 0; i + 2 < n; i += 3) polygon({i, i + 1, i + 2}, 2);
    break;
  case GL_TRIANGLE_STRIP:
    for (int i = 0; i + 2 < n; i++)
      polygon(i % 2 ? std::vector{i + 1, i, i + 2} : std::vector{i, i + 1, i + 2}, 2);
    break;
  case GL_TRIANGLE_FAN:
    for (int i = 1; i + 1 < n; i++) polygon({0, i, i + 1}, 2);
    break;
  case GL_QUADS:
    for (int i = 0; i + 3 < n; i += 4) polygon({i, i + 1, i + 2, i + 3}, 3);
    break;
  case GL_QUAD_STRIP:
    for (int i = 0; i + 3 < n; i += 2) polygon({i, i + 1, i + 3, i + 2}, 2);
    break;
  case GL_POLYGON: {
    std::vector<int> all;
    for (int i = 0; i < n; i++) all.push_back(i);
    if (n > 2) polygon(all, 0);
    break;
  }
  }
  vertices_.clear();
}

} // namespace softgl::suite
