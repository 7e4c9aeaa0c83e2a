// The shapes that the workloads draw.
#pragma once

#include <cstdint>
#include <vector>

namespace softgl::bench {

struct MeshVertex {
  float position[3], normal[3], texcoord[2];
};

struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<uint32_t> indices; // triangles
};

/// A closed shell around the origin, about one unit in radius: a sphere with waves, `around` times `along`
/// cells of two triangles. All triangles are of about one size.
Mesh make_shell(int around, int along);

/// A square image, RGBA8, with structure of every size so that filters and mipmap levels matter.
std::vector<uint8_t> make_image(int size);

} // namespace softgl::bench
