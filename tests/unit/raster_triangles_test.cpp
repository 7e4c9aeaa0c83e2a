// Triangles against a plain scalar rasterizer with 64-bit edges, small against block path, instruction sets
// against each other.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "raster_support.h"
#include "shaders/raster/sample_points.h"

using namespace raster_test;

namespace {

/// Of the plane through three corners, in OSMesa's order, whose origin is `center` of the first pixel.
float value(const float* a, const float p[3][4], float center, float px, float py) {
  const float dx01 = p[0][0] - p[1][0], dy01 = p[0][1] - p[1][1], dx20 = p[2][0] - p[0][0],
              dy20 = p[2][1] - p[0][1];
  const float r = 1.0f / (dx01 * dy20 - dy01 * dx20);
  const float sx01 = dx01 * r, sy01 = dy01 * r, sx20 = dx20 * r, sy20 = dy20 * r;
  const float gx = (a[0] - a[1]) * sy20 - (a[2] - a[0]) * sy01;
  const float gy = (a[2] - a[0]) * sx01 - (a[0] - a[1]) * sx20;
  const float origin = a[0] - (gx * (p[0][0] - center) + gy * (p[0][1] - center));
  return gy * py + (gx * px + origin);
}

uint32_t byte_of(float v) {
  const float c = v > 0 ? (v < 1 ? v : 1.0f) : 0.0f;
  return uint32_t(std::lrint(c * 255.0f));
}

/// One triangle, pixel by pixel: all that lie within a pixel of its corners' box.
void reference_triangle(const Canvas& canvas, const RasterConstants& rc, const ShadedVertices::Slot* v) {
  const Surface& s = canvas.surface;
  float p[3][4], c[3][4];
  int64_t x[3], y[3];
  for (int k = 0; k < 3; ++k) memcpy(p[k], v[2 * k].v, 16), memcpy(c[k], v[2 * k + 1].v, 16);
  const float center = rc.pixel_center;
  for (int k = 0; k < 3; ++k)
    x[k] = std::llrint((p[k][0] - center) * 256.0f), y[k] = std::llrint((p[k][1] - center) * 256.0f);
  const int64_t area = (x[0] - x[1]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[0] - y[1]);
  if (area == 0 || (area > 0 && (rc.cull & 1)) || (area < 0 && (rc.cull & 2))) return;
  if (area < 0) {
    std::swap(x[0], x[1]), std::swap(y[0], y[1]);
    for (int i = 0; i < 4; ++i) std::swap(p[0][i], p[1][i]), std::swap(c[0][i], c[1][i]);
  }
  int64_t ea[3], eb[3], ec[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    ea[i] = y[i] - y[j], eb[i] = x[i] - x[j];
    ec[i] = ea[i] * x[i] - eb[i] * y[i] + ((ea[i] < 0 || (ea[i] == 0 && eb[i] < 0)) ? 1 : 0);
  }
  auto* color = static_cast<uint32_t*>(s.color);
  const float z[3] = {p[0][2], p[1][2], p[2][2]}, w[3] = {p[0][3], p[1][3], p[2][3]};
  const auto draw_sample = [&](int px, int py, int sample) {
    const int sx = rc.per_sample ? kSampleX[sample] : 0, sy = rc.per_sample ? kSampleY[sample] : 0;
    const int64_t x = px * 256 + sx, y = py * 256 + sy;
    for (int i = 0; i < 3; ++i)
      if (ec[i] - ea[i] * x + eb[i] * y <= 0) return;
    const size_t at = color_index(s, px, py) + size_t(sample);
    const float fz = value(z, p, center, float(x) / 256, float(y) / 256);
    const uint32_t depth = uint32_t(std::lrint((fz > 0 ? (fz < 1 ? fz : 1.0f) : 0.0f) * 16777215.0f));
    if (depth >= s.depth_stencil[at]) return;
    s.depth_stencil[at] = depth;
    const float cx = float(px) + (0.5f - center), cy = float(py) + (0.5f - center); // the pixel's center
    const float rw = 1.0f / value(w, p, center, cx, cy);
    color[at] = 0;
    for (int k = 0; k < 4; ++k) {
      const float a[3] = {c[0][k] * w[0], c[1][k] * w[1], c[2][k] * w[2]};
      color[at] |= byte_of(value(a, p, center, cx, cy) * rw) << (8 * k);
    }
  };
  const auto first = [](const int64_t* v, int low) {
    return std::max(low, int(std::min({v[0], v[1], v[2]}) / 256) - 1);
  };
  const auto end = [](const int64_t* v, int high) {
    return std::min(high, int(std::max({v[0], v[1], v[2]}) / 256) + 2);
  };
  for (int py = first(y, rc.y0); py < end(y, rc.y1); ++py)
    for (int px = first(x, rc.x0); px < end(x, rc.x1); ++px)
      for (int sample = 0; sample < s.samples; ++sample)
        if (rc.sample_mask >> sample & 1) draw_sample(px, py, sample);
}

Canvas drawn(const Vertices& v, bool small, int scissor = 0, uint8_t cull = 0, const Kernels& k = kernels(),
             size_t unit = 5000) {
  Canvas canvas(157, 131);
  Draw draw(canvas.surface);
  draw.raster.x0 += scissor, draw.raster.y0 += 2 * scissor, draw.raster.x1 -= 3 * scissor,
      draw.raster.y1 -= scissor;
  draw.raster.cull = cull;
  draw.derive();
  draw.derived.small = small;
  draw_triangles(canvas, draw, v, k, unit);
  return canvas;
}

} // namespace

TEST_CASE("triangles equal the plain scalar rasterizer", "[raster]") {
  for (int category = 0; category < kCategories; ++category)
    for (int round = 0; round < 3; ++round) {
      INFO("category " << category << " round " << round);
      const Vertices v =
          random_triangles(uint32_t(100 * category + round), Category(category), 700, 157, 131);
      const int scissor = round == 1 ? 13 : 0;
      const uint8_t cull = round == 2 ? 1 : 0;
      Canvas expected(157, 131);
      Draw draw(expected.surface);
      draw.raster.x0 += scissor, draw.raster.y0 += 2 * scissor, draw.raster.x1 -= 3 * scissor,
          draw.raster.y1 -= scissor;
      draw.raster.cull = cull;
      {
        const FloatEnvironment environment;
        for (size_t i = 0; i < v.size(); i += 6) reference_triangle(expected, draw.raster, &v[i]);
      }
      size_t wrong = 0;
      const Canvas got = drawn(v, true, scissor, cull);
      for (size_t i = 0; i < got.color.size(); ++i)
        wrong += got.color[i] != expected.color[i] || got.depth[i] != expected.depth[i];
      CHECK(wrong == 0);
      CHECK(drawn(v, false, scissor, cull) == expected);
    }
}

TEST_CASE("triangles reach up to 64 pixels out of a small scissor box", "[raster]") {
  for (int round = 0; round < 20; ++round) {
    INFO("round " << round);
    const int x = 7 * round % 140, y = 11 * round % 110, side = 1 + round % 16; // on borders of tiles, too
    Vertices v;
    std::mt19937 random{uint32_t(round)};
    auto uniform = [&](float lo, float hi) {
      return lo + (hi - lo) * float(random() >> 8) * (1.0f / 16777216.0f);
    };
    for (int i = 0; i < 400; ++i) {
      const float extent = round % 2 ? 63.9f : 31.0f, px = uniform(float(x) - extent, float(x + side)),
                  py = uniform(float(y) - extent, float(y + side));
      for (int k = 0; k < 3; ++k) {
        float cx = px + uniform(0, extent);
        float cy = py + uniform(0, extent);
        if (i % 3 == 0) cx = std::floor(cx) + 0.5f, cy = std::floor(cy) + 0.5f; // edges through pixel centres
        v.push_back({{cx, cy, uniform(0, 1), 1}});
        v.push_back({{uniform(0, 1), uniform(0, 1), uniform(0, 1), 1}});
      }
    }
    Canvas expected(157, 131);
    Draw draw(expected.surface);
    draw.raster.x0 = x, draw.raster.y0 = y, draw.raster.x1 = std::min(x + side, 157),
    draw.raster.y1 = std::min(y + side, 131);
    draw.derive();
    {
      const FloatEnvironment environment;
      for (size_t i = 0; i < v.size(); i += 6) reference_triangle(expected, draw.raster, &v[i]);
    }
    for (int isa = 0; isa <= int(detect_isa()); ++isa) {
      const Kernels* k = find_kernels(Isa(isa));
      if (!k) continue;
      INFO("instruction set " << isa_name(Isa(isa)));
      Canvas got(157, 131);
      draw_triangles(got, draw, v, *k);
      CHECK(got == expected);
    }
  }
}

TEST_CASE("samples of triangles equal the plain scalar rasterizer", "[raster]") {
  for (int category = 0; category < kCategories; ++category)
    for (int round = 0; round < 3; ++round) {
      INFO("category " << category << " round " << round);
      const Vertices v =
          random_triangles(uint32_t(500 + 10 * category + round), Category(category), 700, 157, 131);
      Canvas expected(157, 131, ColorFormat::Rgba8, kSamples);
      Draw draw(expected.surface);
      if (round == 1) draw.raster.x0 = 13, draw.raster.y0 = 26, draw.raster.x1 -= 39, draw.raster.y1 -= 7;
      if (round == 2) draw.raster.sample_mask = 6, draw.raster.cull = 1;
      {
        const FloatEnvironment environment;
        for (size_t i = 0; i < v.size(); i += 6) reference_triangle(expected, draw.raster, &v[i]);
      }
      for (int isa = 0; isa <= int(detect_isa()); ++isa) {
        const Kernels* k = find_kernels(Isa(isa));
        if (!k) continue;
        for (bool small : {true, false}) {
          INFO("instruction set " << isa_name(Isa(isa)) << (small ? ", small ones apart" : ""));
          Canvas got(157, 131, ColorFormat::Rgba8, kSamples);
          draw.derive();
          REQUIRE(draw.derived.small);
          draw.derived.small = small;
          draw_triangles(got, draw, v, *k);
          CHECK(got == expected);
        }
      }
    }
}

TEST_CASE("without a color plane depths are the same, and nothing beyond the scratch words is written",
          "[raster]") {
  const Vertices v = random_triangles(77, Mixed, 1500, 157, 131);
  for (int samples : {1, kSamples})
    for (bool small : {true, false}) {
      INFO(samples << (small ? " samples, small ones apart" : " samples"));
      Canvas with(157, 131, ColorFormat::Rgba8, samples), without(157, 131, ColorFormat::Rgba8, samples);
      without.surface.color = nullptr, without.surface.color_tile = nullptr;
      for (Canvas* canvas : {&with, &without}) {
        Draw draw(canvas->surface);
        draw.derive();
        draw.derived.small = small;
        draw_triangles(*canvas, draw, v); // the address sanitizer sees what lies beyond
      }
      CHECK(without.depth == with.depth);
      CHECK(without.depth != Canvas(157, 131, ColorFormat::Rgba8, samples).depth);
    }
}

TEST_CASE("small triangles, blocks, units and instruction sets draw the same", "[raster]") {
  for (int category = 0; category < kCategories; ++category) {
    INFO("category " << category);
    const Vertices v = random_triangles(uint32_t(7000 + category), Category(category), 3000, 157, 131);
    const Canvas first = drawn(v, true);
    CHECK(drawn(v, false) == first);
    CHECK(drawn(v, true, 0, 0, kernels(), 777) == first);
    for (int isa = 0; isa <= int(detect_isa()); ++isa) {
      INFO("instruction set " << isa_name(Isa(isa)));
      const Kernels* k = find_kernels(Isa(isa));
      if (!k) continue;
      CHECK(drawn(v, true, 0, 0, *k) == first);
      CHECK(drawn(v, false, 0, 0, *k) == first);
    }
  }
}

TEST_CASE("coordinates that are not numbers or too large draw nothing and do no harm", "[raster]") {
  const float bad[] = {NAN, INFINITY, -INFINITY, 3e38f, -3e38f, 1e9f, 70000.0f, -70000.0f};
  Vertices v;
  for (float b : bad)
    for (int k = 0; k < 6; ++k)
      for (int c = 0; c < 3; ++c) {
        v.push_back({{c == k % 3 && k < 3 ? b : 10.0f * float(c),
                      c == k % 3 && k >= 3 ? b : float(c * c) * 7.0f, 0.5f, 1.0f}});
        v.push_back({{1, 1, 1, 1}});
      }
  CHECK(drawn(v, true) == Canvas(157, 131));
}

namespace {

/// Alpha test, fog and blending, so that stages run and the order of fragments matters.
Canvas staged(const Vertices& v, bool small, const Kernels& k, ColorFormat format = ColorFormat::Rgba8,
              bool stencil = false) {
  Canvas canvas(157, 131, format);
  Draw draw(canvas.surface);
  FragmentKey& key = draw.program.key;
  key.fog_mode = uint64_t(FogMode::Exp2);
  key.alpha_function = uint64_t(Compare::Greater);
  key.depth_function = uint64_t(Compare::LessEqual);
  key.blend = 1;
  key.blend_source_rgb = key.blend_source_alpha = uint64_t(BlendFactor::SourceAlpha);
  key.blend_destination_rgb = key.blend_destination_alpha = uint64_t(BlendFactor::OneMinusSourceColor);
  if (stencil) {
    key.stencil = 1;
    key.stencil_function = uint64_t(Compare::NotEqual);
    key.stencil_fail = uint64_t(StencilOperation::Increment),
    key.stencil_depth_fail = uint64_t(StencilOperation::Invert);
    key.stencil_pass = uint64_t(StencilOperation::IncrementWrap);
    draw.constants.stencil_reference = 3, draw.constants.stencil_value_mask = 7,
    draw.constants.stencil_write_mask = 0x3f;
  }
  draw.constants.alpha_reference = 0.2f, draw.constants.alpha_reference_8 = 51;
  draw.constants.fog_scale = 0.9f;
  draw.constants.fog_color[1] = 0.7f;
  draw.record.layout.secondary = 1; // the color's alpha serves as fog coordinate
  draw.program.add(k.raster->fog_exp2);
  draw.program.add(format == ColorFormat::Rgba8 ? k.raster->alpha_test_8 : k.raster->alpha_test_float,
                   int32_t(Compare::Greater));
  draw.derive();
  draw.derived.small = draw.derived.small && small;
  draw_triangles(canvas, draw, v, k);
  return canvas;
}

} // namespace

TEST_CASE("fragments of small, dense and wide primitives go through a program alike", "[raster]") {
  for (int category = 0; category < kCategories; ++category)
    for (int variant = 0; variant < 3; ++variant) {
      INFO("category " << category << " variant " << variant);
      const auto format = variant == 2 ? ColorFormat::Rgb565 : ColorFormat::Rgba8;
      const Vertices v = random_triangles(uint32_t(9000 + category), Category(category), 1000, 157, 131);
      const Canvas first = staged(v, true, kernels(), format, variant == 1);
      CHECK(staged(v, false, kernels(), format, variant == 1) == first);
      for (int isa = 0; isa <= int(detect_isa()); ++isa)
        if (const Kernels* k = find_kernels(Isa(isa)))
          CHECK(staged(v, true, *k, format, variant == 1) == first);
    }
}

TEST_CASE("blending and logic operations of plain blocks are those of staged ones", "[raster]") {
  for (unsigned equation = 0; equation < 5; ++equation)
    for (unsigned factor = 0; factor < 15; ++factor) {
      const Vertices v = random_triangles(equation * 100 + factor, Mixed, 300, 157, 131);
      auto draw_with = [&](bool direct, bool small) {
        Canvas canvas(157, 131);
        Draw draw(canvas.surface);
        FragmentKey& key = draw.program.key;
        key.blend = equation < 4, key.logic_op = equation == 4;
        key.blend_equation = equation;
        key.blend_source_rgb = factor, key.blend_destination_rgb = (factor * 7 + equation) % 15;
        key.blend_source_alpha = (factor * 4 + 3) % 15, key.blend_destination_alpha = (factor + 5) % 15;
        for (int i = 0; i < 4; ++i) draw.constants.blend_color_8[i] = uint8_t(40 * i + 9);
        draw.derive();
        draw.derived.direct = direct, draw.derived.small = small;
        draw_triangles(canvas, draw, v);
        return canvas;
      };
      INFO("equation " << equation << " factor " << factor);
      const Canvas first = draw_with(true, true);
      CHECK(draw_with(false, false) == first);
      CHECK(draw_with(false, true) == first);
      CHECK(draw_with(true, false) == first);
    }
}
