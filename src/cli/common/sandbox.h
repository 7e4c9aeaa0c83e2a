// The process gives up what it does not need, before it reads files of unknown origin.
#pragma once

#include <string>
#include <vector>

namespace softgl::cli {

// What may still be reached; folders with all below them. What does not exist is left out.
struct SandboxPaths {
  std::vector<std::string> read;  // files and folders
  std::vector<std::string> write; // folders
};

// Of this kernel; 0: it has none, or it is switched off.
int landlock_version();

// For the whole process, for good: no program can be started, no process, no socket, no other process seen (a
// filter of system calls by seccomp), and no file opened outside of `paths` (Landlock). The files of the C
// library and of the libraries that are loaded later can be read. Returns what of this the kernel lacks, one
// sentence each. Throws ProgramError (kUsageError) if it lacks the filter, or the program was built for
// another processor than x86-64.
std::vector<std::string> enter_sandbox(const SandboxPaths& paths);

} // namespace softgl::cli
