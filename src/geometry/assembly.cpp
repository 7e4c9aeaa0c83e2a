// Primitive assembly (GL 1.5, 2.6.1): vertices become triangles, lines and points in the corner order that OSMesa hands
// to set-up, because the order decides last bits. GL_QUADS are cut from corner 0 to corner 2, flat-shaded ones from 1
// to 3, see reference/DEVIATIONS.md.
#include "clipping.h"
#include "geometry.h"
#include "line_stipple.h"
#include "raster_constants.h"

namespace softgl {
namespace {

using Slot = ShadedVertices::Slot;

// Element number within the primitive -> vertex number.
struct NoIndices {
  uint32_t first;
  uint32_t operator[](uint32_t element) const { return first + element; }
};
template <class T> struct Indices {
  const T* index;
  uint32_t operator[](uint32_t element) const { return index[element]; }
};

/// Vertex numbers of a batch of triangles, corner 2 provoking.
struct TriangleIndices {
  uint32_t corner[3][kAssemblyBatch];
};

/// Fills triangles [0, n) of steps [step, ...); returns n. Two triangles a step for quadrilaterals.
template <class Elements>
int triangle_indices(GLenum mode, bool flat, bool right_first, const Elements& e, uint32_t step, uint32_t steps, TriangleIndices& out) {
  uint32_t *a = out.corner[0], *b = out.corner[1], *c = out.corner[2];
  const int n = int(steps);
  switch (mode) {
  case GL_TRIANGLES:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 3 * (step + uint32_t(i));
      a[i] = e[k], b[i] = e[k + 1], c[i] = e[k + 2];
    }
    return n;
  case GL_TRIANGLE_STRIP:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i), odd = k & 1;
      a[i] = e[k + odd], b[i] = e[k + 1 - odd], c[i] = e[k + 2];
    }
    return n;
  case GL_TRIANGLE_FAN:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i);
      a[i] = e[0], b[i] = e[k + 1], c[i] = e[k + 2];
    }
    return n;
  case GL_POLYGON:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = step + uint32_t(i);
      a[i] = e[k + 1], b[i] = e[k + 2], c[i] = e[0];
    }
    return n;
  case GL_QUADS:
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 4 * (step + uint32_t(i));
      const uint32_t first = e[k], second = e[k + 1], third = e[k + 2], fourth = e[k + 3];
      a[2 * i] = first, b[2 * i] = second, c[2 * i] = flat ? fourth : third;
      a[2 * i + 1] = flat ? second : first, b[2 * i + 1] = third, c[2 * i + 1] = fourth;
    }
    return 2 * n;
  default: // GL_QUAD_STRIP
    for (int i = 0; i < n; ++i) {
      const uint32_t k = 2 * (step + uint32_t(i));
      const int left = 2 * i + right_first, right = 2 * i + !right_first;
      a[left] = e[k + 2], b[left] = e[k], c[left] = e[k + 3];
      a[right] = e[k], b[right] = e[k + 1], c[right] = e[k + 3];
    }
    return 2 * n;
  }
}

class Assembler {
public:
  Assembler(const DrawRecord& draw, const ShadedVertices& vertices, const PrimitiveRange& range, Arena& arena,
            PrimitiveSink& sink)
      : draw_(draw), vertices_(vertices), range_(range), arena_(arena), sink_(sink), slots_(draw.layout.slots) {}

  template <class Elements> void run(const Elements& e, uint32_t first_step, uint32_t step_count) {
    switch (range_.mode) {
    case GL_POINTS: return points(e, first_step, step_count);
    case GL_LINES:
    case GL_LINE_STRIP:
    case GL_LINE_LOOP: return lines(e, first_step, step_count);
    default: return triangles(e, first_step, step_count);
    }
  }

private:
  const Slot* shaded(uint32_t v) const { return vertices_.slot + size_t(v - vertices_.first) * slots_; }
  uint32_t mask(uint32_t v) const { return vertices_.clip_mask[v - vertices_.first]; }

  template <class Elements> void triangles(const Elements& e, uint32_t step, uint32_t steps) {
    const bool quads = range_.mode == GL_QUADS || range_.mode == GL_QUAD_STRIP;
    const uint32_t batch_steps = quads ? kAssemblyBatch / 2 : kAssemblyBatch;
    const bool right_first = range_.mode == GL_QUAD_STRIP && !any_clipped(e);
    TriangleIndices index;
    AssembledTriangles batch;
    for (const uint32_t end = step + steps; step < end; step += batch_steps) {
      const uint32_t left = end - step;
      const int n = triangle_indices(range_.mode, draw_.raster->flat, right_first, e, step, left < batch_steps ? left : batch_steps, index);
      uint32_t any = 0;
      const uint16_t* masks = vertices_.clip_mask;
      const uint32_t first = vertices_.first;
      for (int i = 0; i < n; ++i)
        any |= uint32_t(masks[index.corner[0][i] - first]) | masks[index.corner[1][i] - first] | masks[index.corner[2][i] - first];
      if (any == 0) {
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < n; ++i) batch.corner[c][i] = shaded(index.corner[c][i]);
        batch.count = n;
      } else {
        batch.count = 0;
        for (int i = 0; i < n; ++i) clip_triangle(index, i, batch);
      }
      if (batch.count) sink_.triangles(draw_, batch);
    }
  }

  /// True if a vertex of the primitive is clipped; not asked of primitives longer than OSMesa's batches. OSMesa draws
  /// the two triangles of a strip's quadrilaterals in an order that depends on it, seen where one overlaps itself.
  template <class Elements> bool any_clipped(const Elements& e) const {
    if (range_.count > 8192) return false;
    uint32_t any = 0;
    for (uint32_t i = 0; i < range_.count; ++i) any |= mask(e[i]);
    return any != 0;
  }

  void add_triangle(AssembledTriangles& batch, const Slot* a, const Slot* b, const Slot* c) {
    if (batch.count == kAssemblyBatch) {
      sink_.triangles(draw_, batch);
      batch.count = 0;
    }
    batch.corner[0][batch.count] = a;
    batch.corner[1][batch.count] = b;
    batch.corner[2][batch.count] = c;
    ++batch.count;
  }

  __attribute__((noinline)) void clip_triangle(const TriangleIndices& index, int i, AssembledTriangles& batch) {
    const uint32_t v[3] = {index.corner[0][i], index.corner[1][i], index.corner[2][i]};
    const uint32_t m0 = mask(v[0]), m1 = mask(v[1]), m2 = mask(v[2]);
    if ((m0 | m1 | m2) == 0) return add_triangle(batch, shaded(v[0]), shaded(v[1]), shaded(v[2]));
    if (m0 & m1 & m2) return;
    const Slot* polygon[Clipper::kMaxPolygon];
    const int n = Clipper(draw_, vertices_, arena_).triangle(v, m0 | m1 | m2, polygon);
    for (int k = 2; k < n; ++k) add_triangle(batch, polygon[k - 1], polygon[k], polygon[0]);
  }

  template <class Elements> void points(const Elements& e, uint32_t step, uint32_t steps) {
    AssembledPoints batch;
    for (const uint32_t end = step + steps; step < end; ++step) {
      const uint32_t v = e[step];
      if (mask(v)) continue;
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
    return (m0 | m1) == 0 || Clipper(draw_, vertices_, arena_).line(v, end);
  }

  template <class Elements> void lines(const Elements& e, uint32_t step, uint32_t steps) {
    AssembledLines batch;
    auto emit = [&](const Slot* a, const Slot* b) {
      if (batch.count == kAssemblyBatch) {
        sink_.lines(draw_, batch);
        batch.count = 0;
      }
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
      const uint32_t v[2] = {e[element[0]], e[element[1]]};
      const Slot* end[2];
      if (stippled && separate) stipple.reset();
      if (!clip_line(v, end)) continue;
      if (!stippled) emit(end[0], end[1]);
      else if (at < step) stipple.skip(end);
      else stipple.cut(end, emit);
    }
    if (batch.count) sink_.lines(draw_, batch);
  }

  const DrawRecord& draw_;
  const ShadedVertices& vertices_;
  const PrimitiveRange& range_;
  Arena& arena_;
  PrimitiveSink& sink_;
  const uint32_t slots_;
};

} // namespace

void assemble(const DrawRecord& draw, const ShadedVertices& vertices, const PrimitiveRange& range, uint32_t first_step,
              uint32_t step_count, Arena& arena, PrimitiveSink& sink) {
  Assembler assembler(draw, vertices, range, arena, sink);
  const void* indices = draw.call.indices;
  if (!indices) return assembler.run(NoIndices{range.first}, first_step, step_count);
  switch (draw.call.index_type) {
  case GL_UNSIGNED_BYTE:
    return assembler.run(Indices<uint8_t>{static_cast<const uint8_t*>(indices) + range.first}, first_step, step_count);
  case GL_UNSIGNED_SHORT:
    return assembler.run(Indices<uint16_t>{static_cast<const uint16_t*>(indices) + range.first}, first_step, step_count);
  default:
    return assembler.run(Indices<uint32_t>{static_cast<const uint32_t*>(indices) + range.first}, first_step, step_count);
  }
}

} // namespace softgl
