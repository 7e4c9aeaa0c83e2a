// What ends a run: one sentence and an exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace softgl::cli {

enum ExitCode {
  kSuccess = 0,
  kDiffers = 1, // softgl compare
  kUsageError = 2,
  kCannotRead = 3, // unreadable, no geometry, nothing visible, or a warning with --strict
  kCannotWrite = 4,
};

struct ProgramError : std::runtime_error {
  ProgramError(ExitCode exit_code, const std::string& sentence)
      : std::runtime_error(sentence), code(exit_code) {}
  ExitCode code;
};

} // namespace softgl::cli
