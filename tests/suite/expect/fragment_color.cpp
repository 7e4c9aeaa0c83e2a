// The color of a fragment: texture, color sum and fog (3.8 to 3.10).
#include <stdexcept>

#include "expect/primitive.h"

namespace softgl::suite {
namespace {

double component(const Vec4& v, int i) { return i == 0 ? v.x : i == 1 ? v.y : i == 2 ? v.z : v.w; }

Interval fog_factor(const FogState& fog, Interval distance) {
  const auto at = [&](double c) {
    switch (fog.mode) {
    case GL_EXP: return std::exp(-fog.density * c);
    case GL_EXP2: return std::exp(-fog.density * fog.density * c * c);
    default: return (fog.end - c) / (fog.end - fog.start);
    }
  };
  const double near = at(distance.low), far = at(distance.high);
  return spec::clamped(spec::widened({std::min(near, far), std::max(near, far)}, 1e-4), 0, 1);
}

} // namespace

void Rasterizer::process_color(const State& state, const Fragment& f, Interval color[4]) const {
  for (int c = 0; c < 4; c++) {
    const double step = precision_.half_step(c == 3 && precision_.bits[3] < 2 ? 0 : c);
    // Each stage may round to the bits of the framebuffer.
    const auto stage = [&](Interval value) { return spec::clamped(spec::widened(value, step), 0, 1); };
    color[c] = stage(f.color.primary[c]);
    if (state.texture.on) {
      const double texel = component(state.texture.color, c);
      if (state.texture.environment == GL_MODULATE)
        color[c] = stage(color[c] * texel);
      else if (state.texture.environment == GL_REPLACE)
        color[c] = stage(texel);
      else
        throw std::logic_error("a texture environment that the machine does not know");
    }
    if (c < 3 && f.color.secondary[c].high > 0) color[c] = stage(color[c] + f.color.secondary[c]);
    if (c < 3 && state.fog.on) {
      const Interval factor = fog_factor(state.fog, f.fog_distance);
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
  }
}

} // namespace softgl::suite
