// The program from its arguments to its exit code.
#pragma once

namespace softgl::cli {

int run_program(int argc, const char* const* argv);

} // namespace softgl::cli
