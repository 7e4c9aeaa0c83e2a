#include <catch2/catch.hpp>

#include "mesh/polygon_triangulator.h"

#include <chrono>
#include <cmath>
#include <random>
#include <set>
#include <vector>

using softgl::cli::PolygonTriangulator;

namespace {

using Polygon = std::vector<double>;

struct Result {
  std::vector<uint32_t> triangles;
  double area = 0; // of all triangles, whatever their direction
  double signed_area = 0;
};

double signed_area(const Polygon& p, uint32_t a, uint32_t b, uint32_t c) {
  return ((p[3 * b] - p[3 * a]) * (p[3 * c + 1] - p[3 * a + 1]) -
          (p[3 * c] - p[3 * a]) * (p[3 * b + 1] - p[3 * a + 1])) /
         2;
}

Result triangulate(const Polygon& polygon) {
  const auto size = uint32_t(polygon.size() / 3);
  Result result;
  result.triangles.assign(3 * (size - 2), size);
  PolygonTriangulator().triangulate(polygon.data(), size, result.triangles.data());
  for (size_t i = 0; i < result.triangles.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) REQUIRE(result.triangles[i + k] < size);
    const double area =
        signed_area(polygon, result.triangles[i], result.triangles[i + 1], result.triangles[i + 2]);
    result.area += std::fabs(area);
    result.signed_area += area;
  }
  return result;
}

double polygon_area(const Polygon& p) {
  double sum = 0;
  for (size_t i = 0, j = p.size() / 3 - 1; i < p.size() / 3; j = i++)
    sum += p[3 * j] * p[3 * i + 1] - p[3 * i] * p[3 * j + 1];
  return sum / 2;
}

template <class Radius> Polygon star(int corners, Radius radius) {
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners, r = radius(i);
    polygon.insert(polygon.end(), {r * std::cos(angle), r * std::sin(angle), 0});
  }
  return polygon;
}

Polygon spiral(int corners) {
  Polygon polygon;
  for (int i = 0; i < corners / 2; ++i) {
    const double angle = i * 80.0 / corners, r = 1 + angle;
    polygon.insert(polygon.end(), {r * std::cos(angle), r * std::sin(angle), 0});
  }
  for (int i = corners / 2 - 1; i >= 0; --i) {
    const double angle = i * 80.0 / corners, r = 3 + angle;
    polygon.insert(polygon.end(), {r * std::cos(angle), r * std::sin(angle), 0});
  }
  return polygon;
}

} // namespace

TEST_CASE("polygon triangulator: triangles cover a simple polygon exactly", "[models][triangulation]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  for (int corners = 4; corners < 60; ++corners) {
    const Polygon polygon = star(corners, [&](int) { return radius(random); });
    const Result result = triangulate(polygon);
    CHECK(result.area == Approx(polygon_area(polygon)));
    CHECK(result.signed_area == Approx(polygon_area(polygon))); // all turn the polygon's way
  }
}

TEST_CASE("polygon triangulator: thousands of corners", "[models][triangulation]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.1, 1.0);
  const Polygon polygons[] = {star(10000, [](int) { return 1.0; }),
                              star(10000, [](int i) { return i % 2 ? 1.0 : 0.3; }),
                              star(10000, [&](int) { return radius(random); }), spiral(10000)};
  for (const Polygon& polygon : polygons) {
    const Result result = triangulate(polygon);
    CHECK(result.triangles.size() == 3 * 9998);
    CHECK(result.area == Approx(std::fabs(polygon_area(polygon))));
  }
}

TEST_CASE("polygon triangulator: holes joined by bridges", "[models][triangulation]") {
  // A square with square holes in a row, each reached from the hole before it.
  const int holes = 12;
  Polygon outer = {0, 0, 0, 3.0 * holes, 0, 0, 3.0 * holes, 3, 0, 0, 3, 0, 0, 0, 0}, back;
  for (int i = 0; i < holes; ++i) {
    const double x = 3 * i + 1;
    outer.insert(outer.end(), {x, 1, 0, x, 2, 0, x + 1, 2, 0, x + 1, 1, 0});
    Polygon closing = {x, 1, 0};
    if (i + 1 < holes) closing = {x + 1, 1, 0, x, 1, 0};
    back.insert(back.begin(), closing.begin(), closing.end());
  }
  outer.insert(outer.end(), back.begin(), back.end());
  const Result result = triangulate(outer);
  CHECK(result.area == Approx(9.0 * holes - holes));
}

TEST_CASE("polygon triangulator: any plane, any size, any place", "[models][triangulation]") {
  const double arrow[4][2] = {{-1, -1}, {0, -0.3}, {1, -1}, {0, 1}};
  for (const double scale : {1e-30, 1e-3, 1.0, 1e30})
    for (int plane = 0; plane < 3; ++plane)
      for (const bool turned : {false, true}) {
        Polygon polygon, flat;
        for (int i = 0; i < 4; ++i) {
          const double* corner = arrow[turned ? 3 - i : i];
          double p[3] = {0, 0, 0};
          p[plane] = 5 * scale;
          p[(plane + 1) % 3] = corner[0] * scale;
          p[(plane + 2) % 3] = corner[1] * scale;
          polygon.insert(polygon.end(), {p[0], p[1], p[2]});
          flat.insert(flat.end(), {corner[0], corner[1], 0});
        }
        uint32_t triangles[6];
        PolygonTriangulator().triangulate(polygon.data(), 4, triangles);
        CHECK(std::fabs(signed_area(flat, triangles[0], triangles[1], triangles[2])) +
                  std::fabs(signed_area(flat, triangles[3], triangles[4], triangles[5])) ==
              Approx(1.3));
      }
}

TEST_CASE("polygon triangulator: corners on straight edges leave no gap", "[models][triangulation]") {
  // An L with extra corners on its edges, at places that are not exact in binary.
  Polygon polygon;
  const double outline[6][2] = {{0.1, 0.1}, {1.3, 0.1}, {1.3, 0.4}, {0.7, 0.4}, {0.7, 1.9}, {0.1, 1.9}};
  for (int i = 0; i < 6; ++i) {
    const double* a = outline[i];
    const double* b = outline[(i + 1) % 6];
    for (int k = 0; k < 7; ++k)
      polygon.insert(polygon.end(), {a[0] + (b[0] - a[0]) * k / 7, a[1] + (b[1] - a[1]) * k / 7, 0});
  }
  CHECK(triangulate(polygon).area == Approx(1.2 * 0.3 + 0.6 * 1.5));
}

TEST_CASE("polygon triangulator: hopeless polygons end", "[models][triangulation]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(0, 1);
  Polygon crossing, repeated, line;
  for (int i = 0; i < 2000; ++i) {
    crossing.insert(crossing.end(), {place(random), place(random), place(random)});
    repeated.insert(repeated.end(), {double(i % 3), double(i % 2), 0});
    line.insert(line.end(), {double(i), 2.0 * i, 3.0 * i});
  }
  for (const Polygon& polygon : {crossing, repeated, line})
    CHECK(triangulate(polygon).triangles.size() == 3 * 1998);
}
