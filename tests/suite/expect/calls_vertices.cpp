// Vertices and the current values that they take (2.6, 2.7).
#include "expect/calls.h"

namespace softgl::suite {

void Machine::color(double r, double g, double b, double a) {
  state_.current.color = {r, g, b, a};
  track_color();
}

bool Machine::play_vertices(const Call& call) {
  const auto n = [&](size_t i) { return call.n(i); };
  const auto vertex = [&](const std::vector<double>& v) { vertices_.push_back(transform(vec4(v))); };
  const auto normal = [&](int bits) {
    const auto unit = [&](double x) { return bits ? signed_unit(x, bits) : x; };
    state_.current.normal = {unit(n(0)), unit(n(1)), unit(n(2))};
  };
  switch (call.command) {
  case Command::Begin: open_ = true, mode_ = call.e(0); return true;
  case Command::End: open_ = false, end(); return true;
  case Command::Vertex2f:
  case Command::Vertex3f:
  case Command::Vertex3d:
  case Command::Vertex4f: vertex(numbers_of(call, 0)); return true;
  case Command::Vertex3fv: vertex(call.v(0)); return true;
  case Command::Normal3d:
  case Command::Normal3f: normal(0); return true;
  case Command::Normal3fv: state_.current.normal = {call.v(0)[0], call.v(0)[1], call.v(0)[2]}; return true;
  case Command::Normal3b: normal(8); return true;
  case Command::Normal3s: normal(16); return true;
  case Command::Normal3i: normal(32); return true;
  case Command::Color3d:
  case Command::Color3f: color(n(0), n(1), n(2)); return true;
  case Command::Color4f: color(n(0), n(1), n(2), n(3)); return true;
  case Command::Color4fv: color(call.v(0)[0], call.v(0)[1], call.v(0)[2], call.v(0)[3]); return true;
  case Command::Color3ub: color(n(0) / 255, n(1) / 255, n(2) / 255); return true;
  case Command::Color4ub: color(n(0) / 255, n(1) / 255, n(2) / 255, n(3) / 255); return true;
  default: return false;
  }
}

} // namespace softgl::suite
