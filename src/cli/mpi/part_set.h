// A rank's parts of the model, read and prepared as models of their own.
#pragma once

#include <vector>

#include "command/prepared_model.h"
#include "mpi/part_deal.h"
#include "mpi/ranks.h"
#include "scene/part_renderer.h"

namespace softgl::cli {

// What is said about the part of that number.
struct PartMessages {
  size_t number;
  Warnings warnings, notes;
};

// A part has its own indices, materials, smoothing groups and generated normals; the frame is that of all
// parts.
class PartSet {
public:
  // All ranks call. Throws SharedError.
  PartSet(const std::vector<PartFile>& parts, Deal deal, const ProgramOptions& options, unsigned threads,
          const Ranks& ranks);

  std::vector<PartMesh> meshes() const;
  CameraPoints points(const Ranks& ranks) const;
  const ModelFrame& frame() const { return frame_; }
  // Triangles of all parts, then their segments, then their points.
  std::vector<PartStep> steps() const;
  // Whether steps of other ranks come between those of this one.
  bool is_interleaved(const Ranks& ranks) const;
  bool lines_on_surfaces(const Ranks& ranks) const;
  const std::string& name(size_t mesh) const { return models_[mesh].name; }
  std::vector<PartMessages>& messages() { return messages_; }
  uint64_t triangles() const;

private:
  size_t count_; // of all ranks' parts
  std::vector<size_t> numbers_;
  std::vector<PreparedModel> models_;
  std::vector<PartMessages> messages_;
  ModelFrame frame_;
};

} // namespace softgl::cli
