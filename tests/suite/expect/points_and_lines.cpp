// The fragments of points (3.3) and line segments (3.4).
#include <map>
#include <stdexcept>

#include "expect/coverage.h"
#include "expect/interpolation.h"

namespace softgl::suite {
namespace {

// 3.4.2: whether a rectangle or column `from` to `to` fragments from the start is drawn.
class Stipple {
public:
  Stipple(const LineState& line, Interval along) : line_(line), along_(along) {}
  Passes between(double from, double to) const {
    if (!line_.stippled) return Passes::Yes;
    bool any = false, all = true;
    for (double s = along_.low + from;; s += 0.5) {
      s = std::min(s, along_.high + to);
      const int bit = int(std::floor(std::max(s, 0.0) / line_.stipple_factor)) % 16;
      const bool on = line_.stipple_pattern >> bit & 1;
      any |= on, all &= on;
      if (s == along_.high + to) break;
    }
    return all ? Passes::Yes : any ? Passes::Perhaps : Passes::No;
  }

private:
  const LineState& line_;
  Interval along_;
};

struct LineData {
  ColorBounds color;
  Interval depth, fog;
};

// The data of a line at t (equations 3.3 to 3.5), if the fragment may be off by `reach` pixels.
class LineBetween {
public:
  LineBetween(const State& state, const LitVertex& a, const LitVertex& b)
      : a_(a), b_(b), length_(std::hypot(b.window.x - a.window.x, b.window.y - a.window.y)),
        fog_(state.fog, {a, b}) {}
  LineData at(double t, double reach) const {
    LineData data;
    for (int side = -1; side <= 1; side += 2) {
      // A fragment's center may lie beyond the end.
      const double u = std::clamp(t + side * reach / length_, -reach / length_, 1 + reach / length_);
      const double linear[2] = {1 - u, u}, w[2] = {a_.w, b_.w};
      double perspective[2];
      divide_by_w(w, linear, perspective, 2);
      const ColorBounds* ends[2] = {&a_.front, &b_.front};
      const ColorBounds color = hull_of(weighted(ends, linear, 2), weighted(ends, perspective, 2));
      const Interval depth = linear[0] * a_.window.z + linear[1] * b_.window.z;
      const Interval fog = fog_.at(linear, perspective);
      data.color = side < 0 ? color : hull_of(data.color, color);
      data.depth = side < 0 ? depth : spec::hull(data.depth, depth);
      data.fog = side < 0 ? fog : spec::hull(data.fog, fog);
    }
    return data;
  }

private:
  const LitVertex &a_, &b_;
  double length_;
  FogBetween fog_;
};

// Rule 1 of 3.4.1, and half a pixel; fragments of a wide line may have the data of their column's.
double reach_of_line(double width) { return 1.5 + (width - 1) / 2; }

} // namespace

double Rasterizer::fragments_of(const LitVertex& a, const LitVertex& b) {
  return std::max(std::abs(b.window.x - a.window.x), std::abs(b.window.y - a.window.y));
}

bool Rasterizer::writes_colors(const State& state) const {
  const ColorBufferState& b = state.color_buffer;
  return !b.blend && !b.logic && b.drawn && b.mask[0] && b.mask[1] && b.mask[2] && b.mask[3];
}

void Rasterizer::add_witness(Witness& witness) {
  witness.touched = picture_.sum(picture_.touched, witness);
  witness.hidden = picture_.sum(picture_.hidden, witness);
  picture_.witnesses.push_back(witness);
}

// The column (or row) of a line: some of its pixels have the color, and as many as the line is wide if that
// can be seen.
Witness Rasterizer::line_witness(const State& state, const Interval color[4], double minor, int major,
                                 bool x_major, int width) const {
  Witness witness;
  std::copy(color, color + 4, witness.color);
  witness.counts = true;
  for (int i = int(minor - width / 2.0) - 2; i <= int(minor + width / 2.0) + 2; i++) {
    const int x = x_major ? major : i, y = x_major ? i : major;
    if (std::abs(i + 0.5 - minor) > 1.1 + width / 2.0) continue;
    if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) {
      witness.counts = false;
      continue;
    }
    witness.pixels.push_back(y * picture_.width + x);
    for (const Answer& before : picture_.pixels[size_t(witness.pixels.back())]) {
      bool differs = false;
      for (int c = 0; c < 3; c++)
        differs |= before.color[c].low > color[c].high + 3 * step_of(c) ||
                   before.color[c].high < color[c].low - 3 * step_of(c);
      witness.counts &= differs;
    }
  }
  if (state.scissor.test) witness.counts = false;
  witness.least = width, witness.most = width;
  return witness;
}

void Rasterizer::line(const State& state, const LitVertex& a, const LitVertex& b, Interval along,
                      Interval offset) {
  const Vec3 &p = a.window, &q = b.window;
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  if (length < 2) throw std::logic_error("a line of less than two pixels");
  const bool x_major = std::abs(q.x - p.x) >= std::abs(q.y - p.y), smooth = state.line.smooth;
  // 3.4.2: the width is rounded, or the nearest one that the GL has.
  const double width = smooth ? precision_.smooth_lines.nearest(state.line.width)
                              : std::clamp(std::round(state.line.width), 1.0, precision_.lines.greatest);
  refuse_varying(state, a.texture, b.texture);
  const auto texture = constant_texture(state, a.texture);
  const LineBetween between(state, a, b);
  const Stipple stipple(state.line, along);
  const double columns = fragments_of(a, b);
  const Vec3 side{(q.y - p.y) / length * width / 2, -(q.x - p.x) / length * width / 2, 0};
  const std::vector<Vec3> rectangle = {{p.x + side.x, p.y + side.y, 0},
                                       {q.x + side.x, q.y + side.y, 0},
                                       {q.x - side.x, q.y - side.y, 0},
                                       {p.x - side.x, p.y - side.y, 0}};
  // Each column (or row) between the ends has fragments (3.4.1). Near an end another line of a strip may
  // hide them.
  std::vector<Witness> witnesses;
  const double from = x_major ? std::min(p.x, q.x) : std::min(p.y, q.y);
  const double to = x_major ? std::max(p.x, q.x) : std::max(p.y, q.y);
  for (int major = int(from) + 7; major < int(to) - 6 && !smooth && writes_colors(state); major++) {
    const double t = x_major ? (major + 0.5 - p.x) / (q.x - p.x) : (major + 0.5 - p.y) / (q.y - p.y);
    if (stipple.between(t * columns - 1.6, t * columns + 0.6) != Passes::Yes) continue;
    const double minor = x_major ? p.y + t * (q.y - p.y) : p.x + t * (q.x - p.x);
    const LineData data = between.at(t, reach_of_line(width));
    Fragment f;
    f.color = data.color, f.fog = data.fog, f.texture = texture;
    Interval color[4];
    process_color(state, f, color);
    witnesses.push_back(line_witness(state, color, minor, major, x_major, int(width)));
  }

  std::map<int, Passes> passes;
  const double reach = width / 2 + 3;
  for (int y = std::max(0, int(std::min(p.y, q.y) - reach));
       y < std::min(picture_.height, int(std::max(p.y, q.y) + reach)); y++)
    for (int x = std::max(0, int(std::min(p.x, q.x) - reach));
         x < std::min(picture_.width, int(std::max(p.x, q.x) + reach)); x++) {
      const double dx = x + 0.5 - p.x, dy = y + 0.5 - p.y;
      const double t = (dx * (q.x - p.x) + dy * (q.y - p.y)) / (length * length);
      Fragment f;
      Passes stippled;
      if (smooth) {
        const Coverage coverage = covered_by_polygon(rectangle, x, y, slack());
        if (coverage == Coverage::None) continue;
        // Rectangles of one pixel's length; the square reaches over some of them.
        const double half = (std::abs(q.x - p.x) + std::abs(q.y - p.y)) / length / 2 + slack();
        stippled = stipple.between(t * length - half, t * length + half);
        f.certain = coverage == Coverage::All && stippled == Passes::Yes;
        f.nominal = coverage == Coverage::All && stippled != Passes::No;
        f.coverage = f.certain ? Interval(1) : Interval(0, 1);
      } else {
        const double u = std::clamp(t, 0.0, 1.0);
        const double off = std::hypot(dx - u * (q.x - p.x), dy - u * (q.y - p.y));
        if (off > 1.1 + width / 2) continue;
        // Columns are counted along the greater axis.
        const double along_major = x_major ? dx / (q.x - p.x) : dy / (q.y - p.y);
        const double minor = x_major ? dy - along_major * (q.y - p.y) : dx - along_major * (q.x - p.x);
        stippled = stipple.between(along_major * columns - 1.6, along_major * columns + 0.6);
        f.certain = stippled == Passes::Yes && std::abs(minor) < width / 2 - 1.1 &&
                    along_major * columns > 1.6 && (1 - along_major) * columns > 1.6;
        f.nominal = off < width / 2;
      }
      if (stippled == Passes::No) continue;
      const LineData data = between.at(t, reach_of_line(width));
      f.color = data.color, f.fog = data.fog, f.texture = texture;
      f.depth = {data.depth.low + offset.low, data.depth.high + offset.high};
      passes[y * picture_.width + x] = fragment(state, x, y, f);
    }
  for (Witness& witness : witnesses) {
    bool all = true;
    for (int pixel : witness.pixels) all &= !passes.contains(pixel) || passes[pixel] == Passes::Yes;
    if (!all) continue;
    add_witness(witness), picture_.covered++;
  }
}

void Rasterizer::smooth_point(const State& state, const LitVertex& vertex, Fragment f) {
  const double radius = precision_.smooth_points.nearest(vertex.point_size) / 2;
  const Vec3& at = vertex.window;
  for (int y = std::max(0, int(at.y - radius) - 2); y < std::min(picture_.height, int(at.y + radius) + 3);
       y++)
    for (int x = std::max(0, int(at.x - radius) - 2); x < std::min(picture_.width, int(at.x + radius) + 3);
         x++) {
      const Coverage coverage = covered_by_circle(at, radius, x, y, slack());
      if (coverage == Coverage::None) continue;
      f.certain = f.nominal = coverage == Coverage::All;
      f.coverage = f.certain ? Interval(1) : Interval(0, 1);
      fragment(state, x, y, f);
    }
}

void Rasterizer::point(const State& state, const LitVertex& vertex, Interval offset) {
  Fragment f;
  f.color = vertex.front, f.depth = {vertex.window.z + offset.low, vertex.window.z + offset.high};
  f.fog = fog_factor(state.fog, vertex.fog_distance);
  f.texture = constant_texture(state, vertex.texture);
  if (state.point.smooth) return smooth_point(state, vertex, f);
  // 3.3.1: a square of fragments whose corner is at whole coordinates.
  const double size = std::clamp(std::round(vertex.point_size), 1.0, precision_.points.greatest);
  const double x = vertex.window.x, y = vertex.window.y;
  Witness witness;
  bool all = true;
  if (writes_colors(state)) process_color(state, f, witness.color);
  for (int j = int(y - size / 2) - 2; j <= int(y + size / 2) + 2; j++)
    for (int i = int(x - size / 2) - 2; i <= int(x + size / 2) + 2; i++) {
      if (i < 0 || j < 0 || i >= picture_.width || j >= picture_.height) continue;
      const double off = std::max(std::abs(i + 0.5 - x), std::abs(j + 0.5 - y));
      if (off > size / 2 + slack()) continue;
      f.certain = off < size / 2 - slack(), f.nominal = off < size / 2;
      all &= fragment(state, i, j, f) == Passes::Yes;
      witness.pixels.push_back(j * picture_.width + i);
    }
  if (!all || !writes_colors(state) || witness.pixels.empty()) return;
  add_witness(witness);
}

} // namespace softgl::suite
