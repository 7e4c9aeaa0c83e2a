// Matrix commands (GL 1.5, 2.11.2). Double and transposed forms arrive as float columns.
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl::gl {
namespace {

// The current matrix stack, whose top is about to change.
MatrixStack& edit_stack(Context& c) {
  const GLenum mode = c.state.transform.matrix_mode;
  c.dirty |= mode == GL_PROJECTION ? kDirtyProjection
             : mode == GL_TEXTURE  ? kDirtyTextureMatrices
                                   : kDirtyModelview;
  return c.matrices.current(c.state);
}
Matrix& edit_matrix(Context& c) { return edit_stack(c).top(); }

} // namespace

void MatrixMode(Context& c, GLenum mode) {
  if (mode != GL_MODELVIEW && mode != GL_PROJECTION && mode != GL_TEXTURE)
    return set_error(c, GL_INVALID_ENUM, "mode");
  c.state.transform.matrix_mode = mode;
}

void LoadIdentity(Context& c) { set_identity(edit_matrix(c)); }
void LoadMatrix(Context& c, const float* m) {
  if (m) load(edit_matrix(c), m);
}
void MultMatrix(Context& c, const float* m) {
  if (SOFTGL_FAULT(multiplied_from_left) && m) {
    Matrix left;
    load(left, m);
    edit_matrix(c) = product(left, edit_matrix(c));
    return;
  }
  if (m) multiply(edit_matrix(c), m);
}
void Rotate(Context& c, float angle, float x, float y, float z) {
  rotate(edit_matrix(c), SOFTGL_FAULT(rotates_clockwise) ? -angle : angle, x, y, z);
}
void Translate(Context& c, float x, float y, float z) { translate(edit_matrix(c), x, y, z); }
void Scale(Context& c, float x, float y, float z) { scale(edit_matrix(c), x, y, z); }

void Frustum(Context& c, float left, float right, float bottom, float top, float near_value,
             float far_value) {
  if (const char* wrong = first_wrong({{"zNear", near_value <= 0.0f},
                                       {"zFar", far_value <= 0.0f || near_value == far_value},
                                       {"right", left == right},
                                       {"top", bottom == top}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (SOFTGL_FAULT(frustum_symmetric)) right = 0.5f * (right - left), left = -right;
  frustum(edit_matrix(c), left, right, bottom, top, near_value, far_value);
}
void Ortho(Context& c, float left, float right, float bottom, float top, float near_value, float far_value) {
  if (const char* wrong =
          first_wrong({{"right", left == right}, {"top", bottom == top}, {"zFar", near_value == far_value}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  if (SOFTGL_FAULT(ortho_replaces)) set_identity(edit_matrix(c));
  ortho(edit_matrix(c), left, right, bottom, top, near_value, far_value);
}

void PushMatrix(Context& c) {
  MatrixStack& stack = c.matrices.current(c.state);
  int limit = kMaxModelviewDepth;
  if (c.state.transform.matrix_mode == GL_PROJECTION) limit = kMaxProjectionDepth;
  if (c.state.transform.matrix_mode == GL_TEXTURE) limit = kMaxTextureDepth;
  if (stack.depth() >= limit && !SOFTGL_FAULT(stack_overflow_ignored)) return set_error(c, GL_STACK_OVERFLOW);
  settle_history(stack.top());
  stack.entry.push_back(SOFTGL_FAULT(push_is_identity) ? Matrix() : Matrix(stack.top()));
}
void PopMatrix(Context& c) {
  if (c.matrices.current(c.state).depth() == 1)
    return SOFTGL_FAULT(stack_underflow_silent) ? void() : set_error(c, GL_STACK_UNDERFLOW);
  if (SOFTGL_FAULT(pop_keeps_projection) && c.state.transform.matrix_mode == GL_PROJECTION) {
    MatrixStack& stack = c.matrices.current(c.state);
    stack.entry[size_t(stack.depth() - 2)] = stack.top();
  }
  edit_stack(c).entry.pop_back();
}

} // namespace softgl::gl
