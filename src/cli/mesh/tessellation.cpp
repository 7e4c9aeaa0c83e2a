#include "mesh/tessellation.h"

#include <cmath>
#include <unordered_map>

#include "common/trigonometry.h"

namespace softgl::cli {
namespace {

void append_normalized(GrowingArray<float>& normals, const float* a, const float* b) {
  float sum[3], square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    sum[axis] = a[axis] + b[axis];
    square += sum[axis] * sum[axis];
  }
  const float factor = square > 0 ? 1 / std::sqrt(square) : 1;
  for (const float part : sum) normals.append(part * factor);
}

void append_mean(GrowingArray<float>& values, size_t components, uint32_t a, uint32_t b) {
  if (values.empty()) return;
  for (size_t i = 0; i < components; ++i)
    values.append(0.5f * (values[components * a + i] + values[components * b + i]));
}

// The vertices in the middle of edges; neighbouring triangles share them.
class Middles {
public:
  explicit Middles(Mesh& mesh) : mesh_(mesh) { numbers_.reserve(mesh.triangles.size()); }

  uint32_t between(uint32_t a, uint32_t b) {
    const uint64_t edge = uint64_t(a < b ? a : b) << 32 | (a < b ? b : a);
    const auto [entry, added] = numbers_.try_emplace(edge, uint32_t(mesh_.positions.size() / 3));
    if (added) {
      append_mean(mesh_.positions, 3, a, b);
      mesh_.normals.room(3); // the two that follow are read where they lie
      append_normalized(mesh_.normals, &mesh_.normals[3 * size_t(a)], &mesh_.normals[3 * size_t(b)]);
      append_mean(mesh_.texcoords, 2, a, b);
      append_mean(mesh_.colors, 4, a, b);
    }
    return entry->second;
  }

private:
  Mesh& mesh_;
  std::unordered_map<uint64_t, uint32_t> numbers_;
};

} // namespace

Mesh sphere_mesh(int slices) {
  Mesh mesh;
  const int stacks = slices / 2;
  for (int stack = 0; stack <= stacks; ++stack) {
    const double latitude = 180.0 * stack / stacks;
    for (int slice = 0; slice < slices; ++slice) {
      const double longitude = 360.0 * slice / slices;
      const double place[3] = {sine(latitude) * sine(longitude), cosine(latitude),
                               sine(latitude) * cosine(longitude)};
      for (const double value : place) {
        mesh.positions.append(float(value));
        mesh.normals.append(float(value));
      }
    }
  }
  const auto vertex = [slices](int stack, int slice) { return uint32_t(stack * slices + slice % slices); };
  for (int stack = 0; stack < stacks; ++stack)
    for (int slice = 0; slice < slices; ++slice) {
      const uint32_t below = vertex(stack + 1, slice), right = vertex(stack, slice + 1);
      const uint32_t left_half[3] = {vertex(stack, slice), below, right};
      const uint32_t right_half[3] = {right, below, vertex(stack + 1, slice + 1)};
      if (stack > 0) mesh.triangles.append(left_half, 3); // at a pole it has no area
      if (stack < stacks - 1) mesh.triangles.append(right_half, 3);
    }
  mesh.triangle_batches.push_back({0, 0, uint32_t(mesh.triangles.size())});
  return mesh;
}

Mesh subdivide(const Mesh& mesh) {
  Mesh fine;
  fine.positions.append(mesh.positions.data(), mesh.positions.size());
  fine.normals.append(mesh.normals.data(), mesh.normals.size());
  fine.texcoords.append(mesh.texcoords.data(), mesh.texcoords.size());
  fine.colors.append(mesh.colors.data(), mesh.colors.size());
  fine.triangles.room(4 * mesh.triangles.size());
  Middles middles(fine);
  for (size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const uint32_t* corner = &mesh.triangles[i];
    uint32_t middle[3];
    for (size_t k = 0; k < 3; ++k) middle[k] = middles.between(corner[k], corner[(k + 1) % 3]);
    const uint32_t four[12] = {corner[0], middle[0], middle[2], middle[0], corner[1], middle[1],
                               middle[2], middle[1], corner[2], middle[0], middle[1], middle[2]};
    fine.triangles.append(four, 12);
  }
  fine.triangle_batches = mesh.triangle_batches;
  for (Batch& batch : fine.triangle_batches) {
    batch.first *= 4;
    batch.count *= 4;
  }
  return fine;
}

} // namespace softgl::cli
