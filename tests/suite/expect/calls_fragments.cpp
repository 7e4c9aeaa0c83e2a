// Fog (3.10), the operations on fragments, and the whole framebuffer (4.1, 4.2).
#include "expect/calls.h"

namespace softgl::suite {

void Machine::fog(GLenum name, const std::vector<double>& v) {
  FogState& f = state_.fog;
  switch (name) {
  case GL_FOG_MODE: f.mode = GLenum(v[0]); break;
  case GL_FOG_DENSITY: f.density = v[0]; break;
  case GL_FOG_START: f.start = v[0]; break;
  case GL_FOG_END: f.end = v[0]; break;
  case GL_FOG_COLOR: f.color = vec4(v); break;
  default: throw std::logic_error("glFog of what the machine does not know");
  }
}

bool Machine::play_fragments(const Call& call) {
  ColorBufferState& color = state_.color_buffer;
  DepthState& depth = state_.depth;
  switch (call.command) {
  case Command::Fogf:
  case Command::Fogi: fog(call.e(0), numbers_of(call, 1)); return true;
  case Command::Fogfv: fog(call.e(0), call.v(1)); return true;
  case Command::AlphaFunc: color.alpha_function = call.e(0), color.alpha_reference = call.n(1); return true;
  case Command::BlendFunc: color.source = call.e(0), color.destination = call.e(1); return true;
  case Command::DepthFunc: depth.function = call.e(0); return true;
  case Command::DepthMask: depth.mask = call.n(0) != 0; return true;
  case Command::ClearDepth: depth.clear = call.n(0); return true;
  case Command::ClearColor: color.clear_color = vec4(numbers_of(call, 0)); return true;
  case Command::Clear: raster_.clear(state_, GLbitfield(call.n(0))); return true;
  case Command::Hint:
  case Command::Flush:
  case Command::Finish: return true;
  default: return false;
  }
}

} // namespace softgl::suite
