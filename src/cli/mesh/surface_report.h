// What can be measured of a mesh's surface.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"

namespace softgl::cli {

struct MaterialPart {
  uint32_t material;
  uint64_t triangles;
  double area; // in the model's units
};

struct SurfaceReport {
  // Enclosed by the triangles if their winding is outwards everywhere; means something where no edge is open.
  double volume = 0;
  uint64_t edges = 0;
  uint64_t open_edges = 0;    // of one triangle only
  uint64_t crowded_edges = 0; // of more than two
  std::vector<MaterialPart> parts;
};

SurfaceReport report_surface(const Mesh& mesh, const ModelFrame& frame);

} // namespace softgl::cli
