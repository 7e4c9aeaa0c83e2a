// Runs programs of others, with softgl and with the system's OSMesa.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace softgl::test {

/// Where the loader finds OSMesa.
std::string system_library();

/// What a command prints; `code` is its exit code.
std::string output_of(const std::string& command, int& code);

/// The lines that a command prints; it must succeed and print some.
std::vector<std::string> output_lines(const std::string& command);

/// Whether the shell finds a program.
bool has_program(const std::string& name);

/// A folder for what the clients write, which exists.
std::string client_folder();

/// A folder in which the loader finds `library` as OSMesa, for LD_LIBRARY_PATH.
std::string loader_folder(const std::string& library);

struct Pair {
  std::string ours, theirs;
};

/// What a program writes to a file with each of the two libraries. `with` makes the command out of the
/// library's path; the file's path is appended to it.
Pair run_with_both(const std::string& name, const std::function<std::string(const std::string&)>& with);

} // namespace softgl::test
