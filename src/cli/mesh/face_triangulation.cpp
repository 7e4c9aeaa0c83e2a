#include "mesh/face_triangulation.h"

#include <cmath>

#include "mesh/polygon_triangulator.h"
#include "mesh/vector.h"

namespace softgl::cli {
namespace {

class FaceTriangulator {
public:
  explicit FaceTriangulator(const GrowingArray<double>& positions) : positions_(positions) {}

  void triangulate(ObjChunk& chunk) {
    if (chunk.face_sizes.empty()) return;
    places_.truncate(0);
    size_t total = 0;
    for (const uint32_t size : chunk.face_sizes) total += size_t(3) * (size - 2);
    places_.room(total);
    uint32_t first = 0, change = 0, triangles = 0;
    for (uint32_t face = 0; face < chunk.face_count; ++face) {
      while (change < chunk.changes.size() && chunk.changes[change].face <= face)
        chunk.changes[change++].face = triangles;
      const uint32_t size = chunk.face_sizes[face];
      add_face(chunk.corner_vertices.values.data() + first, first, size);
      first += size;
      triangles += size - 2;
    }
    while (change < chunk.changes.size()) chunk.changes[change++].face = triangles;
    reorder(chunk.corner_vertices.values);
    reorder(chunk.corner_texcoords.values);
    reorder(chunk.corner_normals.values);
    chunk.face_sizes.release();
    chunk.face_count = triangles;
  }

private:
  Vector position(int32_t vertex) const {
    const double* p = &positions_[3 * size_t(vertex)];
    return {p[0], p[1], p[2]};
  }

  void add_face(const int32_t* vertices, uint32_t first, uint32_t size) {
    uint32_t* out = places_.extend(size_t(3) * (size - 2));
    if (size == 3) {
      for (uint32_t i = 0; i < 3; ++i) out[i] = first + i;
      return;
    }
    if (size == 4) {
      const Vector a = position(vertices[0]), c = position(vertices[2]);
      const Vector side = c - a;
      const Vector n1 = cross(position(vertices[1]) - a, side), n2 = cross(side, position(vertices[3]) - a);
      // A corner on the wrong side of 1-3 is reflex (or its mirror is): 2-4 is the diagonal inside.
      static constexpr uint32_t kDiagonal[2][6] = {{0, 1, 2, 0, 2, 3}, {0, 1, 3, 1, 2, 3}};
      const uint32_t* corners = kDiagonal[dot(n1, n2) < 0];
      for (uint32_t i = 0; i < 6; ++i) out[i] = first + corners[i];
      return;
    }
    polygon_.truncate(0);
    double* xyz = polygon_.extend(size_t(3) * size);
    for (uint32_t i = 0; i < size; ++i) {
      const Vector p = position(vertices[i]);
      xyz[3 * i] = p.x;
      xyz[3 * i + 1] = p.y;
      xyz[3 * i + 2] = p.z;
    }
    triangulator_.triangulate(xyz, size, out);
    for (uint32_t i = 0; i < 3 * (size - 2); ++i) out[i] += first;
  }

  void reorder(GrowingArray<int32_t>& values) const {
    if (values.empty()) return;
    GrowingArray<int32_t> ordered;
    int32_t* out = ordered.extend(places_.size());
    for (size_t i = 0; i < places_.size(); ++i) out[i] = values[places_[i]];
    values = std::move(ordered);
  }

  const GrowingArray<double>& positions_;
  GrowingArray<uint32_t> places_; // the corner that stands at each place of the triangles
  GrowingArray<double> polygon_;
  PolygonTriangulator triangulator_;
};

} // namespace

void triangulate_faces(ObjModel& model) {
  FaceTriangulator triangulator(model.positions);
  for (ObjChunk& chunk : model.chunks) triangulator.triangulate(chunk);
}

uint64_t triangle_count(const ObjModel& model) {
  uint64_t count = 0;
  for (const ObjChunk& chunk : model.chunks) count += chunk.corner_vertices.values.size() / 3;
  return count;
}

double surface_area(const ObjModel& model) {
  double area = 0;
  for (const ObjChunk& chunk : model.chunks) {
    const GrowingArray<int32_t>& vertices = chunk.corner_vertices.values;
    for (size_t i = 0; i + 2 < vertices.size(); i += 3) {
      const double* p[3];
      for (size_t k = 0; k < 3; ++k) p[k] = &model.positions[3 * size_t(vertices[i + k])];
      const Vector a{p[0][0], p[0][1], p[0][2]}, b{p[1][0], p[1][1], p[1][2]}, c{p[2][0], p[2][1], p[2][2]};
      const Vector n = cross(b - a, c - a);
      area += std::sqrt(dot(n, n)) / 2;
    }
  }
  return area;
}

} // namespace softgl::cli
