// All pictures of a run, drawn by as many threads as there are.
#pragma once

#include <cstdint>
#include <string>

#include "options/program_options.h"

namespace softgl::cli {

// What came out, where it is asked for.
struct PictureRecord {
  std::string pixels; // StableHash of the only picture, or of those of all
  uint64_t warnings = 0;
};

// Reads each model once. Messages go to standard error, by model. Returns the exit code; throws ProgramError
// for what ends the run. With a record there is no progress bar.
int draw_pictures(const ProgramOptions& options, unsigned threads, PictureRecord* record = nullptr);

} // namespace softgl::cli
