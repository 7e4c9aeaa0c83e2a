// Fog (3.10), the operations on fragments, and the whole framebuffer (4.1, 4.2).
#include <algorithm>
#include <utility>

#include "expect/calls.h"

namespace softgl::suite {

void Machine::fog(GLenum name, const std::vector<double>& v) {
  FogState& f = state_.fog;
  switch (name) {
  case GL_FOG_MODE: f.mode = GLenum(v[0]); break;
  case GL_FOG_DENSITY: f.density = v[0]; break;
  case GL_FOG_START: f.start = v[0]; break;
  case GL_FOG_END: f.end = v[0]; break;
  case GL_FOG_COORD_SRC: f.source = GLenum(v[0]); break;
  case GL_FOG_COLOR: {
    double c[4];
    for (size_t i = 0; i < 4; i++) c[i] = std::clamp(v[i], 0.0, 1.0);
    f.color = {c[0], c[1], c[2], c[3]};
    break;
  }
  default: throw std::logic_error("glFog of what the machine does not know");
  }
}

bool Machine::play_fragments(const Call& call) {
  ColorBufferState& color = state_.color_buffer;
  DepthState& depth = state_.depth;
  StencilState& stencil = state_.stencil;
  switch (call.command) {
  case Command::Fogf:
  case Command::Fogi: fog(call.e(0), numbers_of(call, 1)); return true;
  case Command::Fogfv: fog(call.e(0), call.v(1)); return true;
  case Command::Fogiv: { // a color has the numbers of table 2.9
    std::vector<double> v = call.v(1);
    if (call.e(0) == GL_FOG_COLOR)
      for (double& x : v) x = signed_unit(x, 32);
    fog(call.e(0), v);
    return true;
  }
  case Command::AlphaFunc: color.alpha_function = call.e(0), color.alpha_reference = call.n(1); return true;
  case Command::BlendFunc:
    std::fill(color.source, color.source + 2, call.e(0));
    std::fill(color.destination, color.destination + 2, call.e(1));
    return true;
  case Command::BlendFuncSeparate:
    for (size_t i = 0; i < 2; i++) color.source[i] = call.e(2 * i), color.destination[i] = call.e(2 * i + 1);
    return true;
  case Command::BlendEquation: color.equation = call.e(0); return true;
  case Command::BlendColor: {
    double c[4];
    for (size_t k = 0; k < 4; k++) c[k] = std::clamp(call.n(k), 0.0, 1.0);
    color.constant = {c[0], c[1], c[2], c[3]};
    return true;
  }
  case Command::LogicOp: color.operation = call.e(0); return true;
  case Command::ColorMask:
    for (size_t i = 0; i < 4; i++) color.mask[i] = call.n(i) != 0;
    return true;
  case Command::DrawBuffer: // what the window's buffer is called differs between bindings
    if (call.e(0) != GL_NONE && call.e(0) != GL_FRONT_AND_BACK)
      throw std::logic_error("glDrawBuffer of what a window need not have");
    color.drawn = call.e(0) != GL_NONE;
    return true;
  case Command::Scissor:
    for (size_t i = 0; i < 4; i++) state_.scissor.box[i] = int(call.n(i));
    return true;
  case Command::StencilFunc:
    stencil.function = call.e(0), stencil.reference = int(call.n(1)), stencil.mask = unsigned(call.n(2));
    return true;
  case Command::StencilOp:
    stencil.fail = call.e(0), stencil.depth_fail = call.e(1), stencil.depth_pass = call.e(2);
    return true;
  case Command::StencilMask: stencil.write_mask = unsigned(call.n(0)); return true;
  case Command::ClearStencil: stencil.clear = int(call.n(0)); return true;
  case Command::DepthFunc: depth.function = call.e(0); return true;
  case Command::DepthMask: depth.mask = call.n(0) != 0; return true;
  case Command::ClearDepth: depth.clear = call.n(0); return true;
  case Command::ClearColor: color.clear_color = vec4(numbers_of(call, 0)); return true;
  case Command::ClearAccum: state_.accumulation_clear = vec4(numbers_of(call, 0)); return true;
  case Command::Accum:
    if (render_mode_.mode == GL_RENDER) raster_.accumulate(state_, call.e(0), call.n(1));
    return true;
  case Command::BeginQuery:
    query_ = GLuint(call.n(1)), queries_[query_] = raster_.passed = {0, 0}, complete_.erase(query_);
    return true;
  case Command::EndQuery: queries_[std::exchange(query_, 0)] = raster_.passed; return true;
  case Command::DeleteQueries:
    for (const double name : call.arguments[1].numbers) queries_.erase(GLuint(name));
    return true;
  case Command::Clear: // nothing changes while primitives are selected or fed back (corollary 18)
    if (render_mode_.mode == GL_RENDER) raster_.clear(state_, GLbitfield(call.n(0)));
    return true;
  case Command::Hint:
  case Command::Flush:
  case Command::Finish: return true;
  default: return false;
  }
}

} // namespace softgl::suite
