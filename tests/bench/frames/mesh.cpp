#include "frames/mesh.h"

#include <cmath>
#include <numbers>

namespace softgl::bench {

Mesh make_shell(int around, int along) {
  Mesh mesh;
  const double pi = std::numbers::pi;
  for (int j = 0; j <= along; j++)
    for (int i = 0; i <= around; i++) {
      const double longitude = 2 * pi * i / around, latitude = pi * (double(j) / along - 0.5);
      const double wave = 0.06 * std::sin(8 * longitude) * std::cos(6 * latitude) * std::cos(latitude);
      const double direction[3] = {std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                                   std::cos(latitude) * std::sin(longitude)};
      MeshVertex v{};
      for (int k = 0; k < 3; k++) {
        v.position[k] = float((1 + wave) * direction[k]);
        v.normal[k] = float(direction[k]); // of the sphere: good enough to light, and never degenerate
      }
      v.texcoord[0] = float(6.0 * i / around), v.texcoord[1] = float(3.0 * j / along);
      mesh.vertices.push_back(v);
    }
  for (int j = 0; j < along; j++)
    for (int i = 0; i < around; i++) {
      const uint32_t a = uint32_t(j * (around + 1) + i), b = a + 1, c = a + uint32_t(around) + 1, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  return mesh;
}

std::vector<uint8_t> make_image(int size) {
  std::vector<uint8_t> rgba(size_t(size) * size_t(size) * 4);
  for (int y = 0; y < size; y++)
    for (int x = 0; x < size; x++) {
      uint8_t* p = &rgba[(size_t(y) * size_t(size) + size_t(x)) * 4];
      const int u = x * 256 / size, v = y * 256 / size;
      p[0] = uint8_t((u ^ v) | 32), p[1] = uint8_t(u), p[2] = uint8_t(((u / 16 + v / 16) & 1) * 160 + 40),
      p[3] = uint8_t(255 - v / 2);
    }
  return rgba;
}

} // namespace softgl::bench
