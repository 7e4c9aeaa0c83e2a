#include "geometry/feedback.h"

#include <algorithm>

#include "api/generated/commands.h"
#include "base/float_environment.h"
#include "base/unit_range.h"
#include "fragment_program.h"
#include "geometry/geometry.h"
#include "raster/raster_snapshot.h"
#include "raster_constants.h"
#include "state/context.h"
#include "vertex_snapshot.h"

namespace softgl {
namespace {

using Slot = ShadedVertices::Slot;

template <class T> void put(RenderModeState& m, T* buffer, GLsizei size, T value) {
  if (m.written < uint64_t(size)) buffer[m.written] = value;
  ++m.written;
}
void put(RenderModeState& m, float value) { put(m, m.feedback_buffer, m.feedback_size, value); }
void put_token(RenderModeState& m, GLenum token) { put(m, float(token)); }

void note_hit(RenderModeState& m, float depth) {
  m.hit = true;
  m.least_depth = std::min(m.least_depth, depth);
  m.greatest_depth = std::max(m.greatest_depth, depth);
}

/// A depth of a hit record: [0,1] to the integers of 32 bits, to nearest.
GLuint record_depth(float depth) { return GLuint(double(unit_range(depth)) * 4294967295.0 + 0.5); }

/// Writes the record of the hits since the name stack changed last, if there were any.
void write_hit_record(RenderModeState& m) {
  if (!m.hit) return;
  auto write = [&](GLuint v) { put(m, m.selection_buffer, m.selection_size, v); };
  write(GLuint(m.name_stack_depth));
  write(record_depth(m.least_depth));
  write(record_depth(m.greatest_depth));
  for (int i = 0; i < m.name_stack_depth; ++i) write(m.name[i]);
  ++m.hits;
  m.hit = false;
  m.least_depth = 1, m.greatest_depth = 0;
}

/// Window position (y up), clip w, colour and the coordinates of unit 0, as far as the type of feedback wants
/// them (table 5.1).
void put_vertex(RenderModeState& m, const Vec4& window, const Vec4& color, const Vec4& coordinates) {
  put(m, window.x);
  put(m, window.y);
  if (m.feedback_type == GL_2D) return;
  put(m, window.z);
  if (m.feedback_type == GL_4D_COLOR_TEXTURE) put(m, window.w);
  if (m.feedback_type == GL_3D) return;
  for (int i = 0; i < 4; ++i) put(m, color[i]);
  if (m.feedback_type == GL_3D_COLOR) return;
  for (int i = 0; i < 4; ++i) put(m, coordinates[i]);
}

/// Takes primitives; polygons have been culled, and have the colours of the side that is seen.
class Receiver final : public PrimitiveSink {
public:
  Receiver(RenderModeState& mode, float height) : mode_(mode), height_(height) {}

  void triangles(const DrawRecord& draw, const AssembledTriangles& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      const Slot* const corner[3] = {batch.corner[0][i], batch.corner[1][i], batch.corner[2][i]};
      if (selects()) {
        for (const Slot* c : corner) note_hit(mode_, c->v[2]);
        continue;
      }
      put_token(mode_, GL_POLYGON_TOKEN);
      put(mode_, 3.0f);
      for (const Slot* c : corner) vertex(draw, c, corner[2]);
    }
  }

  void lines(const DrawRecord& draw, const AssembledLines& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      const Slot* const end[2] = {batch.corner[0][i], batch.corner[1][i]};
      if (!selects()) put_token(mode_, batch.begins >> i & 1 ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
      for (const Slot* e : end) selects() ? note_hit(mode_, e->v[2]) : vertex(draw, e, end[1]);
    }
  }

  void points(const DrawRecord& draw, const AssembledPoints& batch) override {
    for (int32_t i = 0; i < batch.count; ++i) {
      if (selects()) {
        note_hit(mode_, batch.corner[i]->v[2]);
        continue;
      }
      put_token(mode_, GL_POINT_TOKEN);
      vertex(draw, batch.corner[i], batch.corner[i]);
    }
  }

private:
  bool selects() const { return mode_.mode == GL_SELECT; }

  void vertex(const DrawRecord& draw, const Slot* v, const Slot* provoking) {
    auto value = [](const Slot& s) { return Vec4(s.v[0], s.v[1], s.v[2], s.v[3]); };
    const ShadedLayout& l = draw.layout;
    const Slot* colors = draw.raster->flat ? provoking : v;
    put_vertex(mode_, {v->v[0], height_ - v->v[1], v->v[2], 1.0f / v->v[3]}, value(colors[l.color]),
               value(v[l.texcoord[0]]));
  }

  RenderModeState& mode_;
  const float height_;
};

GLint leave_mode(RenderModeState& m) {
  GLint result = 0;
  if (m.mode == GL_SELECT) {
    write_hit_record(m);
    result = m.written > uint64_t(m.selection_size) ? -1 : m.hits;
  } else if (m.mode == GL_FEEDBACK) {
    result = m.written > uint64_t(m.feedback_size) ? -1 : GLint(m.written);
  }
  m.written = 0;
  m.hits = 0;
  m.name_stack_depth = 0;
  return result;
}

} // namespace

void feed_back(Context& c, const DrawCall& call) {
  Arena& arena = c.frame.arena();
  const Arena::Mark mark = arena.mark();
  FragmentProgram fragment{};
  fragment.key.texture_units = 1;
  OwnSnapshot own =
      make_own_snapshot(c, fragment.key, call.source->present, &call.constant[kColor][0], arena);
  own.program.line_stipple = false;                        // whole lines are fed back
  own.program.polygons = make_polygon_constants(c, arena); // culled, coloured and offset ones
  const DrawRecord draw{call, own.layout, &own.program, make_raster_constants(c, arena), &fragment};
  const ShadedVertices& vertices = *allocate_vertices(draw, call.first_vertex, call.vertex_count, arena);
  {
    const FloatEnvironment environment;
    shade_vertices(draw, call.first_vertex, call.vertex_count, vertices);
    Receiver receiver(c.state.render_mode, float(c.framebuffer.surface.height));
    for (uint32_t i = 0; i < call.primitive_count; ++i)
      assemble(draw, vertices, call.primitives[i], 0, assembly_steps(call.primitives[i]), arena, receiver);
  }
  arena.rewind(mark);
  if (!c.frame.over_budget()) return;
  c.frame.flush(c.framebuffer.surface); // empty, but for what callers have put there
  c.dirty = kDirtyAll;
}

void feed_back_raster_position(Context& c) {
  if (c.state.render_mode.mode == GL_SELECT) note_hit(c.state.render_mode, c.state.raster_position.window.z);
}

void feed_back_pixels(Context& c, GLenum token) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_FEEDBACK) return;
  const RasterPosition& p = c.state.raster_position;
  put_token(m, token);
  put_vertex(m, p.window, p.color, p.texcoord[0]);
}

namespace gl {

GLint RenderMode(Context& c, GLenum mode) {
  RenderModeState& m = c.state.render_mode;
  if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK) return set_error(c, GL_INVALID_ENUM), 0;
  // A mode whose buffer was never given cannot be entered.
  if ((mode == GL_SELECT && !m.selection_buffer) || (mode == GL_FEEDBACK && !m.feedback_buffer))
    return set_error(c, GL_INVALID_OPERATION), 0;
  flush_rendering(c); // what is to be rendered is not mixed with what is not
  const GLint result = leave_mode(m);
  m.mode = mode;
  return result;
}

void SelectBuffer(Context& c, GLsizei size, GLuint* buffer) {
  RenderModeState& m = c.state.render_mode;
  if (size < 0) return set_error(c, GL_INVALID_VALUE);
  if (m.mode == GL_SELECT) return set_error(c, GL_INVALID_OPERATION);
  m.selection_buffer = buffer;
  m.selection_size = size;
  m.hit = false;
  m.least_depth = 1, m.greatest_depth = 0;
}

void FeedbackBuffer(Context& c, GLsizei size, GLenum type, GLfloat* buffer) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode == GL_FEEDBACK) return set_error(c, GL_INVALID_OPERATION);
  if (size < 0 || (!buffer && size > 0)) return set_error(c, GL_INVALID_VALUE);
  if (type != GL_2D && type != GL_3D && type != GL_3D_COLOR && type != GL_3D_COLOR_TEXTURE &&
      type != GL_4D_COLOR_TEXTURE)
    return set_error(c, GL_INVALID_ENUM);
  m.feedback_buffer = buffer;
  m.feedback_size = size;
  m.feedback_type = type;
}

void PassThrough(Context& c, GLfloat token) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_FEEDBACK) return;
  put_token(m, GL_PASS_THROUGH_TOKEN);
  put(m, token);
}

void InitNames(Context& c) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  write_hit_record(m);
  m.name_stack_depth = 0;
}

void LoadName(Context& c, GLuint name) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  if (m.name_stack_depth == 0) return set_error(c, GL_INVALID_OPERATION);
  write_hit_record(m);
  m.name[m.name_stack_depth - 1] = name;
}

void PushName(Context& c, GLuint name) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  write_hit_record(m);
  if (m.name_stack_depth == kMaxNameStackDepth) return set_error(c, GL_STACK_OVERFLOW);
  m.name[m.name_stack_depth++] = name;
}

void PopName(Context& c) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  write_hit_record(m);
  if (m.name_stack_depth == 0) return set_error(c, GL_STACK_UNDERFLOW);
  --m.name_stack_depth;
}

} // namespace gl
} // namespace softgl
