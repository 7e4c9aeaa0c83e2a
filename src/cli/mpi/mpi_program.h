// softgl-mpi: one picture by several processes.
#pragma once

namespace softgl::cli {

// Between the beginning and the end of MPI; the exit code.
int run_mpi(int argc, const char* const* argv);

} // namespace softgl::cli
