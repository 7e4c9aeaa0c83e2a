#include "mpi/mpi_program.h"

int main(int argc, char** argv) { return softgl::cli::run_mpi(argc, argv); }
