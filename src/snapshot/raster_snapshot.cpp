#include "snapshot/raster_snapshot.h"

#include <algorithm>

#include "context/context.h"
#include "context/shading.h"
#include "context/viewport_transform.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/drawn_box.h"
#include "snapshot/polygons.h"

namespace softgl {
namespace {

/// Sizes are clamped to GL_ALIASED_POINT_SIZE_RANGE and GL_ALIASED_LINE_WIDTH_RANGE; what is not a number
/// becomes 1.
float drawn_size(float size) { return size > 1.0f ? std::min(size, 255.0f) : 1.0f; }

/// The size of points that do not shrink with distance (3.3). The order decides where the minimum is above
/// the maximum: OSMesa's.
float clamped_size(const PointState& point) {
  return point.size < point.size_min   ? point.size_min
         : point.size > point.size_max ? point.size_max
                                       : point.size;
}

/// The pattern's rows count from the bottom of the window (GL 1.5, 3.5.2).
const uint64_t* make_stipple(const PolygonStippleState& stipple, const Surface& surface, Arena& arena) {
  auto* block = arena.allocate_array<uint64_t>(16);
  std::fill_n(block, 16, uint64_t(0));
  for (int y = 0; y < 32; ++y) {
    const uint32_t row = stipple.row[(surface.y_up ? y : surface.height - 1 - y) & 31];
    for (int x = 0; x < 32; ++x)
      block[y / 8 * 4 + x / 8] |= uint64_t(row >> (31 - x) & 1) << (8 * (y & 7) + (x & 7));
  }
  return block;
}

/// GL 1.5, 3.2.1 and 4.1.3.
void set_multisampling(const MultisampleState& m, RasterConstants& r) {
  r.per_sample = m.enabled && r.samples > 1;
  r.pixel_center = r.per_sample ? 0.0f : 0.5f;
  r.to_first_pixel = r.per_sample ? 0 : 255;
  r.edge_shift = r.per_sample ? 0 : 8;
  const unsigned all = (1u << kSamples) - 1;
  unsigned mask = all;
  if (r.per_sample) {
    r.alpha_to_coverage = m.alpha_to_coverage;
    r.alpha_to_one = m.alpha_to_one;
    // OSMesa 22.3.6: as many of the first samples as the value asks for.
    if (m.coverage) mask = (1u << int(m.coverage_value * float(kSamples))) - 1;
    if (m.coverage && m.coverage_invert) mask = ~mask & all;
  }
  r.sample_mask = uint8_t(mask);
}

} // namespace

const RasterConstants* make_raster_constants(const Context& context, Arena& arena) {
  const State& s = context.state;
  const Surface& surface = context.draw->surface;
  auto& r = *arena.make<RasterConstants>();
  const WindowBox box = drawn_box(s.scissor, surface);
  r.x0 = box.x0, r.y0 = box.y0;
  r.x1 = box.x1, r.y1 = box.y1;
  // Positive areas are counter-clockwise in GL's y-up sense where rows go down.
  const bool positive_is_front =
      counter_clockwise_is_front(s) != (SOFTGL_FAULT(faces_swapped) ? !surface.y_up : surface.y_up);
  // An origin above turns the rule for pixels on an edge round, too (OSMesa 22.3.6).
  r.top_edge_rule = surface.y_up != (s.clip_control.origin == GL_UPPER_LEFT);
  r.back = positive_is_front ? 0 : 1;
  r.cull = static_cast<uint8_t>((s.polygon.culls(!positive_is_front) ? 1 : 0) |
                                (s.polygon.culls(positive_is_front) ? 2 : 0));
  r.samples = surface.samples;
  set_multisampling(s.multisample, r);
  r.flat = s.lighting.shade_model == GL_FLAT && !SOFTGL_FAULT(flat_is_smooth);
  const bool before = polygons_before_raster(s); // geometry has colored and offset polygons
  r.two_sided = s.lighting.enabled && s.lighting.two_side &&
                (!before || lights_fragments(s.lighting, context.smooth_is_phong));
  // OSMesa 22.3.6 offsets by units * 2 / (2^bits - 1), twice the smallest step.
  r.offset_floats = surface.depth_format == DepthFormat::Z32F;
  r.offset_units =
      r.offset_floats
          ? s.polygon.offset_units
          : static_cast<float>(s.polygon.offset_units * (1.0 / largest_depth(surface.depth_format)) * 2);
  r.offset_factor = s.polygon.offset_factor;
  r.offset = !before && s.polygon.offset_fill && (r.offset_units != 0.0f || r.offset_factor != 0.0f);
  r.stipple = s.polygon.stipple ? make_stipple(s.polygon_stipple, surface, arena) : nullptr;
  r.point_sprite = s.point.sprite;
  r.sprite_units = s.point.sprite ? static_cast<uint8_t>(s.point.coord_replace) : 0;
  r.sprite_lower_left = (s.point.sprite_origin == GL_LOWER_LEFT) != surface.y_up;
  r.line_width = drawn_size(s.line.width);
  r.point_size = drawn_size(clamped_size(s.point));
  return &r;
}

} // namespace softgl
