// What is switched on and off, and the stack of attributes (6.1.14).
#include <tuple>

#include "expect/calls.h"

namespace softgl::suite {

void Machine::enable(GLenum name, bool on) {
  State& s = state_;
  if (name >= GL_LIGHT0 && name <= GL_LIGHT7) {
    s.lighting.enabled[name - GL_LIGHT0] = on;
    return;
  }
  if (name >= GL_CLIP_PLANE0 && name < GL_CLIP_PLANE0 + kClipPlanes) {
    s.transform.clip_enabled[name - GL_CLIP_PLANE0] = on;
    return;
  }
  switch (name) {
  case GL_LIGHTING: s.lighting.lighting = on; break;
  case GL_COLOR_MATERIAL: s.lighting.color_material = on, track_color(); break;
  case GL_NORMALIZE: s.transform.normalize = on; break;
  case GL_RESCALE_NORMAL: s.transform.rescale_normal = on; break;
  case GL_CULL_FACE: s.polygon.cull = on; break;
  case GL_DEPTH_TEST: s.depth.test = on; break;
  case GL_ALPHA_TEST: s.color_buffer.alpha_test = on; break;
  case GL_SCISSOR_TEST: s.scissor.test = on; break;
  case GL_STENCIL_TEST: s.stencil.test = on; break;
  case GL_COLOR_LOGIC_OP: s.color_buffer.logic = on; break;
  case GL_POLYGON_STIPPLE: s.polygon.stippled = on; break;
  case GL_POLYGON_SMOOTH: s.polygon.smooth = on; break;
  case GL_POINT_SMOOTH: s.point.smooth = on; break;
  case GL_LINE_SMOOTH: s.line.smooth = on; break;
  case GL_LINE_STIPPLE: s.line.stippled = on; break;
  case GL_POLYGON_OFFSET_POINT: s.polygon.offset_point = on; break;
  case GL_POLYGON_OFFSET_LINE: s.polygon.offset_line = on; break;
  case GL_POLYGON_OFFSET_FILL: s.polygon.offset_fill = on; break;
  case GL_BLEND: s.color_buffer.blend = on; break;
  case GL_FOG: s.fog.on = on; break;
  case GL_DITHER: s.color_buffer.dither = on; break;
  default:
    if (!enable_texture(name, on) && !enable_map(name, on))
      throw std::logic_error("glEnable of what the machine does not know");
  }
}

bool Machine::play_attributes(const Call& call) {
  switch (call.command) {
  case Command::Enable: enable(call.e(0), true); return true;
  case Command::Disable: enable(call.e(0), false); return true;
  case Command::PushAttrib:
    state_.saved.push_back({GLbitfield(call.n(0)), state_});
    raster_saved_.push_back({raster_position_, raster_position_valid_});
    return true;
  case Command::PopAttrib:
    if (state_.saved.empty()) throw std::logic_error("glPopAttrib without glPushAttrib");
    restore(state_, state_.saved.back());
    if (state_.saved.back().mask & GL_CURRENT_BIT)
      std::tie(raster_position_, raster_position_valid_) = raster_saved_.back();
    raster_saved_.pop_back();
    state_.saved.pop_back();
    track_color();
    return true;
  case Command::PushClientAttrib:
    state_.saved_clients.push_back({GLbitfield(call.n(0)), state_});
    return true;
  case Command::PopClientAttrib:
    if (state_.saved_clients.empty()) throw std::logic_error("glPopClientAttrib without glPushClientAttrib");
    restore(state_, state_.saved_clients.back());
    state_.saved_clients.pop_back();
    return true;
  default: return false;
  }
}

} // namespace softgl::suite
