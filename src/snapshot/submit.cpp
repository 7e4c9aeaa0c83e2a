// submit(): snapshots of the state a draw needs, and the record of the draw. A snapshot block is used again
// as long as no dirty bit tells of a change: 10,000 small draws a frame must not be dominated by them.
#include <cstring>

#include "context/context.h"
#include "snapshot/feedback.h"
#include "snapshot/flush.h"
#include "snapshot/fragment_snapshot.h"
#include "snapshot/raster_snapshot.h"
#include "snapshot/submit.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

/// The few bits of the lighting group on which raster and fragment snapshots depend; materials and lights are
/// not among them.
uint32_t lighting_mode(const LightingState& l, bool for_fragments) {
  return uint32_t(l.enabled) | uint32_t(l.enabled && l.two_side) << 1 |
         uint32_t(l.enabled && l.color_control == GL_SEPARATE_SPECULAR_COLOR) << 2 |
         uint32_t(l.shade_model == GL_FLAT) << 3 | uint32_t(for_fragments) << 4;
}

bool draws_points(const DrawCall& call, const PolygonState& polygon) {
  if (polygon.seen_mode(false) == GL_POINT || polygon.seen_mode(true) == GL_POINT) return true;
  for (uint32_t i = 0; i < call.primitive_count; ++i)
    if (call.primitives[i].mode == GL_POINTS) return true;
  return false;
}

/// The state's program; where it lights fragments, with the lights and materials of the draw.
const FragmentProgram* program_of_draw(const SnapshotCache& cache, Arena& arena) {
  const FragmentProgram *program = cache.fragment, *last = cache.fragment_of_draw;
  if (!program->key.lit) return program;
  if (last && last->constants->lighting == cache.lighting) return last;
  auto* constants = arena.make<FragmentConstants>(*program->constants);
  constants->lighting = cache.lighting;
  auto* copy = arena.make<FragmentProgram>(*program);
  copy->constants = constants;
  return copy;
}

/// Brings the cache up to date with the state.
void take_snapshots(Context& c, const DrawCall& call) {
  SnapshotCache& cache = c.snapshots;
  Arena& arena = c.frame.arena();
  uint32_t dirty = c.dirty;
  const State& s = c.state;
  const bool lit = s.lighting.enabled, for_fragments = lights_fragments(s.lighting, c.smooth_is_phong);
  const uint32_t mode = lighting_mode(s.lighting, for_fragments);
  const bool mode_changed = mode != cache.lighting_mode;
  const bool points = draws_points(call, s.polygon);
  const uint32_t present = call.source->present;
  const float* color = &call.constant[kColor][0];
  const bool color_feeds = lit && s.lighting.color_material_enabled && !(present >> kColor & 1);
  if (present != cache.present || (color_feeds && std::memcmp(color, cache.color, sizeof cache.color) != 0))
    dirty |= kDirtyLighting;

  if (mode_changed || !cache.fragment || dirty & (kDirtyFragment | kDirtyTexture | kDirtyRaster))
    cache.fragment = make_fragment_program(c, arena), cache.fragment_of_draw = nullptr,
    dirty |= kDirtyFragment;
  if (mode_changed || !cache.raster || dirty & (kDirtyRaster | kDirtyViewport | kDirtyFragment))
    cache.raster = make_raster_constants(c, arena);
  cache.lighting_mode = mode;

  Matrix& modelview = c.matrices.modelview.top();
  settle_history(modelview);
  const uint32_t units = uint32_t(cache.fragment->key.texture_units);
  bool program = false;
  if (dirty &
      (kDirtyMatrices | kDirtyLighting | kDirtyTransform | kDirtyFragment | kDirtyTexture | kDirtyRaster)) {
    const bool eye_space = needs_eye_space(c, units);
    if (eye_space != cache.eye_space) dirty |= kDirtyMatrices | kDirtyLighting;
    cache.eye_space = eye_space;
    program = true;
  }
  if (!cache.transform || dirty & (kDirtyMatrices | kDirtyViewport | kDirtyTransform)) {
    cache.transform = make_transform(c, cache.eye_space, arena);
    cache.clip_planes = make_clip_planes(c, arena);
    program = true;
  }
  if (dirty & (kDirtyMatrices | kDirtyTransform | kDirtyTexture | kDirtyFragment))
    for (int u = 0; u < kMaxTextureUnits; ++u)
      cache.coordinates[u] = units >> u & 1 ? make_coordinates(c, u, arena) : nullptr;
  program |= points != cache.draws_points || mode_changed;
  int8_t source[5][2];
  std::memset(source, -1, sizeof source);
  if (program) {
    if (lit) find_material_sources(c, present, source);
    cache.layout = make_layout(c, cache.fragment->key, source, points);
    cache.draws_points = points;
  }

  const bool relight = mode_changed || dirty & kDirtyLighting || (!cache.eye_space && dirty & kDirtyMatrices);
  if (program) {
    if (!lit)
      cache.lighting = nullptr;
    else if (relight || !cache.lighting)
      cache.lighting = make_lighting(c, source, color, cache.eye_space, for_fragments, arena);
    std::memcpy(cache.color, color, sizeof cache.color);
    cache.present = present;
    cache.vertex = make_vertex_program(c, cache, arena);
  }
  cache.fragment_of_draw = program_of_draw(cache, arena);
  c.dirty &= kDirtyCurrent | kDirtyArrays;
}

} // namespace

void submit(Context& c, const DrawCall& call) {
  const bool has_position = call.source && call.source->present >> kPosition & 1;
  if (!has_position || call.primitive_count == 0 || call.vertex_count == 0 ||
      c.framebuffer.surface.width == 0)
    return;
  if (c.state.render_mode.mode != GL_RENDER) return feed_back(c, call);
  take_snapshots(c, call);
  const SnapshotCache& cache = c.snapshots;
  c.frame.append(c.frame.arena().make<DrawRecord>(call, cache.layout, cache.vertex, cache.raster,
                                                  cache.fragment_of_draw));
  if (c.frame.over_budget()) flush_frame(c);
}

namespace {

/// One vertex with the raster position's attributes stands for all fragments of the rectangle.
void append_rectangle(Context& c, const FragmentProgram* program, const WindowBox& box) {
  Arena& arena = c.frame.arena();
  const RasterPosition& p = c.state.raster_position;
  const int8_t no_source[5][2] = {};
  const ShadedLayout layout = make_layout(c, program->key, no_source, false);
  auto* slot = arena.allocate_array<ShadedVertices::Slot>(layout.slots);
  auto set = [&](int at, const Vec4& v) {
    if (at >= 0) slot[at] = {{v.x, v.y, v.z, v.w}};
  };
  // OSMesa's depth goes through the clip volume.
  set(0, {p.window.x, float(c.framebuffer.surface.height) - p.window.y,
          (p.window.z * 2.0f - 1.0f) * 0.5f + 0.5f, 1});
  for (int at : {layout.color, layout.back_color}) set(at, p.color);
  for (int at : {layout.secondary, layout.back_secondary}) set(at, Vec4(Vec3(p.secondary_color), p.distance));
  for (int u = 0; u < kMaxTextureUnits; ++u) set(layout.texcoord[u], p.texcoord[u]);
  const auto* rectangle = arena.make<PixelRectangle>(slot, box);
  c.frame.append(arena.make<DrawRecord>(DrawCall{}, layout, nullptr, make_raster_constants(c, arena), program,
                                        rectangle));
  if (c.frame.over_budget()) flush_frame(c);
}

} // namespace

void submit_pixels(Context& c, const PixelImage& image, const WindowBox& box) {
  append_rectangle(c, make_fragment_program(c, c.frame.arena(), &image), box);
}

void submit_stencil(Context& c, const PixelImage& image, uint8_t value, const WindowBox& box) {
  append_rectangle(c, make_stencil_program(c, c.frame.arena(), image, value), box);
}

} // namespace softgl
