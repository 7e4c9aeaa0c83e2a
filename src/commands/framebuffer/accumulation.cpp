// The accumulation buffer: Accum, ClearAccum (GL 1.5, 4.2.4 and 4.2.3). Nothing else reads or writes it, so
// its operations never wait in the frame.
#include "commands/framebuffer/accumulation.h"

#include <algorithm>
#include <iterator>

#include "base/float_environment.h"
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "frame/surface_work.h"
#include "snapshot/drawn_box.h"
#include "snapshot/render_targets.h"

namespace softgl {
namespace {

/// OSMesa 22.3.6: -1 is -32768, 1 is 32767, and 0 is 0.
int16_t store_clear_value(float v) { return int16_t((int(65535.0f * v) - 1) / 2); }

void run(Context& c, Accumulation& accumulation, const WindowBox& box) {
  accumulation.x0 = box.x0, accumulation.y0 = box.y0;
  accumulation.x1 = box.x1, accumulation.y1 = box.y1;
  const FloatEnvironment environment;
  accumulate(c.framebuffer, accumulation);
}

bool find_operation(GLenum op, AccumulationOperation& operation) {
  switch (op) {
  case GL_ACCUM: operation = AccumulationOperation::Accumulate; return true;
  case GL_LOAD: operation = AccumulationOperation::Load; return true;
  case GL_RETURN: operation = AccumulationOperation::Return; return true;
  case GL_MULT: operation = AccumulationOperation::Multiply; return true;
  case GL_ADD: operation = AccumulationOperation::Add; return true;
  default: return false;
  }
}

} // namespace

bool prepare_accumulation_clear(Context& c) {
  Framebuffer& f = c.framebuffer;
  if (f.accumulation_bits == 0 || c.bindings.draw) return false;
  const Vec4& value = c.state.accumulation.clear;
  bool zero = true;
  for (int i = 0; i < 4; ++i) zero = zero && store_clear_value(value[i]) == 0;
  if (zero && !f.accumulation) return false;
  f.make_accumulation();
  return true;
}

void clear_accumulation(Context& c, const WindowBox& box) {
  Accumulation accumulation{};
  accumulation.operation = AccumulationOperation::Clear;
  for (int i = 0; i < 4; ++i) accumulation.clear_value[i] = store_clear_value(c.state.accumulation.clear[i]);
  run(c, accumulation, box);
}

namespace gl {

void Accum(Context& c, GLenum op, GLfloat value) {
  Accumulation accumulation{};
  if (!find_operation(op, accumulation.operation)) return set_error(c, GL_INVALID_ENUM, "op");
  Framebuffer& f = c.framebuffer;
  if (!draw_target_complete(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  if (f.accumulation_bits == 0 || c.bindings.draw || c.bindings.read) // only the window has one
    return set_error(c, GL_INVALID_OPERATION);
  if (c.state.render_mode.mode != GL_RENDER) return;
  const ColorBufferState& color = c.state.color_buffer;
  const bool returns = accumulation.operation == AccumulationOperation::Return;
  if (returns && color.draw_buffer == GL_NONE) return;
  const WindowBox box = drawn_box(c.state.scissor, f.surface);
  if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
  std::copy(std::begin(color.mask), std::end(color.mask), accumulation.color_mask);
  accumulation.color_mask[3] = color.mask[3] && f.has_alpha; // without alpha it stays 1
  f.make_accumulation();
  const bool alone = accumulation.operation == AccumulationOperation::Multiply ||
                     accumulation.operation == AccumulationOperation::Add;
  accumulation.value = alone && c.specification_answers ? std::clamp(value, -1.0f, 1.0f) : value;
  if (!alone) flush_rendering(c); // the colors are needed
  run(c, accumulation, box);
  if (returns) f.unresolved = true;
}

void ClearAccum(Context& c, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  const auto clamp = [](float v) { return v > -1.0f ? (v > 1.0f ? 1.0f : v) : -1.0f; };
  c.state.accumulation.clear = {clamp(red), clamp(green), clamp(blue), clamp(alpha)};
}

} // namespace gl
} // namespace softgl
