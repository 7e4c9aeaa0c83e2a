// Writes the man pages and the completions below a folder: softgl_manual FOLDER.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "manual/completions.h"
#include "manual/man_page.h"
#include "mpi/mpi_options.h"
#include "options/command_line.h"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  if (!(file << text) || !file.flush()) throw std::runtime_error(path.string() + ": cannot write");
}

void write_all(const fs::path& folder) {
  using namespace softgl::cli;
  const CommandRow program = describe_command_line();
  for (const CommandRow& command : program.commands)
    write(folder / "man/man1" / ("softgl-" + command.word + ".1"), man_page(program, command));
  write(folder / "man/man1/softgl-mpi.1", man_page(program, describe_mpi()));
  write(folder / "bash-completion/completions/softgl", bash_completion(program));
  write(folder / "zsh/site-functions/_softgl", zsh_completion(program));
  write(folder / "fish/vendor_completions.d/softgl.fish", fish_completion(program));
  write(folder / "man/man1/softgl.1", man_page(program, program)); // the last: the build looks at its time
}

} // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: softgl_manual FOLDER");
    write_all(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "softgl_manual: %s\n", error.what());
    return 1;
  }
}
