#include "snapshot/derived_state.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <utility>

#include "base/assert.h"
#include "base/bits.h"
#include "base/fast_paths.h"
#include "context/context.h"
#include "snapshot/fragment_snapshot.h"
#include "snapshot/raster_snapshot.h"
#include "snapshot/snapshot_difference.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

// Inputs beside those of State and objects (DirtyBit): values of the draw call, and what earlier rows make.
constexpr uint64_t derived_bit(int i) { return uint64_t(1) << (32 + i); }
constexpr uint64_t kPresentStreams = derived_bit(0);
constexpr uint64_t kConstantColor = derived_bit(1);
constexpr uint64_t kDrawnPoints = derived_bit(2);
constexpr uint64_t kStateFragmentProgram = derived_bit(3);
constexpr uint64_t kFragmentInputs = derived_bit(4);
constexpr uint64_t kLightingSpace = derived_bit(5);
constexpr uint64_t kMaterialSources = derived_bit(6);
constexpr uint64_t kTransformConstants = derived_bit(7);
constexpr uint64_t kClipPlanes = derived_bit(8);
constexpr uint64_t kCoordinates = derived_bit(9);
constexpr uint64_t kShadedLayout = derived_bit(10);
constexpr uint64_t kLightingConstants = derived_bit(11);
constexpr uint64_t kDrawFragmentProgram = derived_bit(12);
constexpr uint64_t kBackProgram = derived_bit(13);
constexpr uint64_t kDepthLimits = derived_bit(14);
constexpr uint64_t kNobodysInput = 0;

constexpr uint64_t kDirtySnapshots = kDirtyAll & ~(kDirtyCurrent | kDirtyArrays);

/// Sets a value of the cache; true if it is another one than before.
template <class T> bool set(T& member, const T& value) {
  static_assert(std::has_unique_object_representations_v<T>);
  const bool differs = std::memcmp(&member, &value, sizeof(T)) != 0;
  std::memcpy(&member, &value, sizeof(T));
  return differs;
}

/// The same of a snapshot. A new one is another one even where it lies at the old one's address, since a
/// frame uses the memory of the frame before.
template <class T> bool set(const T*& member, const T* value) {
  return std::exchange(member, value) || value;
}

/// What a maker knows: rows before its own are up to date in the cache.
struct Making {
  Context& context;
  uint64_t changed; // inputs
  Arena& arena;
  const State& state;
  bool lights_fragments() const { return softgl::lights_fragments(state.lighting, context.smooth_is_phong); }
};

// Makers: they tell whether the result is another one than before.

bool make_state_fragment_program(const Making& m, SnapshotCache& cache) {
  return set(cache.fragment, make_fragment_program(m.context, m.arena));
}

bool make_fragment_inputs(const Making&, SnapshotCache& cache) {
  const FragmentKey& key = cache.fragment->key;
  return set(cache.fragment_inputs, uint32_t(key.lit | key.secondary << 1 | uint64_t(key.fog_mode != 0) << 2 |
                                             uint64_t(key.texture_units) << 3));
}

bool make_raster(const Making& m, SnapshotCache& cache) {
  return set(cache.raster, make_raster_constants(m.context, m.arena));
}

/// Object space is another one with every modelview.
bool make_lighting_space(const Making& m, SnapshotCache& cache) {
  const bool eye_space = needs_eye_space(m.context, uint32_t(cache.fragment->key.texture_units));
  return set(cache.eye_space, eye_space) || (!eye_space && m.changed & kDirtyModelview);
}

bool make_material_sources(const Making& m, SnapshotCache& cache) {
  int8_t source[5][2];
  std::memset(source, -1, sizeof source);
  if (m.state.lighting.enabled) find_material_sources(m.context, cache.present, source);
  return set(cache.material_source, source);
}

bool make_transform_constants(const Making& m, SnapshotCache& cache) {
  return set(cache.transform, make_transform(m.context, cache.eye_space, m.arena));
}

bool make_clip_plane_constants(const Making& m, SnapshotCache& cache) {
  return set(cache.clip_planes, make_clip_planes(m.context, m.arena));
}

bool make_all_coordinates(const Making& m, SnapshotCache& cache) {
  const uint64_t units = cache.fragment->key.texture_units;
  bool differs = false;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    differs |= set(cache.coordinates[u], units >> u & 1 ? make_coordinates(m.context, u, m.arena) : nullptr);
  return differs;
}

bool make_shaded_layout(const Making& m, SnapshotCache& cache) {
  return set(cache.layout,
             make_layout(m.context, cache.fragment->key, cache.material_source, cache.draws_points));
}

bool make_lighting_constants(const Making& m, SnapshotCache& cache) {
  return set(cache.lighting, m.state.lighting.enabled
                                 ? make_lighting(m.context, cache.material_source, cache.color,
                                                 cache.eye_space, m.lights_fragments(), m.arena)
                                 : nullptr);
}

bool make_vertex(const Making& m, SnapshotCache& cache) {
  return set(cache.vertex, make_vertex_program(m.context, cache, m.arena));
}

/// The state's program; where it lights fragments, with the lights and materials of the draw.
bool make_draw_fragment_program(const Making& m, SnapshotCache& cache) {
  const FragmentProgram& program = *cache.fragment;
  if (!program.key.lit) return set(cache.fragment_of_draw, cache.fragment);
  auto* constants = m.arena.make<FragmentConstants>(*program.constants);
  constants->lighting = cache.lighting;
  auto* copy = m.arena.make<FragmentProgram>(program);
  copy->constants = constants;
  return set(cache.fragment_of_draw, copy);
}

bool make_back(const Making& m, SnapshotCache& cache) {
  return set(cache.back_fragment, make_back_program(m.context, *cache.fragment_of_draw, m.arena));
}

bool make_back_smooth(const Making& m, SnapshotCache& cache) {
  const FragmentProgram* back = cache.back_fragment;
  return set(cache.back_smooth, back ? make_smooth_programs(m.context, *back, m.arena) : nullptr);
}

bool make_smooth(const Making& m, SnapshotCache& cache) {
  return set(cache.smooth, make_smooth_programs(m.context, *cache.fragment_of_draw, m.arena));
}

struct DerivedRow {
  const char* name;
  uint64_t inputs; // DirtyBits and DerivedBits: a change of one of them makes the row anew
  uint64_t output; // what later rows name as their input
  bool (*make)(const Making&, SnapshotCache&);
  /// The first member in which the row's results differ; empty if there is none.
  std::string (*difference)(const SnapshotCache&, const SnapshotCache&);
};

/// The difference of a member of the cache.
template <auto kMember> std::string difference_of(const SnapshotCache& a, const SnapshotCache& b) {
  return snapshot_difference(a.*kMember, b.*kMember);
}

constexpr DerivedRow kDerivedRows[] = {
    {"fragment program of the state",
     kDirtyFramebuffer | kDirtyLighting | kDirtyFog | kDirtyColorBuffer | kDirtyDepth | kDirtyStencil |
         kDirtyTexture | kDirtyTextureObjects | kDepthLimits,
     kStateFragmentProgram, make_state_fragment_program, difference_of<&SnapshotCache::fragment>},
    {"inputs of fragments", kStateFragmentProgram, kFragmentInputs, make_fragment_inputs,
     difference_of<&SnapshotCache::fragment_inputs>},
    {"raster constants",
     kDirtyFramebuffer | kDirtyLighting | kDirtyPoint | kDirtyLine | kDirtyPolygon | kDirtyPolygonStipple |
         kDirtyScissor | kDirtyMultisample,
     kNobodysInput, make_raster, difference_of<&SnapshotCache::raster>},
    {"space of lighting",
     kDirtyModelview | kDirtyLighting | kDirtyLights | kDirtyPoint | kDirtyTextureGeneration |
         kFragmentInputs,
     kLightingSpace, make_lighting_space, difference_of<&SnapshotCache::eye_space>},
    {"sources of the material", kPresentStreams | kDirtyLighting | kDirtyMaterial, kMaterialSources,
     make_material_sources, difference_of<&SnapshotCache::material_source>},
    {"transform constants",
     kDirtyModelview | kDirtyProjection | kDirtyTransform | kDirtyViewport | kDirtyFramebuffer |
         kLightingSpace,
     kTransformConstants, make_transform_constants, difference_of<&SnapshotCache::transform>},
    {"clip planes", kDirtyProjection | kDirtyTransform, kClipPlanes, make_clip_plane_constants,
     difference_of<&SnapshotCache::clip_planes>},
    {"texture coordinates", kDirtyTextureMatrices | kDirtyTextureGeneration | kFragmentInputs, kCoordinates,
     make_all_coordinates, difference_of<&SnapshotCache::coordinates>},
    {"layout of shaded vertices",
     kDirtyLighting | kDirtyLights | kDirtyPoint | kDrawnPoints | kMaterialSources | kFragmentInputs,
     kShadedLayout, make_shaded_layout, difference_of<&SnapshotCache::layout>},
    {"lighting constants",
     kDirtyLighting | kDirtyLights | kDirtyMaterial | kConstantColor | kMaterialSources | kLightingSpace,
     kLightingConstants, make_lighting_constants, difference_of<&SnapshotCache::lighting>},
    {"vertex program",
     kDirtyFramebuffer | kDirtyLighting | kDirtyTransform | kDirtyFog | kDirtyPoint | kDirtyLine |
         kDirtyPolygon | kFragmentInputs | kLightingSpace | kTransformConstants | kClipPlanes | kCoordinates |
         kShadedLayout | kLightingConstants,
     kNobodysInput, make_vertex, difference_of<&SnapshotCache::vertex>},
    {"fragment program of the draw", kStateFragmentProgram | kLightingConstants, kDrawFragmentProgram,
     make_draw_fragment_program, difference_of<&SnapshotCache::fragment_of_draw>},
    {"programs of antialiased primitives",
     kDirtyFramebuffer | kDirtyMultisample | kDirtyPoint | kDirtyLine | kDirtyPolygon | kDrawFragmentProgram,
     kNobodysInput, make_smooth, difference_of<&SnapshotCache::smooth>},
    {"program of back-facing polygons", kDirtyFramebuffer | kDirtyStencil | kDrawFragmentProgram,
     kBackProgram, make_back, difference_of<&SnapshotCache::back_fragment>},
    {"programs of antialiased back-facing polygons",
     kDirtyFramebuffer | kDirtyMultisample | kDirtyPoint | kDirtyLine | kDirtyPolygon | kBackProgram,
     kNobodysInput, make_back_smooth, difference_of<&SnapshotCache::back_smooth>},
};

bool draws_points(const DrawCall& call, const PolygonState& polygon) {
  if (polygon.seen_mode(false) == GL_POINT || polygon.seen_mode(true) == GL_POINT) return true;
  for (uint32_t i = 0; i < call.primitive_count; ++i)
    if (call.primitives[i].mode == GL_POINTS) return true;
  return false;
}

/// Puts the values of the draw call that are inputs into the cache. All inputs that have changed.
uint64_t find_changes(Context& c, const DrawCall& call, SnapshotCache& cache) {
  const State& s = c.state;
  settle_history(c.matrices.modelview.top());
  uint64_t changed = c.dirty;
  if (set(cache.present, call.source->present)) changed |= kPresentStreams;
  const DepthLimits limits = depth_limits(c);
  if (set(cache.least_depth, limits.least)) changed |= kDepthLimits;
  if (set(cache.greatest_depth, limits.greatest)) changed |= kDepthLimits;
  // Only attenuated points have a size in their vertices.
  if (set(cache.draws_points, s.point.attenuated() && draws_points(call, s.polygon))) changed |= kDrawnPoints;
  const float* color = &call.constant[kColor][0];
  if (s.lighting.enabled && s.lighting.color_material_enabled &&
      !same_bits(color, cache.color, sizeof cache.color)) {
    std::memcpy(cache.color, color, sizeof cache.color);
    changed |= kConstantColor;
  }
  return changed;
}

} // namespace

void update_snapshots(Context& c, const DrawCall& call) {
#if SOFTGL_CHECKS
  if (const StaleSnapshot stale = find_stale_snapshot(c, call); stale.name) {
    std::fprintf(stderr, "softgl: a dirty bit is missing: \"%s\" is out of date in %s\n", stale.name,
                 stale.member.c_str());
    std::abort();
  }
#endif
  if (!takes(FastPath::KeptSnapshots)) c.dirty |= kDirtySnapshots;
  SnapshotCache& cache = c.snapshots;
  Making making{c, find_changes(c, call, cache), c.frame.arena(), c.state};
  if (!(making.changed >> 32) && !(making.changed & kDirtySnapshots)) return;
  c.dirty |= kDirtySnapshots; // if memory ends on the way
  for (const DerivedRow& row : kDerivedRows)
    if (row.inputs & making.changed && row.make(making, cache)) making.changed |= row.output;
  c.dirty &= ~kDirtySnapshots;
}

StaleSnapshot find_stale_snapshot(Context& c, const DrawCall& call) {
  const Frame::Mark mark = c.frame.mark();
  SnapshotCache cache = c.snapshots;
  Making making{c, find_changes(c, call, cache), c.frame.arena(), c.state};
  StaleSnapshot stale;
  for (const DerivedRow& row : kDerivedRows) {
    SnapshotCache fresh = cache;
    const bool differs = row.make(making, fresh);
    if (row.inputs & making.changed) {
      cache = fresh;
      if (differs) making.changed |= row.output;
    } else if (std::string member = row.difference(cache, fresh); !member.empty()) {
      stale = {row.name, std::move(member)};
      break;
    }
  }
  c.frame.rewind(mark);
  return stale;
}

} // namespace softgl
