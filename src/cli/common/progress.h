// A progress bar for who waits at a terminal.
#pragma once

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>

namespace softgl::cli {

// Shows itself once the work has taken `delay`, and again at most ten times a second. Nothing is written
// where `shown` is false. Any thread may call step() and say().
class Progress {
public:
  Progress(std::FILE* terminal, bool shown, size_t total,
           std::chrono::milliseconds delay = std::chrono::seconds(1));
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step();                        // one more of `total` is done
  void say(const std::string& lines); // lines above the bar, shown in any case

private:
  void draw();
  void erase();

  std::FILE* terminal_;
  bool shown_, drawn_ = false;
  size_t done_ = 0, total_;
  std::chrono::steady_clock::time_point next_;
  std::mutex mutex_;
};

// Standard error, and not a file or a program that reads it.
bool is_terminal(std::FILE* file);

} // namespace softgl::cli
