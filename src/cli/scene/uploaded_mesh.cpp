#include "scene/uploaded_mesh.h"

#include <algorithm>
#include <string>

namespace softgl::cli {
namespace {

GLuint make_texture(const TextureImage& image, bool clamp, bool linear) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const GLint wrap = clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLenum format = image.channels == 4 ? GL_RGBA : image.channels == 3 ? GL_RGB : GL_ALPHA;
  const GLenum stored = !linear || format == GL_ALPHA ? format
                        : format == GL_RGBA           ? GL_SRGB8_ALPHA8
                                                      : GL_SRGB8;
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(stored), image.width, image.height, 0, format, GL_UNSIGNED_BYTE,
               image.texels.data());
  return texture;
}

} // namespace

UploadedMesh::UploadedMesh(const Mesh& mesh, const std::vector<Material>& materials, bool linear,
                           Warnings& warnings)
    : mesh_(mesh), materials_(materials), linear_(linear), prepared_(materials.size()) {
  for (const Batch& batch : mesh_.triangle_batches) prepare_material(batch.material, warnings);
}

void UploadedMesh::prepare_material(uint32_t number, Warnings& warnings) {
  const Material& material = materials_[number];
  PreparedMaterial& prepared = prepared_[number];
  prepared.blended = material.opacity < 1;
  const TextureReference &color = material.diffuse_map, &opacity = material.opacity_map;
  prepared.map = color.file.empty() ? &opacity : &color;
  if (prepared.map->file.empty() || mesh_.texcoords.empty()) return;
  const TextureKey key{color.file,   color.base,   color.gain,   color.alpha,
                       opacity.file, opacity.base, opacity.gain, prepared.map->clamp};
  auto known = textures_.find(key);
  if (known == textures_.end())
    known = textures_.emplace(key, upload_texture(material, prepared.map->clamp, warnings)).first;
  prepared.texture = known->second.name;
  prepared.blended |= known->second.transparent;
}

UploadedMesh::Uploaded UploadedMesh::upload_texture(const Material& material, bool clamp,
                                                    Warnings& warnings) {
  TextureImage image;
  if (!load_texture(material, image, texels_, warnings)) return {};
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  const bool any_size = (version && version[0] >= '2') || has_extension("GL_ARB_texture_non_power_of_two");
  fit_texture(image, std::max(largest, 64), !any_size);
  return {make_texture(image, clamp, linear_), image.channels != 3};
}

void UploadedMesh::use_vertices() const {
  glVertexPointer(3, GL_FLOAT, 0, mesh_.positions.data());
  glEnableClientState(GL_VERTEX_ARRAY);
  glNormalPointer(GL_FLOAT, 0, mesh_.normals.data());
  glEnableClientState(GL_NORMAL_ARRAY);
  if (!mesh_.texcoords.empty()) glTexCoordPointer(2, GL_FLOAT, 0, mesh_.texcoords.data());
  if (!mesh_.colors.empty()) glColorPointer(4, GL_FLOAT, 0, mesh_.colors.data());
}

namespace {

constexpr size_t kPart = 3 << 18; // indices of a draw, for the largest meshes

// Whether parts of the triangles name vertices close to each other, so that each vertex belongs to few parts.
bool parts_are_local(const uint32_t* index, size_t count, size_t vertices) {
  size_t named = 0;
  for (size_t first = 0; first < count; first += kPart) {
    const auto [low, high] = std::minmax_element(index + first, index + std::min(first + kPart, count));
    named += *high - *low + 1;
  }
  return named <= vertices + vertices / 4;
}

} // namespace

void UploadedMesh::draw_triangles(size_t first, size_t count) const {
  const auto draw = [&](size_t part) {
    glDrawElements(GL_TRIANGLES, GLsizei(part), GL_UNSIGNED_INT, mesh_.triangles.data() + first);
  };
  if (count > kPart && parts_are_local(&mesh_.triangles[first], count, mesh_.positions.size() / 3))
    // A library keeps what it is given until it draws: in parts 1.6 million triangles take 131 MB instead of
    // 143 to 157. In any order each part would need nearly all vertices.
    for (; count > kPart; first += kPart, count -= kPart) {
      draw(kPart);
      glFinish();
    }
  draw(count);
}

void UploadedMesh::use_material(uint32_t number) const {
  const Material& material = materials_[number];
  const auto set = [&](GLenum name, const float* rgb) {
    const float rgba[4] = {rgb[0], rgb[1], rgb[2], material.opacity};
    glMaterialfv(GL_FRONT_AND_BACK, name, rgba);
  };
  glDisable(GL_COLOR_MATERIAL);
  set(GL_AMBIENT, material.ambient);
  set(GL_DIFFUSE, material.diffuse);
  set(GL_SPECULAR, material.specular);
  set(GL_EMISSION, material.emission);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
  const bool shiny = material.specular[0] > 0 || material.specular[1] > 0 || material.specular[2] > 0;
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                shiny && prepared_[number].texture ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  if (!mesh_.colors.empty()) {
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glEnableClientState(GL_COLOR_ARRAY);
  } else {
    glDisableClientState(GL_COLOR_ARRAY);
    glColor4f(material.diffuse[0], material.diffuse[1], material.diffuse[2], material.opacity);
  }
  if (material.lit)
    glEnable(GL_LIGHTING);
  else
    glDisable(GL_LIGHTING);
  use_texture(number);
}

void UploadedMesh::use_texture(uint32_t number) const {
  if (!prepared_[number].texture) {
    glDisable(GL_TEXTURE_2D);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    return;
  }
  glEnable(GL_TEXTURE_2D);
  glBindTexture(GL_TEXTURE_2D, prepared_[number].texture);
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  const TextureReference& map = *prepared_[number].map;
  glMatrixMode(GL_TEXTURE);
  glLoadIdentity();
  glTranslatef(map.offset[0], map.offset[1], 0);
  glScalef(map.scale[0], map.scale[1], 1);
  glMatrixMode(GL_MODELVIEW);
}

} // namespace softgl::cli
