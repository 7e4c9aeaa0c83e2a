// One OBJ file, of which each rank reads a stretch.
#pragma once

#include "mpi/rank_model.h"

namespace softgl::cli {

// An OBJ file that can be cut: neither compressed nor in UTF-16. False also for what cannot be read.
bool can_split(const std::string& path);

// The stretch's faces and all that they name, from whatever rank has it; materials, normals and the order of
// drawing are those of the whole file. No rank holds more than its stretch, what it names, and the faces that
// share a place with its own. All ranks call. Throws SharedError.
RankModel read_split(const std::string& path, const ProgramOptions& options, unsigned threads,
                     const Ranks& ranks);

} // namespace softgl::cli
