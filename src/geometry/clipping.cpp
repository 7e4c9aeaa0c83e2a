// Order of planes, order of operations and choice of the end from which a new vertex is interpolated are
// those of OSMesa 22.3.6 (draw_pipe_clip): the end nearer to the plane, so that neighbours cut their shared
// edge at the same point.
#include "geometry/clipping.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "geometry/vertex_fetch.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/raster/raster_constants.h"

namespace softgl {
namespace {

bool is_finite(float f) { return (std::bit_cast<uint32_t>(f) & 0x7f800000u) != 0x7f800000u; }

} // namespace

Clipper::Clipper(const DrawRecord& draw, const ShadedVertices& vertices, Arena& arena)
    : draw_(draw), vertices_(vertices), arena_(arena), transform_(*draw.vertex->transform),
      slots_(draw.layout.slots), flat_(draw.raster->flat),
      first_boundary_(draw.vertex->polygons && draw.vertex->polygons->whole ? 0 : 6) {
  static constexpr float kVolume[6][4] = {{-1, 0, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1},
                                          {0, 1, 0, 1},  {0, 0, 1, 1}, {0, 0, -1, 1}};
  std::memcpy(plane_, kVolume, sizeof kVolume);
  if (draw.vertex->depths_from_zero) plane_[4][3] = 0;
  if (const ClipPlaneConstants* user = draw.vertex->clip_planes)
    for (int i = 0; i < user->count; ++i)
      std::memcpy(plane_[6 + user->index[i]], user->plane[i], sizeof(float[4]));
}

void Clipper::load(uint32_t vertex, Vertex& out) const {
  float p[4];
  fetch_vertex(draw_.call.source->stream[kPosition], vertex, p);
  const float* m = transform_.mvp;
  for (int r = 0; r < 4; ++r)
    out.clip[r] = ((p[0] * m[r] + p[1] * m[4 + r]) + p[2] * m[8 + r]) + p[3] * m[12 + r];
  out.shaded = shaded(vertex);
}

float Clipper::distance(const Vertex& v, int plane) const {
  const float* p = plane_[plane];
  return ((v.clip[0] * p[0] + v.clip[1] * p[1]) + v.clip[2] * p[2]) + v.clip[3] * p[3];
}

Clipper::Slot* Clipper::interpolate(Vertex& out, float t, const Vertex& from, const Vertex& to) {
  for (int i = 0; i < 4; ++i) out.clip[i] = from.clip[i] + t * (to.clip[i] - from.clip[i]);
  Slot* made = arena_.allocate_array<Slot>(size_t(slots_));
  out.shaded = made;
  const float oow = 1.0f / out.clip[3];
  for (int i = 0; i < 3; ++i)
    made[0].v[i] = out.clip[i] * oow * transform_.window_scale[i] + transform_.window_offset[i];
  made[0].v[3] = oow;
  for (int s = 1; s < slots_; ++s)
    for (int i = 0; i < 4; ++i) {
      const float a = from.shaded[s].v[i], b = to.shaded[s].v[i];
      made[s].v[i] = SOFTGL_FAULT(cut_color_of_corner) ? a : a + t * (b - a);
    }
  return made;
}

void copy_flat_colors(const ShadedLayout& l, ShadedVertices::Slot* to, const ShadedVertices::Slot* from) {
  for (int slot : {l.color, l.back_color})
    if (slot >= 0) to[slot] = from[slot];
  for (int slot : {l.secondary, l.back_secondary}) // not the fog coordinate behind the color
    if (slot >= 0) std::memcpy(to[slot].v, from[slot].v, sizeof(float[3]));
}

__attribute__((always_inline)) inline bool Clipper::cut(Cut& polygon, uint32_t mask) {
  Vertex **in = polygon.vertex, **out = polygon.other;
  int n = polygon.count;
  for (; mask && n >= 3; mask &= mask - 1) {
    const int plane = std::countr_zero(mask);
    Vertex* previous = in[0];
    float d_previous = distance(*previous, plane);
    if (!is_finite(d_previous)) return false;
    in[n] = in[0];
    int count = 0;
    for (int i = 1; i <= n; ++i) {
      Vertex* vertex = in[i];
      const float d = distance(*vertex, plane);
      if (!is_finite(d)) return false;
      bool crosses;
      if (d_previous >= 0) {
        if (count == polygon.most) return false;
        out[count++] = previous;
        crosses = d < 0;
      } else {
        crosses = !(d < 0);
      }
      if (crosses) {
        if (count == polygon.most || polygon.made == polygon.most_made) return false;
        Vertex* fresh = &polygon.pool[polygon.made++];
        fresh->edge = d < 0 ? plane >= first_boundary_ && !SOFTGL_FAULT(cut_edge_not_drawn)
                            : previous->edge || SOFTGL_FAULT(cut_edge_always_drawn);
        out[count++] = fresh;
        const Vertex &outside = d < 0 ? *vertex : *previous, &inside = d < 0 ? *previous : *vertex;
        const float d_out = d < 0 ? d : d_previous, d_in = d < 0 ? d_previous : d;
        if (-d_out < d_in)
          interpolate(*fresh, d_out / (d_out - d_in), outside, inside);
        else
          interpolate(*fresh, d_in / (d_in - d_out), inside, outside);
      }
      previous = vertex;
      d_previous = d;
    }
    Vertex** swap = in;
    in = out;
    out = swap;
    n = count;
  }
  polygon.vertex = in, polygon.count = n;
  return n >= 3;
}

int Clipper::triangle(const uint32_t v[3], uint32_t mask, const Slot* polygon[kMaxPolygon], uint32_t& edges) {
  constexpr int kMostMade = 3 + 2 * kMaxPlanes;
  Vertex pool[kMostMade];
  Vertex* lists[2][kMaxPolygon + 1];
  for (int i = 0; i < 3; ++i) {
    load(v[i], *(lists[0][i] = &pool[i]));
    pool[i].edge = edges >> i & 1;
  }
  Cut rest{lists[0], lists[1], 3, kMaxPolygon, pool, 3, kMostMade};
  if (!cut(rest, mask)) return 0;
  edges = 0;
  for (int i = 0; i < rest.count; ++i) {
    polygon[i] = rest.vertex[i]->shaded;
    edges |= uint32_t(rest.vertex[i]->edge) << i;
  }
  if (flat_ && rest.vertex[0] != &pool[2] && !SOFTGL_FAULT(cut_forgets_flat_color)) {
    Slot* provoking = arena_.allocate_array<Slot>(size_t(slots_));
    std::memcpy(provoking, polygon[0], sizeof(Slot) * size_t(slots_));
    copy_flat_colors(draw_.layout, provoking, pool[2].shaded);
    polygon[0] = provoking;
  }
  return rest.count;
}

std::span<const PolygonCorner> Clipper::polygon(const uint32_t* v, uint32_t mask,
                                                std::span<const PolygonCorner> corners) {
  const int n = int(corners.size()), most = n + kMaxPlanes, most_made = n + 2 * kMaxPlanes;
  auto* pool = arena_.allocate_array<Vertex>(size_t(most_made));
  Vertex** lists[2];
  for (Vertex**& list : lists) list = arena_.allocate_array<Vertex*>(size_t(most) + 1);
  for (int i = 0; i < n; ++i) {
    load(v[i], *(lists[0][i] = &pool[i]));
    pool[i].edge = corners[size_t(i)].boundary;
  }
  Cut rest{lists[0], lists[1], n, most, pool, n, most_made};
  if (!cut(rest, mask)) return {};
  auto* result = arena_.allocate_array<PolygonCorner>(size_t(rest.count));
  for (int i = 0; i < rest.count; ++i) result[i] = {rest.vertex[i]->shaded, rest.vertex[i]->edge};
  return {result, size_t(rest.count)};
}

bool Clipper::line(const uint32_t v[2], const Slot* end[2]) {
  Vertex a, b;
  load(v[0], a);
  load(v[1], b);
  const uint32_t mask_a = vertices_.clip_mask[v[0] - vertices_.first],
                 mask_b = vertices_.clip_mask[v[1] - vertices_.first];
  float t0 = 0, t1 = 0;
  for (uint32_t mask = mask_a | mask_b; mask; mask &= mask - 1) {
    const int plane = std::countr_zero(mask);
    const float d0 = distance(a, plane), d1 = distance(b, plane);
    if (!is_finite(d0) || !is_finite(d1)) return false;
    if (d1 < 0) {
      const float t = d1 / (d1 - d0);
      t1 = t1 > t ? t1 : t;
    }
    if (d0 < 0) {
      const float t = d0 / (d0 - d1);
      t0 = t0 > t ? t0 : t;
    }
    if (t0 + t1 >= 1.0f) return false;
  }
  const auto cut_at = [&](float t, const Vertex& from, const Vertex& to) {
    Vertex fresh;
    Slot* made = interpolate(fresh, t, from, to);
    if (flat_) copy_flat_colors(draw_.layout, made, b.shaded);
    return made;
  };
  end[0] = mask_a ? cut_at(t0, a, b) : a.shaded;
  end[1] = mask_b ? cut_at(t1, b, a) : b.shaded;
  return true;
}

} // namespace softgl
