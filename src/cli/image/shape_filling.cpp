#include "image/shape_filling.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"
#include "image/stb_truetype_functions.h"

namespace softgl::cli {
namespace {

constexpr double kLargestCoordinate = 32000; // of stb_truetype's vertices

struct Box {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;

  void add(Point p) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
};

// Overlapping polygons add up only if all run the same way around.
bool runs_backwards(const std::vector<Point>& polygon) {
  double area = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area < 0;
}

std::vector<Point> disk(Point center, double radius) {
  std::vector<Point> points;
  constexpr int kCorners = 12;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 360.0 * i / kCorners;
    points.push_back({center.x + radius * cosine(angle), center.y + radius * sine(angle)});
  }
  return points;
}

} // namespace

void blend_mask(Picture& picture, const uint8_t* mask, int left, int top, int width, int height,
                const Color& color, double opacity) {
  for (int y = std::max(0, -top); y < std::min(height, picture.height - top); ++y)
    for (int x = std::max(0, -left); x < std::min(width, picture.width - left); ++x) {
      const double alpha = opacity * mask[size_t(y) * size_t(width) + size_t(x)] / 255;
      uint8_t* pixel = &picture.pixels[3 * (size_t(top + y) * size_t(picture.width) + size_t(left + x))];
      for (size_t i = 0; i < 3; ++i) pixel[i] = uint8_t(pixel[i] + alpha * (color[i] - pixel[i]) + 0.5);
    }
}

void fill_polygons(Picture& picture, const std::vector<std::vector<Point>>& polygons, const Color& color,
                   double opacity) {
  Box box;
  for (const std::vector<Point>& polygon : polygons)
    for (const Point p : polygon) box.add(p);
  // What is far outside is not computed; an edge that leaves the picture keeps its slope near it.
  const double left = std::max(std::floor(box.left), -1000.0), top = std::max(std::floor(box.top), -1000.0);
  const double right = std::min(std::ceil(box.right), picture.width + 1000.0),
               bottom = std::min(std::ceil(box.bottom), picture.height + 1000.0);
  if (!(right > left && bottom > top)) return;
  const double steps = std::min(64.0, std::floor(kLargestCoordinate / std::max(right - left, bottom - top)));
  std::vector<stbtt_vertex> vertices;
  const auto add = [&](Point p, unsigned char kind) {
    stbtt_vertex vertex{};
    vertex.x = short(std::lround((std::clamp(p.x, left, right) - left) * steps));
    vertex.y = short(std::lround((std::clamp(p.y, top, bottom) - top) * steps));
    vertex.type = kind;
    vertices.push_back(vertex);
  };
  for (const std::vector<Point>& polygon : polygons) {
    std::vector<Point> points = polygon;
    if (runs_backwards(points)) std::reverse(points.begin(), points.end());
    for (size_t i = 0; i <= points.size(); ++i) add(points[i % points.size()], i ? STBTT_vline : STBTT_vmove);
  }
  const int width = int(right - left) + 1, height = int(bottom - top) + 1;
  std::vector<uint8_t> mask(size_t(width) * size_t(height));
  stbtt__bitmap bitmap{width, height, width, mask.data()};
  const float scale = float(1 / steps);
  stbtt_Rasterize(&bitmap, 0.35f, vertices.data(), int(vertices.size()), scale, scale, 0, 0, 0, 0, 0,
                  nullptr);
  blend_mask(picture, mask.data(), int(left), int(top), width, height, color, opacity);
}

void stroke_line(Picture& picture, const std::vector<Point>& points, bool closed, double width,
                 const Color& color, double opacity) {
  std::vector<std::vector<Point>> pieces;
  const double radius = width / 2;
  const size_t count = points.size();
  for (size_t i = 0; i < count; ++i) {
    const Point a = points[i], b = points[(i + 1) % count];
    if (width > 1.5) pieces.push_back(disk(a, radius));
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    if ((i + 1 == count && !closed) || length == 0) continue;
    const double x = -dy / length * radius, y = dx / length * radius;
    pieces.push_back({{a.x + x, a.y + y}, {a.x - x, a.y - y}, {b.x - x, b.y - y}, {b.x + x, b.y + y}});
  }
  fill_polygons(picture, pieces, color, opacity);
}

} // namespace softgl::cli
