#include <limits>
#include <numeric>
#include <utility>

#include "shape.h"

namespace softgl::raycast {

static double component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

// True where the ray passes the box in front of `limit`.
static bool meets(const Ray& ray, Vec3 low, Vec3 high, double limit) {
  double enter = 0, leave = limit;
  for (int axis = 0; axis < 3; axis++) {
    const double origin = component(ray.origin, axis), speed = component(ray.direction, axis);
    if (speed == 0) {
      if (origin < component(low, axis) || origin > component(high, axis)) return false;
      continue;
    }
    double a = (component(low, axis) - origin) / speed, b = (component(high, axis) - origin) / speed;
    if (a > b) std::swap(a, b);
    // A box may be flat: a little slack, that no triangle is missed by a rounding error.
    enter = std::max(enter, a - 1e-12 * std::abs(a)), leave = std::min(leave, b + 1e-12 * std::abs(b));
  }
  return enter <= leave;
}

TriangleMesh::TriangleMesh(Material material, std::vector<Vertex> vertices, std::vector<int> indices)
    : Shape(material), vertices_(std::move(vertices)), indices_(std::move(indices)),
      order_(indices_.size() / 3) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) build(0, int(order_.size()));
}

// Puts a box around the triangles, halves them along its longest side, and does the same with both halves.
void TriangleMesh::build(int first, int count) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Node node{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}, first, count, 0};
  for (int i = first; i < first + count; i++)
    for (int corner = 0; corner < 3; corner++) {
      const Vec3 p = vertices_[size_t(indices_[size_t(3 * order_[size_t(i)] + corner)])].position;
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y), std::min(node.low.z, p.z)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y), std::max(node.high.z, p.z)};
    }
  const size_t index = nodes_.size();
  nodes_.push_back(node);
  if (count <= 4) return;
  const Vec3 size = node.high - node.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto middle = [&](int triangle) {
    double sum = 0;
    for (int corner = 0; corner < 3; corner++)
      sum += component(vertices_[size_t(indices_[size_t(3 * triangle + corner)])].position, axis);
    return sum;
  };
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](int a, int b) { return middle(a) < middle(b); });
  nodes_[index].count = 0;
  build(first, count / 2);
  nodes_[index].right = int(nodes_.size());
  build(first + count / 2, count - count / 2);
}

// Möller and Trumbore: solve origin + t direction = a + u (b - a) + v (c - a) by Cramer's rule.
bool TriangleMesh::intersect_triangle(const Ray& ray, int triangle, Hit& nearest) const {
  const Vertex& a = vertices_[size_t(indices_[size_t(3 * triangle)])];
  const Vertex& b = vertices_[size_t(indices_[size_t(3 * triangle + 1)])];
  const Vertex& c = vertices_[size_t(indices_[size_t(3 * triangle + 2)])];
  const Vec3 ab = b.position - a.position, ac = c.position - a.position, from_a = ray.origin - a.position;
  const Vec3 p = cross(ray.direction, ac);
  const double determinant = dot(ab, p);
  if (determinant == 0) return false; // the ray runs in the triangle's plane, or the triangle has no area
  const double u = dot(from_a, p) / determinant;
  const Vec3 q = cross(from_a, ab);
  const double v = dot(ray.direction, q) / determinant, t = dot(ac, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || t <= ray.nearest || t >= nearest.distance) return false;
  nearest = hit_at(ray, t, spec::unit((1 - u - v) * a.normal + u * b.normal + v * c.normal));
  nearest.from_behind = determinant < 0; // the vertices run clockwise, whatever the normals say
  nearest.part = triangle;
  nearest.weights = {1 - u - v, u, v};
  return true;
}

std::optional<Hit> TriangleMesh::intersect(const Ray& ray) const {
  Hit nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  std::vector<int> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const int index = open.back();
    open.pop_back();
    const Node& node = nodes_[size_t(index)];
    if (!meets(ray, node.low, node.high, nearest.distance)) continue;
    for (int i = node.first; i < node.first + node.count; i++)
      intersect_triangle(ray, order_[size_t(i)], nearest);
    if (!node.count) open.push_back(node.right), open.push_back(index + 1);
  }
  if (!nearest.material) return {};
  return nearest;
}

} // namespace softgl::raycast
