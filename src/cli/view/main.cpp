#include "view/view_program.h"

int main(int argc, char** argv) { return softgl::cli::run_view(argc, argv); }
