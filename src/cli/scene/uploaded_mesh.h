// A mesh and its materials for the current context: vertex arrays and textures.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "common/warnings.h"
#include "image/texture_loader.h"
#include "mesh/mesh_builder.h"
#include "obj/material.h"
#include "scene/gl_functions.h"

namespace softgl::cli {

class UploadedMesh {
public:
  // `mesh` and `materials` outlive it. `linear`: textures are decoded from sRGB. Pictures that cannot be read
  // are warned of and left out.
  UploadedMesh(const Mesh& mesh, const std::vector<Material>& materials, bool linear, Warnings& warnings);

  bool blended(uint32_t material) const { return prepared_[material].blended; }

  // Vertex arrays of the triangles. They stay where they are: on the CPU a buffer object is a copy that
  // nothing gains by (1.6 million triangles: 23 ms and 38 MB).
  void use_vertices() const;
  // Of the vertices in use; `first` and `count` are indices.
  void draw_triangles(size_t first, size_t count) const;
  void draw_triangles() const { draw_triangles(0, mesh_.triangles.size()); }
  // Material, lighting, texture and color array of one material's triangles.
  void use_material(uint32_t number) const;
  void use_texture(uint32_t number) const; // with its coordinates

private:
  struct PreparedMaterial {
    GLuint texture = 0;
    bool blended = false;
    const TextureReference* map = nullptr; // whose options say where the texture lies
  };
  // The files, their options that change texels, and the clamping: equal ones share a texture.
  using TextureKey = std::tuple<std::string, float, float, bool, std::string, float, float, bool>;
  struct Uploaded {
    GLuint name = 0; // 0: could not be read
    bool transparent = false;
  };

  void prepare_material(uint32_t number, Warnings& warnings);
  Uploaded upload_texture(const Material& material, bool clamp, Warnings& warnings);

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  bool linear_;
  std::vector<PreparedMaterial> prepared_;
  std::map<TextureKey, Uploaded> textures_;
  TexelBudget texels_;
};

} // namespace softgl::cli
