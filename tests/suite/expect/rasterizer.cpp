// Coverage and interpolation (chapter 3), with what the specification leaves open as intervals.
#include <stdexcept>

#include "expect/primitive.h"

namespace softgl::suite {
namespace {

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

// From the weights of window coordinates to those of equation 3.6.
void divide_by_w(const double* w, const double* weights, double* result, int count) {
  double sum = 0;
  for (int i = 0; i < count; i++) sum += result[i] = weights[i] / w[i];
  for (int i = 0; i < count; i++) result[i] /= sum;
}

// Texture coordinates that do not change: of a point, or of a raster position.
TexturePoint constant_point(const Vec4& v) {
  TexturePoint point;
  const double c[3] = {v.x, v.y, v.z};
  for (int i = 0; i < 3; i++) point.coordinate[i] = v.w == 0 ? 0 : c[i] / v.w;
  return point;
}
using TextureCoordinates = std::array<Vec4, kTextureUnits>;
std::array<TexturePoint, kTextureUnits> constant_texture(const State& state, const TextureCoordinates& at) {
  std::array<TexturePoint, kTextureUnits> points;
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u))) points[u] = constant_point(at[u]);
  return points;
}
// For primitives between whose vertices the machine does not interpolate.
void refuse_varying(const State& state, const TextureCoordinates& a, const TextureCoordinates& b) {
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u)) &&
        (a[u].x != b[u].x || a[u].y != b[u].y || a[u].z != b[u].z || a[u].w != b[u].w))
      throw std::logic_error("texture coordinates that vary along a line or in a polygon of many corners");
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

double Rasterizer::slack() const {
  return std::ldexp(1, -std::clamp(precision_.subpixel_bits, 4, 16)) +
         2 * spec::kAccuracy * std::max(picture_.width, picture_.height);
}

void Rasterizer::clear(const State& state, GLbitfield mask) {
  const Vec4& c = state.color_buffer.clear_color;
  for (auto& answers : picture_.pixels) {
    if (answers.empty()) answers.resize(1);
    for (Answer& answer : answers) {
      if (mask & GL_COLOR_BUFFER_BIT) {
        const double color[4] = {c.x, c.y, c.z, c.w};
        std::copy(color, color + 4, answer.color);
      }
      if (mask & GL_DEPTH_BUFFER_BIT) answer.depth = state.depth.clear;
    }
    answers.resize(mask & GL_COLOR_BUFFER_BIT ? 1 : answers.size());
  }
}

void Rasterizer::polygon(const State& state, const std::vector<LitVertex>& vertices) {
  double area = 0; // equation 2.6, twice
  for (size_t i = 0; i < vertices.size(); i++) {
    const Vec3 &a = vertices[i].window, &b = vertices[(i + 1) % vertices.size()].window;
    area += a.x * b.y - b.x * a.y;
  }
  if (std::abs(area) < 1e-9) return;
  const bool back = spec::faces_back(area, state.polygon.front_face == GL_CW);
  const GLenum culled = state.polygon.cull ? state.polygon.cull_face : GL_NONE;
  if (culled == GL_FRONT_AND_BACK || culled == GLenum(back ? GL_BACK : GL_FRONT)) return;

  if (state.polygon.mode[back] != GL_FILL) {
    polygon_outline(state, vertices, back);
    return;
  }
  std::vector<const ColorBounds*> colors;
  for (const LitVertex& v : vertices) colors.push_back(back ? &v.back : &v.front);
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const LitVertex& v : vertices) {
    left = std::min(left, v.window.x), right = std::max(right, v.window.x);
    bottom = std::min(bottom, v.window.y), top = std::max(top, v.window.y);
  }
  const double sign = area > 0 ? 1 : -1;
  for (int y = std::max(0, int(bottom) - 1); y < std::min(picture_.height, int(top) + 2); y++)
    for (int x = std::max(0, int(left) - 1); x < std::min(picture_.width, int(right) + 2); x++) {
      const Vec3 center{x + 0.5, y + 0.5, 0};
      double inside = 1e9;
      for (size_t i = 0; i < vertices.size(); i++) {
        const Vec3 &a = vertices[i].window, &b = vertices[(i + 1) % vertices.size()].window;
        const double edge = std::hypot(b.x - a.x, b.y - a.y);
        if (edge > 0) inside = std::min(inside, sign * cross2(a, b, center) / edge);
      }
      if (inside > -1.5 * slack()) polygon_fragment(state, vertices, colors, back, x, y, inside);
    }
}

void Rasterizer::polygon_outline(const State& state, std::vector<LitVertex> vertices, bool back) { // 3.5.4
  for (LitVertex& v : vertices)
    if (back) v.front = v.back;
  for (size_t i = 0; i < vertices.size(); i++) {
    if (!vertices[i].boundary) continue;
    if (state.polygon.mode[back] == GL_POINT)
      point(state, vertices[i]);
    else
      line(state, vertices[i], vertices[(i + 1) % vertices.size()]);
  }
}

void Rasterizer::polygon_fragment(const State& state, const std::vector<LitVertex>& vertices,
                                  const std::vector<const ColorBounds*>& colors, bool back, int x, int y,
                                  double inside) {
  Fragment f;
  f.certain = inside > 1.5 * slack(), f.nominal = inside > 0;
  const int count = int(vertices.size());
  if (count > 3 && lights_fragments(state)) throw std::logic_error("a lit polygon that is no triangle");
  if (count > 3) {
    // "we require only that a convex combination of the values of the datum at the polygon's vertices can be
    // used"
    f.color = *colors[0], f.depth = vertices[0].window.z, f.fog_distance = vertices[0].fog_distance;
    f.texture = constant_texture(state, vertices[0].texture);
    for (int i = 1; i < count; i++) {
      refuse_varying(state, vertices[0].texture, vertices[size_t(i)].texture);
      f.color = hull_of(f.color, *colors[size_t(i)]);
      f.depth = spec::hull(f.depth, vertices[size_t(i)].window.z);
      f.fog_distance = spec::hull(f.fog_distance, vertices[size_t(i)].fog_distance);
    }
    fragment(state, x, y, f);
    return;
  }
  const Vec3 &a = vertices[0].window, &b = vertices[1].window, &c = vertices[2].window;
  const double area = cross2(a, b, c), w[3] = {vertices[0].w, vertices[1].w, vertices[2].w};
  const Interval fog[3] = {vertices[0].fog_distance, vertices[1].fog_distance, vertices[2].fog_distance};
  bool first = true;
  for (const auto& [dx, dy] : {std::pair{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}) {
    const Vec3 p{x + 0.5 + dx * slack(), y + 0.5 + dy * slack(), 0};
    const double linear[3] = {cross2(p, b, c) / area, cross2(a, p, c) / area, cross2(a, b, p) / area};
    double perspective[3];
    divide_by_w(w, linear, perspective, 3);
    // "equation 3.6 may be approximated": either is right for colors.
    const auto color_by = [&](const double* weights) {
      return lights_fragments(state) ? lit_fragment(state, vertices, weights, back, precision_.unit_normals)
                                     : weighted(colors.data(), weights, 3);
    };
    const ColorBounds color = hull_of(color_by(linear), color_by(perspective));
    const Interval distance = spec::hull(weighted(fog, linear, 3), weighted(fog, perspective, 3));
    const double depth = linear[0] * a.z + linear[1] * b.z + linear[2] * c.z;
    f.color = first ? color : hull_of(f.color, color);
    f.depth = first ? Interval(depth) : spec::hull(f.depth, depth);
    f.fog_distance = first ? distance : spec::hull(f.fog_distance, distance);
    first = false;
  }
  for (size_t u = 0; u < kTextureUnits; u++)
    if (state.texture.texture_of(int(u)))
      f.texture[u] = TextureTriangle{{a, b, c},
                                     {w[0], w[1], w[2]},
                                     {vertices[0].texture[u], vertices[1].texture[u], vertices[2].texture[u]}}
                         .point(x, y, slack());
  fragment(state, x, y, f);
}

void Rasterizer::line(const State& state, const LitVertex& a, const LitVertex& b) {
  const Vec3 &p = a.window, &q = b.window;
  const double length = std::hypot(q.x - p.x, q.y - p.y), half_width = state.width.line / 2;
  if (length < 2) throw std::logic_error("a line of less than two pixels");
  const bool x_major = std::abs(q.x - p.x) >= std::abs(q.y - p.y);
  refuse_varying(state, a.texture, b.texture);
  const auto texture = constant_texture(state, a.texture);
  const ColorBounds* ends[2] = {&a.front, &b.front};
  // A fragment's center may lie beyond the end (equation 3.5).
  const auto color_at = [&](double t) {
    ColorBounds color;
    for (int side = -1; side <= 1; side += 2) {
      const double u = std::clamp(t + side * 1.5 / length, -1 / length, 1 + 1 / length),
                   linear[2] = {1 - u, u}, w[2] = {a.w, b.w};
      double perspective[2];
      divide_by_w(w, linear, perspective, 2);
      const ColorBounds here = hull_of(weighted(ends, linear, 2), weighted(ends, perspective, 2));
      color = side < 0 ? here : hull_of(color, here);
    }
    return color;
  };
  for (int y = 0; y < picture_.height; y++)
    for (int x = 0; x < picture_.width; x++) {
      const double dx = x + 0.5 - p.x, dy = y + 0.5 - p.y;
      const double t = (dx * (q.x - p.x) + dy * (q.y - p.y)) / (length * length);
      const double u = std::clamp(t, 0.0, 1.0);
      const double off = std::hypot(dx - u * (q.x - p.x), dy - u * (q.y - p.y));
      if (off > 1.1 + half_width) continue;
      Fragment f;
      f.certain = false, f.nominal = off < half_width;
      f.color = color_at(t), f.fog_distance = spec::hull(a.fog_distance, b.fog_distance), f.texture = texture;
      f.depth = spec::hull(p.z, q.z);
      fragment(state, x, y, f);
    }
  // Each column (or row) between the ends has a fragment (3.4.1). Near an end another line of a strip may
  // hide it.
  const double from = x_major ? std::min(p.x, q.x) : std::min(p.y, q.y);
  const double to = x_major ? std::max(p.x, q.x) : std::max(p.y, q.y);
  for (int major = int(from) + 7; major < int(to) - 6; major++) {
    const double t = x_major ? (major + 0.5 - p.x) / (q.x - p.x) : (major + 0.5 - p.y) / (q.y - p.y);
    const double minor = x_major ? p.y + t * (q.y - p.y) : p.x + t * (q.x - p.x);
    Witness witness;
    for (int i = int(minor) - 2; i <= int(minor) + 2; i++) {
      const int x = x_major ? major : i, y = x_major ? i : major;
      if (std::abs(i + 0.5 - minor) <= 1.1 + half_width && x >= 0 && y >= 0 && x < picture_.width &&
          y < picture_.height)
        witness.pixels.push_back(y * picture_.width + x);
    }
    Fragment f;
    f.color = color_at(t), f.fog_distance = spec::hull(a.fog_distance, b.fog_distance), f.texture = texture;
    process_color(state, f, witness.color);
    picture_.witnesses.push_back(witness), picture_.covered++;
  }
}

void Rasterizer::point(const State& state, const LitVertex& vertex) {
  const double size = state.width.point, x = vertex.window.x, y = vertex.window.y;
  Fragment f;
  f.color = vertex.front, f.depth = vertex.window.z, f.fog_distance = vertex.fog_distance;
  f.texture = constant_texture(state, vertex.texture);
  Witness witness;
  for (int j = int(y - size / 2) - 2; j <= int(y + size / 2) + 2; j++)
    for (int i = int(x - size / 2) - 2; i <= int(x + size / 2) + 2; i++) {
      if (i < 0 || j < 0 || i >= picture_.width || j >= picture_.height) continue;
      const double off = std::max(std::abs(i + 0.5 - x), std::abs(j + 0.5 - y));
      // The size is rounded, and a point of even size begins at a whole coordinate (3.3).
      if (off > size / 2 + (size <= 1 ? 0 : 0.5) + slack()) continue;
      f.certain = size <= 1 ? off < 0.5 - slack() : off < size / 2 - 1, f.nominal = off < size / 2;
      fragment(state, i, j, f);
      witness.pixels.push_back(j * picture_.width + i);
    }
  process_color(state, f, witness.color);
  picture_.witnesses.push_back(witness);
}

void Rasterizer::pixel(const State& state, int x, int y, const LitVertex& at, Interval depth) {
  if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
  Fragment f;
  f.color = at.front, f.depth = depth, f.fog_distance = at.fog_distance,
  f.texture = constant_texture(state, at.texture);
  fragment(state, x, y, f);
}

PixelImage Rasterizer::read(int left, int bottom, int width, int height, PixelKind kind) const {
  PixelImage image{kind, width, height, 1, {}};
  for (int y = bottom; y < bottom + height; y++)
    for (int x = left; x < left + width; x++) {
      if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height)
        throw std::logic_error("pixels outside of the window are read");
      const std::vector<Answer>& answers = picture_.pixels[size_t(y * picture_.width + x)];
      Pixel pixel;
      for (size_t i = 0; i < answers.size(); i++) {
        const Answer& a = answers[i];
        const auto add = [&](int c, Interval value) {
          pixel.c[c] = i == 0 ? value : spec::hull(pixel.c[c], value);
        };
        switch (kind) {
        case PixelKind::Color:
          for (int c = 0; c < 4; c++) {
            const bool stored = c < 3 || precision_.bits[3] > 0;
            add(c, stored ? spec::clamped(spec::widened(a.color[c], precision_.half_step(c)), 0, 1)
                          : Interval(1));
          }
          break;
        case PixelKind::Depth: add(0, spec::clamped(spec::widened(a.depth, 1.0 / 65535), 0, 1)); break;
        default: throw std::logic_error("a buffer that the machine does not have");
        }
      }
      image.pixels.push_back(pixel);
    }
  return image;
}

void Rasterizer::paint(int left, int bottom, int size, const Interval color[4]) {
  for (int y = std::max(bottom, 0); y < std::min(bottom + size, picture_.height); y++)
    for (int x = std::max(left, 0); x < std::min(left + size, picture_.width); x++) {
      auto& answers = picture_.pixels[size_t(y * picture_.width + x)];
      answers.resize(1);
      std::copy(color, color + 4, answers[0].color);
      picture_.covered++;
    }
}

} // namespace softgl::suite
