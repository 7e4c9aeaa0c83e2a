#include <catch2/catch.hpp>

#include "mesh/tessellation.h"

#include <cmath>
#include <map>

using namespace softgl::cli;

namespace {

const float* position(const Mesh& mesh, size_t index) {
  return &mesh.positions[3 * size_t(mesh.triangles[index])];
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const float *a = position(mesh, i), *b = position(mesh, i + 1), *c = position(mesh, i + 2);
    double u[3], v[3];
    for (int k = 0; k < 3; ++k) {
      u[k] = b[k] - a[k];
      v[k] = c[k] - a[k];
    }
    sum += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return sum;
}

// Every edge between two places is walked once in each direction.
bool closed(const Mesh& mesh) {
  using Place = std::array<float, 3>;
  std::map<std::pair<Place, Place>, int> walked;
  const auto place = [&](size_t index) {
    const float* p = position(mesh, index);
    return Place{p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f}; // -0 is 0
  };
  for (size_t i = 0; i < mesh.triangles.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) ++walked[{place(i + k), place(i + (k + 1) % 3)}];
  for (const auto& [edge, count] : walked) {
    const auto back = walked.find({edge.second, edge.first});
    if (count != 1 || back == walked.end() || back->second != 1) return false;
  }
  return true;
}

} // namespace

TEST_CASE("tessellation: spheres are closed, face outwards and come near the true area", "[models]") {
  const double exact = 4 * 3.14159265358979323846;
  double before = 0;
  for (const int slices : {8, 16, 32, 64}) {
    const Mesh mesh = sphere_mesh(slices);
    INFO(slices);
    CHECK(mesh.triangles.size() / 3 == size_t(2 * slices * (slices / 2 - 1)));
    CHECK(closed(mesh));
    for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const float *a = position(mesh, i), *b = position(mesh, i + 1), *c = position(mesh, i + 2);
      const double volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                            a[2] * (b[0] * c[1] - b[1] * c[0]);
      REQUIRE(volume > 0);
    }
    CHECK(area(mesh) < exact);
    CHECK(area(mesh) > before);
    before = area(mesh);
  }
  CHECK(before > 0.99 * exact);
}

TEST_CASE("tessellation: cutting triangles keeps surface, batches and unit normals", "[models]") {
  Mesh mesh = sphere_mesh(8);
  mesh.triangle_batches = {{3, 0, 30}, {5, 30, uint32_t(mesh.triangles.size()) - 30}};
  const Mesh fine = subdivide(mesh);
  CHECK(fine.triangles.size() == 4 * mesh.triangles.size());
  CHECK(area(fine) == Approx(area(mesh)).epsilon(1e-6)); // sums of floats' middles
  CHECK(closed(fine));
  REQUIRE(fine.triangle_batches.size() == 2);
  CHECK(fine.triangle_batches[1].material == 5);
  CHECK(fine.triangle_batches[1].first == 120);
  CHECK(fine.triangle_batches[1].count == 4 * mesh.triangle_batches[1].count);
  for (size_t i = 0; i < fine.normals.size(); i += 3)
    REQUIRE(std::hypot(fine.normals[i], fine.normals[i + 1], fine.normals[i + 2]) ==
            Approx(1).margin(1e-6)); // rounding of floats
}
