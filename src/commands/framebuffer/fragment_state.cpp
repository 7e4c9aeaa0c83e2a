// Fog (GL 1.5, 3.10), per-fragment operations (4.1), and the masks and buffers of the framebuffer
// (4.2, 4.3.2).
#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "snapshot/render_targets.h"

namespace softgl::gl {
namespace {

bool is_comparison(GLenum function) { return function >= GL_NEVER && function <= GL_ALWAYS; }

bool is_stencil_operation(GLenum operation) {
  switch (operation) {
  case GL_KEEP:
  case GL_ZERO:
  case GL_REPLACE:
  case GL_INCR:
  case GL_DECR:
  case GL_INVERT:
  case GL_INCR_WRAP:
  case GL_DECR_WRAP: return true;
  default: return false;
  }
}

bool is_face(GLenum face) { return face == GL_FRONT || face == GL_BACK || face == GL_FRONT_AND_BACK; }

/// The faces that glStencilFunc, glStencilOp and glStencilMask set.
template <class Set> void for_active_faces(Context& c, Set set) {
  StencilState& stencil = edit<&State::stencil>(c);
  if (stencil.active_face == GL_BACK) return set(stencil.two_side_back);
  set(stencil.front);
  set(stencil.back);
}

template <class Set> void for_faces(Context& c, GLenum face, Set set) {
  StencilState& stencil = edit<&State::stencil>(c);
  if (face != GL_BACK) set(stencil.front);
  if (face != GL_FRONT) set(stencil.back);
}

void set_function(StencilFace& face, GLenum function, GLint reference, GLuint mask) {
  face.function = function;
  face.reference = reference;
  face.value_mask = mask;
}

void set_operations(StencilFace& face, GLenum fail, GLenum depth_fail, GLenum depth_pass) {
  face.fail = fail;
  face.depth_fail = depth_fail;
  face.depth_pass = depth_pass;
}

bool is_blend_equation(GLenum mode) {
  return mode == GL_FUNC_ADD || mode == GL_FUNC_SUBTRACT || mode == GL_FUNC_REVERSE_SUBTRACT ||
         mode == GL_MIN || mode == GL_MAX;
}

bool is_blend_factor(GLenum factor, bool source) {
  switch (factor) {
  case GL_ZERO:
  case GL_ONE:
  case GL_SRC_COLOR:
  case GL_ONE_MINUS_SRC_COLOR:
  case GL_DST_COLOR:
  case GL_ONE_MINUS_DST_COLOR:
  case GL_SRC_ALPHA:
  case GL_ONE_MINUS_SRC_ALPHA:
  case GL_DST_ALPHA:
  case GL_ONE_MINUS_DST_ALPHA:
  case GL_CONSTANT_COLOR:
  case GL_ONE_MINUS_CONSTANT_COLOR:
  case GL_CONSTANT_ALPHA:
  case GL_ONE_MINUS_CONSTANT_ALPHA: return true;
  case GL_SRC_ALPHA_SATURATE: return source;
  default: return false;
  }
}

// There is one color buffer: front left. OSMesa lets GL_BACK and GL_BACK_LEFT mean it, too.
enum class BufferName { Unknown, Absent, Present };
BufferName classify_buffer(GLenum buffer) {
  switch (buffer) {
  case GL_FRONT:
  case GL_LEFT:
  case GL_FRONT_LEFT:
  case GL_BACK:
  case GL_BACK_LEFT: return BufferName::Present;
  case GL_RIGHT:
  case GL_FRONT_RIGHT:
  case GL_BACK_RIGHT:
  case GL_AUX0:
  case GL_AUX1:
  case GL_AUX2:
  case GL_AUX3: return BufferName::Absent;
  default:
    return buffer >= GL_COLOR_ATTACHMENT0 && buffer <= GL_COLOR_ATTACHMENT31 ? BufferName::Absent
                                                                             : BufferName::Unknown;
  }
}

/// The draw or read buffer of a framebuffer object (GL_ARB_framebuffer_object, 4.2.1, 4.3.2): why it cannot
/// be that.
Refusal check_attachment(GLenum buffer, const char* argument) {
  if (buffer == GL_NONE || buffer - GL_COLOR_ATTACHMENT0 < GLenum(kMaxColorAttachments)) return {};
  const bool known = buffer == GL_FRONT_AND_BACK || classify_buffer(buffer) != BufferName::Unknown;
  return known ? Refusal{GL_INVALID_OPERATION} : Refusal{GL_INVALID_ENUM, argument};
}

} // namespace

void Fog(Context& c, GLenum pname, const GLfloat* params) {
  FogState& fog = edit<&State::fog>(c);
  const float v = params[0];
  switch (pname) {
  case GL_FOG_MODE:
    if (v != float(GL_LINEAR) && v != float(GL_EXP) && v != float(GL_EXP2))
      return set_error(c, GL_INVALID_ENUM, "params");
    fog.mode = GLenum(v);
    break;
  case GL_FOG_DENSITY:
    if (v < 0.0f) return set_error(c, GL_INVALID_VALUE, "params");
    fog.density = v;
    break;
  case GL_FOG_START: fog.start = v; break;
  case GL_FOG_END: fog.end = v; break;
  case GL_FOG_INDEX: fog.index = v; break;
  case GL_FOG_COLOR: fog.color = {params[0], params[1], params[2], params[3]}; break;
  case GL_FOG_COORDINATE_SOURCE:
    if (v != float(GL_FOG_COORDINATE) && v != float(GL_FRAGMENT_DEPTH))
      return set_error(c, GL_INVALID_ENUM, "params");
    fog.coordinate_source = GLenum(v);
    break;
  case GL_FOG_DISTANCE_MODE_NV:
    if (v != float(GL_EYE_RADIAL_NV) && v != float(GL_EYE_PLANE) && v != float(GL_EYE_PLANE_ABSOLUTE_NV))
      return set_error(c, GL_INVALID_ENUM, "params");
    fog.distance_mode = GLenum(v);
    break;
  default: return set_error(c, GL_INVALID_ENUM, "pname");
  }
}

void Scissor(Context& c, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (const char* wrong = first_wrong({{"width", width < 0}, {"height", height < 0}}))
    return set_error(c, GL_INVALID_VALUE, wrong);
  ScissorState& scissor = edit<&State::scissor>(c);
  scissor.x = x, scissor.y = y, scissor.width = width, scissor.height = height;
}

void SampleCoverage(Context& c, GLfloat value, GLboolean invert) {
  MultisampleState& multisample = edit<&State::multisample>(c);
  multisample.coverage_value = value > 0.0f ? (value > 1.0f ? 1.0f : value) : 0.0f;
  multisample.coverage_invert = invert != 0;
}

void ClampColor(Context& c, GLenum target, GLenum clamp) {
  if (clamp != GL_TRUE && clamp != GL_FALSE && clamp != GL_FIXED_ONLY)
    return set_error(c, GL_INVALID_ENUM, "clamp");
  switch (target) {
  case GL_CLAMP_VERTEX_COLOR: edit<&State::lighting>(c).clamp_vertex_color = clamp; return;
  case GL_CLAMP_FRAGMENT_COLOR: edit<&State::color_buffer>(c).clamp_fragment_color = clamp; return;
  case GL_CLAMP_READ_COLOR: edit<&State::color_buffer>(c).clamp_read_color = clamp; return;
  default: set_error(c, GL_INVALID_ENUM, "target");
  }
}

void AlphaFunc(Context& c, GLenum func, GLfloat ref) {
  if (!is_comparison(func)) return set_error(c, GL_INVALID_ENUM, "func");
  ColorBufferState& color = edit<&State::color_buffer>(c);
  color.alpha_function = func;
  color.alpha_reference = ref;
}

void StencilFunc(Context& c, GLenum func, GLint ref, GLuint mask) {
  if (!is_comparison(func)) return set_error(c, GL_INVALID_ENUM, "func");
  for_active_faces(c, [&](StencilFace& face) { set_function(face, func, ref, mask); });
}

void StencilFuncSeparate(Context& c, GLenum face, GLenum func, GLint ref, GLuint mask) {
  if (const char* wrong = first_wrong({{"face", !is_face(face)}, {"func", !is_comparison(func)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  for_faces(c, face, [&](StencilFace& f) { set_function(f, func, ref, mask); });
}

void StencilFuncSeparateATI(Context& c, GLenum frontfunc, GLenum backfunc, GLint ref, GLuint mask) {
  if (const char* wrong =
          first_wrong({{"frontfunc", !is_comparison(frontfunc)}, {"backfunc", !is_comparison(backfunc)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  StencilState& stencil = edit<&State::stencil>(c);
  set_function(stencil.front, frontfunc, ref, mask);
  set_function(stencil.back, backfunc, ref, mask);
}

void StencilOp(Context& c, GLenum fail, GLenum zfail, GLenum zpass) {
  if (const char* wrong = first_wrong({{"fail", !is_stencil_operation(fail)},
                                       {"zfail", !is_stencil_operation(zfail)},
                                       {"zpass", !is_stencil_operation(zpass)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  for_active_faces(c, [&](StencilFace& face) { set_operations(face, fail, zfail, zpass); });
}

void StencilOpSeparate(Context& c, GLenum face, GLenum sfail, GLenum dpfail, GLenum dppass) {
  if (const char* wrong = first_wrong({{"face", !is_face(face)},
                                       {"sfail", !is_stencil_operation(sfail)},
                                       {"dpfail", !is_stencil_operation(dpfail)},
                                       {"dppass", !is_stencil_operation(dppass)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  for_faces(c, face, [&](StencilFace& f) { set_operations(f, sfail, dpfail, dppass); });
}

void ActiveStencilFaceEXT(Context& c, GLenum face) {
  if (face != GL_FRONT && face != GL_BACK) return set_error(c, GL_INVALID_ENUM, "face");
  edit<&State::stencil>(c).active_face = face;
}

void DepthFunc(Context& c, GLenum func) {
  if (!is_comparison(func)) return set_error(c, GL_INVALID_ENUM, "func");
  edit<&State::depth>(c).function = func;
}

void DepthBoundsEXT(Context& c, GLclampd zmin, GLclampd zmax) {
  if (zmin > zmax) return set_error(c, GL_INVALID_VALUE, "zmax");
  const auto clamp = [](double v) { return v > 0.0 ? (v > 1.0 ? 1.0 : v) : 0.0; };
  DepthState& depth = edit<&State::depth>(c);
  depth.least_bound = clamp(zmin);
  depth.greatest_bound = clamp(zmax);
}

void BlendFuncSeparate(Context& c, GLenum source_rgb, GLenum destination_rgb, GLenum source_alpha,
                       GLenum destination_alpha) {
  if (const char* wrong = first_wrong({{"sfactorRGB", !is_blend_factor(source_rgb, true)},
                                       {"dfactorRGB", !is_blend_factor(destination_rgb, false)},
                                       {"sfactorAlpha", !is_blend_factor(source_alpha, true)},
                                       {"dfactorAlpha", !is_blend_factor(destination_alpha, false)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  ColorBufferState& color = edit<&State::color_buffer>(c);
  color.blend_source_rgb = source_rgb;
  color.blend_source_alpha = source_alpha;
  color.blend_destination_rgb = destination_rgb;
  color.blend_destination_alpha = destination_alpha;
}
void BlendFunc(Context& c, GLenum source, GLenum destination) {
  if (const char* wrong = first_wrong(
          {{"sfactor", !is_blend_factor(source, true)}, {"dfactor", !is_blend_factor(destination, false)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  BlendFuncSeparate(c, source, destination, source, destination);
}

void BlendEquationSeparate(Context& c, GLenum mode_rgb, GLenum mode_alpha) {
  if (const char* wrong = first_wrong(
          {{"modeRGB", !is_blend_equation(mode_rgb)}, {"modeAlpha", !is_blend_equation(mode_alpha)}}))
    return set_error(c, GL_INVALID_ENUM, wrong);
  ColorBufferState& color = edit<&State::color_buffer>(c);
  color.blend_equation = mode_rgb;
  color.blend_equation_alpha = mode_alpha;
}
void BlendEquation(Context& c, GLenum mode) {
  if (!is_blend_equation(mode)) return set_error(c, GL_INVALID_ENUM, "mode");
  BlendEquationSeparate(c, mode, mode);
}

void BlendColor(Context& c, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  edit<&State::color_buffer>(c).blend_color = {red, green, blue, alpha};
}

void LogicOp(Context& c, GLenum opcode) {
  if (opcode < GL_CLEAR || opcode > GL_SET) return set_error(c, GL_INVALID_ENUM, "opcode");
  edit<&State::color_buffer>(c).logic_op_mode = opcode;
}

void DrawBuffer(Context& c, GLenum buffer) {
  if (c.bindings.draw) {
    if (const Refusal refusal = check_attachment(buffer, "buf")) return set_error(c, refusal);
    if (c.bindings.draw->draw_buffer == buffer) return;
    draw_what_waits(c);
    c.bindings.draw->draw_buffer = buffer;
    return framebuffers_changed(c);
  }
  if (buffer != GL_NONE && buffer != GL_FRONT_AND_BACK) {
    const BufferName name = classify_buffer(buffer);
    if (name == BufferName::Unknown) return set_error(c, GL_INVALID_ENUM, "buf");
    if (name == BufferName::Absent) return set_error(c, GL_INVALID_OPERATION);
  }
  edit<&State::color_buffer>(c).draw_buffer = buffer;
}

void ReadBuffer(Context& c, GLenum buffer) {
  if (c.bindings.read) {
    if (const Refusal refusal = check_attachment(buffer, "src")) return set_error(c, refusal);
    draw_what_waits(c); // the draw framebuffer may be the same object, and then its completeness changes
    c.bindings.read->read_buffer = buffer;
    return framebuffers_changed(c);
  }
  const BufferName name = classify_buffer(buffer);
  if (name == BufferName::Unknown) return set_error(c, GL_INVALID_ENUM, "src");
  if (name == BufferName::Absent) return set_error(c, GL_INVALID_OPERATION);
  c.state.pixel_mode.read_buffer = buffer;
}

void ColorMask(Context& c, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
  bool* mask = edit<&State::color_buffer>(c).mask;
  mask[0] = red != 0, mask[1] = green != 0, mask[2] = blue != 0, mask[3] = alpha != 0;
}
void IndexMask(Context& c, GLuint mask) { c.state.color_buffer.index_mask = mask; }
void DepthMask(Context& c, GLboolean flag) { edit<&State::depth>(c).mask = flag != 0; }
void StencilMask(Context& c, GLuint mask) {
  for_active_faces(c, [&](StencilFace& face) { face.write_mask = mask; });
}
void StencilMaskSeparate(Context& c, GLenum face, GLuint mask) {
  if (!is_face(face)) return set_error(c, GL_INVALID_ENUM, "face");
  for_faces(c, face, [&](StencilFace& f) { f.write_mask = mask; });
}

} // namespace softgl::gl
