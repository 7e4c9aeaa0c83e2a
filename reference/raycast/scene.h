// A scene, its camera, and the loop over all pixels.
#pragma once

#include <cstdint>
#include <string>

#include "shape.h"

namespace softgl::raycast {

/// The eye is at the origin and looks along -z. A perspective camera sees the angle `field_of_view` (degrees,
/// from bottom to top), an orthographic one sees `half_height` to both sides of the axis. Pixel rows count
/// from the bottom, as in OpenGL.
struct Camera {
  int width = 256, height = 256;
  bool perspective = true;
  double field_of_view = 40, half_height = 1;

  /// The ray through window coordinates (x, y); pixel (i, j) has its centre at (i + 0.5, j + 0.5).
  Ray ray(double x, double y) const;
};

struct Scene {
  Camera camera;
  Illumination illumination;
  Vec3 background{0, 0, 0};
  bool shadows = false;                   // a light that something hides from a point adds nothing there
  double shadow_start = kNearestDistance; // what is nearer to the point hides no light
  std::vector<std::unique_ptr<Shape>> shapes;

  /// The nearest hit of all shapes.
  std::optional<Hit> nearest(const Ray& ray) const;
  /// The color that a ray brings back, not clamped.
  Vec3 color(const Ray& ray) const;

private:
  Illumination reaching(Vec3 point) const;
};

/// RGB bytes, the top row first.
std::vector<uint8_t> render(const Scene& scene);

/// Reads a scene file (NOTES.md describes it). Throws std::runtime_error with file and line.
Scene read_scene(const std::string& path);
/// A scene that comes with the program: "sphere", "shapes" or "spots"; its text is an example of the format.
const char* built_in_scene(const std::string& name);
Scene parse_scene(const std::string& text, const std::string& name);

} // namespace softgl::raycast
