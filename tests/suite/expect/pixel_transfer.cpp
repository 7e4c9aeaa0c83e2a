// Pixel transfer (3.6.5).
#include <cmath>
#include <stdexcept>

#include "expect/pixel_state.h"

namespace softgl::suite {
namespace {

const std::vector<double>& map_of(const PixelTransferState& state, GLenum name) {
  static const std::vector<double> initial = {0};
  const auto found = state.maps.find(name);
  return found == state.maps.end() ? initial : found->second;
}

// A color through its map: "each component is multiplied by the size less one, rounded to the nearest
// integer".
Interval mapped_color(const std::vector<double>& map, Interval value) {
  const double last = double(map.size() - 1);
  Interval result;
  // Both neighbours of what lies in the middle are right.
  for (long i = std::lround(value.low * last - 1e-3), first = i; i <= std::lround(value.high * last + 1e-3);
       i++)
    result = i == first ? Interval(map[size_t(i)]) : spec::hull(result, map[size_t(i)]);
  return result;
}

double shifted(const PixelTransferState& state, double index) {
  return std::floor(std::ldexp(index, state.index_shift)) + state.index_offset;
}

double looked_up(const std::vector<double>& map, double index) {
  return map[size_t(int64_t(index) & int64_t(map.size() - 1))];
}

} // namespace

bool PixelTransferState::is_default() const {
  for (int i = 0; i < 4; i++)
    if (scale[i] != 1 || bias[i] != 0) return false;
  return !map_color && !map_stencil && index_shift == 0 && index_offset == 0 && depth_scale == 1 &&
         depth_bias == 0;
}

void transfer(const PixelTransferState& state, PixelImage& image, bool to_colors) {
  for (Pixel& p : image.pixels) {
    if (image.kind == PixelKind::Depth) {
      p.c[0] = spec::clamped(p.c[0] * state.depth_scale + state.depth_bias, 0, 1);
      continue;
    }
    if (image.kind == PixelKind::Color) {
      for (int i = 0; i < 4; i++) {
        if (state.scale[i] != 1) p.c[i] = p.c[i] * state.scale[i];
        if (state.bias[i] != 0) p.c[i] = p.c[i] + state.bias[i];
        if (state.map_color)
          p.c[i] = mapped_color(map_of(state, GLenum(GL_PIXEL_MAP_R_TO_R + i)), spec::clamped(p.c[i], 0, 1));
      }
      continue;
    }
    if (p.c[0].low != p.c[0].high) throw std::logic_error("an index that is not known");
    double index = shifted(state, p.c[0].low);
    if (image.kind == PixelKind::Stencil) {
      p.c[0] = state.map_stencil ? looked_up(map_of(state, GL_PIXEL_MAP_S_TO_S), index) : index;
      continue;
    }
    if (!to_colors) throw std::logic_error("color indexes that stay indexes");
    for (int i = 0; i < 4; i++) p.c[i] = looked_up(map_of(state, GLenum(GL_PIXEL_MAP_I_TO_R + i)), index);
  }
  if (image.kind == PixelKind::Index) image.kind = PixelKind::Color;
}

} // namespace softgl::suite
