// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace softgl::cli {

// Calls work(0) to work(count - 1), each once, on at most `threads` threads, lower numbers first. An
// exception keeps pieces with higher numbers from being begun; that of the lowest number is thrown on when
// all have ended, so what a caller sees does not depend on the number of threads.
void parallel_for(size_t count, unsigned threads, const std::function<void(size_t, unsigned)>& work);

} // namespace softgl::cli
