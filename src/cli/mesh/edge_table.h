// The edges between a mesh's triangles. Corners at one place are one corner, whatever the file repeats.
#pragma once

#include <vector>

#include "mesh/mesh_builder.h"

namespace softgl::cli {

struct MeshEdge {
  uint32_t first, second; // vertices of the mesh
  uint32_t faces;         // triangles that meet here; those without area do not count
  uint32_t triangles[2];  // the first two of them
};

std::vector<MeshEdge> mesh_edges(const Mesh& mesh);

// Ends of edges, six floats each: where one or more than two triangles are, or two whose planes meet at more
// than `angle` degrees.
GrowingArray<float> sharp_edges(const Mesh& mesh, double angle);

// Ends of the edges of a model's faces as the file has them, each once, before they are cut into triangles:
// pairs of vertices of the file.
GrowingArray<uint32_t> face_edges(const ObjModel& model);

} // namespace softgl::cli
