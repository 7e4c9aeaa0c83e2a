#include "texture/pixel_transfer.h"

#include <algorithm>
#include <cmath>

#include "base/unit_range.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

constexpr int map_number(GLenum map) { return int(map - GL_PIXEL_MAP_I_TO_I); }

/// The map's value for a color.
float mapped(const PixelMaps& maps, int map, float v) {
  const int last = maps.size[map] - 1;
  if (SOFTGL_FAULT(map_truncates)) return maps.value[map][int(unit_range(v) * float(last))];
  return maps.value[map][std::clamp(int(std::lrint(unit_range(v) * float(last))), 0, last)];
}

/// The map's value for an index; sizes are powers of two.
float looked_up(const PixelMaps& maps, GLenum map, uint32_t index) {
  const int i = map_number(map);
  return maps.value[i][index & uint32_t(maps.size[i] - 1)];
}

} // namespace

const PixelTransfer& PixelTransfer::none() {
  static const PixelModeState mode;
  static const PixelMaps maps;
  static const PixelTransfer transfer(mode, maps);
  return transfer;
}

bool PixelTransfer::changes_color() const {
  return mode.scale != Vec4(1.0f) || mode.bias != Vec4(0.0f) || mode.map_color;
}

void PixelTransfer::color(float (*rgba)[4], int count) const {
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k) {
      float& v = rgba[i][k];
      v = v * (SOFTGL_FAULT(color_scale_ignored) ? 1.0f : mode.scale[k]) +
          (SOFTGL_FAULT(color_bias_ignored) ? 0.0f : mode.bias[k]);
      if (mode.map_color && !SOFTGL_FAULT(color_map_ignored))
        v = mapped(maps, map_number(GL_PIXEL_MAP_R_TO_R) + k, v);
    }
}

void PixelTransfer::clamped_color(float (*rgba)[4], int count) const {
  color(rgba, count);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < 4; ++k) rgba[i][k] = unit_range(rgba[i][k]);
}

bool PixelTransfer::changes_depth() const { return mode.depth_scale != 1.0f || mode.depth_bias != 0.0f; }

float PixelTransfer::depth(float value) const {
  depths(&value, 1);
  return value;
}

void PixelTransfer::depths(float* value, size_t count) const {
  const float bias = SOFTGL_FAULT(depth_bias_ignored) ? 0.0f : mode.depth_bias;
  if (changes_depth())
    for (size_t i = 0; i < count; ++i) value[i] = value[i] * mode.depth_scale + bias;
  for (size_t i = 0; i < count; ++i) value[i] = unit_range(value[i]);
}

uint32_t PixelTransfer::index(uint32_t v) const {
  if (SOFTGL_FAULT(index_shift_turned))
    return (mode.index_shift > 0 ? v >> mode.index_shift : v << -mode.index_shift) +
           uint32_t(mode.index_offset);
  if (mode.index_shift > 0) v = mode.index_shift < 32 ? v << mode.index_shift : 0;
  if (mode.index_shift < 0) v = mode.index_shift > -32 ? v >> -mode.index_shift : 0;
  return SOFTGL_FAULT(index_offset_ignored) ? v : v + uint32_t(mode.index_offset);
}

uint32_t PixelTransfer::stencil(uint32_t value) const {
  const uint32_t v = index(value) & 0xff;
  if (!mode.map_stencil) return v;
  const float f = looked_up(maps, GL_PIXEL_MAP_S_TO_S, v);
  return f > 0 && f < 4294967296.0f ? uint32_t(f) & 0xff : 0;
}

void PixelTransfer::index_to_color(uint32_t value, float rgba[4]) const {
  const uint32_t i = index(value);
  for (GLenum k = 0; k < 4; ++k) rgba[k] = looked_up(maps, GL_PIXEL_MAP_I_TO_R + k, i);
}

} // namespace softgl
