// Lights, materials and how colors follow them (2.14).
#include "expect/calls.h"

namespace softgl::suite {
namespace {

Vec3 eye_direction(const Matrix4& m, const Vec3& d) {
  const Vec4 v = m * Vec4{d.x, d.y, d.z, 0};
  return v.xyz();
}

std::vector<double> signed_units(std::vector<double> integers) {
  for (double& x : integers) x = signed_unit(x, 32);
  return integers;
}

} // namespace

void Machine::light(const Call& call, const std::vector<double>& v) {
  spec::LightBounds& l = state_.lighting.light[call.e(0) - GL_LIGHT0];
  spec::Light& p = l.parameters;
  const Matrix4& m = state_.modelview.back();
  switch (call.e(1)) {
  case GL_AMBIENT: p.ambient = {v[0], v[1], v[2]}; break;
  case GL_DIFFUSE: p.diffuse = {v[0], v[1], v[2]}; break;
  case GL_SPECULAR: p.specular = {v[0], v[1], v[2]}; break;
  case GL_POSITION: {
    const Vec4 object = vec4(v);
    p.position = m * object;
    const Interval eye[3] = {row_times(m, 0, object), row_times(m, 1, object), row_times(m, 2, object)};
    const Interval by = p.position.w == 0 ? Interval(1) : Interval(1 / p.position.w);
    l.position = {eye[0] * by, eye[1] * by, eye[2] * by};
    break;
  }
  case GL_SPOT_DIRECTION: {
    // Transformed by the upper leftmost 3x3 of the modelview (2.14.2).
    p.spot_direction = eye_direction(m, {v[0], v[1], v[2]});
    const Vec4 d{v[0], v[1], v[2], 0};
    l.spot_direction = {row_times(m, 0, d), row_times(m, 1, d), row_times(m, 2, d)};
    break;
  }
  case GL_SPOT_EXPONENT: p.spot_exponent = v[0]; break;
  case GL_SPOT_CUTOFF: p.spot_cutoff = v[0]; break;
  case GL_CONSTANT_ATTENUATION: p.constant_attenuation = v[0]; break;
  case GL_LINEAR_ATTENUATION: p.linear_attenuation = v[0]; break;
  case GL_QUADRATIC_ATTENUATION: p.quadratic_attenuation = v[0]; break;
  default: throw std::logic_error("glLight of what the machine does not know");
  }
}

void Machine::light_model(GLenum name, const std::vector<double>& v) {
  spec::LightModel& m = state_.lighting.model;
  switch (name) {
  case GL_LIGHT_MODEL_AMBIENT: m.ambient = {v[0], v[1], v[2]}; break;
  case GL_LIGHT_MODEL_LOCAL_VIEWER: m.local_viewer = v[0] != 0; break;
  case GL_LIGHT_MODEL_TWO_SIDE: m.two_sided = v[0] != 0; break;
  case GL_LIGHT_MODEL_COLOR_CONTROL: m.separate_specular = v[0] == GL_SEPARATE_SPECULAR_COLOR; break;
  default: throw std::logic_error("glLightModel of what the machine does not know");
  }
}

bool Machine::tracks(int face, GLenum name) const {
  const LightingState& l = state_.lighting;
  if (!l.color_material) return false;
  if (l.tracked_face != GL_FRONT_AND_BACK && l.tracked_face != GLenum(face ? GL_BACK : GL_FRONT))
    return false;
  return l.tracked == name ||
         (l.tracked == GL_AMBIENT_AND_DIFFUSE && (name == GL_AMBIENT || name == GL_DIFFUSE));
}

void Machine::set_material(int face, GLenum name, const std::vector<double>& v) {
  spec::Material& m = state_.lighting.material[face];
  switch (name) {
  case GL_AMBIENT: m.ambient = vec4(v); break;
  case GL_DIFFUSE: m.diffuse = vec4(v); break;
  case GL_SPECULAR: m.specular = vec4(v); break;
  case GL_EMISSION: m.emission = vec4(v); break;
  case GL_SHININESS: m.shininess = v[0]; break;
  default: throw std::logic_error("glMaterial of what the machine does not know");
  }
}

void Machine::material(GLenum face, GLenum name, const std::vector<double>& v) {
  if (name == GL_AMBIENT_AND_DIFFUSE) {
    material(face, GL_AMBIENT, v), material(face, GL_DIFFUSE, v);
    return;
  }
  for (int i = 0; i < 2; i++)
    if (face == GL_FRONT_AND_BACK || face == GLenum(i ? GL_BACK : GL_FRONT))
      if (!tracks(i, name)) set_material(i, name, v);
}

void Machine::track_color() {
  const Vec4& c = state_.current.color;
  for (int face = 0; face < 2; face++)
    for (GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
      if (tracks(face, name)) set_material(face, name, {c.x, c.y, c.z, c.w});
}

bool Machine::play_lighting(const Call& call) {
  switch (call.command) {
  case Command::Lightf:
  case Command::Lighti: light(call, numbers_of(call, 2)); return true;
  case Command::Lightfv: light(call, call.v(2)); return true;
  case Command::Lightiv: {
    // Colors map the whole range of integers to [-1, 1] (table 2.9); other values are taken as they are.
    const bool color = call.e(1) == GL_AMBIENT || call.e(1) == GL_DIFFUSE || call.e(1) == GL_SPECULAR;
    light(call, color ? signed_units(call.v(2)) : call.v(2));
    return true;
  }
  case Command::LightModelf:
  case Command::LightModeli: light_model(call.e(0), numbers_of(call, 1)); return true;
  case Command::LightModelfv: light_model(call.e(0), call.v(1)); return true;
  case Command::LightModeliv:
    light_model(call.e(0), call.e(0) == GL_LIGHT_MODEL_AMBIENT ? signed_units(call.v(1)) : call.v(1));
    return true;
  case Command::Materialf:
  case Command::Materiali: material(call.e(0), call.e(1), numbers_of(call, 2)); return true;
  case Command::Materialfv: material(call.e(0), call.e(1), call.v(2)); return true;
  case Command::Materialiv:
    material(call.e(0), call.e(1), call.e(1) == GL_SHININESS ? call.v(2) : signed_units(call.v(2)));
    return true;
  case Command::ColorMaterial:
    state_.lighting.tracked_face = call.e(0), state_.lighting.tracked = call.e(1), track_color();
    return true;
  case Command::ShadeModel: state_.lighting.shade_model = call.e(0); return true;
  case Command::FrontFace: state_.polygon.front_face = call.e(0); return true;
  default: return false;
  }
}

} // namespace softgl::suite
