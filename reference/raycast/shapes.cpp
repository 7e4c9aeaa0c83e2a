// Sphere, plane and box: the exact point and the exact normal.
#include <limits>
#include <utility>

#include "shape.h"

namespace softgl::raycast {

std::optional<Hit> Sphere::intersect(const Ray& ray) const {
  // |origin + t direction - center|^2 = radius^2 is t^2 - 2 b t + c = 0, for a direction of length 1.
  const Vec3 to_center = center_ - ray.origin;
  const double b = dot(to_center, ray.direction);
  // How far the ray passes from the centre: b^2 - c without the cancellation.
  const Vec3 miss = to_center - b * ray.direction;
  const double discriminant = radius_ * radius_ - dot(miss, miss);
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant);
  const double t = b - root > ray.nearest ? b - root : b + root; // the second one, seen from inside
  if (t <= ray.nearest) return {};
  return hit_at(ray, t, (1 / radius_) * (ray.at(t) - center_));
}

std::optional<Hit> Plane::intersect(const Ray& ray) const {
  const double towards = dot(ray.direction, normal_);
  if (towards == 0) return {}; // parallel
  const double t = dot(point_ - ray.origin, normal_) / towards;
  if (t <= ray.nearest) return {};
  return hit_at(ray, t, normal_);
}

std::optional<Hit> Box::intersect(const Ray& ray) const {
  // Between each pair of opposite faces the ray is inside from `near` to `far`; inside all three, it is in
  // the box.
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  int enter_face = 0, leave_face = 0; // 2 * axis, + 1 on the negative side
  for (int axis = 0; axis < 3; axis++) {
    const double size = length(half_edge_[axis]);
    const Vec3 direction = (1 / size) * half_edge_[axis];
    const double start = dot(ray.origin - center_, direction), speed = dot(ray.direction, direction);
    if (speed == 0) {
      if (std::abs(start) > size) return {}; // beside the box, and it stays there
      continue;
    }
    double near = (-size - start) / speed, far = (size - start) / speed;
    int near_face = 2 * axis + 1, far_face = 2 * axis;
    if (near > far) std::swap(near, far), std::swap(near_face, far_face);
    if (near > enter) enter = near, enter_face = near_face;
    if (far < leave) leave = far, leave_face = far_face;
  }
  if (enter > leave) return {};
  const bool outside = enter > ray.nearest;
  const double t = outside ? enter : leave;
  if (t <= ray.nearest) return {};
  const int face = outside ? enter_face : leave_face;
  const Vec3 outwards = spec::unit(half_edge_[face / 2]);
  Hit hit = hit_at(ray, t, face & 1 ? -outwards : outwards);
  hit.part = face;
  return hit;
}

} // namespace softgl::raycast
