// A rank's parts of the model, read and prepared as models of their own.
#pragma once

#include "mpi/part_deal.h"
#include "mpi/rank_model.h"

namespace softgl::cli {

// `parts`: files, with their sizes. A part has its own indices, materials, smoothing groups and generated
// normals; the frame is that of all parts. Their triangles are drawn first, then their segments, then their
// points. All ranks call. Throws SharedError.
RankModel read_parts(const std::vector<NumberedText>& parts, Deal deal, const ProgramOptions& options,
                     unsigned threads, const Ranks& ranks);

} // namespace softgl::cli
