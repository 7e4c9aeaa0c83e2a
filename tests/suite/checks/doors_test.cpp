// The doors beside OSMesa: EGL without a screen, and GLX on an X server that is started for the test.
#include <catch2/catch.hpp>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "checks/suite_runs.h"

namespace softgl::suite {
namespace {

// Xvfb with a display number that it chooses; DISPLAY names it while this lives.
class Screen {
public:
  Screen() {
    int pipes[2];
    if (pipe(pipes) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      const int null = open("/dev/null", O_RDWR);
      dup2(null, STDOUT_FILENO), dup2(null, STDERR_FILENO);
      const std::string number = std::to_string(pipes[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "320x240x24", "-nolisten", "tcp",
             static_cast<char*>(nullptr));
      _exit(127);
    }
    close(pipes[1]);
    pollfd ready{pipes[0], POLLIN, 0};
    char text[16] = {};
    if (poll(&ready, 1, 30'000) == 1 && read(pipes[0], text, sizeof text - 1) > 0) {
      const std::string line = text;
      setenv("DISPLAY", (":" + line.substr(0, line.find('\n'))).c_str(), 1), there_ = true;
    }
    close(pipes[0]);
  }
  ~Screen() {
    if (process_ > 0) kill(process_, SIGTERM), waitpid(process_, nullptr, 0);
    unsetenv("DISPLAY");
  }
  bool there() const { return there_; }

private:
  pid_t process_ = -1;
  bool there_ = false;
};

// The failures of Mesa through a door, or a warning that the test was skipped. A door is another framebuffer
// and another way to its pixels, but the same llvmpipe: the chapters of these, not all.
void check_mesa(const std::string& door) {
  setenv("GALLIUM_DRIVER", "llvmpipe", 1), setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1),
      setenv("LP_NUM_THREADS", "0", 1);
  RunOptions options;
  options.subject = parse_subject(door), options.levels = Levels::Plain;
  SubjectFacts facts;
  try {
    facts = probe(options);
  } catch (const std::runtime_error& e) {
    WARN("SKIPPED: " << door << ": " << e.what());
    return;
  }
  if (facts.renderer.find("llvmpipe") == std::string::npos) {
    WARN("SKIPPED: " << door << " is " << facts.renderer << ", of which nothing is known");
    return;
  }
  for (const char* suite : {"raster", "pixels"}) {
    options.suite = suite;
    check_known(run(options, facts, [](const TestResult&) {}), "llvmpipe", door);
  }
}

} // namespace

TEST_CASE("the conformance suite finds through EGL what is known", "[suite]") { check_mesa("egl"); }

TEST_CASE("the conformance suite finds through GLX what is known", "[suite]") {
  const Screen screen;
  if (!screen.there()) {
    WARN("SKIPPED: xvfb is not installed");
    return;
  }
  check_mesa("glx");
}

} // namespace softgl::suite
