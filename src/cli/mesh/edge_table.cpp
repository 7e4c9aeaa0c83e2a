#include "mesh/edge_table.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"
#include "mesh/vector.h"

namespace softgl::cli {
namespace {

Vector normal_of(const Mesh& mesh, uint32_t triangle) {
  const auto corner = [&](size_t k) {
    const float* p = &mesh.positions[3 * size_t(mesh.triangles[3 * size_t(triangle) + k])];
    return Vector{p[0], p[1], p[2]};
  };
  return cross(corner(1) - corner(0), corner(2) - corner(0));
}

// For each vertex the first one at its place.
std::vector<uint32_t> weld(const Mesh& mesh) {
  const size_t count = mesh.positions.size() / 3;
  const float* p = mesh.positions.data();
  std::vector<uint32_t> order(count), first(count);
  for (uint32_t i = 0; i < count; ++i) order[i] = i;
  const auto same = [p](uint32_t a, uint32_t b) {
    return std::equal(p + 3 * size_t(a), p + 3 * size_t(a) + 3, p + 3 * size_t(b));
  };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const float *left = p + 3 * size_t(a), *right = p + 3 * size_t(b);
    for (int i = 0; i < 3; ++i)
      if (left[i] != right[i]) return left[i] < right[i];
    return a < b;
  });
  for (size_t i = 0; i < count; ++i)
    first[order[i]] = i > 0 && same(order[i], order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

} // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh) {
  const std::vector<uint32_t> first = weld(mesh);
  struct Side {
    uint64_t ends;
    uint32_t triangle;
  };
  std::vector<Side> sides;
  sides.reserve(mesh.triangles.size());
  for (uint32_t triangle = 0; triangle < mesh.triangles.size() / 3; ++triangle) {
    const Vector normal = normal_of(mesh, triangle);
    if (!(dot(normal, normal) > 0)) continue;
    for (size_t k = 0; k < 3; ++k) {
      const uint64_t a = first[mesh.triangles[3 * size_t(triangle) + k]];
      const uint64_t b = first[mesh.triangles[3 * size_t(triangle) + (k + 1) % 3]];
      if (a != b) sides.push_back({std::min(a, b) << 32 | std::max(a, b), triangle});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
  });
  std::vector<MeshEdge> edges;
  for (size_t i = 0; i < sides.size();) {
    MeshEdge edge{
        uint32_t(sides[i].ends >> 32), uint32_t(sides[i].ends), 0, {sides[i].triangle, sides[i].triangle}};
    size_t end = i;
    for (; end < sides.size() && sides[end].ends == sides[i].ends; ++end) ++edge.faces;
    if (edge.faces > 1) edge.triangles[1] = sides[i + 1].triangle;
    edges.push_back(edge);
    i = end;
  }
  return edges;
}

GrowingArray<float> sharp_edges(const Mesh& mesh, double angle) {
  const double limit = cosine(angle);
  GrowingArray<float> ends;
  for (const MeshEdge& edge : mesh_edges(mesh)) {
    if (edge.faces == 2) {
      const Vector a = normal_of(mesh, edge.triangles[0]), b = normal_of(mesh, edge.triangles[1]);
      // Winding may be mixed: what counts is the angle between the planes.
      if (std::fabs(dot(a, b)) >= limit * std::sqrt(dot(a, a) * dot(b, b))) continue;
    }
    ends.append(&mesh.positions[3 * size_t(edge.first)], 3);
    ends.append(&mesh.positions[3 * size_t(edge.second)], 3);
  }
  return ends;
}

GrowingArray<uint32_t> face_edges(const ObjModel& model) {
  std::vector<uint64_t> sides;
  for (const ObjChunk& chunk : model.chunks) {
    const GrowingArray<int32_t>& corners = chunk.corner_vertices.values;
    size_t corner = 0;
    for (uint32_t face = 0; face < chunk.face_count; ++face) {
      const size_t size = chunk.face_sizes.empty() ? 3 : chunk.face_sizes[face];
      for (size_t k = 0; k < size; ++k) {
        const auto a = uint64_t(corners[corner + k]), b = uint64_t(corners[corner + (k + 1) % size]);
        sides.push_back(std::min(a, b) << 32 | std::max(a, b));
      }
      corner += size;
    }
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  GrowingArray<uint32_t> ends;
  for (const uint64_t side : sides) {
    ends.append(uint32_t(side >> 32));
    ends.append(uint32_t(side));
  }
  return ends;
}

} // namespace softgl::cli
