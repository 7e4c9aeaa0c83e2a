// How points, lines and polygons are drawn (3.3 to 3.5).
#include <algorithm>

#include "expect/calls.h"

namespace softgl::suite {

bool Machine::play_rasterization(const Call& call) {
  switch (call.command) {
  case Command::PointSize: state_.point.size = call.n(0); return true;
  case Command::PointParameterf:
    (call.e(0) == GL_POINT_SIZE_MIN ? state_.point.least : state_.point.greatest) = call.n(1);
    return true;
  case Command::PointParameterfv:
    if (call.e(0) != GL_POINT_DISTANCE_ATTENUATION) throw std::logic_error("glPointParameterfv of a number");
    std::copy_n(call.v(1).begin(), 3, state_.point.attenuation);
    return true;
  case Command::LineWidth: state_.line.width = call.n(0); return true;
  case Command::LineStipple:
    state_.line.stipple_factor = std::clamp(int(call.n(0)), 1, 256);
    state_.line.stipple_pattern = unsigned(call.n(1)) & 0xffff;
    return true;
  case Command::PolygonStipple: // unpacked as a bitmap of 32 x 32
    for (int i = 0; i < 1024; i++)
      state_.polygon_stipple[size_t(i)] = bitmap_bit(state_.unpack, call.v(0), 32, i % 32, i / 32);
    return true;
  case Command::PolygonOffset:
    state_.polygon.offset_factor = call.n(0), state_.polygon.offset_units = call.n(1);
    return true;
  case Command::PolygonMode:
    for (int back = 0; back < 2; back++)
      if (call.e(0) == GL_FRONT_AND_BACK || call.e(0) == GLenum(back ? GL_BACK : GL_FRONT))
        state_.polygon.mode[back] = call.e(1);
    return true;
  case Command::CullFace: state_.polygon.cull_face = call.e(0); return true;
  default: return false;
  }
}

} // namespace softgl::suite
