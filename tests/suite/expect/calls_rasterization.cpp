// How points, lines and polygons are drawn (3.3 to 3.5).
#include "expect/calls.h"

namespace softgl::suite {

bool Machine::play_rasterization(const Call& call) {
  switch (call.command) {
  case Command::PointSize: state_.width.point = call.n(0); return true;
  case Command::LineWidth: state_.width.line = call.n(0); return true;
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
