// Lets memory end at every place of every stream. Each episode has a process of its own, so that a crash or a
// hang is one line of the report and the rest goes on.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <execinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>

#include "faults/episode.h"
#include "support/environment.h"

using namespace softgl::test;

namespace {

constexpr char kUsage[] =
    "usage: softgl_faults [options]\n"
    "  --list              names of the streams\n"
    "  --stream NAME       this one, or all whose names begin so; default: all\n"
    "  --seed N            of the stream's numbers (1)\n"
    "  --first K           begin with the K-th allocation (1)\n"
    "  --count N           so many places, or up to the last one (all)\n"
    "  --most N            of more places than N, N evenly spread ones are taken (1000)\n"
    "  --once, --persistent  only one allocation fails, or all from the K-th on; default: both\n"
    "  --threads N         of the library (SOFTGL_THREADS, or 0)\n"
    "  --random N          N random episodes instead, from --first on\n"
    "  --stack             where the allocations that fail come from\n"
    "  --here              in this process, for a debugger: one episode\n";

struct Options {
  std::string stream;
  uint64_t seed = 1, first = 1, count = UINT64_MAX, most = 1000, random = 0;
  bool once = true, persistent = true, stack = false, here = false;
  const char* threads = nullptr;
};

/// For a child: a crash says where.
void say_where(int signal) {
  void* frames[40];
  backtrace_symbols_fd(frames, backtrace(frames, 40), STDERR_FILENO);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Calls `make` in a process of its own, which sends back what it returns. The text says how it ended
/// otherwise.
template <class Make> std::string in_child(Outcome* result, int count, bool stack, Make make) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) return "no process";
  if (child == 0) {
    close(ends[0]);
    void* frame;
    backtrace(&frame, 1); // loads what it needs
    for (int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL}) std::signal(signal, say_where);
    if (stack) print_stacks_of_failures();
    alarm(60);
    make(result);
    const auto bytes = ssize_t(sizeof(Outcome)) * count;
    _exit(write(ends[1], result, size_t(bytes)) == bytes ? 0 : 1);
  }
  close(ends[1]);
  size_t have = 0;
  for (ssize_t n; (n = read(ends[0], reinterpret_cast<char*>(result) + have,
                            sizeof(Outcome) * size_t(count) - have)) > 0;)
    have += size_t(n);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGALRM ? "does not end"
                                       : std::string("crashes: ") + strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0 || have != sizeof(Outcome) * size_t(count))
    return "ends with code " + std::to_string(WEXITSTATUS(status));
  return {};
}

int failures = 0, episodes = 0;

void report(const std::string& what, const std::string& command) {
  if (what.empty()) return;
  ++failures;
  std::printf("%s: softgl_faults%s\n", what.c_str(), command.c_str());
}

std::string command_of(const Options& options, const Episode& e) {
  return " --stream " + e.stream.name + " --seed " + std::to_string(e.seed) + " --first " +
         std::to_string(e.k) + " --count 1 " + (e.persistent ? "--persistent" : "--once") + " --threads " +
         options.threads;
}

void play_all_places(const Options& options, const Stream& stream) {
  Outcome clean;
  Episode e{stream, options.seed};
  std::string wrong = in_child(&clean, 1, false, [&](Outcome* o) { *o = play(softgl_library(), e); });
  if (wrong.empty()) wrong = judge(clean, clean);
  report(wrong, " --stream " + stream.name + " --seed " + std::to_string(e.seed) + " (where nothing fails)");
  if (!wrong.empty()) return;
  const uint64_t places =
      clean.calls < options.first ? 0 : std::min(clean.calls - options.first + 1, options.count);
  const uint64_t taken = std::min(places, options.most);
  e.usual = &clean.left;
  const int failures_before = failures;
  for (bool persistent : {false, true}) {
    if (!(persistent ? options.persistent : options.once)) continue;
    for (uint64_t i = 0; i < taken; ++i) {
      e.persistent = persistent;
      e.k = options.first + i * places / taken;
      Outcome o;
      wrong = in_child(&o, 1, options.stack, [&](Outcome* result) { *result = play(softgl_library(), e); });
      ++episodes;
      report(wrong.empty() ? judge(o, clean) : wrong, command_of(options, e));
    }
  }
  std::printf("%-26s %6llu allocations, %llu places, %d failures\n", stream.name.c_str(),
              static_cast<unsigned long long>(clean.calls), static_cast<unsigned long long>(taken),
              failures - failures_before);
}

/// Hostile commands, random families and the streams, with random numbers; one random place each.
void play_random_episodes(const Options& options) {
  const std::vector<Stream> streams = all_streams();
  for (uint64_t n = options.first; n < options.first + options.random; ++n) {
    Random random(n * 7919);
    const int kind = random.integer(1, 100);
    Episode e;
    if (kind <= 50)
      e.stream = {"hostile commands", run_hostile_commands};
    else if (kind <= 80)
      e.stream = {"random family", run_random_family};
    else
      e.stream = streams[size_t(random.integer(0, int(streams.size()) - 1))];
    e.seed = n;
    Outcome two[2];
    std::string wrong = in_child(two, 2, options.stack, [&](Outcome* o) {
      o[0] = play(softgl_library(), e);
      e.k = o[0].calls ? 1 + random.bits() % o[0].calls : 1;
      e.persistent = random.chance(50);
      e.usual = &o[0].left;
      o[1] = play(softgl_library(), e);
    });
    ++episodes;
    if (wrong.empty()) wrong = judge(two[0], two[0]);
    if (wrong.empty()) wrong = judge(two[1], two[0]);
    report(wrong, " --random 1 --first " + std::to_string(n) + " --threads " + options.threads + " (" +
                      e.stream.name + ")");
  }
}

} // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&] {
      if (++i < argc) return argv[i];
      std::fputs(kUsage, stderr);
      std::exit(2);
    };
    const auto number = [&] { return std::strtoull(value(), nullptr, 10); };
    if (name == "--list") {
      for (const Stream& s : all_streams()) std::puts(s.name.c_str());
      return 0;
    }
    if (name == "--stream")
      options.stream = value();
    else if (name == "--seed")
      options.seed = number();
    else if (name == "--first")
      options.first = number();
    else if (name == "--count")
      options.count = number();
    else if (name == "--most")
      options.most = number();
    else if (name == "--random")
      options.random = number();
    else if (name == "--once")
      options.persistent = false;
    else if (name == "--persistent")
      options.once = false;
    else if (name == "--threads")
      options.threads = value();
    else if (name == "--stack")
      options.stack = true;
    else if (name == "--here")
      options.here = true;
    else {
      std::fputs(kUsage, stderr);
      return 2;
    }
  }
  fix_environment();
  if (options.threads) setenv("SOFTGL_THREADS", options.threads, 1);
  if (!getenv("SOFTGL_THREADS")) setenv("SOFTGL_THREADS", "0", 1);
  options.threads = getenv("SOFTGL_THREADS");
  const Gl& gl = softgl_library();
  watch_object_at(reinterpret_cast<const void*>(gl.Clear));

  if (options.random) play_random_episodes(options);
  for (const Stream& stream : all_streams()) {
    if (options.random || stream.name.compare(0, options.stream.size(), options.stream) != 0) continue;
    if (options.here) {
      if (options.stack) print_stacks_of_failures();
      const Outcome o = play(gl, {stream, options.seed, options.first, !options.once, nullptr});
      std::printf("%s: %s, %llu allocations\n", stream.name.c_str(), o.failure[0] ? o.failure : "ends",
                  static_cast<unsigned long long>(o.calls));
    } else {
      play_all_places(options, stream);
    }
  }
  std::printf("%d episodes, %d failures\n", episodes, failures);
  return failures ? 1 : 0;
}
