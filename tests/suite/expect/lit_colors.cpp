// The equations of 2.14.1 for a vertex, and for a fragment (GL_WIN_phong_shading).
#include <stdexcept>

#include "expect/primitive.h"

namespace softgl::suite {
namespace {

bool same(const Vec4& a, const Vec4& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; }
bool same(const spec::Material& a, const spec::Material& b) {
  return same(a.ambient, b.ambient) && same(a.diffuse, b.diffuse) && same(a.specular, b.specular) &&
         same(a.emission, b.emission) && a.shininess == b.shininess;
}

} // namespace

ColorBounds lit_color(const LightingState& lighting, const spec::Material& material,
                      const spec::Vec3Interval& eye, const spec::Vec3Interval& normal) {
  std::vector<spec::LightBounds> lights;
  for (int i = 0; i < 8; i++)
    if (lighting.enabled[i]) lights.push_back(lighting.light[i]);
  const spec::LitBounds lit = light_vertex_bounds(lighting.model, lights, material, eye, normal);
  ColorBounds color;
  for (int i = 0; i < 4; i++) color.primary[i] = spec::clamped(lit.primary[i], 0, 1);
  for (int i = 0; i < 3; i++) color.secondary[i] = spec::clamped(lit.secondary[i], 0, 1);
  return color;
}

bool lights_fragments(const State& state) {
  return state.lighting.lighting && state.lighting.shade_model == GL_PHONG_WIN;
}

ColorBounds lit_fragment(const State& state, const std::vector<LitVertex>& vertices, const double* weights,
                         bool back, bool unit_normals) {
  const bool back_color = back && state.lighting.model.two_sided;
  spec::Vec3Interval eye, normal;
  for (size_t i = 0; i < vertices.size(); i++) {
    const LitVertex& v = vertices[i];
    // "an implementation may choose to ignore the effects of the changes in material properties"
    if (!same(v.material[back_color], vertices[0].material[back_color]))
      throw std::logic_error("a material that changes within a primitive whose fragments are lit");
    eye = eye + Interval(weights[i]) * v.eye, normal = normal + Interval(weights[i]) * v.normal;
  }
  if (unit_normals) normal = spec::unit(normal);
  return lit_color(state.lighting, vertices[0].material[back_color], eye, back_color ? -normal : normal);
}

} // namespace softgl::suite
