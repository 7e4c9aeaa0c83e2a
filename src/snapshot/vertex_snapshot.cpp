#include "snapshot/vertex_snapshot.h"

#include <cmath>
#include <cstring>

#include "context/color_clamping.h"
#include "context/context.h"
#include "context/viewport_transform.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/fragment/fragment_program.h"
#include "snapshot/polygons.h"

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

PolygonMode polygon_mode(GLenum mode) {
  return mode == GL_POINT ? PolygonMode::Point : mode == GL_LINE ? PolygonMode::Line : PolygonMode::Fill;
}

FogDistance fog_distance(GLenum mode) {
  return mode == GL_EYE_RADIAL_NV ? FogDistance::Radial
         : mode == GL_EYE_PLANE   ? FogDistance::Plane
                                  : FogDistance::PlaneAbsolute;
}

} // namespace

bool needs_eye_space(const Context& c, uint32_t texture_units) {
  const State& s = c.state;
  if (s.point.attenuated()) return true;
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
    for (int j = 0; j < 3; ++j)
      k->normal_matrix[i][j] =
          SOFTGL_FAULT(normal_by_modelview) ? k->modelview[4 * j + i] : inverted[4 * i + j];

  // In eye space GL_RESCALE_NORMAL asks for the scale; in object space its absence does, since the normal is
  // not transformed there.
  k->normal_scale = 1;
  if (!c.state.transform.normalize && eye_space == c.state.transform.rescale_normal &&
      !is_length_preserving(modelview)) {
    float f = (inverted[2] * inverted[2] + inverted[6] * inverted[6]) + inverted[10] * inverted[10];
    if (f < 1e-12f) f = 1;
    k->normal_scale = eye_space ? 1.0f / std::sqrt(f) : std::sqrt(f);
    if (SOFTGL_FAULT(rescale_ignored)) k->normal_scale = 1;
  }

  const ViewportTransform window = viewport_transform(c.state);
  std::memcpy(k->window_scale, window.scale, sizeof k->window_scale);
  std::memcpy(k->window_offset, window.offset, sizeof k->window_offset);
  const Surface& surface = c.draw->surface;
  if (!surface.y_up) {
    k->window_scale[1] = -window.scale[1];
    k->window_offset[1] = float(surface.height) - window.offset[1];
  }
  return k;
}

const ClipPlaneConstants* make_clip_planes(Context& c, Arena& arena) {
  const uint32_t enabled = c.state.transform.clip_plane_enabled;
  if (!enabled) return nullptr;
  auto* k = arena.make<ClipPlaneConstants>();
  const float* m = &inverse(c.matrices.projection.top())[0][0];
  k->count = 0;
  for (int i = 0; i < kMaxClipPlanes; ++i) {
    if (!(enabled >> i & 1) || (SOFTGL_FAULT(last_plane_forgotten) && i == 5)) continue;
    const Vec4 p = c.state.transform.clip_plane[i] * (SOFTGL_FAULT(plane_keeps_other_side) ? -1.0f : 1.0f);
    float* out = k->plane[k->count];
    for (int j = 0; j < 4; ++j)
      out[j] = ((p.x * m[4 * j] + p.y * m[4 * j + 1]) + p.z * m[4 * j + 2]) + p.w * m[4 * j + 3];
    if (SOFTGL_FAULT(plane_in_clip_coordinates)) std::memcpy(out, &p, sizeof p);
    k->index[k->count++] = uint8_t(i);
  }
  return k;
}

const PolygonConstants* make_polygon_constants(const Context& c, Arena& arena) {
  const PolygonState& p = c.state.polygon;
  auto* k = arena.make<PolygonConstants>();
  k->ccw_is_front = counter_clockwise_is_front(c.state) != c.draw->surface.y_up; // as rows go
  k->mode[0] = polygon_mode(p.seen_mode(!k->ccw_is_front));
  k->mode[1] = polygon_mode(p.seen_mode(k->ccw_is_front));
  k->cull_front = p.culls(false);
  k->cull_back = p.culls(true);
  k->two_sided = c.state.lighting.enabled && c.state.lighting.two_side;
  k->offset[int(PolygonMode::Fill)] = p.offset_fill;
  k->offset[int(PolygonMode::Line)] = p.offset_line;
  k->offset[int(PolygonMode::Point)] = p.offset_point;
  k->whole = c.specification_answers;
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

ShadedLayout make_layout(const Context& c, const FragmentKey& key, const int8_t source[5][2], bool points) {
  ShadedLayout l;
  const LightingState& lighting = c.state.lighting;
  const bool two_sided = lighting.enabled && lighting.two_side && !key.lit;
  int8_t next = 1;
  if (key.lit) {
    bool lights = false, positional = false;
    for (const Light& light : lighting.light)
      lights |= light.enabled, positional |= light.enabled && light.position.w != 0;
    if (lights) l.normal = next++;
    if (positional || (lights && lighting.local_viewer)) l.eye = next++;
    for (int parameter = 0; parameter < kMaterialParameters; ++parameter)
      for (int face = 0; face <= int(lighting.two_side); ++face) {
        const int from = source[parameter][face];
        if (from < 0) continue;
        int8_t& slot = from == kColor ? l.tracked : l.material[from - kMaterial0];
        if (slot < 0) slot = next++;
      }
  } else {
    l.color = next++;
  }
  if (key.secondary || key.fog_mode) l.secondary = next++;
  if (two_sided) l.back_color = next++;
  if (two_sided && key.secondary) l.back_secondary = next++;
  if (points && c.state.point.attenuated()) l.point = next++;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (key.texture_units >> u & 1) l.texcoord[u] = next++;
  l.slots = uint8_t(next);
  return l;
}

const VertexProgram* make_vertex_program(const Context& c, const SnapshotCache& cache, Arena& arena) {
  auto* p = arena.make<VertexProgram>();
  const State& s = c.state;
  const FragmentKey& key = cache.fragment->key;
  p->transform = cache.transform;
  p->clip_planes = cache.clip_planes;
  p->lighting = cache.lighting;
  p->lit = cache.lighting && !key.lit;
  p->fog = key.fog_mode != 0;
  p->fog_from_attribute = s.fog.coordinate_source == GL_FOG_COORDINATE;
  p->fog_distance = fog_distance(s.fog.distance_mode);
  p->eye_position = p->fog && !p->fog_from_attribute && p->fog_distance == FogDistance::Radial;
  p->depth_clamp = s.transform.depth_clamp;
  p->depths_from_zero = depths_from_zero(s);
  p->clamp_colors = clamps_vertex_colors(c);
  p->normal_to_eye = cache.eye_space;
  p->normalize = s.transform.normalize || (SOFTGL_FAULT(rescale_is_normalize) && s.transform.rescale_normal);
  p->unit_normal = p->normalize && key.lit;

  if (cache.lighting) {
    const LightingConstants& k = *cache.lighting;
    p->unit_normal |= k.reflection;
    bool positional = false;
    for (int i = 0; i < k.light_count; ++i) positional |= k.light[i].positional;
    p->eye_unit = p->lit && k.local_viewer && !k.shininess_zero && k.light_count > 0;
    p->eye_position |= positional || p->eye_unit || cache.layout.eye >= 0;
    p->normal = k.light_count > 0;
  }
  for (int u = 0; u < kMaxTextureUnits; ++u) {
    p->coordinates[u] = cache.coordinates[u];
    if (!cache.coordinates[u]) continue;
    p->reflection_z |= cache.coordinates[u]->mode[2] == TexGen::ReflectionMap;
    for (TexGen mode : cache.coordinates[u]->mode) {
      const bool reflects = mode == TexGen::SphereMap || mode == TexGen::ReflectionMap;
      p->normal |= reflects || mode == TexGen::NormalMap;
      p->eye_unit |= reflects;
      p->eye_position_late |= reflects || mode == TexGen::EyeLinear;
    }
  }
  const PointState& point = s.point;
  p->point_attenuated = cache.layout.point >= 0;
  p->signed_fog = c.specification_answers;
  p->from_eye = c.specification_answers && p->point_attenuated;
  p->eye_position_late |= p->from_eye;
  p->point = {point.size,
              point.size_min,
              point.size_max,
              {point.distance_attenuation.x, point.distance_attenuation.y, point.distance_attenuation.z}};
  p->polygons = polygons_before_raster(s) ? make_polygon_constants(c, arena) : nullptr;
  p->line_stipple = s.line.stipple && s.line.stipple_pattern != 0xffff;
  p->stipple_pattern = s.line.stipple_pattern;
  p->stipple_factor = uint16_t(s.line.stipple_factor);
  // Points that are neither sprites nor smooth are at least a pixel large.
  if (!point.sprite && !point.smooth && p->point.minimum < 1) p->point.minimum = 1;
  return p;
}

OwnSnapshot make_own_snapshot(Context& c, const FragmentKey& key, uint32_t present, const float color[4],
                              Arena& arena) {
  settle_history(c.matrices.modelview.top());
  FragmentProgram fragment{};
  fragment.key = key;
  SnapshotCache cache;
  cache.fragment = &fragment;
  cache.eye_space = needs_eye_space(c, uint32_t(key.texture_units));
  cache.transform = make_transform(c, cache.eye_space, arena);
  cache.clip_planes = make_clip_planes(c, arena);
  for (int u = 0; u < kMaxTextureUnits; ++u)
    cache.coordinates[u] = key.texture_units >> u & 1 ? make_coordinates(c, u, arena) : nullptr;
  int8_t source[5][2];
  std::memset(source, -1, sizeof source);
  if (c.state.lighting.enabled) {
    find_material_sources(c, present, source);
    cache.lighting = make_lighting(c, source, color, cache.eye_space, false, arena);
  }
  cache.layout = make_layout(c, key, source, false);
  return {cache.layout, *make_vertex_program(c, cache, arena)};
}

} // namespace softgl
