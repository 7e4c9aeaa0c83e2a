#include "figure/subject.h"

#include <algorithm>

#include "common/program_error.h"
#include "mesh/tessellation.h"

namespace softgl::cli {
namespace {

constexpr int kLevels = 5;
constexpr size_t kMostTriangles = 2000000; // of the finest tessellation of a model: about 0.3 s a picture

} // namespace

FigureSubject sphere_subject(const CameraOptions& camera) {
  FigureSubject subject;
  Material clay;
  clay.name = "clay";
  const float ambient[3] = {0.35f, 0.14f, 0.1f}, diffuse[3] = {0.7f, 0.28f, 0.2f};
  for (size_t i = 0; i < 3; ++i) {
    clay.ambient[i] = ambient[i];
    clay.diffuse[i] = diffuse[i];
    clay.specular[i] = 0.6f;
  }
  clay.shininess = 20;
  subject.materials.push_back(clay);
  for (int slices = 8, level = 0; level < kLevels; slices *= 2, ++level)
    subject.levels.push_back({sphere_mesh(slices), slices});
  subject.camera = fit_camera(subject.levels.back().mesh, camera);
  return subject;
}

FigureSubject model_subject(std::string name, Mesh mesh, std::vector<Material> materials, ModelFrame frame,
                            const Camera& camera) {
  if (mesh.triangles.empty())
    throw ProgramError(kCannotRead, name + ": no faces; a figure about light needs some");
  FigureSubject subject;
  subject.name = std::move(name);
  subject.materials = std::move(materials);
  subject.frame = std::move(frame);
  subject.camera = camera;
  const auto dull = [](const Material& material) {
    return *std::max_element(material.specular, material.specular + 3) == 0;
  };
  if (std::all_of(subject.materials.begin(), subject.materials.end(), dull))
    for (Material& material : subject.materials) { // nothing would shine on the whole sheet
      std::fill(material.specular, material.specular + 3, 0.5f);
      material.shininess = 20;
    }
  subject.levels.push_back({std::move(mesh), 1});
  for (int level = 1; level < kLevels; ++level) {
    const Mesh& coarse = subject.levels.back().mesh;
    if (coarse.triangles.size() / 3 * 4 > kMostTriangles) break;
    subject.levels.push_back({subdivide(coarse), 1 << (2 * level)});
  }
  return subject;
}

} // namespace softgl::cli
