// The vertex program: fetch, stages and store for 64 vertices at a time.
#pragma once

#include "shaders/vertex/vertex_coordinates.inl"
#include "shaders/vertex/vertex_fetch.inl"

namespace softgl {
namespace SOFTGL_ISA {

static inline void store_slot(const float* x, const float* y, const float* z, const float* w,
                              ShadedVertices::Slot* out, int slots, int count) {
  int i = 0;
  for (; i + 4 <= count; i += 4, out += 4 * slots) {
    __m128 a = _mm_load_ps(x + i), b = _mm_load_ps(y + i), c = _mm_load_ps(z + i), d = _mm_load_ps(w + i);
    _MM_TRANSPOSE4_PS(a, b, c, d);
    _mm_store_ps(out[0].v, a);
    _mm_store_ps(out[slots].v, b);
    _mm_store_ps(out[2 * slots].v, c);
    _mm_store_ps(out[3 * slots].v, d);
  }
  for (; i < count; ++i, out += slots) {
    out->v[0] = x[i];
    out->v[1] = y[i];
    out->v[2] = z[i];
    out->v[3] = w[i];
  }
}

/// Clamps the colors of a slot to [0,1] in place: OSMesa clamps at the vertex (GL 1.5, 2.14.6). What is not
/// a number, such as an infinite highlight of a black material, becomes 1.
static inline void clamp_lanes(float (*color)[kLanes], int components, int n) {
  for (int c = 0; c < components; ++c) {
    float* v = color[c];
    SOFTGL_FOR_LANES(i, n) v[i] = maximum(minimum(v[i], 1.0f), 0.0f);
  }
}

static inline void light_vertices(VertexBlock& b, const VertexJob& job, uint32_t first, int count, int n) {
  const LightingConstants& k = *job.program->lighting;
  bool have_color = false;
  light_block(b.lighting, k, material_lanes(k, [&](int slot) {
                if (slot == kColor && have_color) return b.color;
                have_color |= slot == kColor;
                float(*lanes)[kLanes] = slot == kColor ? b.color : b.material[slot - kMaterial0];
                fetch_attribute(job, slot, first, count, n, 4, lanes);
                return lanes;
              }));
}

/// What the lighting of fragments reads.
static inline void store_lighting_inputs(VertexBlock& b, const VertexJob& job, uint32_t first, int count,
                                         int n, ShadedVertices::Slot* out) {
  const ShadedLayout& layout = job.layout;
  auto put = [&](int slot, const float(*v)[kLanes], int last) {
    store_slot(v[0], v[1], v[2], v[last], out + slot, layout.slots, count);
  };
  if (layout.normal >= 0) put(layout.normal, b.lighting.normal, 2);
  if (layout.eye >= 0) put(layout.eye, b.lighting.eye, 3);
  if (layout.tracked >= 0) {
    fetch_attribute(job, kColor, first, count, n, 4, b.color);
    put(layout.tracked, b.color, 3);
  }
  for (int i = 0; i < kMaterialSlots; ++i) {
    if (layout.material[i] < 0) continue;
    fetch_attribute(job, kMaterial0 + i, first, count, n, 4, b.material[i]);
    put(layout.material[i], b.material[i], 3);
  }
}

/// Only the masks are set where the vertices have one of the clip bits `common`; gives those bits.
static inline uint32_t shade_block(VertexBlock& b, const VertexJob& job, uint32_t first, int count,
                                   ShadedVertices::Slot* out, uint16_t* mask, uint32_t common) {
  const VertexProgram& p = *job.program;
  const ShadedLayout& layout = job.layout;
  const int slots = layout.slots;
  const int n = (count + kStripLanes - 1) & ~(kStripLanes - 1);
  b.lanes = b.lighting.lanes = n;

  fetch_attribute(job, kPosition, first, count, n, 4, b.position);
  transform_points(b.position, p.transform->mvp, b.clip, n);
  clip_masks(b, p, n);
  for (int i = 0; i < count; ++i) mask[i] = uint16_t(b.mask[i]);
  for (int i = 0; common && i < count; ++i) common &= uint32_t(b.mask[i]);
  if (common) return common;
  window_positions(b, *p.transform, n);
  store_slot(b.window[0], b.window[1], b.window[2], b.window[3], out, slots, count);

  if (p.eye_position || p.eye_position_late)
    transform_points(b.position, p.transform->modelview, b.lighting.eye, n);
  if (p.eye_unit) (p.unit_normal ? unit_lanes : normalize_lanes)(b.lighting.eye, b.lighting.eye_unit, n);
  if (SOFTGL_FAULT(local_viewer_behind) && p.eye_unit)
    for (int c = 0; c < 3; ++c) SOFTGL_FOR_LANES(i, n) b.lighting.eye_unit[c][i] = -b.lighting.eye_unit[c][i];
  if (p.normal) {
    fetch_attribute(job, kNormal, first, count, n, 3, b.lighting.normal);
    transform_normals(b, p, n);
  }

  if (p.lit) {
    light_vertices(b, job, first, count, n);
    const int faces = layout.back_color >= 0 ? 2 : 1;
    for (int face = 0; face < faces; ++face) {
      float(*color)[kLanes] = b.lighting.color[face];
      const int slot = face ? layout.back_color : layout.color;
      if (slot < 0) continue;
      if (p.clamp_colors && !SOFTGL_FAULT(colors_clamped_late)) clamp_lanes(color, 4, n);
      store_slot(color[0], color[1], color[2], color[3], out + slot, slots, count);
    }
  } else if (layout.color >= 0) {
    fetch_attribute(job, kColor, first, count, n, 4, b.color);
    if (p.clamp_colors) clamp_lanes(b.color, 4, n);
    store_slot(b.color[0], b.color[1], b.color[2], b.color[3], out + layout.color, slots, count);
  } else {
    store_lighting_inputs(b, job, first, count, n, out);
  }

  if (layout.secondary >= 0) {
    if (!p.fog) {
      broadcast(0.0f, b.fog, n);
    } else if (p.fog_from_attribute) {
      fetch_attribute(job, kFogCoordinate, first, count, n, 1, &b.fog);
      if (!p.signed_fog) SOFTGL_FOR_LANES(i, n) b.fog[i] = absolute(b.fog[i]);
    } else {
      fog_distances(b, p, n);
    }
    const bool separate = p.lit && p.lighting->separate_specular;
    for (int face = 0; face < 2; ++face) {
      const int slot = face ? layout.back_secondary : layout.secondary;
      if (slot < 0) continue;
      float(*color)[kLanes] = separate ? b.lighting.secondary[face] : b.secondary;
      if (!separate && p.lit)
        for (int c = 0; c < 3; ++c) broadcast(0.0f, color[c], n);
      else if (!separate)
        fetch_attribute(job, kSecondaryColor, first, count, n, 3, color);
      if (p.clamp_colors && !SOFTGL_FAULT(secondary_not_clamped)) clamp_lanes(color, 3, n);
      store_slot(color[0], color[1], color[2], b.fog, out + slot, slots, count);
    }
  }

  for (int unit = 0; unit < kMaxTextureUnits; ++unit) {
    const int slot = layout.texcoord[unit];
    if (slot < 0) continue;
    float(*coordinate)[kLanes] = b.texcoord[unit];
    fetch_attribute(job, kTexCoord0 + unit, first, count, n, 4, coordinate);
    if (p.coordinates[unit]) generate_coordinates(b, *p.coordinates[unit], p.reflection_z, coordinate, n);
    store_slot(coordinate[0], coordinate[1], coordinate[2], coordinate[3], out + slot, slots, count);
  }

  if (layout.point >= 0) {
    point_sizes(b, p, p.eye_position || p.eye_position_late, n);
    store_slot(b.point, b.point, b.point, b.point, out + layout.point, slots, count);
  }
  return 0;
}

static uint16_t shade_vertices(const VertexJob& job, uint32_t first, uint32_t count,
                               ShadedVertices::Slot* out, uint16_t* mask, bool leave_clipped) {
  VertexBlock block;
  uint32_t common = leave_clipped && !SOFTGL_FAULT(points_not_clipped) ? 0xffff : 0;
  for (uint32_t i = 0; i < count;) {
    const uint32_t n = count - i < uint32_t(kLanes) ? count - i : uint32_t(kLanes);
    const bool left = common && i > 0;
    common = shade_block(block, job, first + i, int(n), out + size_t(i) * job.layout.slots, mask + i, common);
    i = left && !common ? 0 : i + n; // the blocks before this one are seen, too
  }
  return uint16_t(common);
}

} // namespace SOFTGL_ISA
} // namespace softgl
