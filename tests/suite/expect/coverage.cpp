#include "expect/coverage.h"

#include <algorithm>
#include <cmath>

namespace softgl::suite {

using spec::Vec3;

Coverage covered_by_polygon(const std::vector<Vec3>& polygon, int x, int y, double slack) {
  double area = 0, left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (size_t i = 0; i < polygon.size(); i++) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - b.x * a.y;
    left = std::min(left, a.x), right = std::max(right, a.x);
    bottom = std::min(bottom, a.y), top = std::max(top, a.y);
  }
  if (right < x - slack || left > x + 1 + slack || top < y - slack || bottom > y + 1 + slack)
    return Coverage::None;
  bool all = true;
  for (size_t i = 0; i < polygon.size(); i++) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double edge = std::hypot(b.x - a.x, b.y - a.y);
    if (edge < 1e-9) continue;
    double nearest = 1e9, farthest = -1e9; // of the square's corners, inside of the edge
    for (int corner = 0; corner < 4; corner++) {
      const double px = x + corner % 2, py = y + corner / 2;
      const double inside =
          ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / edge * (area > 0 ? 1 : -1);
      nearest = std::min(nearest, inside), farthest = std::max(farthest, inside);
    }
    if (farthest < -slack) return Coverage::None;
    all &= nearest > slack;
  }
  return all ? Coverage::All : Coverage::Some;
}

Coverage covered_by_circle(const Vec3& center, double radius, int x, int y, double slack) {
  const double dx = std::max({x - center.x, center.x - x - 1, 0.0}),
               dy = std::max({y - center.y, center.y - y - 1, 0.0});
  if (std::hypot(dx, dy) > radius + slack) return Coverage::None;
  const double far_x = std::max(std::abs(x - center.x), std::abs(x + 1 - center.x)),
               far_y = std::max(std::abs(y - center.y), std::abs(y + 1 - center.y));
  return std::hypot(far_x, far_y) < radius - slack ? Coverage::All : Coverage::Some;
}

} // namespace softgl::suite
