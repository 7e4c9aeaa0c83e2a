// GL 1.5, 3.3.1, 3.4.4, 3.5.6, 3.11: alpha is multiplied by the part of a pixel's square that an antialiased
// point, line or polygon covers.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spec/state_snapshot.h"
#include "support/random.h"

namespace softgl::test {
namespace {

constexpr int kSize = 64; // of the window

/// A context in which one unit is a pixel.
class Pixels {
public:
  Pixels() : gl(softgl_library()), context_(gl) {
    gl.MatrixMode(GL_PROJECTION);
    gl.Ortho(0, kSize, 0, kSize, -1, 1);
  }
  /// Red, green, blue and alpha of all pixels, from the lower left one on.
  std::vector<GLubyte> read() {
    std::vector<GLubyte> p(kSize * kSize * 4);
    gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, p.data());
    return p;
  }
  void draw(GLenum mode, const std::vector<Float2>& corners) {
    gl.Begin(mode);
    for (const Float2& c : corners) gl.Vertex2fv(c.data());
    gl.End();
  }
  const Gl& gl;

private:
  CurrentContext context_;
};

int alpha(const std::vector<GLubyte>& p, int x, int y) { return p[size_t(y * kSize + x) * 4 + 3]; }

/// The area of the square of pixel (x, y) in which span(column) says from where to where is inside: exact but
/// for the columns' width.
template <class Span> double covered(int x, int y, const Span& span) {
  constexpr int kColumns = 512;
  double area = 0;
  for (int i = 0; i < kColumns; i++) {
    const auto [low, high] = span(x + (i + 0.5) / kColumns);
    area += std::max(0.0, std::min(high, y + 1.0) - std::max(low, double(y)));
  }
  return area / kColumns;
}

struct Span {
  double low, high;
};

/// Of a convex polygon whose corners go round counterclockwise.
Span span_of(const std::vector<Float2>& corners, double x) {
  Span s{-1e9, 1e9};
  for (size_t i = 0; i < corners.size(); i++) {
    const Float2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = double(b[0]) - a[0], dy = double(b[1]) - a[1];
    const double y = a[1] + (x - a[0]) * dy / dx;
    if (dx > 0)
      s.low = std::max(s.low, y);
    else if (dx < 0)
      s.high = std::min(s.high, y);
    else if ((x - a[0]) * dy > 0) // on the right of an edge that goes up
      s.high = -1e9;
  }
  return s;
}

/// The largest difference of an alpha from the part of the square that is covered, in 1/255.
template <class Part> double largest_error(const std::vector<GLubyte>& p, const Part& part) {
  double largest = 0;
  for (int y = 0; y < kSize; y++)
    for (int x = 0; x < kSize; x++) largest = std::max(largest, std::fabs(alpha(p, x, y) - 255 * part(x, y)));
  return largest;
}

} // namespace

TEST_CASE("an antialiased point covers what its disk covers", "[spec][antialiasing]") {
  struct Point {
    float size, x, y;
  };
  for (const Point& point : {Point{1, 20.5f, 20.5f}, Point{1, 20.1f, 20.8f}, Point{1.5f, 30, 30},
                             Point{3, 31.3f, 17.9f}, Point{7.25f, 40.7f, 22.2f}, Point{31, 32, 32}}) {
    Pixels w;
    w.gl.Enable(GL_POINT_SMOOTH);
    w.gl.PointSize(point.size);
    w.draw(GL_POINTS, {{point.x, point.y}});
    const double r = point.size / 2;
    const auto disk = [&](double x) {
      const double h2 = r * r - (x - point.x) * (x - point.x), h = h2 > 0 ? std::sqrt(h2) : 0;
      return h > 0 ? Span{point.y - h, point.y + h} : Span{0, 0};
    };
    INFO("size " << point.size << " at " << point.x << ", " << point.y);
    CHECK(largest_error(w.read(), [&](int x, int y) { return covered(x, y, disk); }) < 2);
  }
}

TEST_CASE("the square of a point sprite is not antialiased", "[spec][antialiasing]") {
  Pixels w;
  w.gl.Enable(GL_POINT_SMOOTH);
  w.gl.Enable(GL_POINT_SPRITE);
  w.gl.PointSize(8);
  w.draw(GL_POINTS, {{32, 32}});
  const std::vector<GLubyte> p = w.read();
  CHECK(std::count(p.begin(), p.end(), GLubyte(255)) == 4 * 64);
}

TEST_CASE("an antialiased triangle covers its area of each pixel", "[spec][antialiasing]") {
  const std::vector<std::vector<Float2>> triangles = {
      {{10.3f, 10.2f}, {50.8f, 14.1f}, {22.4f, 55.5f}},
      {{10, 10}, {40.5f, 10}, {40.5f, 40.25f}},
      {{5.2f, 30.4f}, {60.1f, 31.2f}, {59.3f, 31.9f}},  // thinner than a pixel
      {{30.2f, 30.3f}, {30.8f, 30.4f}, {30.5f, 30.9f}}, // inside of one
  };
  for (const auto& corners : triangles)
    for (const bool reversed : {false, true}) {
      Pixels w;
      w.gl.Enable(GL_POLYGON_SMOOTH);
      w.draw(GL_TRIANGLES, reversed ? std::vector<Float2>(corners.rbegin(), corners.rend()) : corners);
      const auto span = [&](double x) { return span_of(corners, x); };
      INFO("triangle from " << corners[0][0] << ", " << corners[0][1]);
      // Corners are on a grid of 1/256 pixel.
      CHECK(largest_error(w.read(), [&](int x, int y) { return covered(x, y, span); }) < 2.5);
    }
}

TEST_CASE("the edges inside an antialiased polygon are not seen", "[spec][antialiasing]") {
  const std::vector<Float2> corners = {{12.3f, 8.4f}, {50.6f, 14.2f}, {55.7f, 40.1f}, {9.4f, 52.8f}};
  for (const GLenum mode : {GL_QUADS, GL_POLYGON}) {
    Pixels w;
    w.gl.Enable(GL_POLYGON_SMOOTH);
    w.gl.Enable(GL_BLEND);
    w.gl.BlendFunc(GL_ONE, GL_ONE);
    w.gl.Color4f(0, 0, 0, 0.2f);
    w.draw(mode, corners);
    const std::vector<GLubyte> p = w.read();
    const auto span = [&](double x) { return span_of(corners, x); };
    int inside = 0, wrong = 0;
    for (int y = 0; y < kSize; y++)
      for (int x = 0; x < kSize; x++) {
        const double part = covered(x, y, span);
        inside += part == 1;
        // Where the cut meets a corner, each triangle knows its own edges only.
        wrong += std::fabs(alpha(p, x, y) - 51 * part) > (part == 1 || part == 0 ? 0.01 : 1);
      }
    CHECK(inside > 1000);
    CHECK(wrong <= 4);
  }
}

TEST_CASE("an antialiased triangle is cut at the window's border", "[spec][antialiasing]") {
  const std::vector<Float2> corners = {{-20, 20}, {90, 22}, {30, 90}};
  Pixels w;
  w.gl.Enable(GL_POLYGON_SMOOTH);
  w.draw(GL_TRIANGLES, corners);
  const std::vector<GLubyte> p = w.read();
  const auto span = [&](double x) { return span_of(corners, x); };
  int wrong = 0; // only where cuts meet corners
  for (int y = 0; y < kSize; y++)
    for (int x = 0; x < kSize; x++) wrong += std::fabs(alpha(p, x, y) - 255 * covered(x, y, span)) > 2.5;
  CHECK(wrong <= 4);
}

TEST_CASE("the window's border cuts an antialiased polygon without an edge", "[spec][antialiasing]") {
  Pixels w;
  w.gl.Enable(GL_POLYGON_SMOOTH);
  w.gl.Viewport(8, 8, 40, 40); // 64 units wide
  w.draw(GL_TRIANGLES, {{-100, -100}, {300, -100}, {-100, 300}});
  const std::vector<GLubyte> p = w.read();
  for (int i = 8; i < 48; i++) {
    REQUIRE(alpha(p, i, 8) == 255);
    REQUIRE(alpha(p, 8, i) == 255);
    REQUIRE(alpha(p, 20, i) == 255);
  }
  CHECK(alpha(p, 7, 20) == 0);
}

TEST_CASE("antialiased polygons are culled and stippled as others", "[spec][antialiasing]") {
  Pixels w;
  w.gl.Enable(GL_POLYGON_SMOOTH);
  w.gl.Enable(GL_CULL_FACE);
  w.draw(GL_TRIANGLES, {{10, 10}, {20, 50}, {50, 10}});
  std::vector<GLubyte> p = w.read();
  CHECK(std::count(p.begin(), p.end(), GLubyte(0)) == kSize * kSize * 4);
  std::array<GLubyte, 128> rows{};
  for (size_t i = 0; i < rows.size(); i++) rows[i] = i / 4 % 2 ? 0xff : 0;
  w.gl.PolygonStipple(rows.data());
  w.gl.Enable(GL_POLYGON_STIPPLE);
  w.draw(GL_TRIANGLES, {{10, 10}, {50, 10}, {20, 50}});
  p = w.read();
  CHECK(alpha(p, 22, 21) == 255);
  CHECK(alpha(p, 22, 22) == 0);
}

TEST_CASE("an antialiased line covers as much as its rectangle", "[spec][antialiasing]") {
  for (const float width : {1.0f, 2.0f, 3.5f, 8.0f})
    for (const float degrees : {0.0f, 10.0f, 45.0f, 77.0f, 90.0f, 160.0f}) {
      Pixels w;
      w.gl.Enable(GL_LINE_SMOOTH);
      w.gl.LineWidth(width);
      const float x = 20 * std::cos(degrees * 0.0174533f), y = 20 * std::sin(degrees * 0.0174533f);
      w.draw(GL_LINES, {{32 - x, 32 - y}, {32 + x, 32 + y}});
      double sum = 0;
      const std::vector<GLubyte> p = w.read();
      for (int i = 0; i < kSize * kSize; i++) sum += p[size_t(i) * 4 + 3] / 255.0;
      INFO("width " << width << " at " << degrees << " degrees");
      CHECK(sum == Approx(width * 40).epsilon(width == 1 ? 0.13 : 0.05)); // the ramps are sampled at centers
    }
}

TEST_CASE("coverage comes in front of the alpha test, and to lines of polygons and lists",
          "[spec][antialiasing]") {
  Pixels w;
  w.gl.Enable(GL_LINE_SMOOTH);
  w.gl.Enable(GL_ALPHA_TEST);
  w.gl.AlphaFunc(GL_LESS, 0.9f);
  w.gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  w.gl.LineWidth(5);
  w.gl.NewList(1, GL_COMPILE);
  w.draw(GL_TRIANGLES, {{10, 10}, {50, 10}, {20, 50}});
  w.gl.EndList();
  w.gl.CallList(1);
  const std::vector<GLubyte> p = w.read();
  CHECK(alpha(p, 30, 10) == 0); // the middle of an edge
  int some = 0, full = 0;
  for (int i = 0; i < kSize * kSize; i++)
    some += p[size_t(i) * 4 + 3] > 0, full += p[size_t(i) * 4 + 3] > 230;
  CHECK(some > 50);
  CHECK(full == 0);
}

} // namespace softgl::test
