#include "figure/figure_meshes.h"

#include "common/trigonometry.h"

namespace softgl::cli {
namespace {

// `columns` times `rows` rectangles; normal_at(u) writes the normal at a place from 0 (left) to 1.
template <class Normal> Mesh grid(int columns, int rows, Normal normal_at) {
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const double u = double(column) / columns, v = double(row) / rows;
      const float position[3] = {float(2 * u - 1), float(2 * v - 1), 0};
      float normal[3];
      normal_at(u, normal);
      mesh.positions.append(position, 3);
      mesh.normals.append(normal, 3);
    }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto corner = [&](int up, int right) {
        return uint32_t((row + up) * (columns + 1) + column + right);
      };
      const uint32_t two_triangles[6] = {corner(0, 0), corner(0, 1), corner(1, 1),
                                         corner(0, 0), corner(1, 1), corner(1, 0)};
      mesh.triangles.append(two_triangles, 6);
    }
  mesh.triangle_batches.push_back({0, 0, uint32_t(mesh.triangles.size())});
  return mesh;
}

} // namespace

Mesh square_mesh(int cells) {
  return grid(cells, cells, [](double, float* normal) {
    normal[0] = normal[1] = 0;
    normal[2] = 1;
  });
}

Mesh band_mesh(int strips, double angle) {
  return grid(strips, 1, [angle](double u, float* normal) {
    normal[0] = float(sine(angle * (2 * u - 1)));
    normal[1] = 0;
    normal[2] = float(cosine(angle * (2 * u - 1)));
  });
}

} // namespace softgl::cli
