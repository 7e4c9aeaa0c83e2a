// What one process draws of a picture that several draw, each a part of the model.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/growing_array.h"
#include "common/warnings.h"
#include "mesh/mesh_builder.h"
#include "scene/camera.h"
#include "scene/renderer.h"

namespace softgl::cli {

// Rows from the top. A sample that nothing was drawn to has order 0 and the background's color.
struct PartSamples {
  int width = 0, height = 0;
  GrowingArray<uint8_t> colors;  // RGBA
  GrowingArray<uint32_t> depths; // as the depth buffer compares them
  GrowingArray<uint32_t> orders; // of what was drawn last there
};

struct PartMesh {
  const Mesh* mesh;
  const std::vector<Material>* materials;
};

// One step of the drawing. Where depths are equal, the higher order is seen, as it is drawn later.
struct PartStep {
  enum Kind { kTriangles, kSegments, kPoints } kind;
  size_t mesh; // of the part's meshes
  size_t batch;
  uint32_t order; // from 1
};

class PartRenderer {
public:
  // The meshes and the frame outlive it. `interleaved`: orders of other processes lie between those of this
  // one. `warnings`, one for each mesh, get those about its textures. Throws ProgramError.
  PartRenderer(std::vector<PartMesh> meshes, const ModelFrame& frame, const RenderOptions& options,
               bool interleaved, std::vector<Warnings>& warnings);
  ~PartRenderer();

  // A material through which others are seen; null if there is none.
  const Material* transparent_material() const;

  // Steps by rising order. `lines_on_surfaces`: the whole model has triangles and segments.
  PartSamples draw(const Camera& camera, const std::vector<PartStep>& steps, bool lines_on_surfaces);
  // The triangles' edges, for a model of which nothing else is seen.
  PartSamples draw_edges(const Camera& camera);

private:
  class Drawing;
  struct Resources;
  std::vector<PartMesh> meshes_;
  const ModelFrame& frame_;
  RenderOptions options_;
  bool interleaved_;
  std::unique_ptr<Resources> resources_;
};

// The picture that the samples of all make.
Picture picture_of(PartSamples samples, const RenderOptions& options);

} // namespace softgl::cli
