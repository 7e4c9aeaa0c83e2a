// The jobs of `softgl batch`: what each draws, and into which files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jobs/job_report.h"
#include "options/command_line.h"

namespace softgl::cli {

struct BatchJob {
  std::string where; // its line, or the model
  std::string model, output;
  std::shared_ptr<const ProgramOptions> options; // but for models and output; null with a fault
  std::vector<std::string> files;                // of the pictures
  uint64_t bytes = 0;                            // of the model; 0 where there is none
  bool outdated = false;                         // a file is missing, empty or older than the model
  std::string key;                               // StableHash of all that says what is drawn
  std::string fault;                             // a sentence; the job fails with kUsageError
};

// From lists, folders and models of the command line. Throws ProgramError: kCannotRead for what cannot be
// read, kUsageError if two jobs would write one file.
std::vector<BatchJob> read_jobs(const ProgramOptions& options, const std::vector<GivenOption>& given);

} // namespace softgl::cli
