#include "raster/smooth_primitives.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/trigonometry.h"
#include "raster/point_setup.h"
#include "raster/raster_draws.h"

namespace softgl {

namespace {

constexpr float kBeyond = 65536.0f; // pixels: no viewport reaches so far; what is not a number fails, too

RasterDraw* make_smooth_draw(const DrawRecord& draw, const FragmentProgram* program,
                             const RasterConstants* constants, Arena& arena) {
  DrawRecord own = draw;
  own.fragment = program;
  own.raster = constants;
  return arena.make<RasterDraw>(make_raster_draw(own));
}

} // namespace

void add_smooth_draws(const DrawRecord& draw, RasterDraw& raster, Arena& arena) {
  const SmoothPrograms& programs = *draw.smooth;
  if (programs.point) raster.smooth_point = make_smooth_draw(draw, programs.point, draw.raster, arena);
  if (programs.line) {
    // A line is drawn as two triangles, which obey nothing that is said about polygons.
    auto* constants = arena.make<RasterConstants>(*draw.raster);
    constants->cull = constants->back = 0;
    constants->two_sided = constants->offset = false;
    constants->stipple = nullptr;
    RasterDraw* lines = make_smooth_draw(draw, programs.line, constants, arena);
    lines->facing = raster.facing;
    raster.smooth_line = lines;
  }
  if (programs.polygon) raster.smooth_polygon = make_smooth_draw(draw, programs.polygon, draw.raster, arena);
}

bool setup_smooth_point(const RasterDraw& draw, const ShadedVertices::Slot* corner, bool back,
                        RasterPrimitive& out) {
  const float *v = corner->v, x = v[0], y = v[1];
  if (!(std::fabs(x) < kBeyond && std::fabs(y) < kBeyond)) return false;
  const float size = draw.layout.point >= 0 ? corner[draw.layout.point].v[0] : draw.raster->point_size;
  const float radius = 0.5f * (size > 1.0f ? std::min(size, 255.0f) : 1.0f); // GL_SMOOTH_POINT_SIZE_RANGE
  const auto floor = [](float f) { return static_cast<int32_t>(std::floor(f)); };
  const WindowBox box = {floor(x - radius), floor(y - radius), floor(x + radius) + 1, floor(y + radius) + 1};
  if (!setup_box(draw, corner, box, out)) return false;
  out.back = back;
  Plane* number = out.plane + coverage_plane(draw);
  number[0] = {x, 0, 0}, number[1] = {y, 0, 0}, number[2] = {radius, 0, 0};
  return true;
}

void smooth_line_corners(const RasterDraw& draw, const ShadedVertices::Slot* const end[2], Arena& arena,
                         const ShadedVertices::Slot* corner[4]) {
  // As OSMesa 22.3.6 (draw_pipe_aaline): half a pixel is added all round.
  const float dx = end[1]->v[0] - end[0]->v[0], dy = end[1]->v[1] - end[0]->v[1];
  const float angle = angle_of(dy, dx), c = cosine(angle), s = sine(angle);
  float half_length = 0.5f * std::sqrt(dx * dx + dy * dy);
  half_length = half_length < 0.5f ? 2.0f * half_length : half_length + 0.5f;
  const float width = draw.raster->line_width, half_width = width <= 1.0f ? 1.0f : 0.5f * width + 0.5f;
  const ShadedLayout& l = draw.layout;
  const size_t slots = l.slots;
  for (int i = 0; i < 4; ++i) {
    const ShadedVertices::Slot* from = end[i / 2];
    auto* to = arena.allocate_array<ShadedVertices::Slot>(slots + 1);
    std::memcpy(to, from, sizeof(*to) * slots);
    if (draw.raster->flat) { // the provoking vertex is the second one
      if (l.color >= 0) to[l.color] = end[1][l.color];
      if (l.secondary >= 0) std::memcpy(to[l.secondary].v, end[1][l.secondary].v, sizeof(float[3]));
    }
    const float along = i < 2 ? -0.5f : 0.5f, across = i & 1 ? -half_width : half_width;
    to[0].v[0] = from[0].v[0] + (along * c - across * s);
    to[0].v[1] = from[0].v[1] + (along * s + across * c);
    to[slots] = {{-across, half_width, i < 2 ? -half_length : half_length, half_length}};
    corner[i] = to;
  }
}

bool snap_smooth_triangle(const RasterDraw& draw, const ShadedVertices::Slot* const corner[3],
                          SmoothTriangle& out) {
  for (int k = 0; k < 3; ++k) {
    const float *v = corner[k]->v, x = v[0], y = v[1];
    if (!(std::fabs(x) < kBeyond && std::fabs(y) < kBeyond)) return false;
    out.x[k] = static_cast<int32_t>(std::lrint((x - 0.5f) * 256.0f));
    out.y[k] = static_cast<int32_t>(std::lrint((y - 0.5f) * 256.0f));
  }
  const int64_t area = int64_t(out.x[0] - out.x[1]) * (out.y[2] - out.y[0]) -
                       int64_t(out.x[2] - out.x[0]) * (out.y[0] - out.y[1]);
  if (area == 0 || (area > 0 ? draw.raster->cull & 1 : draw.raster->cull & 2)) return false;
  out.negative = area < 0;
  if (out.negative) std::swap(out.x[0], out.x[1]), std::swap(out.y[0], out.y[1]);
  return true;
}

void widen_smooth_triangle(const RasterDraw& draw, const SmoothTriangle& t, uint32_t inner,
                           RasterPrimitive& out) {
  const RasterConstants& r = *draw.raster;
  Plane* number = out.plane + coverage_plane(draw);
  for (int k = 0; k < 3; ++k, number += 3) {
    // Exchanged corners: edges 1 and 2 change places.
    if (inner >> (t.negative && k > 0 ? 3 - k : k) & 1) {
      number[0] = {1, 0, 0}, number[1] = number[2] = {0, 0, 0}; // takes nothing away
      continue;
    }
    const int64_t a = out.a[k], b = out.b[k], c = a * t.x[k] - b * t.y[k];
    out.c[k] = (c + 128 * (std::abs(a) + std::abs(b)) - 1) >> 8;
    number[0] = {static_cast<float>(static_cast<double>(c) / 65536), 0, 0};
    number[1] = {static_cast<float>(-a) / 256.0f, 0, 0};
    number[2] = {static_cast<float>(b) / 256.0f, 0, 0};
  }
  const auto [min_x, max_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [min_y, max_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
  out.x0 = std::max((min_x + 127) >> 8, r.x0), out.x1 = std::min(((max_x + 128) >> 8) + 1, r.x1);
  out.y0 = std::max((min_y + 127) >> 8, r.y0), out.y1 = std::min(((max_y + 128) >> 8) + 1, r.y1);
}

} // namespace softgl
