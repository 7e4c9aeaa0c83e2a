// submit(): the record of a draw or of a rectangle of pixels, with its snapshots.
#include "snapshot/submit.h"

#include "base/assert.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/check_call.h"
#include "snapshot/derived_state.h"
#include "snapshot/diagonal.h"
#include "snapshot/feedback.h"
#include "snapshot/flush.h"
#include "snapshot/fragment_snapshot.h"
#include "snapshot/raster_snapshot.h"
#include "snapshot/render_targets.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

/// Where a draw's fragments are counted while a query is active (GL 1.5, 4.1.7). The frame holds the counter
/// until they are.
uint64_t* active_counter(Context& c) {
  const std::shared_ptr<uint64_t>& samples = c.queries.samples;
  if (SOFTGL_FAULT(query_needs_buffer) && c.state.color_buffer.draw_buffer == GL_NONE) return nullptr;
  if (SOFTGL_FAULT(query_needs_colors) && !c.state.color_buffer.mask[0]) return nullptr;
  if (samples) [[unlikely]]
    c.frame.retain(samples, sizeof *samples);
  return samples.get();
}

} // namespace

bool first_provokes(const Context& c) {
  return c.state.lighting.shade_model == GL_FLAT &&
         c.state.lighting.provoking_vertex == GL_FIRST_VERTEX_CONVENTION;
}

void submit(Context& c, const DrawCall& call) {
  const bool has_position = call.source && call.source->present >> kPosition & 1;
  if (!has_position || call.primitive_count == 0 || call.vertex_count == 0) return;
  if (c.bindings.draw && !ready_to_draw(c)) return;
  if (c.draw->surface.width == 0) return;
  check_call(call);
  // The frame's arena is needed now: no run of live vertices may be open in it.
  SOFTGL_ASSERT(c.builder.compiling || !c.builder.base);
  if (c.state.render_mode.mode != GL_RENDER) {
    if (SOFTGL_FAULT(query_counts_hits) && c.queries.samples) ++*c.queries.samples;
    return feed_back(c, call);
  }
  update_snapshots(c, call);
  const SnapshotCache& cache = c.snapshots;
  uint64_t* const samples = active_counter(c);
  c.frame.append(c.frame.arena().make<DrawRecord>(
      call, cache.layout, cache.vertex, cache.raster, cache.fragment_of_draw, nullptr, samples, cache.smooth,
      diagonal_of_quadrilaterals(c, call, *cache.fragment_of_draw), cache.back_fragment, cache.back_smooth,
      first_provokes(c)));
  if (c.frame.over_budget()) flush_frame(c);
}

namespace {

/// One vertex with the raster position's attributes stands for all fragments of the rectangle.
void append_rectangle(Context& c, const FragmentProgram* program, const RasterConstants* raster,
                      const WindowBox& box, uint64_t* samples) {
  Arena& arena = c.frame.arena();
  const RasterPosition& p = c.state.raster_position;
  if (SOFTGL_FAULT(image_takes_current_color)) c.state.raster_position.color = c.state.current.slot[kColor];
  const int8_t no_source[5][2] = {};
  const ShadedLayout layout = make_layout(c, program->key, no_source, false);
  auto* slot = arena.allocate_array<ShadedVertices::Slot>(layout.slots);
  auto set = [&](int at, const Vec4& v) {
    if (at >= 0) slot[at] = {{v.x, v.y, v.z, v.w}};
  };
  // OSMesa's depth goes through the clip volume.
  const Surface& surface = c.draw->surface;
  const float y = surface.y_up ? p.window.y : float(surface.height) - p.window.y;
  set(0, {p.window.x, y, (p.window.z * 2.0f - 1.0f) * 0.5f + 0.5f, 1});
  for (int at : {layout.color, layout.back_color}) set(at, p.color);
  for (int at : {layout.secondary, layout.back_secondary}) set(at, Vec4(Vec3(p.secondary_color), p.distance));
  for (int u = 0; u < kMaxTextureUnits; ++u) set(layout.texcoord[u], p.texcoord[u]);
  const auto* rectangle = arena.make<PixelRectangle>(slot, box);
  c.frame.append(arena.make<DrawRecord>(DrawCall{}, layout, nullptr, raster, program, rectangle, samples));
  if (c.frame.over_budget()) flush_frame(c);
}

/// Of pixels that are stored, which are no fragments: what state does to coverage is not done to them.
const RasterConstants* make_constants_of_copy(Context& c, unsigned samples) {
  auto* raster = c.frame.arena().make<RasterConstants>(*make_raster_constants(c, c.frame.arena()));
  raster->sample_mask = uint8_t(samples);
  raster->alpha_to_coverage = raster->alpha_to_one = false;
  return raster;
}

} // namespace

void submit_pixels(Context& c, const PixelImage& image, const WindowBox& box) {
  append_rectangle(c, make_fragment_program(c, c.frame.arena(), &image),
                   make_raster_constants(c, c.frame.arena()), box,
                   SOFTGL_FAULT(query_without_images) ? nullptr : active_counter(c));
}

void submit_stencils(Context& c, const PixelImage& image, const WindowBox& box, uint32_t write_mask,
                     unsigned samples) {
  // These are no fragments (4.3.1), so no query counts them.
  append_rectangle(c, make_stencil_program(c, c.frame.arena(), image, write_mask),
                   make_constants_of_copy(c, samples), box, nullptr);
}

void submit_copy(Context& c, const PixelImage& image, const WindowBox& box, unsigned samples) {
  append_rectangle(c, make_copy_program(c, c.frame.arena(), image), make_constants_of_copy(c, samples), box,
                   nullptr);
}

} // namespace softgl
