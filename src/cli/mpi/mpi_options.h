// The command line of softgl-mpi: that of a picture, and a few options of its own.
#pragma once

#include <string>
#include <vector>

#include "mpi/part_deal.h"
#include "options/command_table.h"
#include "options/program_options.h"

namespace softgl::cli {

struct MpiOptions {
  Deal deal = Deal::kBlocks;
  int radix = 0;                  // see ExchangePlan
  std::vector<const char*> words; // the rest of the command line
};

// Throws ProgramError (kUsageError).
MpiOptions take_mpi_options(int argc, const char* const* argv);

// Its help and its man page, as a table; the options of a picture are those of softgl.
CommandRow describe_mpi();

// Throws ProgramError (kUsageError) for what several processes do not draw together.
void refuse_what_is_not_drawn(const ProgramOptions& options);

} // namespace softgl::cli
