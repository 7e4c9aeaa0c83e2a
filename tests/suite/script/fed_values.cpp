#include "script/fed_values.h"

#include <algorithm>

#include "gl/subject.h"

namespace softgl::suite {
namespace {

using Vertices = std::vector<std::vector<Interval>>;

double area_of(const Vertices& v) { // in the order of the outline
  double twice = 0;
  for (size_t i = 0; i < v.size(); i++) {
    const auto &a = v[i], &b = v[(i + 1) % v.size()];
    twice += a[0].middle() * b[1].middle() - b[0].middle() * a[1].middle();
  }
  return std::abs(twice) / 2;
}

void sort(Vertices& v) {
  std::stable_sort(v.begin(), v.end(),
                   [](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
}

void append(std::vector<Interval>& numbers, const Vertices& vertices) {
  for (const auto& v : vertices) numbers.insert(numbers.end(), v.begin(), v.end());
}

// 0 at even numbers, 1 at odd ones.
double wave(double x) {
  const double turn = x - 2 * std::floor(x / 2);
  return turn < 1 ? turn : 2 - turn;
}
Interval wave(Interval x) {
  if (!(x.high - x.low < 2)) return {0, 1};
  Interval w = spec::hull(wave(x.low), wave(x.high));
  for (double turn = std::ceil(x.low); turn <= x.high; turn++) w = spec::hull(w, wave(turn));
  return w;
}
Interval scaled(Interval x, double by, double offset) { return {x.low * by + offset, x.high * by + offset}; }

constexpr double kSameCorner = 0.01;  // pixels
constexpr double kLeastDepth = 65536; // of hit records; smaller numbers are names
constexpr double kAreaUnit = 8;       // square pixels

} // namespace

int numbers_of_vertex(GLenum type) {
  switch (type) {
  case GL_2D: return 2;
  case GL_3D: return 3;
  case GL_3D_COLOR: return 7;
  case GL_3D_COLOR_TEXTURE: return 11;
  default: return 12;
  }
}

double place_of(const std::vector<Interval>& vertex) {
  return vertex[0].middle() + 0.618 * vertex[1].middle();
}

std::vector<FedItem> fed_items(GLenum type, const std::vector<double>& values) {
  std::vector<FedItem> items;
  const size_t numbers = size_t(numbers_of_vertex(type));
  for (size_t at = 0; at < values.size();) {
    FedItem item;
    item.token = GLenum(std::clamp(values[at++], 0.0, 65535.0));
    size_t count = 1, width = numbers;
    switch (item.token) {
    case GL_PASS_THROUGH_TOKEN: width = 1; break;
    case GL_LINE_TOKEN:
    case GL_LINE_RESET_TOKEN: count = 2; break;
    case GL_POLYGON_TOKEN:
      if (at == values.size() || !(values[at] >= 3 && values[at] < 100)) return items;
      count = size_t(values[at++]);
      break;
    case GL_POINT_TOKEN:
    case GL_BITMAP_TOKEN:
    case GL_DRAW_PIXEL_TOKEN:
    case GL_COPY_PIXEL_TOKEN: break;
    default: return items;
    }
    if (at + count * width > values.size()) return items;
    for (size_t i = 0; i < count; i++, at += width)
      item.vertices.emplace_back(values.begin() + long(at), values.begin() + long(at + width));
    items.push_back(item);
  }
  return items;
}

std::vector<Interval> painted_numbers(std::vector<FedItem> items, FedOrder order) {
  std::vector<Interval> numbers;
  Vertices corners, points;
  std::vector<Vertices> lines;
  double area = 0;
  for (FedItem& item : items) {
    const bool polygon = item.token == GL_POLYGON_TOKEN;
    if (order == FedOrder::InOrder || order == FedOrder::Resets) {
      const bool line = item.token == GL_LINE_RESET_TOKEN && order == FedOrder::InOrder;
      numbers.push_back(line ? GL_LINE_TOKEN : item.token);
      if (polygon) sort(item.vertices), numbers.push_back(double(item.vertices.size()));
      append(numbers, item.vertices);
      continue;
    }
    if (polygon) {
      area += area_of(item.vertices),
          corners.insert(corners.end(), item.vertices.begin(), item.vertices.end());
    } else if (item.token == GL_LINE_TOKEN || item.token == GL_LINE_RESET_TOKEN) {
      sort(item.vertices), lines.push_back(item.vertices);
    } else {
      points.push_back(item.vertices[0]);
    }
  }
  if (order != FedOrder::AnyOrder) return numbers;
  sort(corners), sort(points);
  const auto same = [](const auto& a, const auto& b) { return place_of(b) - place_of(a) < kSameCorner; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  std::stable_sort(lines.begin(), lines.end(), [](const Vertices& a, const Vertices& b) {
    return place_of(a[0]) + place_of(a[1]) < place_of(b[0]) + place_of(b[1]);
  });
  numbers.push_back(double(corners.size()));
  // The area has the accuracy of the corners.
  if (!corners.empty()) numbers.push_back(spec::widened(area / kAreaUnit, 0.2)), append(numbers, corners);
  numbers.push_back(double(lines.size()));
  for (const Vertices& line : lines) append(numbers, line);
  numbers.push_back(double(points.size())), append(numbers, points);
  return numbers;
}

int painted_squares(int size) { return (kWindowWidth / size) * (kWindowHeight / size); }

void paint_number(Interval number, Interval color[3]) {
  color[0] = wave(scaled(number, 1.0 / 2048, 0.5)), color[1] = wave(scaled(number, 1.0 / 32, 0.5));
  color[2] = wave(scaled(number, 1, 0.5));
}

void paint_record_number(Interval number, Interval color[3]) {
  color[0] = spec::clamped(scaled(number, 1 / 4294967295.0, 0), 0, 1);
  color[1] = wave(scaled(number, 1.0 / (1 << 26), 0));
  color[2] = number.low >= kLeastDepth   ? Interval(0)
             : number.high < kLeastDepth ? wave(scaled(number, 1.0 / 64, 0))
                                         : Interval(0, 1);
}

} // namespace softgl::suite
