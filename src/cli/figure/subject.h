// What the figures about shading show: a sphere or a model, in several tessellations.
#pragma once

#include "scene/renderer.h"

namespace softgl::cli {

struct FigureSubject {
  struct Level {
    Mesh mesh;
    int slices = 0; // of a sphere; of a model: into how many triangles each one is cut
  };
  std::string name; // of the model's file; empty: the sphere
  std::vector<Material> materials;
  ModelFrame frame;
  Camera camera;
  std::vector<Level> levels; // from coarse to fine
};

// The unit sphere at 8, 16, 32, 64 and 128 slices.
FigureSubject sphere_subject(const CameraOptions& camera);
// A model as it is, and its triangles cut into 4, 16, 64, 256 as long as there are not too many. Throws
// ProgramError if it has no faces.
FigureSubject model_subject(std::string name, Mesh mesh, std::vector<Material> materials, ModelFrame frame,
                            const Camera& camera);

} // namespace softgl::cli
