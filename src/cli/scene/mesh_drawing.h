// A mesh's triangles, lines and points as GL draws them with their materials.
#pragma once

#include "scene/camera.h"
#include "scene/uploaded_mesh.h"

namespace softgl::cli {

// Sizes of lines and points in pixels of the finished picture.
struct LineSizes {
  float segment = 1.5f, point = 4.0f;
};

class MeshDrawing {
public:
  // All outlive it. `scale`: samples a pixel on a side.
  MeshDrawing(const Mesh& mesh, const std::vector<Material>& materials, const UploadedMesh& uploaded,
              const Camera& camera, float scale)
      : mesh_(mesh), materials_(materials), uploaded_(uploaded), camera_(camera), scale_(scale) {}

  // Materials without lighting are black: for pictures of single terms, of which they have none.
  void blacken_unlit() { unlit_black_ = true; }

  // Triangles of all materials but the blended ones. False: some are left.
  bool draw_opaque() const;
  void draw_blended() const;
  // One batch of each kind, which is not blended.
  void draw_triangles(const Batch& batch) const;
  void draw_segments(const Batch& batch) const;
  void draw_points(const Batch& batch) const;
  void draw_segments_and_points() const;
  // What has no area to be seen, a plane from its edge or a single place, is shown by its edges and corners.
  void draw_bare_edges() const;
  // All surfaces without materials.
  void draw_silhouette() const;

private:
  struct BlendedTriangle {
    float depth;
    uint32_t first, material;
  };

  void draw_used_triangles(const Batch& batch) const;
  void use_material(uint32_t number) const;
  void set_sizes() const;
  void set_plain_state() const;
  void start_elements(const GrowingArray<float>& positions, const GrowingArray<float>& colors) const;
  void draw_elements(GLenum mode, const Batch& batch) const;
  std::vector<BlendedTriangle> sort_blended() const;

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  const UploadedMesh& uploaded_;
  const Camera& camera_;
  float scale_;
  bool unlit_black_ = false;
};

} // namespace softgl::cli
