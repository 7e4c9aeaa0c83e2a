// The color of a fragment: texture, color sum and fog (3.8 to 3.10).
#include <stdexcept>

#include "expect/fragment_operations.h"
#include "expect/primitive.h"

namespace softgl::suite {

Interval fog_factor(const FogState& fog, Interval distance) {
  const auto at = [&](double c) {
    switch (fog.mode) {
    case GL_EXP: return std::exp(-fog.density * c);
    case GL_EXP2: return std::exp(-fog.density * fog.density * c * c);
    default: return (fog.end - c) / (fog.end - fog.start);
    }
  };
  Interval factor = spec::hull(at(distance.low), at(distance.high));
  if (distance.contains(0)) factor = spec::hull(factor, at(0)); // the square has its least value there
  return spec::clamped(spec::widened(factor, 1e-4), 0, 1);
}

void Rasterizer::apply_textures(const State& state, const Fragment& f, Interval color[4]) const {
  Interval primary[4];
  std::copy(color, color + 4, primary);
  Pixel texels[kTextureUnits];
  const TextureObject* textures[kTextureUnits];
  for (int u = 0; u < kTextureUnits; u++)
    if ((textures[u] = state.texture.texture_of(u)))
      texels[u] = sampled(*textures[u], f.texture[size_t(u)], state.texture.units[u].environment.lod_bias);
  const double step[4] = {step_of(0), step_of(1), step_of(2), step_of(3)};
  for (int u = 0; u < kTextureUnits; u++) {
    if (!textures[u]) continue;
    const TextureObject& t = *textures[u];
    GLenum base = t.images[0][t.parameters.base_level].base;
    if (base == GL_DEPTH_COMPONENT) base = t.parameters.depth_mode;
    apply_environment(state.texture.units[u].environment, base, texels, u, primary, color, step);
  }
}

double Rasterizer::step_of(int c) const {
  return precision_.half_step(c == 3 && precision_.bits[3] < 2 ? 0 : c);
}

void Rasterizer::process_color(const State& state, const Fragment& f, Interval color[4]) const {
  for (int c = 0; c < 4; c++) color[c] = spec::clamped(spec::widened(f.color.primary[c], step_of(c)), 0, 1);
  apply_textures(state, f, color);
  for (int c = 0; c < 4; c++) {
    // Each stage may round to the bits of the framebuffer.
    const auto stage = [&](Interval value) { return spec::clamped(spec::widened(value, step_of(c)), 0, 1); };
    if (c < 3 && f.color.secondary[c].high > 0) color[c] = stage(color[c] + f.color.secondary[c]);
    if (c < 3 && state.fog.on) {
      const Interval factor = f.fog;
      const double fog = component(state.fog.color, c);
      const Interval near{factor.low * color[c].low + (1 - factor.low) * fog,
                          factor.high * color[c].low + (1 - factor.high) * fog};
      const Interval far{factor.low * color[c].high + (1 - factor.low) * fog,
                         factor.high * color[c].high + (1 - factor.high) * fog};
      const auto ordered = [](Interval i) {
        return Interval{std::min(i.low, i.high), std::max(i.low, i.high)};
      };
      color[c] = stage(spec::hull(ordered(near), ordered(far)));
    }
    if (c == 3 && (f.coverage.low != 1 || f.coverage.high != 1))
      color[c] = stage(color[c] * f.coverage); // 3.11
  }
}

} // namespace softgl::suite
