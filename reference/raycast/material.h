// What a surface is made of, and the light that falls on it. Material::shade is Phong's illumination model.
#pragma once

#include <vector>

#include "../spec/lighting.h"

namespace softgl::raycast {

using spec::Vec3;
using spec::Vec4;

struct Hit;
struct Ray;

enum class Equation {
  Textbook, // L = ka LA + kd sum Lj (n . sj) + ks sum Lj (v . rj)^a
  OpenGL,   // GL 1.5, 2.14.1: attenuation, spotlights, separate intensities, two sides
};

/// All that shades a scene. The textbook's lights have one intensity Lj, which is Light::diffuse; its viewer
/// is where the ray comes from.
struct Illumination {
  Equation equation = Equation::Textbook;
  bool tests_light_behind = true; // the textbook's test can be left out, to see what it is for
  spec::LightModel model;         // model.ambient is LA
  std::vector<spec::Light> lights;
};

struct Material {
  Vec3 kAmbient{0.2, 0.2, 0.2}, kDiffuse{0.8, 0.8, 0.8}, kSpecular{0, 0, 0};
  double phongExponent = 1;
  Vec3 kEmission{0, 0, 0}; // OpenGL's equation only

  /// The color of a point, not clamped.
  Vec3 shade(const Hit& hit, const Ray& ray, const Illumination& illumination) const;

private:
  Vec3 shade_textbook(Vec3 point, Vec3 normal, Vec3 towards_viewer, const Illumination& illumination) const;
  Vec3 shade_opengl(Vec3 point, Vec3 normal, const Illumination& illumination) const;
};

} // namespace softgl::raycast
