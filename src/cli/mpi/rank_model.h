// What one rank draws of the model.
#pragma once

#include <string>
#include <vector>

#include "command/prepared_model.h"
#include "mpi/ranks.h"
#include "scene/part_renderer.h"
#include "scene/up_axis.h"

namespace softgl::cli {

// What is said about a part of the model.
struct PartMessages {
  size_t number; // of the part
  Warnings warnings, notes;
};

struct RankModel {
  std::vector<PreparedModel> models;
  std::vector<PartMessages> messages; // of each model
  ModelFrame frame;                   // of all ranks' models, without positions
  std::vector<PartStep> steps;        // by rising order
  double exporter = 0;                // see exporter_evidence(), of the first part alone
  // Of a stretch of a file: for each batch how many triangles of its material other stretches have before it.
  std::vector<uint64_t> triangles_before;

  std::vector<PartMesh> meshes() const;
  uint64_t triangles() const;

  // All ranks call these.
  CameraPoints points(const Ranks& ranks) const;
  // Whether steps of other ranks come between those of this one.
  bool is_interleaved(const Ranks& ranks) const;
  bool lines_on_surfaces(const Ranks& ranks) const;
  UpEvidence up_evidence(const Ranks& ranks) const;
};

ModelBounds bounds_of_all(const ModelBounds& own, const Ranks& ranks);

} // namespace softgl::cli
