#include "mpi/parts_reader.h"

#include <algorithm>

namespace softgl::cli {
namespace {

void extend(ModelBounds& bounds, const ModelBounds& other) {
  for (int axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = std::min(bounds.low[axis], other.low[axis]);
    bounds.high[axis] = std::max(bounds.high[axis], other.high[axis]);
  }
}

// `count`: all ranks' parts.
std::vector<PartStep> steps_of(const RankModel& rank, size_t count) {
  std::vector<PartStep> steps;
  for (const PartStep::Kind kind : {PartStep::kTriangles, PartStep::kSegments, PartStep::kPoints})
    for (size_t mesh = 0; mesh < rank.models.size(); ++mesh) {
      const Mesh& part = rank.models[mesh].mesh;
      const size_t batches = (kind == PartStep::kTriangles  ? part.triangle_batches
                              : kind == PartStep::kSegments ? part.segment_batches
                                                            : part.point_batches)
                                 .size();
      for (size_t batch = 0; batch < batches; ++batch)
        steps.push_back({kind, mesh, batch, uint32_t(size_t(kind) * count + rank.messages[mesh].number + 1)});
    }
  return steps;
}

} // namespace

RankModel read_parts(const std::vector<NumberedText>& parts, Deal deal, const ProgramOptions& options,
                     unsigned threads, const Ranks& ranks) {
  std::vector<uint64_t> sizes;
  sizes.reserve(parts.size());
  for (const NumberedText& part : parts) sizes.push_back(part.number);
  const std::vector<int> dealt = deal_parts(sizes, ranks.count(), deal);
  RankModel rank;
  std::vector<ReadModel> read;
  ModelBounds bounds;
  ranks.together([&] {
    for (size_t number = 0; number < parts.size(); ++number) {
      if (dealt[number] != ranks.rank()) continue;
      rank.messages.push_back({number, {}, {}});
      read.push_back(read_model(parts[number].text, options, threads, rank.messages.back().warnings,
                                rank.messages.back().notes));
      extend(bounds, bounds_of(read.back().loaded.model));
      if (number == 0)
        rank.exporter = exporter_evidence(first_lines(read[0].text, read[0].loaded.report.format));
    }
  });
  bounds = bounds_of_all(bounds, ranks);
  rank.frame = frame_model(ObjModel(), bounds);
  ranks.together([&] {
    for (size_t i = 0; i < read.size(); ++i) {
      rank.models.push_back(prepare_model(read[i], bounds, options, rank.messages[i].warnings));
      rank.models.back().frame.positions.release();
      read[i].loaded = LoadedModel();
    }
  });
  rank.steps = steps_of(rank, parts.size());
  return rank;
}

} // namespace softgl::cli
