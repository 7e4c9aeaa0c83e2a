// Meshes of chosen fineness, for figures.
#pragma once

#include "mesh/mesh_builder.h"

namespace softgl::cli {

// The unit sphere in `slices` of longitude and half as many of latitude, with its exact normals. `slices` >=
// 4, even.
Mesh sphere_mesh(int slices);

// Every triangle cut into four at the middles of its edges. The surface stays what it is; normals are the
// edges' means, of unit length, so that what changes is only where they are given.
Mesh subdivide(const Mesh& mesh);

} // namespace softgl::cli
