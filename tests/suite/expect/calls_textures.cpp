// Texture parameters, objects, environments and coordinates (3.8.3, 3.8.12, 3.8.13, 2.11.4).
#include <algorithm>

#include "expect/calls.h"

namespace softgl::suite {
namespace {

double dot4(const Vec4& a, const Vec4& b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }

void set_parameter(TextureParameters& p, GLenum name, const std::vector<double>& v) {
  switch (name) {
  case GL_TEXTURE_WRAP_S: p.wrap[0] = GLenum(v[0]); break;
  case GL_TEXTURE_WRAP_T: p.wrap[1] = GLenum(v[0]); break;
  case GL_TEXTURE_WRAP_R: p.wrap[2] = GLenum(v[0]); break;
  case GL_TEXTURE_MIN_FILTER: p.min_filter = GLenum(v[0]); break;
  case GL_TEXTURE_MAG_FILTER: p.mag_filter = GLenum(v[0]); break;
  case GL_TEXTURE_BORDER_COLOR:
    for (size_t i = 0; i < 4; i++) p.border[i] = std::clamp(v.at(i), 0.0, 1.0);
    break;
  case GL_TEXTURE_MIN_LOD: p.min_lod = v[0]; break;
  case GL_TEXTURE_MAX_LOD: p.max_lod = v[0]; break;
  case GL_TEXTURE_BASE_LEVEL: p.base_level = int(v[0]); break;
  case GL_TEXTURE_MAX_LEVEL: p.max_level = int(v[0]); break;
  case GL_TEXTURE_PRIORITY: p.priority = v[0]; break;
  case GL_DEPTH_TEXTURE_MODE: p.depth_mode = GLenum(v[0]); break;
  case GL_TEXTURE_COMPARE_MODE: p.compare_mode = GLenum(v[0]); break;
  case GL_TEXTURE_COMPARE_FUNC: p.compare_function = GLenum(v[0]); break;
  case GL_GENERATE_MIPMAP: p.generate_mipmap = v[0] != 0; break;
  default: throw std::logic_error("glTexParameter of what the machine does not know");
  }
}

void set_environment(TextureEnvironment& e, GLenum name, const std::vector<double>& v) {
  for (int i = 0; i < 3; i++)
    for (int a = 0; a < 2; a++) {
      if (name == GLenum((a ? GL_SOURCE0_ALPHA : GL_SOURCE0_RGB) + i)) {
        e.source[a][i] = GLenum(v[0]);
        return;
      }
      if (name == GLenum((a ? GL_OPERAND0_ALPHA : GL_OPERAND0_RGB) + i)) {
        e.operand[a][i] = GLenum(v[0]);
        return;
      }
    }
  switch (name) {
  case GL_TEXTURE_ENV_MODE: e.mode = GLenum(v[0]); break;
  case GL_TEXTURE_ENV_COLOR:
    for (size_t i = 0; i < 4; i++) e.color[i] = std::clamp(v.at(i), 0.0, 1.0);
    break;
  case GL_COMBINE_RGB: e.combine[0] = GLenum(v[0]); break;
  case GL_COMBINE_ALPHA: e.combine[1] = GLenum(v[0]); break;
  case GL_RGB_SCALE: e.scale[0] = v[0]; break;
  case GL_ALPHA_SCALE: e.scale[1] = v[0]; break;
  default: throw std::logic_error("glTexEnv of what the machine does not know");
  }
}

} // namespace

void Machine::generate_coordinates(const Vec4& object, const Vec4& eye, const Vec3& normal,
                                   LitVertex& vertex) const {
  for (size_t u = 0; u < kTextureUnits; u++) {
    const TextureUnit& unit = state_.texture.units[u];
    const Vec4& current = state_.current.texture_coordinate[u];
    double coordinate[4] = {current.x, current.y, current.z, current.w};
    const Vec3 to_vertex = spec::unit((1 / eye.w) * eye.xyz());
    const Vec3 r = to_vertex - (2 * dot(normal, to_vertex)) * normal;
    const double m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    const double sphere[2] = {r.x / m + 0.5, r.y / m + 0.5}, reflection[3] = {r.x, r.y, r.z},
                 normals[3] = {normal.x, normal.y, normal.z};
    for (int i = 0; i < 4; i++) {
      const TextureGeneration& g = unit.generation[i];
      if (!g.on) continue;
      switch (g.mode) {
      case GL_OBJECT_LINEAR: coordinate[i] = dot4(g.object_plane, object); break;
      case GL_EYE_LINEAR: coordinate[i] = dot4(g.eye_plane, eye); break;
      case GL_SPHERE_MAP: coordinate[i] = sphere[i]; break;
      case GL_REFLECTION_MAP: coordinate[i] = reflection[i]; break;
      case GL_NORMAL_MAP: coordinate[i] = normals[i]; break;
      default: throw std::logic_error("a generation of coordinates that the machine does not know");
      }
    }
    vertex.texture[u] =
        state_.texture_matrix[u].back() * Vec4{coordinate[0], coordinate[1], coordinate[2], coordinate[3]};
  }
}

bool Machine::enable_texture(GLenum name, bool on) {
  TextureUnit& unit = state_.texture.units[state_.texture.active];
  if (name >= GL_TEXTURE_GEN_S && name <= GL_TEXTURE_GEN_Q) {
    unit.generation[name - GL_TEXTURE_GEN_S].on = on;
    return true;
  }
  if (name != GL_TEXTURE_1D && name != GL_TEXTURE_2D && name != GL_TEXTURE_3D && name != GL_TEXTURE_CUBE_MAP)
    return false;
  int face = 0;
  unit.on[int(texture_target(name, &face))] = on;
  return true;
}

void Machine::generation(GLenum coordinate, GLenum name, const std::vector<double>& v) {
  TextureGeneration& g = state_.texture.units[state_.texture.active].generation[coordinate - GL_S];
  switch (name) {
  case GL_TEXTURE_GEN_MODE: g.mode = GLenum(v[0]); break;
  case GL_OBJECT_PLANE: g.object_plane = vec4(v); break;
  case GL_EYE_PLANE: {
    // "(p1 p2 p3 p4) M^-1", with the modelview of now.
    const Matrix4 inverted = inverse(state_.modelview.back());
    double plane[4];
    for (int j = 0; j < 4; j++) {
      plane[j] = 0;
      for (int i = 0; i < 4; i++) plane[j] += v.at(size_t(i)) * inverted(i, j);
    }
    g.eye_plane = {plane[0], plane[1], plane[2], plane[3]};
    break;
  }
  default: throw std::logic_error("glTexGen of what the machine does not know");
  }
}

bool Machine::play_textures(const Call& call) {
  TextureState& t = state_.texture;
  const std::vector<double> numbers = numbers_of(call, 0);
  const auto environment = [&](const std::vector<double>& values) {
    if (call.e(0) == GL_TEXTURE_FILTER_CONTROL)
      t.units[t.active].environment.lod_bias = values[0];
    else
      set_environment(t.units[t.active].environment, call.e(1), values);
  };
  int face = 0;
  const auto parameter = [&](const std::vector<double>& values) {
    set_parameter(t.bound(t.active, texture_target(call.e(0), &face)).parameters, call.e(1), values);
  };
  switch (call.command) {
  case Command::TexParameteri:
  case Command::TexParameterf: parameter({call.n(2)}); return true;
  case Command::TexParameterfv: parameter(call.v(2)); return true;
  case Command::TexEnvi:
  case Command::TexEnvf: environment({call.n(2)}); return true;
  case Command::TexEnvfv: environment(call.v(2)); return true;
  case Command::TexGeni: generation(call.e(0), call.e(1), {call.n(2)}); return true;
  case Command::TexGenfv: generation(call.e(0), call.e(1), call.v(2)); return true;
  case Command::ActiveTexture: t.active = int(call.e(0) - GL_TEXTURE0); return true;
  case Command::BindTexture:
    t.units[t.active].bound[int(texture_target(call.e(0), &face))] = GLuint(call.n(1));
    return true;
  case Command::DeleteTextures:
    for (double name : call.v(1))
      for (int target = 0; target < kTextureTargets; target++) {
        t.objects.erase({TextureTarget(target), GLuint(name)});
        for (TextureUnit& unit : t.units)
          if (unit.bound[target] == GLuint(name)) unit.bound[target] = 0;
      }
    return true;
  case Command::MultiTexCoord2f:
    state_.current.texture_coordinate[call.e(0) - GL_TEXTURE0] = {call.n(1), call.n(2), 0, 1};
    return true;
  default: return play_texture_images(call);
  }
}

} // namespace softgl::suite
