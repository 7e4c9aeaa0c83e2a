// The current raster position (GL 1.5, 2.13): a vertex that is not drawn.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/float_environment.h"
#include "base/unit_range.h"
#include "commands/generated/commands.h"
#include "context/color_clamping.h"
#include "context/context.h"
#include "context/viewport_transform.h"
#include "geometry/geometry.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/fragment/fragment_key.h"
#include "snapshot/feedback.h"
#include "snapshot/render_targets.h"
#include "snapshot/vertex_snapshot.h"

namespace softgl {
namespace {

/// In OSMesa's order of operations: positions at half pixels are rounded later on.
Vec4 transformed(const Matrix& matrix, const Vec4& v) {
  const float* m = matrix.data();
  Vec4 out;
  for (int i = 0; i < 4; ++i) out[i] = ((m[i] * v.x + m[4 + i] * v.y) + m[8 + i] * v.z) + m[12 + i] * v.w;
  return out;
}

bool in_view(const State& s, const Vec4& clip, const ClipPlaneConstants* planes) {
  // GL_IBM_rasterpos_clip spares x and y, GL_ARB_depth_clamp z.
  const TransformState& transform = s.transform;
  for (int i = transform.raster_position_unclipped ? 2 : 0; i < (transform.depth_clamp ? 2 : 3); ++i)
    if (!(clip[i] <= clip.w && clip[i] >= (i == 2 && depths_from_zero(s) ? 0 : -clip.w))) return false;
  for (int i = 0; planes && i < planes->count; ++i) {
    const float* p = planes->plane[i];
    if (((clip.x * p[0] + clip.y * p[1]) + clip.z * p[2]) + clip.w * p[3] < 0) return false;
  }
  return true;
}

Vec4 window_position(const State& s, const Vec4& clip) {
  const ViewportTransform t = viewport_transform(s);
  const float inverse = clip.w == 0 || SOFTGL_FAULT(raster_not_divided) ? 1.0f : 1.0f / clip.w;
  Vec4 window;
  for (int i = 0; i < 3; ++i) window[i] = clip[i] * inverse * t.scale[i] + t.offset[i];
  if (SOFTGL_FAULT(raster_ignores_viewport)) window.x -= float(s.viewport.x), window.y -= float(s.viewport.y);
  if (SOFTGL_FAULT(raster_ignores_depth_range)) window.z = clip.z * inverse * 0.5f + 0.5f;
  window.w = clip.w;
  return window;
}

void take_current_attributes(const State& s, RasterPosition& position) {
  position.color = s.current.slot[kColor];
  position.secondary_color = s.current.slot[kSecondaryColor];
  for (int u = 0; u < kMaxTextureUnits; ++u) position.texcoord[u] = s.current.slot[kTexCoord0 + u];
}

/// What the vertex program makes of the current attributes at `object`: colors if there is lighting, and
/// coordinates.
void shade_attributes(Context& c, const Vec4& object, RasterPosition& position) {
  Arena& arena = c.frame.arena();
  const State& s = c.state;
  FragmentKey key{}; // of fragments that need everything
  key.secondary = 1;
  key.texture_units = (1u << kMaxTextureUnits) - 1;
  const OwnSnapshot own = make_own_snapshot(c, key, 0, &s.current.slot[kColor][0], arena);

  Vec4 constant[kMaterial0];
  std::memcpy(constant, s.current.slot, sizeof constant);
  constant[kPosition] = object;
  const VertexSource none;
  DrawCall call;
  call.source = &none;
  call.constant = constant;
  call.vertex_count = 1;
  const DrawRecord draw{call, own.layout, &own.program, nullptr, nullptr};
  const ShadedVertices& out = *allocate_vertices(draw, 0, 1, arena);
  const FloatEnvironment environment;
  shade_vertices(draw, 0, 1, out);
  auto value = [&](int slot) {
    const float* v = out.slot[slot].v;
    return Vec4(v[0], v[1], v[2], v[3]);
  };
  if (s.lighting.enabled && !SOFTGL_FAULT(raster_position_unlit)) {
    position.color = value(own.layout.color);
    position.secondary_color = Vec4(glm::vec3(value(own.layout.secondary)), 1);
  }
  for (int u = 0; u < kMaxTextureUnits; ++u) position.texcoord[u] = value(own.layout.texcoord[u]);
}

} // namespace

namespace gl {

void RasterPos(Context& c, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  if (!draw_target_complete(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  const State& s = c.state;
  RasterPosition& position = c.state.raster_position;
  const Vec4 object(x, y, z, w),
      eye = SOFTGL_FAULT(raster_position_in_eye) ? object : transformed(c.matrices.modelview.top(), object);
  const Vec4 clip = transformed(c.matrices.projection.top(), eye);
  const Arena::Mark mark = c.frame.arena().mark();
  const ClipPlaneConstants* planes = make_clip_planes(c, c.frame.arena());
  position.valid = in_view(s, clip, SOFTGL_FAULT(raster_planes_ignored) ? nullptr : planes) ||
                   SOFTGL_FAULT(raster_always_valid);
  if (position.valid) {
    position.window = window_position(s, clip);
    if (s.transform.depth_clamp) {
      const auto [low, high] = std::minmax({float(s.viewport.near_depth), float(s.viewport.far_depth)});
      position.window.z = std::clamp(position.window.z, low, high);
    }
    position.distance = s.fog.coordinate_source == GL_FOG_COORDINATE
                            ? s.current.slot[kFogCoordinate].x
                            : std::sqrt((eye.x * eye.x + eye.y * eye.y) + eye.z * eye.z);
    if (SOFTGL_FAULT(raster_distance_forgotten)) position.distance = 0;
    take_current_attributes(s, position);
    shade_attributes(c, object, position);
    feed_back_raster_position(c);
  }
  c.frame.arena().rewind(mark);
}

namespace {

void set_window_position(Context& c, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  const State& s = c.state;
  RasterPosition& position = c.state.raster_position;
  if (SOFTGL_FAULT(window_position_in_viewport)) x += float(s.viewport.x), y += float(s.viewport.y);
  position.window = Vec4(x, y,
                         SOFTGL_FAULT(window_depth_not_mapped)
                             ? unit_range(z)
                             : unit_range(z) * float(s.viewport.far_depth - s.viewport.near_depth) +
                                   float(s.viewport.near_depth),
                         w);
  position.distance = s.fog.coordinate_source == GL_FOG_COORDINATE ? s.current.slot[kFogCoordinate].x : 0.0f;
  take_current_attributes(s, position);
  if (clamps_vertex_colors(c)) {
    position.color = glm::clamp(position.color, 0.0f, 1.0f);
    position.secondary_color = glm::clamp(position.secondary_color, 0.0f, 1.0f);
  }
  position.valid = true;
  feed_back_raster_position(c);
}

} // namespace

void WindowPos(Context& c, GLfloat x, GLfloat y, GLfloat z) {
  if (!draw_target_complete(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  set_window_position(c, x, y, z, 1);
}

/// GL_MESA_window_pos: w is the raster position's own, and moves nothing.
void WindowPos4MESA(Context& c, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  if (!draw_target_complete(c)) return set_error(c, GL_INVALID_FRAMEBUFFER_OPERATION);
  set_window_position(c, x, y, z, w);
}

} // namespace gl
} // namespace softgl
