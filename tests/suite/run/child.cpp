#include "run/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

namespace softgl::suite {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kBytes = size_t(4) * kWindowWidth * kWindowHeight;
constexpr uint32_t kFinished = 0x50494354;

// What the child writes; the parent believes it only as far as `finished` says.
struct SharedPicture {
  uint32_t finished;
  char fault[200];
  uint8_t color[kBytes];
};
struct Shared {
  uint32_t opened, ended;
  char fault[300];
  char vendor[200], renderer[200], version[200], extensions[30000];
  int32_t numbers[8];
  float widths[4][3]; // least, greatest and step: of points, antialiased points, lines, antialiased lines
  uint32_t reached;
  SharedPicture pictures[1]; // as many as scripts
};

void copy_text(char* to, size_t size, const char* from) { std::snprintf(to, size, "%s", from ? from : ""); }

/// "1.5 ..." to 15.
int version_number(const std::string& text) {
  int major = 0, minor = 0;
  return std::sscanf(text.c_str(), "%d.%d", &major, &minor) == 2 && major < 10 && minor < 10
             ? 10 * major + minor
             : 0;
}

void ask(const GlTable& gl, Shared& shared) {
  const auto text = [&](GLenum name) { return reinterpret_cast<const char*>(gl.GetString(name)); };
  if (!text(GL_VERSION)) throw std::runtime_error("glGetString(GL_VERSION) returned NULL");
  copy_text(shared.vendor, sizeof shared.vendor, text(GL_VENDOR));
  copy_text(shared.renderer, sizeof shared.renderer, text(GL_RENDERER));
  copy_text(shared.version, sizeof shared.version, text(GL_VERSION));
  copy_text(shared.extensions, sizeof shared.extensions, text(GL_EXTENSIONS));
  const GLenum names[] = {GL_RED_BITS,   GL_GREEN_BITS,   GL_BLUE_BITS,     GL_ALPHA_BITS,
                          GL_DEPTH_BITS, GL_STENCIL_BITS, GL_SUBPIXEL_BITS, GL_ACCUM_RED_BITS};
  for (size_t i = 0; i < std::size(names); i++) gl.GetIntegerv(names[i], &shared.numbers[i]);
  static const GLenum ranges[4] = {GL_ALIASED_POINT_SIZE_RANGE, GL_POINT_SIZE_RANGE,
                                   GL_ALIASED_LINE_WIDTH_RANGE, GL_LINE_WIDTH_RANGE};
  static const GLenum steps[4] = {0, GL_POINT_SIZE_GRANULARITY, 0, GL_LINE_WIDTH_GRANULARITY};
  for (size_t i = 0; i < 4 && gl.GetFloatv; i++) {
    gl.GetFloatv(i % 2 || version_number(text(GL_VERSION)) >= 12 ? ranges[i] : ranges[i + 1],
                 shared.widths[i]);
    if (steps[i]) gl.GetFloatv(steps[i], &shared.widths[i][2]);
  }
  // Without bits of colors every color would be within half a step.
  if (shared.numbers[0] < 1 || shared.numbers[1] < 1 || shared.numbers[2] < 1)
    throw std::runtime_error("the window has no red, green and blue");
  GLint viewport[4] = {}; // that of the whole window at first (2.11.1)
  gl.GetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[2] < kWindowWidth || viewport[3] < kWindowHeight)
    throw std::runtime_error("the window has only " + std::to_string(viewport[2]) + " x " +
                             std::to_string(viewport[3]) + " pixels");
}

void draw(const GlTable& gl, const Script& script, SharedPicture& picture) {
  Player player(gl);
  if (const char* name = player.missing(script)) {
    std::snprintf(picture.fault, sizeof picture.fault, "the library has no gl%s", name);
    picture.finished = kFinished;
    return;
  }
  while (gl.GetError() != GL_NO_ERROR) {} // a GL that always answers an error runs into the time limit
  player.play(script);
  const GLenum error = gl.GetError();
  std::vector<uint8_t> pixels(kBytes);
  // A GL that reads nothing leaves a pattern that no test expects.
  for (size_t i = 0; i < kBytes; i++) pixels[i] = uint8_t(0x5a ^ (i * 37));
  if (gl.PixelStorei) gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, kWindowWidth, kWindowHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  const GLenum read_error = gl.GetError();
  std::memcpy(picture.color, pixels.data(), kBytes);
  if (error != GL_NO_ERROR)
    std::snprintf(picture.fault, sizeof picture.fault, "the calls raise the GL error 0x%04x", error);
  else if (!player.fault().empty())
    copy_text(picture.fault, sizeof picture.fault, player.fault().c_str());
  else if (read_error != GL_NO_ERROR)
    std::snprintf(picture.fault, sizeof picture.fault, "glReadPixels raises the GL error 0x%04x", read_error);
  picture.finished = kFinished;
}

[[noreturn]] void child(const SubjectName& name, const std::vector<Script>& scripts, Shared& shared,
                        bool quiet) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int null = open("/dev/null", O_RDWR);
  dup2(null, STDOUT_FILENO);
  if (quiet) dup2(null, STDERR_FILENO);
  try {
    const std::unique_ptr<Subject> subject = open_subject(name);
    for (size_t i = 0; i < scripts.size(); i++) {
      subject->renew();
      if (const char* query = missing_query(subject->gl))
        throw std::runtime_error(std::string("the library has no ") + query);
      if (i == 0) ask(subject->gl, shared), shared.opened = kFinished;
      shared.reached = uint32_t(i);
      draw(subject->gl, scripts[i], shared.pictures[i]);
    }
    shared.ended = kFinished;
  } catch (const std::exception& e) { copy_text(shared.fault, sizeof shared.fault, e.what()); }
  _exit(0); // without the library's destructors
}

std::string text_of(const char* from, size_t size) { return std::string(from, strnlen(from, size)); }

SubjectFacts facts_of(const Shared& s) {
  SubjectFacts f;
  f.vendor = text_of(s.vendor, sizeof s.vendor), f.renderer = text_of(s.renderer, sizeof s.renderer);
  f.version = text_of(s.version, sizeof s.version), f.extensions = text_of(s.extensions, sizeof s.extensions);
  f.version_number = version_number(f.version);
  for (int i = 0; i < 4; i++) f.precision.bits[i] = std::clamp(s.numbers[i], 0, 32);
  f.depth_bits = s.numbers[4], f.stencil_bits = s.numbers[5];
  f.precision.subpixel_bits = s.numbers[6], f.accumulation_bits = s.numbers[7];
  f.precision.depth_bits = std::clamp(f.depth_bits, 1, 32);
  f.precision.stencil_bits = std::clamp(f.stencil_bits, 0, 16);
  f.precision.accumulation_bits = f.accumulation_bits;
  WidthRange* const ranges[4] = {&f.precision.points, &f.precision.smooth_points, &f.precision.lines,
                                 &f.precision.smooth_lines};
  for (int i = 0; i < 4; i++) {
    const float* w = s.widths[i];
    if (w[1] >= 1) *ranges[i] = {std::max(double(w[0]), 0.0), double(w[1]), double(w[2])};
  }
  return f;
}

/// Waits for the end of the process: its fault, or nothing.
std::string wait_for(pid_t process, int pipe, Clock::time_point until) {
  pollfd end{pipe, POLLIN, 0};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    const int ready = poll(&end, 1, int(std::max<long long>(left.count(), 0)));
    if (ready != 0 && !(ready < 0 && errno == EINTR)) break;
    if (ready == 0) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
      return "ran out of time";
    }
  }
  // The pipe closes when the process ends, and also if the library closes all files: then it may still hang.
  for (;;) {
    int status = 0;
    const pid_t ended = waitpid(process, &status, WNOHANG);
    if (ended == process) {
      if (WIFSIGNALED(status)) return std::string("died of ") + strsignal(WTERMSIG(status));
      return WEXITSTATUS(status) ? "ended with status " + std::to_string(WEXITSTATUS(status)) : "";
    }
    if (Clock::now() > until) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
      return "ran out of time";
    }
    usleep(200);
  }
}

} // namespace

struct RunningChild::State {
  Shared* shared = nullptr;
  size_t size = 0, count = 0; // of the memory, of scripts
  pid_t process = 0;
  int pipe = -1;
  Clock::time_point until;
  bool ended = false;
};

RunningChild::RunningChild(const SubjectName& subject, const std::vector<Script>& scripts, double seconds)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.count = scripts.size(), s.size = sizeof(Shared) + s.count * sizeof(SharedPicture);
  s.until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  void* memory = mmap(nullptr, s.size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  s.shared = static_cast<Shared*>(memory);
  int pipes[2];
  if (pipe2(pipes, O_CLOEXEC) != 0) throw std::runtime_error("there are no more pipes");
  s.process = fork();
  if (s.process < 0) throw std::runtime_error("there are no more processes");
  if (s.process == 0) {
    close(pipes[0]);
    child(subject, scripts, *s.shared, !getenv("SOFTGL_SUITE_STDERR"));
  }
  close(pipes[1]);
  s.pipe = pipes[0];
  madvise(memory, s.size, MADV_DONTFORK); // a child that runs wild shall not reach another's pictures
}

RunningChild::~RunningChild() {
  if (!state_->ended) kill(state_->process, SIGKILL), waitpid(state_->process, nullptr, 0);
  if (state_->pipe >= 0) close(state_->pipe);
  munmap(state_->shared, state_->size);
}

ChildResult RunningChild::finish() {
  State& s = *state_;
  const Shared& shared = *s.shared;
  ChildResult result;
  result.fault = wait_for(s.process, s.pipe, s.until);
  s.ended = true;

  if (shared.opened == kFinished) result.facts = facts_of(shared);
  if (result.fault.empty() && shared.ended != kFinished) {
    const std::string said = text_of(shared.fault, sizeof shared.fault);
    result.fault = said.empty() ? "ended before the test did" : said;
  }
  for (size_t i = 0; i < s.count; i++) {
    DrawnPicture picture;
    const SharedPicture& from = shared.pictures[i];
    if (from.finished == kFinished) {
      picture.color.assign(from.color, from.color + kBytes);
      picture.fault = text_of(from.fault, sizeof from.fault);
    } else {
      picture.fault = result.fault.empty() ? "was not drawn" : result.fault;
    }
    result.pictures.push_back(std::move(picture));
  }
  return result;
}

ChildResult run_in_child(const SubjectName& subject, const std::vector<Script>& scripts, double seconds) {
  return RunningChild(subject, scripts, seconds).finish();
}

} // namespace softgl::suite
