// The textbook's equation at one point of a surface, and scenes with exact shapes: what curves and ray-cast
// pictures are computed with.
#pragma once

#include "image/picture.h"
#include "raycast/scene.h"

namespace softgl::cli {

using spec::Vec3;

// A unit vector in the drawing's plane: degrees from the normal, which is (0, 1, 0), to the right.
Vec3 direction_at(double angle);
inline constexpr Vec3 kNormal = {0, 1, 0};

struct Reflectances {
  double ambient = 0, diffuse = 0, specular = 0, exponent = 1;
};

// L of one light of intensity 1 in direction s, seen from v, with LA = 1. `tested`: light from behind is left
// out.
double reflected_light(const Reflectances& reflectances, Vec3 n, Vec3 s, Vec3 v, bool tested = true);

Picture ray_cast_picture(const raycast::Scene& scene);
// Colors from 0 to 1, cut off where they are beyond.
Picture picture_of(int width, int height, const std::vector<Vec3>& colors);
// The color that each pixel's ray brings back, the top row first.
std::vector<Vec3> ray_cast_colors(const raycast::Scene& scene);

// "size 300 300" and other lines of a scene's file (reference/raycast/NOTES.md).
raycast::Scene scene_of(int width, int height, const std::string& text);

} // namespace softgl::cli
