#include "lighting_bounds.h"

#include <numbers>

namespace softgl::spec {
namespace {

Interval clamped_dot(Vec3Interval a, Vec3Interval b) {
  const Interval d = dot(a, b);
  return {std::max(d.low, 0.0), std::max(d.high, 0.0)};
}

// The cosine of an angle that is itself accurate to 1 part in 10^5.
Interval cosine_of_degrees(double degrees) {
  const double angle = degrees * std::numbers::pi / 180, slack = angle * kAccuracy;
  return rounded({std::cos(angle + slack), std::cos(angle - slack)});
}

Interval attenuation(const LightBounds& light, Vec3Interval vertex) { // equation 2.4
  const Light& p = light.parameters;
  if (p.position.w == 0) return 1;
  const Interval d = length(light.position - vertex);
  return reciprocal(Interval(p.constant_attenuation) + Interval(p.linear_attenuation) * d +
                    Interval(p.quadratic_attenuation) * square(d));
}

Interval spotlight(const LightBounds& light, Vec3Interval towards_light) { // equation 2.5
  const Light& p = light.parameters;
  if (p.spot_cutoff == 180) return 1;
  // The vector from light to vertex and the direction are of unit length.
  const Interval cosine = clamped(dot(-towards_light, unit(light.spot_direction)), -1, 1);
  const Interval limit = cosine_of_degrees(p.spot_cutoff);
  const Interval inside = power(cosine, p.spot_exponent);
  if (cosine.high < limit.low) return 0;
  if (cosine.low >= limit.high) return inside;
  return hull(0, inside);
}

Interval highlight(Vec3Interval normal, Vec3Interval towards_light, Vec3Interval towards_viewer,
                   double shininess) {
  const Interval n_dot_l = dot(normal, towards_light);
  if (n_dot_l.high <= 0) return 0;
  const Interval lit = power(clamped_dot(normal, unit(towards_light + towards_viewer)), shininess);
  return n_dot_l.low > 0 ? lit : hull(0, lit);
}

double component(Vec3 color, int i) { return i == 0 ? color.x : i == 1 ? color.y : color.z; }

} // namespace

LitBounds light_vertex_bounds(const LightModel& model, std::span<const LightBounds> lights,
                              const Material& material, Vec3Interval vertex, Vec3Interval normal) {
  LitBounds lit;
  const Vec3 a_cm = material.ambient.xyz(), d_cm = material.diffuse.xyz(), s_cm = material.specular.xyz();
  for (int c = 0; c < 3; c++)
    lit.primary[c] = Interval(component(material.emission.xyz(), c)) +
                     Interval(component(a_cm, c)) * component(model.ambient, c);
  for (const LightBounds& light : lights) {
    const Light& p = light.parameters;
    const Vec3Interval l = unit(p.position.w == 0 ? light.position : light.position - vertex);
    const Vec3Interval v = model.local_viewer ? unit(-vertex) : Vec3Interval(Vec3{0, 0, 1});
    const Interval diffuse = clamped_dot(normal, l), specular = highlight(normal, l, v, material.shininess);
    const Interval intensity = attenuation(light, vertex) * spotlight(light, l);
    for (int c = 0; c < 3; c++) {
      const Interval matt = Interval(component(a_cm, c)) * component(p.ambient, c) +
                            diffuse * (Interval(component(d_cm, c)) * component(p.diffuse, c));
      const Interval shiny = specular * (Interval(component(s_cm, c)) * component(p.specular, c));
      lit.primary[c] = lit.primary[c] + intensity * matt;
      Interval& highlights = model.separate_specular ? lit.secondary[c] : lit.primary[c];
      highlights = highlights + intensity * shiny;
    }
  }
  lit.primary[3] = material.diffuse.w;
  return lit;
}

} // namespace softgl::spec
