#include <malloc.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>

#include "command/program.h"
#include "common/program_error.h"

namespace {

// Memory may end before main(), where objects of the libraries are made and nobody catches what they throw.
[[noreturn]] void end_without_memory() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    constexpr char kSentence[] = "softgl: error: not enough memory\n";
    if (::write(STDERR_FILENO, kSentence, sizeof kSentence - 1) >= 0) ::_exit(softgl::cli::kCannotRead);
    ::_exit(softgl::cli::kCannotRead);
  } catch (...) {}
  std::abort();
}

[[gnu::constructor(101)]] void watch_memory() { std::set_terminate(end_without_memory); }

} // namespace

int main(int argc, char** argv) {
  // Large arrays give their pages back when they are freed. By itself malloc would take them from the heap
  // after the first was freed, where holes stay: 8 MB more of 161 for 1.6 million triangles.
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  return softgl::cli::run_program(argc, argv);
}
