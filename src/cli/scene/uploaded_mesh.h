// A mesh and its materials as objects of the current context: buffers and textures.
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

  // Vertex arrays of the triangles.
  void bind_vertices() const;
  // The mesh's triangle indices as element array.
  void bind_triangles() const { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_); }
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
  using TextureKey = std::tuple<std::string, float, float, std::string, float, float, bool>;
  struct Uploaded {
    GLuint name = 0; // 0: could not be read
    bool transparent = false;
  };

  void upload_vertices();
  void prepare_material(uint32_t number, Warnings& warnings);
  Uploaded upload_texture(const Material& material, bool clamp, Warnings& warnings);

  const Mesh& mesh_;
  const std::vector<Material>& materials_;
  bool linear_;
  std::vector<PreparedMaterial> prepared_;
  std::map<TextureKey, Uploaded> textures_;
  TexelBudget texels_;
  GLuint vertex_buffer_ = 0, index_buffer_ = 0;
  size_t offsets_[4] = {0, 0, 0, 0}; // of positions, normals, texture coordinates and colors in the buffer
};

} // namespace softgl::cli
