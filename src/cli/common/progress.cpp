#include "common/progress.h"

#include <unistd.h>

namespace softgl::cli {
namespace {

constexpr size_t kBarColumns = 40;
constexpr auto kPause = std::chrono::milliseconds(100);

} // namespace

bool is_terminal(std::FILE* file) { return ::isatty(::fileno(file)) == 1; }

Progress::Progress(std::FILE* terminal, bool shown, size_t total, std::chrono::milliseconds delay)
    : terminal_(terminal), shown_(shown && total > 1), total_(total),
      next_(std::chrono::steady_clock::now() + delay) {}

Progress::~Progress() { erase(); }

void Progress::step() {
  const std::scoped_lock lock(mutex_);
  ++done_;
  if (!shown_ || std::chrono::steady_clock::now() < next_) return;
  next_ = std::chrono::steady_clock::now() + kPause;
  draw();
}

void Progress::say(const std::string& lines) {
  const std::scoped_lock lock(mutex_);
  const bool again = drawn_;
  erase();
  std::fputs(lines.c_str(), terminal_);
  if (again) draw();
}

void Progress::draw() {
  const size_t full = kBarColumns * done_ / total_;
  const std::string bar = std::string(full, '#') + std::string(kBarColumns - full, '.');
  std::fprintf(terminal_, "\r[%s] %zu of %zu", bar.c_str(), done_, total_);
  std::fflush(terminal_);
  drawn_ = true;
}

void Progress::erase() {
  if (drawn_) std::fputs("\r\033[K", terminal_);
  drawn_ = false;
}

} // namespace softgl::cli
