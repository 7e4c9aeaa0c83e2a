#include "figure/textbook.h"

#include "common/trigonometry.h"

namespace softgl::cli {

Vec3 direction_at(double angle) { return {sine(angle), cosine(angle), 0}; }

double reflected_light(const Reflectances& reflectances, Vec3 n, Vec3 s, Vec3 v, bool tested) {
  const auto gray = [](double value) { return Vec3{value, value, value}; };
  raycast::Material material;
  material.kAmbient = gray(reflectances.ambient);
  material.kDiffuse = gray(reflectances.diffuse);
  material.kSpecular = gray(reflectances.specular);
  material.phongExponent = reflectances.exponent;
  raycast::Illumination illumination;
  illumination.tests_light_behind = tested;
  illumination.model.ambient = gray(1);
  spec::Light& light = illumination.lights.emplace_back();
  light.position = {s.x, s.y, s.z, 0};
  light.diffuse = gray(1);
  raycast::Hit hit;
  hit.normal = n;
  return material.shade(hit, {v, -v}, illumination).x;
}

Picture picture_of(int width, int height, const std::vector<Vec3>& colors) {
  Picture picture;
  picture.width = width;
  picture.height = height;
  for (const Vec3& color : colors)
    for (const double component : {color.x, color.y, color.z})
      picture.pixels.append(spec::to_fixed_point(component));
  return picture;
}

std::vector<Vec3> ray_cast_colors(const raycast::Scene& scene) {
  std::vector<Vec3> colors;
  const raycast::Camera& camera = scene.camera;
  for (int row = camera.height - 1; row >= 0; --row)
    for (int column = 0; column < camera.width; ++column)
      colors.push_back(scene.color(camera.ray(column + 0.5, row + 0.5)));
  return colors;
}

Picture ray_cast_picture(const raycast::Scene& scene) {
  return picture_of(scene.camera.width, scene.camera.height, ray_cast_colors(scene));
}

raycast::Scene scene_of(int width, int height, const std::string& text) {
  return raycast::parse_scene("size " + std::to_string(width) + " " + std::to_string(height) + "\n" + text,
                              "figure");
}

} // namespace softgl::cli
