#include "vertex_snapshot.h"

#include <cmath>
#include <cstring>

#include "state/context.h"

namespace softgl {
namespace {

TexGen texgen_mode(const TextureGeneration& g) {
  if (!g.enabled) return TexGen::None;
  switch (g.mode) {
  case GL_OBJECT_LINEAR: return TexGen::ObjectLinear;
  case GL_EYE_LINEAR: return TexGen::EyeLinear;
  case GL_SPHERE_MAP: return TexGen::SphereMap;
  case GL_REFLECTION_MAP: return TexGen::ReflectionMap;
  default: return TexGen::NormalMap;
  }
}

bool is_identity(const float* m) {
  for (int i = 0; i < 16; ++i)
    if (m[i] != (i % 5 == 0 ? 1.0f : 0.0f)) return false;
  return true;
}

PolygonMode polygon_mode(GLenum mode) { return mode == GL_POINT ? PolygonMode::Point : mode == GL_LINE ? PolygonMode::Line : PolygonMode::Fill; }

} // namespace

bool needs_eye_space(const Context& c, uint32_t texture_units) {
  const State& s = c.state;
  const Vec3 a = s.point.distance_attenuation;
  if (a.x != 1 || a.y != 0 || a.z != 0) return true;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (texture_units >> u & 1)
      for (const TextureGeneration& g : s.texture.unit[u].generation)
        if (g.enabled && g.mode != GL_OBJECT_LINEAR) return true;
  const LightingState& l = s.lighting;
  if (!l.enabled) return false;
  if (lights_fragments(l, c.smooth_is_phong) || l.specular_vector == GL_REFLECTION_VECTOR_SOFTGL) return true;
  if (l.local_viewer || l.color_control == GL_SEPARATE_SPECULAR_COLOR) return true;
  for (const Light& light : l.light)
    if (light.enabled && (light.position.w != 0 || light.spot_cutoff != 180)) return true;
  return !is_length_preserving(c.matrices.modelview.top());
}

const TransformConstants* make_transform(Context& c, bool eye_space, Arena& arena) {
  auto* k = arena.make<TransformConstants>();
  Matrix& modelview = c.matrices.modelview.top();
  const float* inverted = &inverse(modelview)[0][0];
  const Matrix mvp = product(c.matrices.projection.top(), modelview);
  std::memcpy(k->mvp, mvp.data(), sizeof k->mvp);
  std::memcpy(k->modelview, modelview.data(), sizeof k->modelview);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) k->normal_matrix[i][j] = inverted[4 * i + j];

  // In eye space GL_RESCALE_NORMAL asks for the scale; in object space its absence does, since the normal is not
  // transformed there.
  k->normal_scale = 1;
  if (!c.state.transform.normalize && eye_space == c.state.transform.rescale_normal && !is_length_preserving(modelview)) {
    float f = (inverted[2] * inverted[2] + inverted[6] * inverted[6]) + inverted[10] * inverted[10];
    if (f < 1e-12f) f = 1;
    k->normal_scale = eye_space ? 1.0f / std::sqrt(f) : std::sqrt(f);
  }

  const ViewportState& v = c.state.viewport;
  const float half_width = 0.5f * float(v.width), half_height = 0.5f * float(v.height);
  k->window_scale[0] = half_width;
  k->window_offset[0] = half_width + float(v.x);
  k->window_scale[1] = -half_height;
  k->window_offset[1] = float(c.framebuffer.surface.height) - (half_height + float(v.y));
  k->window_scale[2] = float(0.5 * (v.far_depth - v.near_depth));
  k->window_offset[2] = float(0.5 * (v.near_depth + v.far_depth));
  return k;
}

const ClipPlaneConstants* make_clip_planes(Context& c, Arena& arena) {
  const uint32_t enabled = c.state.transform.clip_plane_enabled;
  if (!enabled) return nullptr;
  auto* k = arena.make<ClipPlaneConstants>();
  const float* m = &inverse(c.matrices.projection.top())[0][0];
  k->count = 0;
  for (int i = 0; i < kMaxClipPlanes; ++i) {
    if (!(enabled >> i & 1)) continue;
    const Vec4 p = c.state.transform.clip_plane[i];
    float* out = k->plane[k->count];
    for (int j = 0; j < 4; ++j)
      out[j] = ((p.x * m[4 * j] + p.y * m[4 * j + 1]) + p.z * m[4 * j + 2]) + p.w * m[4 * j + 3];
    k->index[k->count++] = uint8_t(i);
  }
  return k;
}

const PolygonConstants* make_polygon_constants(const Context& c, Arena& arena) {
  const PolygonState& p = c.state.polygon;
  if (!polygons_before_raster(c.state)) return nullptr;
  auto* k = arena.make<PolygonConstants>();
  k->ccw_is_front = p.front_face == GL_CCW;
  k->mode[0] = polygon_mode(p.seen_mode(!k->ccw_is_front));
  k->mode[1] = polygon_mode(p.seen_mode(k->ccw_is_front));
  k->cull_front = p.culls(false);
  k->cull_back = p.culls(true);
  k->two_sided = c.state.lighting.enabled && c.state.lighting.two_side;
  k->offset[int(PolygonMode::Fill)] = p.offset_fill;
  k->offset[int(PolygonMode::Line)] = p.offset_line;
  k->offset[int(PolygonMode::Point)] = p.offset_point;
  return k;
}

const CoordinateConstants* make_coordinates(const Context& c, int unit, Arena& arena) {
  const TextureUnitState& u = c.state.texture.unit[unit];
  const float* matrix = c.matrices.texture[unit].top().data();
  const bool transform = !is_identity(matrix);
  bool generates = false;
  for (const TextureGeneration& g : u.generation) generates |= g.enabled;
  if (!transform && !generates) return nullptr;
  auto* k = arena.make<CoordinateConstants>();
  k->transform = transform;
  std::memcpy(k->matrix, matrix, sizeof k->matrix);
  for (int i = 0; i < 4; ++i) {
    const TextureGeneration& g = u.generation[i];
    k->mode[i] = texgen_mode(g);
    const Vec4& plane = g.mode == GL_EYE_LINEAR ? g.eye_plane : g.object_plane;
    std::memcpy(k->plane[i], &plane, sizeof k->plane[i]);
  }
  return k;
}

} // namespace softgl
