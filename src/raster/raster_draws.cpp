#include "raster/raster_draws.h"

#include "vertex_program.h"

namespace softgl {

RasterDraw make_raster_draw(const DrawRecord& draw) {
  const FragmentKey& key = draw.fragment->key;
  RasterDraw d{};
  d.program = draw.fragment;
  d.raster = draw.raster;
  d.layout = draw.layout;
  int planes = kPlaneColor + 4;
  auto take = [&](bool wanted, int count) {
    if (!wanted) return int8_t(-1);
    planes += count;
    return int8_t(planes - count);
  };
  d.secondary_plane = take(key.secondary && d.layout.secondary >= 0, 3);
  d.fog_plane = take(key.fog_coordinate && d.layout.secondary >= 0, 1);
  for (int u = 0; u < kBlockTextureUnits; ++u) d.unit_plane[u] = take((key.texture_units >> u & 1) && d.layout.texcoord[u] >= 0, 4);
  d.plane_count = uint8_t(planes);
  // OSMesa 22.3.6 hands an unlit colour that no vertex sets straight to the fragments, without interpolating it (which
  // would disturb its last bits: 0.3 * 255 is a tie).
  const bool unlit = draw.vertex && !draw.vertex->lit && draw.call.source;
  auto constant = [&](AttributeSlot slot) { return unlit && !(draw.call.source->present >> slot & 1); };
  d.flat_color = key.flat || constant(kColor);
  d.flat_secondary = key.flat || constant(kSecondaryColor);
  const auto format = static_cast<ColorFormat>(key.color_format);
  d.small = format == ColorFormat::Rgba8 || format == ColorFormat::Rgb565;
  d.direct = draw.fragment->step_count == 0 && format == ColorFormat::Rgba8 && !key.stencil;
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) d.color_mask |= 0xffu << (8 * c);
  return d;
}

} // namespace softgl
