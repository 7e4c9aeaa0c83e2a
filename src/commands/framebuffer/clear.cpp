// glClear and its values (GL 1.5, 4.2.3).
#include <algorithm>
#include <bit>
#include <cmath>

#include "base/unit_range.h"
#include "commands/framebuffer/accumulation.h"
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/drawn_box.h"
#include "snapshot/render_targets.h"
#include "surface/stored_color.h"

namespace softgl {
namespace {

/// The depth in the surface's integers. OSMesa 22.3.6 clears a whole buffer in double; a part of it, or one
/// whose stencil is masked, by drawing a rectangle, whose depth goes through float.
uint32_t store_depth(DepthFormat format, double depth, bool drawn) {
  if (format == DepthFormat::Z32F) return std::bit_cast<uint32_t>(float(depth));
  const double one = largest_depth(format);
  if (!drawn) return uint32_t(std::nearbyint(depth * one));
  const float z = float(depth * 2.0 - 1.0) * 0.5f + 0.5f;
  return uint32_t(std::nearbyint(unit_range(z) * float(one)));
}

} // namespace

namespace gl {

void Clear(Context& c, GLbitfield mask) {
  if (mask &
      ~GLbitfield(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT))
    return set_error(c, GL_INVALID_VALUE, "mask");
  if (!prepare_draw_target(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  if (c.state.render_mode.mode != GL_RENDER && !SOFTGL_FAULT(clears_in_any_mode)) return;
  const RenderTarget& target = *c.draw;
  if (!c.bindings.draw) c.framebuffer.unresolved = true; // OSMesa: also when nothing is cleared in the end
  const Surface& surface = target.surface;
  const State& s = c.state;
  ClearRecord record{};
  const WindowBox box = drawn_box(s.scissor, surface);
  record.x0 = box.x0, record.y0 = box.y0;
  record.x1 = box.x1, record.y1 = box.y1;
  if (record.x0 >= record.x1 || record.y0 >= record.y1) return;

  const bool accumulation = (mask & GL_ACCUM_BUFFER_BIT) && prepare_accumulation_clear(c);
  const bool part = record.x0 > 0 || record.y0 > 0 || record.x1 < surface.width || record.y1 < surface.height;
  if ((mask & GL_COLOR_BUFFER_BIT) && draws_color(c)) {
    bool all = true; // of the components that are kept
    for (int i = 0; i < 4; ++i) {
      record.color_mask[i] = s.color_buffer.mask[i] && surface.encoding.bits[i];
      record.color = record.color || record.color_mask[i];
      all = all && record.color_mask[i] == (surface.encoding.bits[i] != 0);
    }
    const bool srgb = surface.encoding.srgb && s.color_buffer.framebuffer_srgb;
    store_clear_color(surface, srgb, &s.color_buffer.clear_color[0], part || !all, record.color_value);
  }
  if ((mask & GL_DEPTH_BUFFER_BIT) && target.depth_bits > 0 && s.depth.mask) {
    const GLuint stencil_mask = s.stencil.front.write_mask & 0xff;
    const bool with_masked_stencil = (mask & GL_STENCIL_BUFFER_BIT) && target.stencil_bits > 0 &&
                                     stencil_mask != 0 && stencil_mask != 0xff;
    record.depth = true;
    record.depth_value = store_depth(surface.depth_format, s.depth.clear, part || with_masked_stencil);
  }
  if ((mask & GL_STENCIL_BUFFER_BIT) && target.stencil_bits > 0 && (s.stencil.front.write_mask & 0xff) != 0) {
    record.stencil = true;
    record.stencil_value = uint32_t(s.stencil.clear) & 0xff;
    record.stencil_write_mask = s.stencil.front.write_mask & 0xff;
  }
  if (record.color || record.depth || record.stencil) {
    ++c.framebuffer.counts.clears;
    if (c.frame.over_budget()) flush_rendering(c);
    c.frame.append(c.frame.arena().make<ClearRecord>(record));
  }
  if (accumulation) clear_accumulation(c, box);
}

void ClearColor(Context& c, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  c.state.color_buffer.clear_color = Vec4(red, green, blue, alpha);
}

void ClearIndex(Context& c, GLfloat value) { c.state.color_buffer.clear_index = value; }

void ClearDepth(Context& c, GLdouble depth) {
  c.state.depth.clear = depth > 0 ? (depth < 1 ? depth : 1.0) : 0.0;
}

void ClearStencil(Context& c, GLint s) { c.state.stencil.clear = s; }

} // namespace gl
} // namespace softgl
