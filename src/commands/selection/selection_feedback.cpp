// Selection and feedback (GL 1.5, 5.2 and 5.3).
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"
#include "snapshot/feedback.h"

namespace softgl {
namespace {

GLint leave_mode(RenderModeState& m) {
  GLint result = 0;
  if (m.mode == GL_SELECT) {
    if (!SOFTGL_FAULT(last_record_lost)) write_hit_record(m);
    const bool silent = SOFTGL_FAULT(selection_overflow_silent);
    result = m.written > uint64_t(m.selection_size) && !silent ? -1 : m.hits;
  } else if (m.mode == GL_FEEDBACK) {
    const bool silent = SOFTGL_FAULT(feedback_overflow_silent);
    result = m.written > uint64_t(m.feedback_size) && !silent ? -1 : GLint(m.written);
  }
  if (!SOFTGL_FAULT(buffer_goes_on)) m.written = 0;
  m.hits = 0;
  if (!SOFTGL_FAULT(names_stay)) m.name_stack_depth = 0;
  return result;
}

} // namespace

namespace gl {

GLint RenderMode(Context& c, GLenum mode) {
  RenderModeState& m = c.state.render_mode;
  if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK)
    return set_error(c, GL_INVALID_ENUM, "mode"), 0;
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
  if (size < 0) return set_error(c, GL_INVALID_VALUE, "size");
  if (m.mode == GL_SELECT && !SOFTGL_FAULT(select_buffer_any_time)) return set_error(c, GL_INVALID_OPERATION);
  m.selection_buffer = buffer;
  m.selection_size = size;
  m.hit = false;
  m.least_depth = 1, m.greatest_depth = 0;
}

void FeedbackBuffer(Context& c, GLsizei size, GLenum type, GLfloat* buffer) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode == GL_FEEDBACK && !SOFTGL_FAULT(feedback_buffer_any_time))
    return set_error(c, GL_INVALID_OPERATION);
  if (const char* wrong = first_wrong({{"size", size < 0}, {"buffer", !buffer && size > 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (type != GL_2D && type != GL_3D && type != GL_3D_COLOR && type != GL_3D_COLOR_TEXTURE &&
      type != GL_4D_COLOR_TEXTURE)
    return set_error(c, GL_INVALID_ENUM, "type");
  m.feedback_buffer = buffer;
  m.feedback_size = size;
  m.feedback_type = type;
}

void PassThrough(Context& c, GLfloat token) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_FEEDBACK || SOFTGL_FAULT(mark_not_written)) return;
  feed_back_token(m, GL_PASS_THROUGH_TOKEN);
  feed_back_value(m, token);
}

void InitNames(Context& c) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  if (!SOFTGL_FAULT(init_without_record)) write_hit_record(m);
  m.name_stack_depth = 0;
}

void LoadName(Context& c, GLuint name) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  if (m.name_stack_depth == 0) return set_error(c, GL_INVALID_OPERATION);
  if (!SOFTGL_FAULT(load_without_record)) write_hit_record(m);
  if (!SOFTGL_FAULT(load_ignored)) m.name[m.name_stack_depth - 1] = name;
}

void PushName(Context& c, GLuint name) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT) return;
  if (!SOFTGL_FAULT(push_without_record)) write_hit_record(m);
  if (m.name_stack_depth == kMaxNameStackDepth - (SOFTGL_FAULT(names_one_less) ? 1 : 0))
    return set_error(c, GL_STACK_OVERFLOW);
  m.name[m.name_stack_depth++] = name;
}

void PopName(Context& c) {
  RenderModeState& m = c.state.render_mode;
  if (m.mode != GL_SELECT && !SOFTGL_FAULT(pop_in_any_mode)) return;
  if (!SOFTGL_FAULT(pop_without_record)) write_hit_record(m);
  if (m.name_stack_depth == 0) return set_error(c, GL_STACK_UNDERFLOW);
  --m.name_stack_depth;
}

} // namespace gl
} // namespace softgl
