#include "scene.h"

#include <numbers>

namespace softgl::raycast {

Ray Camera::ray(double x, double y) const {
  // From -1 to 1 over the window's height, and the same scale across.
  const double across = (2 * x - width) / height, up = (2 * y - height) / height;
  if (!perspective) return {{half_height * across, half_height * up, 0}, {0, 0, -1}};
  const double slope = std::tan(field_of_view / 2 * std::numbers::pi / 180);
  return {{0, 0, 0}, spec::unit({slope * across, slope * up, -1})};
}

std::optional<Hit> Scene::nearest(const Ray& ray) const {
  std::optional<Hit> best;
  for (const auto& shape : shapes) {
    const std::optional<Hit> hit = shape->intersect(ray);
    if (hit && (!best || hit->distance < best->distance)) best = hit;
  }
  return best;
}

Vec3 Scene::color(const Ray& ray) const {
  const std::optional<Hit> hit = nearest(ray);
  if (!hit) return background;
  return hit->material->shade(*hit, ray, shadows ? reaching(hit->point) : illumination);
}

// The lights that nothing hides from the point.
Illumination Scene::reaching(Vec3 point) const {
  Illumination lit = illumination;
  const spec::Vec4 from{point.x, point.y, point.z, 1};
  std::erase_if(lit.lights, [&](const spec::Light& light) {
    const std::optional<Hit> hit =
        nearest({point, spec::direction_between(from, light.position), shadow_start});
    return hit && (light.position.w == 0 || hit->distance < length(light.position.divided() - point));
  });
  return lit;
}

std::vector<uint8_t> render(const Scene& scene) {
  const Camera& camera = scene.camera;
  std::vector<uint8_t> rgb;
  rgb.reserve(size_t(camera.width) * size_t(camera.height) * 3);
  for (int row = camera.height - 1; row >= 0; row--)
    for (int column = 0; column < camera.width; column++) {
      const Vec3 color = scene.color(camera.ray(column + 0.5, row + 0.5));
      for (double component : {color.x, color.y, color.z}) rgb.push_back(spec::to_fixed_point(component));
    }
  return rgb;
}

} // namespace softgl::raycast
