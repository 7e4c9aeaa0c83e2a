#include "raster/raster_draws.h"

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "base/fast_paths.h"
#include "shaders/vertex/vertex_program.h"

namespace softgl {

namespace {

/// True when every vertex's alpha is known to be 1 without looking: lit with a material of constant diffuse
/// alpha.
bool is_opaque(const VertexProgram& vertex) {
  if (!vertex.lit) return false;
  const LightingConstants& k = *vertex.lighting;
  for (int face = 0; face <= int(k.two_sided); ++face)
    if (k.material_source[kMaterialDiffuse][face] >= 0 || !(k.material[kMaterialDiffuse][face][3] >= 1.0f))
      return false;
  return true;
}

/// What make_raster_draw() asks of vertex programs.
bool come_to_the_same(const VertexProgram& a, const VertexProgram& b) {
  if (a.lit != b.lit || is_opaque(a) != is_opaque(b)) return false;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (!a.coordinates[u] != !b.coordinates[u]) return false;
  return true;
}

} // namespace

bool have_same_raster_draw(const DrawRecord& a, const DrawRecord& b) {
  static_assert(std::has_unique_object_representations_v<ShadedLayout>);
  return a.fragment == b.fragment && a.raster == b.raster && a.samples == b.samples && a.smooth == b.smooth &&
         a.back_fragment == b.back_fragment && a.back_smooth == b.back_smooth && a.vertex && b.vertex &&
         a.call.source && b.call.source && a.call.source->present == b.call.source->present &&
         std::memcmp(&a.layout, &b.layout, sizeof a.layout) == 0 &&
         (a.vertex == b.vertex || come_to_the_same(*a.vertex, *b.vertex));
}

RasterDraw make_raster_draw(const DrawRecord& draw) {
  const FragmentKey& key = draw.fragment->key;
  RasterDraw d{};
  d.program = draw.fragment;
  d.raster = draw.raster;
  d.layout = draw.layout;
  // OSMesa 22.3.6 hands an unlit color that no vertex sets straight to the fragments, without interpolating
  // it (which would disturb its last bits: 0.3 * 255 is a tie). So it does with texture coordinates that
  // nothing changes on the way, unless GL_POINT_SPRITE is on.
  const bool unlit = draw.vertex && !draw.vertex->lit && !key.lit && draw.call.source;
  auto flat = [&](AttributeSlot slot) {
    return key.flat || (unlit && !(draw.call.source->present >> slot & 1));
  };
  int planes = kPlaneColor;
  auto take = [&](int count) { return planes += count, static_cast<int8_t>(planes - count); };
  auto vary = [&](size_t lanes, int8_t slot, int8_t back_slot, int8_t first, int8_t components,
                  bool is_flat) {
    if (slot < 0) return;
    if (!draw.raster->two_sided || back_slot < 0) back_slot = slot;
    d.varying[d.varying_count++] = {
        static_cast<uint32_t>(lanes), slot, back_slot, first, components, take(components), is_flat};
  };
  const ShadedLayout& l = d.layout;
  vary(offsetof(FragmentBlock, color), l.color, l.back_color, 0, 4, flat(kColor));
  if (key.secondary)
    vary(offsetof(FragmentBlock, secondary), l.secondary, l.back_secondary, 0, 3, flat(kSecondaryColor));
  if (key.fog_mode) vary(offsetof(FragmentBlock, fog), l.secondary, -1, 3, 1, false);
  if (key.lit) {
    constexpr size_t kLighting = offsetof(FragmentBlock, lighting);
    vary(kLighting + offsetof(LightingBlock, normal), l.normal, -1, 0, 3, false);
    vary(kLighting + offsetof(LightingBlock, eye), l.eye, -1, 0, 3, false);
    vary(offsetof(FragmentBlock, color), l.tracked, -1, 0, 4, false);
    for (int i = 0; i < kMaterialSlots; ++i)
      vary(offsetof(FragmentBlock, material) + size_t(i) * sizeof(FragmentBlock::material[0]), l.material[i],
           -1, 0, i / 2 == kMaterialShininess ? 1 : 4, false);
    d.facing = draw.raster->two_sided;
  }
  const bool constant = draw.vertex && !key.lit && draw.call.source && !draw.raster->point_sprite;
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    d.unit_plane[u] = key.texture_units >> u & 1 && l.texcoord[u] >= 0 ? take(4) : int8_t(-1);
    if (constant && !(draw.call.source->present >> (kTexCoord0 + u) & 1) && !draw.vertex->coordinates[u])
      d.flat_units |= uint8_t(1u << u);
  }
  switch (draw.fragment->coverage) {
  case Coverage::None: break;
  case Coverage::Line: // in the slot behind all others
    vary(offsetof(FragmentBlock, coverage), static_cast<int8_t>(l.slots), -1, 0, 4, false);
    break;
  case Coverage::Point: d.coverage_numbers = 3; break;
  case Coverage::Polygon: d.coverage_numbers = 9; break;
  }
  d.plane_count = static_cast<uint8_t>(planes + d.coverage_numbers);
  const auto format = static_cast<ColorFormat>(key.color_format);
  d.opaque = draw.fragment->coverage == Coverage::None && draw.vertex && is_opaque(*draw.vertex) &&
             takes(FastPath::OpaqueColors);
  // Depths that are floats are tested by strips alone, and so are samples but those of small triangles.
  const bool depth_floats = static_cast<DepthFormat>(key.depth_format) == DepthFormat::Z32F,
             samples = draw.raster->samples > 1, strips = depth_floats || samples;
  const bool words = (format == ColorFormat::Rgba8 || (format == ColorFormat::Rgb565 && !samples)) &&
                     !key.encoded && !d.program->writes_depth && !d.raster->stipple && !depth_floats;
  const bool packed = words && !samples;
  const bool alpha_covers = d.raster->per_sample && (d.raster->alpha_to_coverage || d.raster->alpha_to_one);
  d.small = words && !alpha_covers && !d.program->reads_quads && is_enabled(FastPath::Small);
  d.drops_uncovered = !d.small && takes(FastPath::UncoveredTriangles);
  d.quads = packed && d.program->reads_quads && takes(FastPath::Quads);
  d.direct = draw.fragment->step_count == 0 && !d.raster->stipple && format == ColorFormat::Rgba8 &&
             !key.encoded && !strips && !draw.fragment->bounds_depth &&
             (!draw.samples || key.color_mask == 0) && takes(FastPath::Direct);
  d.samples = draw.samples;
  for (int c = 0; c < 4; ++c)
    if (key.color_mask >> c & 1) d.color_mask |= 0xffu << (8 * c);
  d.replaces_words = format == ColorFormat::Rgba8 && !key.stencil && !key.blend && !key.logic_op &&
                     d.color_mask == ~uint32_t{0} && !d.samples && !draw.fragment->bounds_depth;
  // Stencil values that stay may be tested later.
  const auto keep = static_cast<uint64_t>(StencilOperation::Keep);
  const bool stencil_changes =
      key.stencil && (key.stencil_fail != keep || key.stencil_depth_fail != keep || key.stencil_pass != keep);
  // With NotEqual a fragment may fail now and pass when those before it, of the same batch, are drawn.
  d.early_depth = !stencil_changes && static_cast<Compare>(key.depth_function) != Compare::NotEqual &&
                  !depth_floats && !draw.fragment->writes_depth && takes(FastPath::EarlyDepth);
  d.lasting_depth = d.early_depth && !draw.fragment->bounds_depth && !draw.fragment->writes_stencil &&
                    takes(FastPath::FinalDepth);
  // A fragment that may die later must not write now.
  const bool drops = draw.fragment->drops() || (draw.raster->per_sample && draw.raster->alpha_to_coverage);
  d.final_depth = d.lasting_depth && !(key.depth_write && drops);
  d.whole_blocks = takes(FastPath::WholeBlocks);
  return d;
}

} // namespace softgl
