#include "geometry/polygon_stage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/unit_range.h"
#include "draw/draw_record.h"
#include "shaders/common/seeded_faults.h"
#include "shaders/raster/raster_constants.h"

namespace softgl {
namespace {

/// What floats of depths up to those of the corners resolve: their exponent less the bits of the mantissa.
float float_step(float z0, float z1, float z2) {
  const float largest = std::max(std::max(std::fabs(z0), std::fabs(z1)), std::fabs(z2));
  const int32_t exponent = (std::bit_cast<int32_t>(largest) & 0x7f800000) - (23 << 23);
  return std::bit_cast<float>(std::max(exponent, 0));
}

/// The greatest change of depth per pixel, times the factor, plus the units. e, f: corners 0 and 1 relative
/// to corner 2.
float depth_offset(const RasterConstants& r, const float e[3], const float f[3], float determinant,
                   float units) {
  const float a = e[1] * f[2] - e[2] * f[1], b = e[2] * f[0] - e[0] * f[2], inverse = 1.0f / determinant;
  const float dzdx = std::fabs(a * inverse), dzdy = std::fabs(b * inverse);
  return units + (dzdx > dzdy ? dzdx : dzdy) * r.offset_factor;
}

} // namespace

PolygonStage::PolygonStage(const DrawRecord& draw, Arena& arena, PrimitiveSink& sink)
    : draw_(draw), constants_(*draw.vertex->polygons), arena_(arena), sink_(sink), slots_(draw.layout.slots),
      stipple_(draw, arena) {}

const PolygonStage::Slot* PolygonStage::own_copy(const Slot* vertex, const Slot* provoking, bool back,
                                                 const float* offset) {
  const ShadedLayout& l = draw_.layout;
  Slot* copy = arena_.allocate_array<Slot>(slots_);
  std::memcpy(copy, vertex, sizeof(Slot) * slots_);
  const Slot* colors = draw_.raster->flat ? provoking : vertex;
  if (l.color >= 0) copy[l.color] = colors[back && l.back_color >= 0 ? l.back_color : l.color];
  if (l.secondary >= 0) // not the fog coordinate behind the color
    std::memcpy(copy[l.secondary].v, colors[back && l.back_secondary >= 0 ? l.back_secondary : l.secondary].v,
                sizeof(float[3]));
  if (offset) copy->v[2] = unit_range(copy->v[2] + *offset);
  return copy;
}

PolygonStage::Plane PolygonStage::plane_of(const Slot* a, const Slot* b, const Slot* c) {
  const float *v0 = a->v, *v1 = b->v, *v2 = c->v;
  Plane p{{v0[0] - v2[0], v0[1] - v2[1], v0[2] - v2[2]},
          {v1[0] - v2[0], v1[1] - v2[1], v1[2] - v2[2]},
          0,
          {a, b, c}};
  p.determinant = p.e[0] * p.f[1] - p.e[1] * p.f[0]; // y is down: negative is counter-clockwise
  return p;
}

bool PolygonStage::look_at(float determinant, PolygonMode& mode) {
  const PolygonConstants& k = constants_;
  // Without area it is culled as a back-facing one, and else drawn and colored as a clockwise one.
  const bool front = determinant != 0 && (determinant < 0) == k.ccw_is_front;
  if (front ? k.cull_front : k.cull_back) return false;
  mode = k.mode[determinant >= 0];
  back_ = k.ccw_is_front ? determinant > 0 : determinant < 0;
  return true;
}

void PolygonStage::finish_corners(std::span<const Slot*> corners, const Slot* provoking, PolygonMode mode,
                                  const Plane& plane) {
  const bool back_colors = constants_.two_sided && back_, offset = constants_.offset[int(mode)];
  if (counting_ || !(offset || back_colors || draw_.raster->flat)) return;
  const RasterConstants& r = *draw_.raster;
  const auto z = [&](int i) { return plane.corner[i]->v[2]; };
  const float units = r.offset_floats ? float_step(z(0), z(1), z(2)) * r.offset_units : r.offset_units;
  const float by = offset ? depth_offset(r, plane.e, plane.f, plane.determinant, units) : 0.0f;
  for (const Slot*& corner : corners)
    corner = own_copy(corner, provoking, back_colors, offset ? &by : nullptr);
}

void PolygonStage::triangle(const PolygonTriangle& t) {
  const Plane plane = plane_of(t.corner[0], t.corner[1], t.corner[2]);
  PolygonMode mode;
  if (!look_at(plane.determinant, mode)) return;
  const Slot* corner[3] = {t.corner[0], t.corner[1], t.corner[2]};
  finish_corners(corner, t.corner[2], mode, plane);
  switch (mode) {
  case PolygonMode::Fill: fill({corner[0], corner[1], corner[2]}, t.boundary); break;
  case PolygonMode::Line:
    if (t.begins) stipple_.reset(), line_begins_ = true;
    if (t.boundary & 4) line(corner[2], corner[0]);
    if (t.boundary & 1) line(corner[0], corner[1]);
    if (t.boundary & 2) line(corner[1], corner[2]);
    break;
  case PolygonMode::Point:
    for (int i = 0; i < 3; ++i)
      if (SOFTGL_FAULT(corners_without_flags) || t.boundary >> i & 1) point(corner[i]);
    break;
  }
}

void PolygonStage::polygon(std::span<const PolygonCorner> corners, const Slot* provoking) {
  const size_t last = corners.size() - 1;
  Plane largest{};
  float determinant = 0; // the sum of those of a fan (equation 2.6)
  for (size_t i = 0; i + 1 < last; ++i) {
    const Plane plane = plane_of(corners[i].vertex, corners[i + 1].vertex, corners[last].vertex);
    determinant += plane.determinant;
    if (i == 0 || std::fabs(plane.determinant) > std::fabs(largest.determinant)) largest = plane;
  }
  PolygonMode mode;
  if (!look_at(determinant, mode)) return;
  const Slot** corner = arena_.allocate_array<const Slot*>(corners.size());
  for (size_t i = 0; i <= last; ++i) corner[i] = corners[i].vertex;
  finish_corners({corner, corners.size()}, provoking, mode, largest);
  switch (mode) {
  case PolygonMode::Fill:
    for (size_t i = 0; i + 1 < last; ++i) {
      const bool closing = i == 0 && corners[last].boundary,
                 ending = i + 2 == last && corners[i + 1].boundary;
      fill({corner[i], corner[i + 1], corner[last]},
           uint32_t(corners[i].boundary) | uint32_t(ending) << 1 | uint32_t(closing) << 2);
    }
    break;
  case PolygonMode::Line:
    stipple_.reset(), line_begins_ = true;
    if (corners[last].boundary) line(corner[last], corner[0]);
    for (size_t i = 0; i < last; ++i)
      if (corners[i].boundary) line(corner[i], corner[i + 1]);
    break;
  case PolygonMode::Point:
    for (size_t i = 0; i <= last; ++i)
      if (corners[i].boundary) point(corner[i]);
    break;
  }
}

void PolygonStage::fill(const std::array<const Slot*, 3>& corner, uint32_t boundary) {
  if (counting_) return;
  begin(Pending::Triangles, triangles_.count);
  for (size_t i = 0; i < 3; ++i) {
    triangles_.corner[i][triangles_.count] = corner[i];
    triangles_.inner[i] |= uint64_t(~boundary >> i & 1) << triangles_.count;
  }
  ++triangles_.count;
}

void PolygonStage::point(const Slot* vertex) {
  if (counting_) return;
  begin(Pending::Points, points_.count);
  points_.back |= uint64_t(back_) << points_.count;
  points_.corner[points_.count++] = vertex;
}

void PolygonStage::line(const Slot* a, const Slot* b) {
  const Slot* const end[2] = {a, b};
  auto emit = [&](const Slot* from, const Slot* to) {
    begin(Pending::Lines, lines_.count);
    lines_.back |= uint64_t(back_) << lines_.count;
    lines_.begins |= uint64_t(line_begins_) << lines_.count;
    line_begins_ = false;
    lines_.corner[0][lines_.count] = from, lines_.corner[1][lines_.count] = to;
    ++lines_.count;
  };
  if (!draw_.vertex->line_stipple) {
    if (!counting_) emit(a, b);
  } else if (counting_) {
    stipple_.skip(end);
  } else {
    stipple_.cut(end, emit);
  }
}

/// Makes room for one of a kind, of which there are `count`; those of other kinds go first.
void PolygonStage::begin(Pending kind, int32_t count) {
  if (pending_ != kind || count == kAssemblyBatch) finish();
  pending_ = kind;
}

void PolygonStage::finish() {
  switch (pending_) {
  case Pending::None: break;
  case Pending::Triangles: sink_.triangles(draw_, triangles_); break;
  case Pending::Lines: sink_.lines(draw_, lines_); break;
  case Pending::Points: sink_.points(draw_, points_); break;
  }
  pending_ = Pending::None;
  triangles_.count = 0;
  for (uint64_t& edges : triangles_.inner) edges = 0;
  lines_.count = 0, lines_.back = 0, lines_.begins = 0;
  points_.count = 0, points_.back = 0;
}

} // namespace softgl
