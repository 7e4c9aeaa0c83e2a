// Primitive assembly (GL 1.5, 2.6.1): vertices become triangles, lines and points in the corner order that
// OSMesa hands to set-up, because the order decides last bits. Where GL_QUADS are cut, the draw says.
#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <tuple>

#include "base/assert.h"
#include "geometry/clipping.h"
#include "geometry/geometry.h"
#include "geometry/line_stipple.h"
#include "geometry/polygon_stage.h"
#include "geometry/primitive_triangles.h"
#include "geometry/vertex_fetch.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/raster/raster_constants.h"

namespace softgl {
namespace {

using Slot = ShadedVertices::Slot;

class Assembler {
public:
  Assembler(const DrawRecord& draw, const ShadedVertices& vertices, const PrimitiveRange& range, Arena& arena,
            PrimitiveSink& sink)
      : draw_(draw), vertices_(vertices), range_(range), arena_(arena), sink_(sink),
        slots_(draw.layout.slots),
        first_provokes_((draw.first_provokes || (SOFTGL_FAULT(first_vertex_provokes) && draw.raster->flat)) &&
                        range.mode != GL_QUADS && range.mode != GL_QUAD_STRIP) {}

  template <class Elements> void run(const Elements& e, uint32_t first_step, uint32_t step_count) {
    switch (range_.mode) {
    case GL_POINTS: return points(e, first_step, step_count);
    case GL_LINES:
    case GL_LINE_STRIP:
    case GL_LINE_LOOP: return lines(e, first_step, step_count);
    default:
      return draw_.vertex->polygons ? staged_triangles(e, first_step, step_count)
                                    : triangles(e, first_step, step_count);
    }
  }

private:
  const Slot* shaded(uint32_t v) const { return vertices_.slot + size_t(v - vertices_.first) * slots_; }
  uint32_t mask(uint32_t v) const { return vertices_.clip_mask[v - vertices_.first]; }

  template <class Elements> void triangles(const Elements& e, uint32_t step, uint32_t steps) {
    const bool right_first = range_.mode == GL_QUAD_STRIP && !strip_clipped(e);
    const bool by_batches = draw_.diagonal == Diagonal::Unclipped02 && range_.mode == GL_QUADS;
    bool from_1_to_3 = draw_.diagonal == Diagonal::From1To3;
    AssembledTriangles batch;
    for (uint32_t part = steps; steps > 0; step += part, steps -= part) {
      if (by_batches) {
        const uint32_t first = 4 * step / kBatchVertices * kBatchVertices;
        from_1_to_3 = any_clipped(e, first, std::min(range_.count, first + kBatchVertices));
        part = std::min(steps, (first + kBatchVertices) / 4 - step);
      }
      int32_t count = batch.count; // in a register
      const auto put =
          [&, vertices = vertices_, slots = size_t(slots_) ](int, uint32_t v0, uint32_t v1, uint32_t v2)
              __attribute__((always_inline)) {
        const uint32_t i0 = v0 - vertices.first, i1 = v1 - vertices.first, i2 = v2 - vertices.first;
        const uint32_t m0 = vertices.clip_mask[i0], m1 = vertices.clip_mask[i1], m2 = vertices.clip_mask[i2];
        if (m0 | m1 | m2) {
          if (m0 & m1 & m2) return;
          batch.count = count;
          add_clipped(batch, v0, v1, v2);
          count = batch.count;
          return;
        }
        if (count == kAssemblyBatch) {
          hand_over(batch, count);
          count = 0;
        }
        batch.corner[0][count] = vertices.slot + i0 * slots,
        batch.corner[1][count] = vertices.slot + i1 * slots,
        batch.corner[2][count] = vertices.slot + i2 * slots;
        ++count;
      };
      if (first_provokes_)
        for_each_triangle_of_first(range_.mode, e, step, part, put);
      else if (SOFTGL_FAULT(polygon_color_of_last) && range_.mode == GL_POLYGON)
        for_each_triangle(GL_TRIANGLE_FAN, from_1_to_3, right_first, e, step, part, put);
      else
        for_each_triangle(range_.mode, from_1_to_3, right_first, e, step, part, put);
      batch.count = count;
    }
    if (batch.count) sink_.triangles(draw_, batch);
  }

  /// True if a vertex of the strip is clipped; not asked of strips longer than OSMesa's batches. OSMesa draws
  /// the two triangles of a strip's quadrilaterals in an order that depends on it, seen where one overlaps
  /// itself.
  template <class Elements> bool strip_clipped(const Elements& e) const {
    return range_.count <= 8192 && any_clipped(e, 0, range_.count);
  }

  /// True if one of elements [first, end) is clipped.
  template <class Elements> bool any_clipped(const Elements& e, uint32_t first, uint32_t end) const {
    uint32_t any = 0;
    for (uint32_t i = first; i < end; ++i) any |= mask(e[i]);
    return any != 0;
  }

  __attribute__((noinline)) void hand_over(AssembledTriangles& batch, int32_t count) {
    batch.count = count;
    sink_.triangles(draw_, batch);
    batch.count = 0;
  }

  /// The parts that clipping leaves of a triangle.
  void add_clipped(AssembledTriangles& batch, uint32_t v0, uint32_t v1, uint32_t v2) {
    clip_triangle(v0, v1, v2, 7, [&](const Slot* a, const Slot* b, const Slot* c, uint32_t, int) {
      if (batch.count == kAssemblyBatch) hand_over(batch, kAssemblyBatch);
      batch.corner[0][batch.count] = a;
      batch.corner[1][batch.count] = b;
      batch.corner[2][batch.count] = c;
      ++batch.count;
    });
  }

  /// Calls emit(a, b, c, edges, part) with the corners of the triangle, or of the parts 0, 1, ... that
  /// clipping leaves of it; the whole triangle is part -1. Bit k of `edges`: the edge that begins at corner k
  /// is one of the polygon.
  template <class Emit> __attribute__((noinline)) void clip_triangle(uint32_t v0, uint32_t v1, uint32_t v2,
                                                                     uint32_t edges, Emit emit) {
    const uint32_t v[3] = {v0, v1, v2}, m0 = mask(v0), m1 = mask(v1), m2 = mask(v2);
    if ((m0 | m1 | m2) == 0) return emit(shaded(v0), shaded(v1), shaded(v2), edges, -1);
    if ((m0 & m1 & m2) || SOFTGL_FAULT(cut_polygon_vanishes)) return;
    const Slot* polygon[Clipper::kMaxPolygon];
    const int n = Clipper(draw_, vertices_, arena_).triangle(v, m0 | m1 | m2, polygon, edges);
    for (int k = 2; k < n; ++k) {
      const uint32_t first = k == 2 ? (edges & 1) << 2 : 0, last = k == n - 1 ? (edges >> k & 1) << 1 : 0;
      emit(polygon[k - 1], polygon[k], polygon[0], first | last | (edges >> (k - 1) & 1), k - 2);
    }
  }

  /// Triangles that go through the polygon stage. Which of their edges are edges of the polygons matters,
  /// too.
  template <class Elements> void staged_triangles(const Elements& e, uint32_t step, uint32_t steps) {
    PolygonStage polygons(draw_, arena_, sink_);
    const bool polygon = range_.mode == GL_POLYGON;
    const uint32_t last_step = assembly_steps(range_) - 1;
    const bool whole = draw_.vertex->polygons->whole && !polygons.fills();
    if (polygon && whole && any_clipped(e, 0, range_.count)) {
      if (step == 0) clip_polygon(e, polygons); // one piece does it for all
      return polygons.finish();
    }
    // The stipple of a polygon goes on from triangle to triangle: count those in front of this chunk.
    uint32_t at = polygon && polygons.stipples() ? 0 : step;
    for (const uint32_t end = step + steps; at < end; ++at) {
      polygons.count_only(at < step);
      if (whole && clip_step(e, at, polygons)) continue;
      const auto put = [&](int i, uint32_t v0, uint32_t v1, uint32_t v2) {
        uint32_t boundary = 7;
        bool begins = true;
        if (polygon) {
          begins = at == 0 && range_.begins;
          boundary = 1u | (begins ? 4u : 0u) | (at == last_step && range_.ends ? 2u : 0u);
        } else if (range_.mode == GL_QUADS || range_.mode == GL_QUAD_STRIP) {
          begins = i == 0;
          boundary = begins ? 5 : 3;
        }
        clip_triangle(v0, v1, v2, polygons.fills() ? boundary : boundary & flags(v0, v1, v2),
                      [&](const Slot* a, const Slot* b, const Slot* c, uint32_t edges, int part) {
                        polygons.triangle({{a, b, c}, edges, part < 0 ? begins : part == 0});
                      });
      };
      if (first_provokes_)
        for_each_triangle_of_first(range_.mode, e, at, 1, put);
      else
        for_each_triangle(range_.mode, true, false, e, at, 1, put);
    }
    polygons.finish();
  }

  /// An edge that begins at the vertex is marked as one of the polygon (GL 1.5, 2.6.2).
  bool flagged(uint32_t vertex) const {
    if (SOFTGL_FAULT(edge_flags_ignored)) return true;
    if (range_.mode != GL_TRIANGLES && range_.mode != GL_QUADS && range_.mode != GL_POLYGON &&
        !SOFTGL_FAULT(strips_have_edge_flags))
      return true;
    const VertexSource& source = *draw_.call.source;
    if (!(source.present >> kEdgeFlag & 1)) return draw_.call.constant[kEdgeFlag].x != 0;
    float flag[4];
    fetch_vertex(source.stream[kEdgeFlag], vertex, flag);
    return flag[0] != 0;
  }
  uint32_t flags(uint32_t v0, uint32_t v1, uint32_t v2) const {
    if (SOFTGL_FAULT(edge_flag_of_end)) std::tie(v0, v1, v2) = std::tuple(v1, v2, v0);
    return uint32_t(flagged(v0)) | uint32_t(flagged(v1)) << 1 | uint32_t(flagged(v2)) << 2;
  }

  /// Clips the triangle or the quadrilateral of a step as a whole. False if nothing clips it.
  template <class Elements> bool clip_step(const Elements& e, uint32_t step, PolygonStage& polygons) {
    uint32_t v[4];
    size_t n = 3;
    const auto take = [&](int, uint32_t v0, uint32_t v1, uint32_t v2) { v[0] = v0, v[1] = v1, v[2] = v2; };
    if (range_.mode == GL_QUADS) {
      n = 4;
      for (uint32_t i = 0; i < 4; ++i) v[i] = e[4 * step + i];
    } else if (range_.mode == GL_QUAD_STRIP) {
      n = 4;
      for (uint32_t i = 0; i < 4; ++i) v[i] = e[2 * step + std::array{2u, 0u, 1u, 3u}[i]];
    } else if (range_.mode == GL_POLYGON) {
      return false;
    } else if (first_provokes_) {
      for_each_triangle_of_first(range_.mode, e, step, 1, take);
    } else {
      for_each_triangle(range_.mode, false, false, e, step, 1, take);
    }
    PolygonCorner corners[4] = {};
    for (size_t i = 0; i < n; ++i) corners[i].boundary = flagged(v[i]);
    return clip_whole(v, {corners, n}, polygons);
  }

  /// Clips a primitive of GL_POLYGON. Of one that is continued a part, which has inner edges.
  template <class Elements> void clip_polygon(const Elements& e, PolygonStage& polygons) {
    const uint32_t n = range_.count;
    auto* v = arena_.allocate_array<uint32_t>(n);
    auto* corners = arena_.allocate_array<PolygonCorner>(n);
    for (uint32_t i = 0; i < n; ++i) { // the first vertex, which provokes, comes last
      v[i] = e[(i + 1) % n];
      const bool inner = (i + 2 == n && !range_.ends) || (i + 1 == n && !range_.begins);
      corners[i].boundary = !inner && flagged(v[i]);
    }
    clip_whole(v, {corners, n}, polygons);
  }

  /// Clips the polygon with vertices v, of which the last one provokes. False if nothing clips it.
  bool clip_whole(const uint32_t* v, std::span<const PolygonCorner> corners, PolygonStage& polygons) {
    uint32_t any = 0, all = ~0u;
    for (size_t i = 0; i < corners.size(); ++i) any |= mask(v[i]), all &= mask(v[i]);
    if (!any) return false;
    if (all) return true;
    const auto rest = Clipper(draw_, vertices_, arena_).polygon(v, any, corners);
    if (!rest.empty()) polygons.polygon(rest, shaded(v[corners.size() - 1]));
    return true;
  }

  template <class Elements> void points(const Elements& e, uint32_t step, uint32_t steps) {
    AssembledPoints batch;
    for (const uint32_t end = step + steps; step < end; ++step) {
      const uint32_t v = e[step];
      if (mask(v) && !SOFTGL_FAULT(points_not_clipped)) continue;
      batch.corner[batch.count++] = shaded(v);
      if (batch.count == kAssemblyBatch) {
        sink_.points(draw_, batch);
        batch.count = 0;
      }
    }
    if (batch.count) sink_.points(draw_, batch);
  }

  /// The ends of line `step`, as numbers of elements.
  void line_elements(uint32_t step, uint32_t out[2]) const {
    if (range_.mode == GL_LINES) {
      out[0] = 2 * step, out[1] = 2 * step + 1;
      return;
    }
    // A loop that continues has its very first vertex in front.
    const uint32_t start = range_.mode == GL_LINE_LOOP && !range_.begins;
    out[0] = start + step, out[1] = start + step + 1;
    if (out[1] == range_.count) out[1] = 0;
  }

  /// Clips line v; false when nothing is left.
  bool clip_line(const uint32_t v[2], const Slot* end[2]) {
    const uint32_t m0 = mask(v[0]), m1 = mask(v[1]);
    if (m0 & m1) return false;
    end[0] = shaded(v[0]);
    end[1] = shaded(v[1]);
    if ((m0 | m1) != 0 && !Clipper(draw_, vertices_, arena_).line(v, end)) return false;
    if (first_provokes_ || (SOFTGL_FAULT(line_color_of_first) && draw_.raster->flat))
      end[1] = with_colors(end[1], shaded(v[0]));
    return true;
  }

  /// A copy of the vertex with the colors of another one.
  const Slot* with_colors(const Slot* vertex, const Slot* colors) {
    Slot* copy = arena_.allocate_array<Slot>(slots_);
    std::memcpy(copy, vertex, sizeof(Slot) * slots_);
    copy_flat_colors(draw_.layout, copy, colors);
    return copy;
  }

  template <class Elements> void lines(const Elements& e, uint32_t step, uint32_t steps) {
    AssembledLines batch;
    bool begins = false;
    auto emit = [&](const Slot* a, const Slot* b) {
      if (batch.count == kAssemblyBatch) {
        sink_.lines(draw_, batch);
        batch.count = 0, batch.begins = 0;
      }
      batch.begins |= uint64_t(begins) << batch.count;
      begins = false;
      batch.corner[0][batch.count] = a;
      batch.corner[1][batch.count] = b;
      ++batch.count;
    };
    const bool stippled = draw_.vertex->line_stipple, separate = range_.mode == GL_LINES;
    LineStipple stipple(draw_, arena_);
    // A strip's pattern goes on from line to line: count the lines in front of this chunk.
    uint32_t at = stippled && !separate ? 0 : step;
    for (const uint32_t end_step = step + steps; at < end_step; ++at) {
      uint32_t element[2];
      line_elements(at, element);
      if (SOFTGL_FAULT(loop_not_closed) && element[1] == 0) continue;
      const uint32_t v[2] = {e[element[0]], e[element[1]]};
      const Slot* end[2];
      if (stippled && separate) stipple.reset();
      begins = begins || separate || (at == 0 && range_.begins);
      if (!clip_line(v, end)) continue;
      if (!stippled)
        emit(end[0], end[1]);
      else if (at < step)
        stipple.skip(end);
      else
        stipple.cut(end, emit);
    }
    if (batch.count) sink_.lines(draw_, batch);
  }

  const DrawRecord& draw_;
  const ShadedVertices& vertices_;
  const PrimitiveRange& range_;
  Arena& arena_;
  PrimitiveSink& sink_;
  const uint32_t slots_;
  const bool first_provokes_;
};

} // namespace

void assemble(const DrawRecord& draw, const ShadedVertices& vertices, const PrimitiveRange& range,
              uint32_t first_step, uint32_t step_count, Arena& arena, PrimitiveSink& sink) {
  SOFTGL_ASSERT(uint64_t(first_step) + step_count <= assembly_steps(range));
  SOFTGL_ASSERT(vertices.slot && vertices.clip_mask);
  Assembler assembler(draw, vertices, range, arena, sink);
  const void* indices = draw.call.indices;
  if (!indices) return assembler.run(NoIndices{range.first}, first_step, step_count);
  switch (draw.call.index_type) {
  case GL_UNSIGNED_BYTE:
    return assembler.run(Indices<uint8_t>{static_cast<const uint8_t*>(indices) + range.first}, first_step,
                         step_count);
  case GL_UNSIGNED_SHORT:
    return assembler.run(Indices<uint16_t>{static_cast<const uint16_t*>(indices) + range.first}, first_step,
                         step_count);
  default:
    return assembler.run(Indices<uint32_t>{static_cast<const uint32_t*>(indices) + range.first}, first_step,
                         step_count);
  }
}

} // namespace softgl
