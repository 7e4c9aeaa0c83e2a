#include "command/program.h"

int main(int argc, char** argv) { return softgl::cli::run_program(argc, argv); }
