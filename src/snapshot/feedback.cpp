#include "snapshot/feedback.h"

#include <algorithm>

#include "base/float_environment.h"
#include "base/unit_range.h"
#include "context/context.h"
#include "geometry/geometry.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/fragment/fragment_program.h"
#include "shaders/raster/raster_constants.h"
#include "snapshot/raster_snapshot.h"
#include "snapshot/submit.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

using Slot = ShadedVertices::Slot;

template <class T> void feed_back_value(RenderModeState& m, T* buffer, GLsizei size, T value) {
  if (m.written < uint64_t(size)) buffer[m.written] = value;
  ++m.written;
}

/// A depth of a hit record: [0,1] to the integers of 32 bits, to nearest.
GLuint record_depth(float depth) { return GLuint(double(unit_range(depth)) * 4294967295.0 + 0.5); }

void note_hit(RenderModeState& m, float depth) {
  m.hit = true;
  m.least_depth = std::min(m.least_depth, depth);
  m.greatest_depth = std::max(m.greatest_depth, depth);
}

} // namespace

void feed_back_value(RenderModeState& m, float value) {
  feed_back_value(m, m.feedback_buffer, m.feedback_size, value);
}
void feed_back_token(RenderModeState& m, GLenum token) { feed_back_value(m, float(token)); }

void write_hit_record(RenderModeState& m) {
  if (!m.hit) return;
  auto write = [&](GLuint v) { feed_back_value(m, m.selection_buffer, m.selection_size, v); };
  write(GLuint(m.name_stack_depth));
  const bool swapped = SOFTGL_FAULT(hit_depths_swapped);
  write(record_depth(swapped ? m.greatest_depth : m.least_depth));
  write(record_depth(swapped ? m.least_depth : m.greatest_depth));
  for (int i = 0; i < m.name_stack_depth; ++i)
    write(m.name[SOFTGL_FAULT(names_reversed) ? m.name_stack_depth - 1 - i : i]);
  ++m.hits;
  if (!SOFTGL_FAULT(hit_stays)) m.hit = false;
  if (!SOFTGL_FAULT(hit_depths_stay)) m.least_depth = 1, m.greatest_depth = 0;
}

namespace {

/// Window position (y up), clip w, color and the coordinates of unit 0, as far as the type of feedback wants
/// them (table 5.1).
void put_vertex(RenderModeState& m, const Vec4& window, const Vec4& color, const Vec4& coordinates) {
  feed_back_value(m, window.x);
  feed_back_value(m, window.y);
  if (m.feedback_type == GL_2D) return;
  feed_back_value(m, window.z);
  if (m.feedback_type == GL_4D_COLOR_TEXTURE)
    feed_back_value(m, SOFTGL_FAULT(feedback_w_inverted) ? 1 / window.w : window.w);
  if (m.feedback_type == GL_3D) return;
  for (int i = 0; i < 4; ++i) feed_back_value(m, color[i]);
  if (m.feedback_type == GL_3D_COLOR || SOFTGL_FAULT(feedback_without_texture)) return;
  for (int i = 0; i < 4; ++i) feed_back_value(m, coordinates[i]);
}

/// Takes primitives; polygons have been culled, and have the colors of the side that is seen.
class Receiver final : public PrimitiveSink {
public:
  Receiver(RenderModeState& mode, const Surface& surface) : mode_(mode), surface_(surface) {}

  void triangles(const DrawRecord& draw, const AssembledTriangles& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      const Slot* const corner[3] = {batch.corner[0][i], batch.corner[1][i], batch.corner[2][i]};
      if (selects()) {
        for (const Slot* c : corner) note_hit(mode_, c->v[2]);
        continue;
      }
      feed_back_token(mode_, GL_POLYGON_TOKEN);
      feed_back_value(mode_, 3.0f);
      for (const Slot* c : corner) vertex(draw, c, corner[2]);
    }
  }

  void lines(const DrawRecord& draw, const AssembledLines& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      const Slot* const end[2] = {batch.corner[0][i], batch.corner[1][i]};
      if (!selects()) {
        const bool begins = batch.begins >> i & 1 && !SOFTGL_FAULT(line_reset_ignored);
        feed_back_token(mode_, begins ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
      }
      for (const Slot* e : end) selects() ? note_hit(mode_, e->v[2]) : vertex(draw, e, end[1]);
    }
  }

  void points(const DrawRecord& draw, const AssembledPoints& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      if (selects()) {
        note_hit(mode_, batch.corner[i]->v[2]);
        continue;
      }
      feed_back_token(mode_, GL_POINT_TOKEN);
      vertex(draw, batch.corner[i], batch.corner[i]);
    }
  }

private:
  bool selects() const { return mode_.mode == GL_SELECT; }

  void vertex(const DrawRecord& draw, const Slot* v, const Slot* provoking) {
    auto value = [](const Slot& s) { return Vec4(s.v[0], s.v[1], s.v[2], s.v[3]); };
    const ShadedLayout& l = draw.layout;
    const bool flat = draw.raster->flat && !SOFTGL_FAULT(feedback_never_flat);
    const Slot* colors = flat ? provoking : v;
    const float y =
        surface_.y_up != SOFTGL_FAULT(feedback_from_above) ? v->v[1] : float(surface_.height) - v->v[1];
    put_vertex(mode_, {v->v[0], y, v->v[2], 1.0f / v->v[3]}, value(colors[l.color]), value(v[l.texcoord[0]]));
  }

  RenderModeState& mode_;
  const Surface& surface_;
};

} // namespace

void feed_back(Context& c, const DrawCall& call) {
  Arena& arena = c.frame.arena();
  const Arena::Mark mark = arena.mark();
  FragmentProgram fragment{};
  fragment.key.texture_units = 1;
  OwnSnapshot own =
      make_own_snapshot(c, fragment.key, call.source->present, &call.constant[kColor][0], arena);
  own.program.line_stipple = false; // whole lines are fed back
  // Culled, colored and, by OSMesa 22.3.6 alone, offset ones. It selects what their mode makes of them, too.
  auto* polygons = arena.make<PolygonConstants>(*make_polygon_constants(c, arena));
  if (c.specification_answers) {
    std::fill_n(polygons->offset, 3, false);
    if (c.state.render_mode.mode == GL_SELECT) std::fill_n(polygons->mode, 2, PolygonMode::Fill);
  }
  const bool selects = c.state.render_mode.mode == GL_SELECT;
  if (selects ? SOFTGL_FAULT(culled_polygons_hit) : SOFTGL_FAULT(culled_polygons_fed_back))
    polygons->cull_front = polygons->cull_back = false;
  if (!selects && SOFTGL_FAULT(feedback_without_modes)) std::fill_n(polygons->mode, 2, PolygonMode::Fill);
  own.program.polygons = polygons;
  DrawRecord draw{call, own.layout, &own.program, make_raster_constants(c, arena), &fragment};
  draw.first_provokes = first_provokes(c);
  const ShadedVertices& vertices = *allocate_vertices(draw, call.first_vertex, call.vertex_count, arena);
  {
    const FloatEnvironment environment;
    shade_vertices(draw, call.first_vertex, call.vertex_count, vertices);
    Receiver receiver(c.state.render_mode, c.draw->surface);
    for (uint32_t i = 0; i < call.primitive_count; ++i)
      assemble(draw, vertices, call.primitives[i], 0, assembly_steps(call.primitives[i]), arena, receiver);
  }
  arena.rewind(mark);
  if (!c.frame.over_budget()) return;
  c.frame.flush(c.draw->surface); // empty, but for what callers have put there
  c.dirty = kDirtyAll;
}

void feed_back_raster_position(Context& c) {
  if (SOFTGL_FAULT(raster_position_no_hit)) return;
  if (c.state.render_mode.mode == GL_SELECT) note_hit(c.state.render_mode, c.state.raster_position.window.z);
}

void feed_back_pixels(Context& c, GLenum token) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode == GL_SELECT && SOFTGL_FAULT(images_hit)) note_hit(m, c.state.raster_position.window.z);
  if (m.mode != GL_FEEDBACK) return;
  const RasterPosition& p = c.state.raster_position;
  if (SOFTGL_FAULT(copy_is_draw) && token == GL_COPY_PIXEL_TOKEN) token = GL_DRAW_PIXEL_TOKEN;
  if (SOFTGL_FAULT(bitmap_not_fed_back) && token == GL_BITMAP_TOKEN) return;
  feed_back_token(m, token);
  put_vertex(m, p.window, p.color, p.texcoord[0]);
}

} // namespace softgl
