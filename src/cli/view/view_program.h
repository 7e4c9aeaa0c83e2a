// `softgl view` from its arguments to its exit code.
#pragma once

namespace softgl::cli {

int run_view(int argc, const char* const* argv);

} // namespace softgl::cli
