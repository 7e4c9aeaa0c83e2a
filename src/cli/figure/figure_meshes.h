// Flat meshes of triangles, for figures about shading.
#pragma once

#include "mesh/mesh_builder.h"

namespace softgl::cli {

// The square from -1 to 1 in the plane z = 0, cut into `cells` times `cells`, with the normal +z.
Mesh square_mesh(int cells);

// The same square in `strips` of one width, side by side. Its normals turn evenly around the y axis, from
// -`angle` at the left to `angle` degrees at the right.
Mesh band_mesh(int strips, double angle);

} // namespace softgl::cli
