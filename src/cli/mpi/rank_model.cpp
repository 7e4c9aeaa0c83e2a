#include "mpi/rank_model.h"

#include <cstring>

namespace softgl::cli {

std::vector<PartMesh> RankModel::meshes() const {
  std::vector<PartMesh> meshes;
  for (const PreparedModel& model : models) meshes.push_back({&model.mesh, &model.materials});
  return meshes;
}

CameraPoints RankModel::points(const Ranks& ranks) const {
  std::vector<const Mesh*> meshes;
  for (const PreparedModel& model : models) meshes.push_back(&model.mesh);
  CameraPoints points(std::move(meshes));
  points.largest_of_all = [&ranks](double* values, size_t count) { ranks.largest(values, count); };
  return points;
}

bool RankModel::is_interleaved(const Ranks& ranks) const {
  const uint32_t ends[2] = {steps.empty() ? 0 : steps.front().order, steps.empty() ? 0 : steps.back().order};
  const std::string bytes(reinterpret_cast<const char*>(ends), sizeof ends);
  bool between = false;
  for (const std::string& other : ranks.gather_everywhere(bytes)) {
    uint32_t theirs[2];
    std::memcpy(theirs, other.data(), sizeof theirs);
    const bool same = theirs[0] == ends[0]; // this rank itself, or another one without steps
    between |= !same && theirs[0] != 0 && theirs[0] <= ends[1] && theirs[1] >= ends[0];
  }
  return between;
}

bool RankModel::lines_on_surfaces(const Ranks& ranks) const {
  bool triangles = false, segments = false;
  for (const PreparedModel& model : models) {
    triangles |= !model.mesh.triangles.empty();
    segments |= !model.mesh.segment_positions.empty();
  }
  triangles = ranks.any(triangles);
  return ranks.any(segments) && triangles;
}

uint64_t RankModel::triangles() const {
  uint64_t count = 0;
  for (const PreparedModel& model : models) count += model.mesh.triangles.size() / 3;
  return count;
}

UpEvidence RankModel::up_evidence(const Ranks& ranks) const {
  ModelBounds box;
  for (const PreparedModel& model : models) extend_bounds(model.mesh, box.low, box.high);
  box = bounds_of_all(box, ranks);
  SurfaceSums sums(box.low, box.high, ranks.sum(triangles()));
  for (const PreparedModel& model : models) sums.add(model.mesh, model.materials, triangles_before);
  ranks.add(sums.values());
  double signs[2] = {exporter, -exporter}; // that of the only rank that has one
  ranks.largest(signs, 2);
  return sums.evidence(frame, signs[0] - signs[1]);
}

ModelBounds bounds_of_all(const ModelBounds& own, const Ranks& ranks) {
  double sides[6];
  for (int axis = 0; axis < 3; ++axis) sides[axis] = -own.low[axis], sides[3 + axis] = own.high[axis];
  ranks.largest(sides, 6);
  ModelBounds all;
  for (int axis = 0; axis < 3; ++axis) all.low[axis] = -sides[axis], all.high[axis] = sides[3 + axis];
  return all;
}

} // namespace softgl::cli
