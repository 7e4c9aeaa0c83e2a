#include "common/time_limit.h"

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstring>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

// Names for the signal handler, which may call but few functions. Threads may write a file each.
std::array<std::atomic<const char*>, 64> unfinished;
char sentence[96];

void end_run(int) {
  for (const std::atomic<const char*>& path : unfinished) {
    const char* name = path.load();
    struct stat status {};
    if (name && ::stat(name, &status) == 0 && S_ISREG(status.st_mode)) ::unlink(name);
  }
  if (::write(STDERR_FILENO, sentence, std::strlen(sentence)) < 0) ::_exit(kCannotRead);
  ::_exit(kCannotRead);
}

} // namespace

void start_time_limit(double seconds) {
  std::snprintf(sentence, sizeof sentence, "softgl: error: not finished after %g s (--timeout)\n", seconds);
  struct sigaction action {};
  action.sa_handler = end_run;
  ::sigaction(SIGALRM, &action, nullptr);
  itimerval timer{};
  timer.it_value.tv_sec = time_t(seconds);
  timer.it_value.tv_usec = suseconds_t(std::fmod(seconds, 1.0) * 1e6);
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

UnfinishedFile::UnfinishedFile(const std::string& path) : path_(path) {
  for (std::atomic<const char*>& slot : unfinished) {
    const char* free = nullptr;
    if (slot.compare_exchange_strong(free, path_.c_str())) return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  for (std::atomic<const char*>& slot : unfinished) {
    const char* mine = path_.c_str();
    if (slot.compare_exchange_strong(mine, nullptr)) return;
  }
}

} // namespace softgl::cli
