#include "lighting.h"

#include <numbers>

namespace softgl::spec {

// 2.11.3
// ---------------------------------------------------------------------------------------------------------------

Vec3 transform_normal(const Matrix4& modelview, Vec3 normal, bool rescale_normal, bool normalize) {
  const auto row = [&](int i) { return Vec3{modelview(i, 0), modelview(i, 1), modelview(i, 2)}; };
  const Vec3 x = row(0), y = row(1), z = row(2);
  const double determinant = dot(x, cross(y, z));
  if (determinant == 0) return {};
  // The columns of the inverse are the cross products of the rows, divided by the determinant.
  const double inverse = 1 / determinant;
  const Vec3 column[3] = {inverse * cross(y, z), inverse * cross(z, x), inverse * cross(x, y)};
  Vec3 n{dot(normal, column[0]), dot(normal, column[1]), dot(normal, column[2])};
  if (rescale_normal) {
    const Vec3 third_row{column[0].z, column[1].z, column[2].z};
    n = (1 / length(third_row)) * n;
  }
  return normalize ? unit(n) : n;
}

// 2.14.1
// ---------------------------------------------------------------------------------------------------------------

Vec3 direction_between(Vec4 from, Vec4 to) {
  if (to.w == 0 && from.w != 0) return unit(to.xyz());
  if (to.w != 0 && from.w == 0) return -unit(from.xyz());
  if (to.w == 0) return unit(to.xyz() - from.xyz());
  return unit(to.divided() - from.divided());
}

double distance_attenuation(const Light& light, Vec4 vertex) {
  if (light.position.w == 0) return 1;
  const double d = length(light.position.divided() - vertex.divided());
  // Not infinite where the light itself is, so that black stays black there.
  return std::min(
      1 / (light.constant_attenuation + light.linear_attenuation * d + light.quadratic_attenuation * d * d),
      1e18);
}

double spotlight(const Light& light, Vec4 vertex) {
  if (light.spot_cutoff == 180) return 1;
  const double cosine = dot(direction_between(light.position, vertex), unit(light.spot_direction));
  if (cosine < std::cos(light.spot_cutoff * std::numbers::pi / 180)) return 0;
  return std::pow(std::max(cosine, 0.0), light.spot_exponent);
}

Vec3 towards_viewer(const LightModel& model, Vec4 vertex) {
  const Vec4 eye{0, 0, 0, 1};
  return model.local_viewer ? direction_between(vertex, eye) : Vec3{0, 0, 1};
}

Vec3 half_vector(Vec3 towards_light, Vec3 towards_viewer) { return unit(towards_light + towards_viewer); }

Vec3 reflection_vector(Vec3 towards_light, Vec3 normal) {
  return 2 * dot(normal, towards_light) * normal - towards_light;
}

double highlight(Highlight kind, Vec3 normal, Vec3 towards_light, Vec3 towards_viewer, double shininess) {
  if (dot(normal, towards_light) <= 0) return 0;
  if (kind == Highlight::HalfVector)
    return std::pow(clamped_dot(normal, half_vector(towards_light, towards_viewer)), shininess);
  const double cosine = dot(towards_viewer, reflection_vector(towards_light, normal));
  return cosine > 0 ? std::pow(cosine, shininess) : 0;
}

LitColor light_vertex(const LightModel& model, std::span<const Light> lights, const Material& material,
                      Vec4 vertex, Vec3 normal) {
  const Vec3 a_cm = material.ambient.xyz(), d_cm = material.diffuse.xyz(), s_cm = material.specular.xyz();
  if (model.highlight == Highlight::ReflectionVector)
    normal = unit(normal); // another length would be mirrored, too
  const auto term = [](bool wanted, Vec3 color) { return wanted ? color : Vec3{}; };

  Vec3 primary =
      term(model.terms.emission, material.emission.xyz()) + term(model.terms.ambient, a_cm * model.ambient);
  Vec3 secondary;
  for (const Light& light : lights) {
    const Vec3 l = direction_between(vertex, light.position);
    const double n_dot_l = clamped_dot(normal, l);
    const double specular =
        highlight(model.highlight, normal, l, towards_viewer(model, vertex), material.shininess);
    const double intensity = distance_attenuation(light, vertex) * spotlight(light, vertex);

    primary = primary + intensity * (term(model.terms.ambient, a_cm * light.ambient) +
                                     term(model.terms.diffuse, n_dot_l * (d_cm * light.diffuse)));
    Vec3& highlights = model.separate_specular ? secondary : primary;
    highlights = highlights + intensity * term(model.terms.specular, specular * (s_cm * light.specular));
  }
  return {{primary.x, primary.y, primary.z, material.diffuse.w}, secondary};
}

double twice_signed_area(std::span<const Vec3> window) {
  double area = 0;
  for (size_t i = 0; i < window.size(); i++) {
    const Vec3 &a = window[i], &b = window[(i + 1) % window.size()];
    area += a.x * b.y - b.x * a.y;
  }
  return area;
}

bool faces_back(double area, bool front_face_is_clockwise) {
  return (front_face_is_clockwise ? -area : area) <= 0;
}

// 2.14.3
// ---------------------------------------------------------------------------------------------------------------

Material track_color(Material material, TrackedColor parameters, Vec4 color) {
  switch (parameters) {
  case TrackedColor::Emission: material.emission = color; break;
  case TrackedColor::Ambient: material.ambient = color; break;
  case TrackedColor::Diffuse: material.diffuse = color; break;
  case TrackedColor::Specular: material.specular = color; break;
  case TrackedColor::AmbientAndDiffuse: material.ambient = material.diffuse = color; break;
  }
  return material;
}

// 2.14.6, 2.14.9, 3.9
// --------------------------------------------------------------------------------------------------

static double clamp01(double x) { return std::clamp(x, 0.0, 1.0); }

LitColor clamped(const LitColor& c) {
  return {{clamp01(c.primary.x), clamp01(c.primary.y), clamp01(c.primary.z), clamp01(c.primary.w)},
          {clamp01(c.secondary.x), clamp01(c.secondary.y), clamp01(c.secondary.z)}};
}

Vec4 color_sum(const LitColor& c) {
  return {clamp01(c.primary.x + c.secondary.x), clamp01(c.primary.y + c.secondary.y),
          clamp01(c.primary.z + c.secondary.z), clamp01(c.primary.w)};
}

uint8_t to_fixed_point(double component) { return uint8_t(std::lround(clamp01(component) * 255)); }

} // namespace softgl::spec
