#include "shape.h"

namespace softgl::raycast {

Vec3 Material::shade(const Hit& hit, const Ray& ray, const Illumination& illumination) const {
  const Vec3 normal = hit.from_behind && illumination.model.two_sided ? -hit.normal : hit.normal;
  if (illumination.equation == Equation::OpenGL) return shade_opengl(hit.point, normal, illumination);
  return shade_textbook(hit.point, normal, -ray.direction, illumination);
}

Vec3 Material::shade_textbook(Vec3 point, Vec3 n, Vec3 v, const Illumination& illumination) const {
  Vec3 L = kAmbient * illumination.model.ambient;
  for (const spec::Light& light : illumination.lights) {
    const Vec3 s = spec::direction_between({point.x, point.y, point.z, 1}, light.position);
    const double n_dot_s = dot(n, s);
    if (n_dot_s <= 0 && illumination.tests_light_behind) continue; // the light is behind the surface
    L = L + n_dot_s * (kDiffuse * light.diffuse);
    const Vec3 r = 2 * n_dot_s * n - s;
    const double v_dot_r = dot(v, r);
    if (v_dot_r > 0) L = L + std::pow(v_dot_r, phongExponent) * (kSpecular * light.diffuse);
  }
  return L;
}

Vec3 Material::shade_opengl(Vec3 point, Vec3 normal, const Illumination& illumination) const {
  const auto opaque = [](Vec3 c) { return Vec4{c.x, c.y, c.z, 1}; };
  const spec::Material material{opaque(kAmbient), opaque(kDiffuse), opaque(kSpecular), opaque(kEmission),
                                phongExponent};
  const spec::LitColor lit =
      spec::light_vertex(illumination.model, illumination.lights, material, opaque(point), normal);
  return lit.primary.xyz() + lit.secondary;
}

} // namespace softgl::raycast
