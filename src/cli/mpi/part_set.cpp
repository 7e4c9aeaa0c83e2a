#include "mpi/part_set.h"

#include <algorithm>
#include <cstring>

namespace softgl::cli {
namespace {

ModelBounds bounds_of_all(const ModelBounds& own, const Ranks& ranks) {
  double sides[6];
  for (int axis = 0; axis < 3; ++axis) sides[axis] = -own.low[axis], sides[3 + axis] = own.high[axis];
  ranks.largest(sides, 6);
  ModelBounds all;
  for (int axis = 0; axis < 3; ++axis) all.low[axis] = -sides[axis], all.high[axis] = sides[3 + axis];
  return all;
}

void extend(ModelBounds& bounds, const ModelBounds& other) {
  for (int axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = std::min(bounds.low[axis], other.low[axis]);
    bounds.high[axis] = std::max(bounds.high[axis], other.high[axis]);
  }
}

} // namespace

PartSet::PartSet(const std::vector<PartFile>& parts, Deal deal, const ProgramOptions& options,
                 unsigned threads, const Ranks& ranks)
    : count_(parts.size()) {
  std::vector<uint64_t> sizes;
  for (const PartFile& part : parts) sizes.push_back(part.bytes);
  const std::vector<int> dealt = deal_parts(sizes, ranks.count(), deal);
  for (size_t i = 0; i < parts.size(); ++i)
    if (dealt[i] == ranks.rank()) numbers_.push_back(i);

  std::vector<ReadModel> read;
  ModelBounds bounds;
  ranks.together([&] {
    for (const size_t number : numbers_) {
      messages_.push_back({number, {}, {}});
      read.push_back(read_model(parts[number].path, options, threads, messages_.back().warnings,
                                messages_.back().notes));
      extend(bounds, bounds_of(read.back().loaded.model));
    }
  });
  bounds = bounds_of_all(bounds, ranks);
  frame_ = frame_model(ObjModel(), bounds);
  ranks.together([&] {
    for (size_t i = 0; i < read.size(); ++i) {
      models_.push_back(prepare_model(read[i], bounds, options, messages_[i].warnings));
      models_.back().frame.positions.release();
      read[i].loaded = LoadedModel();
    }
  });
}

std::vector<PartMesh> PartSet::meshes() const {
  std::vector<PartMesh> meshes;
  for (const PreparedModel& model : models_) meshes.push_back({&model.mesh, &model.materials});
  return meshes;
}

CameraPoints PartSet::points(const Ranks& ranks) const {
  std::vector<const Mesh*> meshes;
  for (const PreparedModel& model : models_) meshes.push_back(&model.mesh);
  CameraPoints points(std::move(meshes));
  points.largest_of_all = [&ranks](double* values, size_t count) { ranks.largest(values, count); };
  return points;
}

std::vector<PartStep> PartSet::steps() const {
  std::vector<PartStep> steps;
  for (const PartStep::Kind kind : {PartStep::kTriangles, PartStep::kSegments, PartStep::kPoints})
    for (size_t mesh = 0; mesh < models_.size(); ++mesh) {
      const Mesh& part = models_[mesh].mesh;
      const size_t batches = (kind == PartStep::kTriangles  ? part.triangle_batches
                              : kind == PartStep::kSegments ? part.segment_batches
                                                            : part.point_batches)
                                 .size();
      for (size_t batch = 0; batch < batches; ++batch)
        steps.push_back({kind, mesh, batch, uint32_t(size_t(kind) * count_ + numbers_[mesh] + 1)});
    }
  return steps;
}

bool PartSet::is_interleaved(const Ranks& ranks) const {
  const std::vector<PartStep> own = steps();
  const uint32_t ends[2] = {own.empty() ? 0 : own.front().order, own.empty() ? 0 : own.back().order};
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

bool PartSet::lines_on_surfaces(const Ranks& ranks) const {
  bool triangles = false, segments = false;
  for (const PreparedModel& model : models_) {
    triangles |= !model.mesh.triangles.empty();
    segments |= !model.mesh.segment_positions.empty();
  }
  triangles = ranks.any(triangles);
  return ranks.any(segments) && triangles;
}

uint64_t PartSet::triangles() const {
  uint64_t count = 0;
  for (const PreparedModel& model : models_) count += model.mesh.triangles.size() / 3;
  return count;
}

} // namespace softgl::cli
