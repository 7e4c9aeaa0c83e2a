// The lecture's figures about the Phong illumination model and Phong shading, on one sheet.
#pragma once

#include "scene/renderer.h"

namespace softgl::cli {

// What a figure shows, in one or more tessellations.
struct FigureSubject {
  struct Level {
    Mesh mesh;
    std::string name;
  };
  std::string name;
  std::vector<Material> materials;
  ModelFrame frame;
  Camera camera;
  std::vector<Level> levels; // from coarse to fine
};

// The unit sphere at 8, 16, 32, 64 and 128 slices.
FigureSubject sphere_subject(const CameraOptions& camera);
// A model as it is, and its triangles cut into 4, 16, 64, 256 as long as there are not too many.
FigureSubject model_subject(std::string name, Mesh mesh, std::vector<Material> materials, ModelFrame frame,
                            const Camera& camera);

// Rows: the terms and their sum; exponents; Gouraud shading, Phong shading and their difference over
// tessellation; both vectors of the specular term. `options` gives size, lights and background of each part.
Picture draw_figure(const FigureSubject& subject, const RenderOptions& options, Warnings& warnings);

} // namespace softgl::cli
