// Every command with random arguments, on softgl and on OSMesa: the same errors, answers and state. Trials
// run in processes of their own, so that a crash is one line of the report and the rest goes on.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "fuzz/argument_trials.h"
#include "support/environment.h"

using namespace softgl::test;

namespace {

constexpr char kUsage[] = "usage: softgl_arguments [options]\n"
                          "  --first N     begin with the N-th trial of each command (0)\n"
                          "  --count N     so many trials of each command (4)\n"
                          "  --every K     of all these trials only every K-th (1)\n"
                          "  --command C   of this command only, its name without \"gl\"\n"
                          "  --calls       says every call, too\n";

struct Options {
  uint64_t first = 0, count = 4, every = 1;
  std::string command;
  bool calls = false;
};

Options read_options(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    const auto value = [&]() -> const char* {
      if (++i < argc) return argv[i];
      std::fputs(kUsage, stderr);
      std::exit(2);
    };
    if (name == "--first")
      options.first = std::strtoull(value(), nullptr, 10);
    else if (name == "--count")
      options.count = std::strtoull(value(), nullptr, 10);
    else if (name == "--every")
      options.every = std::max(1ull, std::strtoull(value(), nullptr, 10));
    else if (name == "--command")
      options.command = value();
    else if (name == "--calls")
      options.calls = true;
    else {
      std::fputs(kUsage, stderr);
      std::exit(2);
    }
  }
  return options;
}

} // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  fix_environment();
  std::vector<Trial> trials;
  uint64_t number = 0;
  for (uint64_t seed = options.first; seed < options.first + options.count; ++seed)
    for (const AnyCommand& command : any_commands())
      if ((options.command.empty() || options.command == command.name) && number++ % options.every == 0)
        trials.push_back({command, seed});

  // What the children tell: the trial that they are at, and how many differed.
  struct Progress {
    size_t trial, differences;
    Player playing;
  };
  void* shared = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return 2;
  auto* progress = new (shared) Progress{};
  size_t their_crashes = 0;
  while (progress->trial < trials.size()) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) return 2;
    if (child == 0) {
      for (; progress->trial < trials.size(); ++progress->trial) {
        alarm(30);
        const std::string difference = play(trials[progress->trial], progress->playing, options.calls);
        progress->differences += !difference.empty();
        std::fputs(difference.c_str(), stdout);
        std::fflush(stdout);
      }
      std::fflush(nullptr);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (progress->trial >= trials.size()) break;
    const Trial& trial = trials[progress->trial++];
    const bool ours = progress->playing != Player::OSMesa;
    ++(ours ? progress->differences : their_crashes);
    if (ours || options.calls)
      std::printf("%s dies: softgl_arguments --command %s --first %llu --count 1\n",
                  ours ? "softgl" : "OSMesa", trial.command.name,
                  static_cast<unsigned long long>(trial.seed));
  }
  std::printf("%zu trials, %zu differences, OSMesa died in %zu\n", trials.size(), progress->differences,
              their_crashes);
  return progress->differences != 0;
}
