// What a preloaded library replaces of the C library, so that a program draws the same in every run.
#include "clients/stable_process.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <poll.h>
#include <pty.h>
#include <sys/select.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

constexpr long kStart = 1'700'000'000, kMicrosecondsOfFrame = 1'000'000 / 30;
constexpr int kProcess = 4242;
int frames = 0;

timeval now() {
  const long microseconds = frames * kMicrosecondsOfFrame;
  return {kStart + microseconds / 1'000'000, microseconds % 1'000'000};
}

template <class Function> Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void pause_shortly() {
  static auto select_of_library = next<decltype(select)>("select");
  timeval time{0, 2000};
  select_of_library(0, nullptr, nullptr, nullptr, &time);
}

// A child that goes on for ever is not waited for longer than this.
constexpr int kLongestWait = 2500; // pauses

void wait_for(pid_t child) {
  siginfo_t info;
  for (int i = 0; i < kLongestWait; ++i, pause_shortly()) {
    info.si_pid = 0;
    if (waitid(P_PID, id_t(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0) return;
  }
}

// Children load this library, too, and not the one that draws.
[[gnu::constructor]] void keep_preload_of_children() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&softgl::test::end_of_frame), &info))
    setenv("LD_PRELOAD", info.dli_fname, 1);
}

} // namespace

namespace softgl::test {

int end_of_frame() { return ++frames; }

} // namespace softgl::test

extern "C" {

int gettimeofday(timeval* time, void*) noexcept {
  *time = now();
  return 0;
}
time_t time(time_t* seconds) noexcept {
  const time_t value = now().tv_sec;
  if (seconds) *seconds = value;
  return value;
}
pid_t getpid() noexcept { return kProcess; }

int select(int count, fd_set* read, fd_set* write, fd_set* except, timeval* timeout) {
  static auto select_of_library = next<decltype(select)>("select");
  return count == 0 ? 0 : select_of_library(count, read, write, except, timeout);
}

pid_t fork() noexcept {
  static auto fork_of_library = next<pid_t()>("fork");
  const pid_t child = fork_of_library();
  if (child > 0) wait_for(child);
  return child;
}
pid_t forkpty(int* terminal, char* name, const termios* termp, const winsize* size) noexcept {
  static auto forkpty_of_library = next<pid_t(int*, char*, const termios*, const winsize*)>("forkpty");
  const pid_t child = forkpty_of_library(terminal, name, termp, size);
  if (child > 0) wait_for(child);
  return child;
}
FILE* popen(const char* command, const char* mode) {
  static auto popen_of_library = next<decltype(popen)>("popen");
  FILE* pipe = popen_of_library(command, mode);
  if (!pipe || mode[0] != 'r') return pipe;
  pollfd end{fileno(pipe), POLLIN, 0};
  for (int i = 0; i < kLongestWait && poll(&end, 1, 0) >= 0 && !(end.revents & POLLHUP); ++i) pause_shortly();
  return pipe;
}

} // extern "C"
