// `softgl view`: the program softgl-view, which alone needs SDL.
#pragma once

namespace softgl::cli {

// Becomes that program, with these arguments behind its name. Returns where there is none.
void start_window(int argc, const char* const* argv);

} // namespace softgl::cli
