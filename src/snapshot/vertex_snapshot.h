// From State to the constants of a vertex program.
#pragma once

#include "base/arena.h"
#include "context/snapshot_cache.h"
#include "draw/draw_call.h"

namespace softgl {

struct Context;
struct FragmentKey;

/// True where OSMesa lights in eye space and not in object space; it decides last bits only. The modelview
/// must be settled.
bool needs_eye_space(const Context& context, uint32_t texture_units);

const TransformConstants* make_transform(Context& context, bool eye_space, Arena& arena);
/// Null when no clip plane is enabled.
const ClipPlaneConstants* make_clip_planes(Context& context, Arena& arena);
const PolygonConstants* make_polygon_constants(const Context& context, Arena& arena);
/// Null when the unit's coordinates are passed through.
const CoordinateConstants* make_coordinates(const Context& context, int unit, Arena& arena);

/// Where each material parameter comes from: the slot of a stream, or -1 (GL 1.5, 2.14.2, 2.14.3).
void find_material_sources(const Context& context, uint32_t present, int8_t source[5][2]);
/// `color` is the draw's constant color, for color material.
const LightingConstants* make_lighting(const Context& context, const int8_t source[5][2],
                                       const float color[4], bool eye_space, bool for_fragments,
                                       Arena& arena);

/// The slots that fragments of the key need; `source` is what find_material_sources() said, `points`: points
/// are drawn.
ShadedLayout make_layout(const Context& context, const FragmentKey& key, const int8_t source[5][2],
                         bool points);
/// Layout and vertex program of a draw that the frame does not get: for fragments of `key`, which are not
/// lit; without sizes of points. Shares nothing with the context's cache.
struct OwnSnapshot {
  ShadedLayout layout;
  VertexProgram program;
};
OwnSnapshot make_own_snapshot(Context& context, const FragmentKey& key, uint32_t present,
                              const float color[4], Arena& arena);

/// Of the cache's snapshots, layout and fragment key.
const VertexProgram* make_vertex_program(const Context& context, const SnapshotCache& cache, Arena& arena);

} // namespace softgl
