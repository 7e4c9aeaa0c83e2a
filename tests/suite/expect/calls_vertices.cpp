// Vertices and the current values that they take (2.6, 2.7), rectangles (2.10).
#include "expect/calls.h"

namespace softgl::suite {
namespace {

// A color or normal of the command's type as a number of about [-1, 1] (table 2.9).
std::vector<double> unit_values(const Call& call) {
  std::string name = facts_of(call.command).name;
  if (name.ends_with("v")) name.pop_back();
  std::vector<double> v = values_of(call);
  const char type = name.back();
  const bool is_unsigned = name[name.size() - 2] == 'u';
  if (type == 'f' || type == 'd') return v;
  const int bits = type == 'b' ? 8 : type == 's' ? 16 : 32;
  for (double& x : v) x = is_unsigned ? x / (std::ldexp(1, bits) - 1) : signed_unit(x, bits);
  return v;
}

} // namespace

void Machine::color(double r, double g, double b, double a) {
  state_.current.color = {r, g, b, a}, state_.current.color_known = true;
  track_color();
}

bool Machine::play_vertices(const Call& call) {
  const std::string name = facts_of(call.command).name;
  if (call.command == Command::Begin) {
    open_ = true, mode_ = call.e(0);
  } else if (call.command == Command::End) {
    open_ = false, end();
  } else if (name.starts_with("Vertex") && call.command != Command::VertexPointer) {
    if (!open_) throw std::logic_error("a vertex that is not between glBegin and glEnd");
    vertices_.push_back(transform(vec4(values_of(call))));
  } else if (name.starts_with("Normal3")) {
    const std::vector<double> v = unit_values(call);
    state_.current.normal = {v[0], v[1], v[2]}, state_.current.normal_known = true;
  } else if (name.starts_with("Color3") || name.starts_with("Color4")) {
    const std::vector<double> v = unit_values(call);
    color(v[0], v[1], v[2], v.size() > 3 ? v[3] : 1);
  } else if (name.starts_with("EdgeFlag") && call.command != Command::EdgeFlagPointer) {
    state_.current.edge = values_of(call)[0] != 0, state_.current.edge_known = true;
  } else if (name.starts_with("TexCoord") && call.command != Command::TexCoordPointer) {
    state_.current.texture_coordinate[0] = vec4(values_of(call));
  } else if (name.starts_with("FogCoord")) {
    state_.current.fog_coordinate = values_of(call)[0];
  } else if (name.starts_with("Rect")) {
    std::vector<double> v = values_of(call);
    if (name.ends_with("v")) v = call.v(0), v.insert(v.end(), call.v(1).begin(), call.v(1).end());
    Script s; // 2.10: a polygon
    s.Begin(GL_POLYGON);
    s.Vertex2d(v[0], v[1]), s.Vertex2d(v[2], v[1]), s.Vertex2d(v[2], v[3]), s.Vertex2d(v[0], v[3]);
    s.End();
    for (const Call& c : s.calls) play(c);
  } else {
    return false;
  }
  return true;
}

} // namespace softgl::suite
