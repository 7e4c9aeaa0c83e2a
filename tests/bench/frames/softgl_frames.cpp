// softgl_frames: milliseconds per picture of programs of several kinds, for any library with OSMesa's
// functions, and a hash of what they drew beside each time.
//   softgl_frames --against /usr/lib/x86_64-linux-gnu/libOSMesa.so.8
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "frames/workloads.h"
#include "support/shader_twins.h"
#include "test_paths.h"

using namespace softgl;
using namespace softgl::bench;

namespace {

const char kUsage[] =
    "usage: softgl_frames [options] [WORKLOAD...]\n"
    "  --list            names of all workloads, and what they draw\n"
    "  --library FILE    the library to measure (softgl of this build)\n"
    "  --against FILE    measure this library too, in turn with the other, and print how many times faster "
    "the other is\n"
    "  --runs N          how often each library is measured; the medians are printed (5 with --against, "
    "otherwise 1)\n"
    "  --seconds S       how long a run takes at least (1)\n"
    "  --size N          width and height of the pictures (1024)\n"
    "  --scale S         part of the geometry and of the draws, 0 < S <= 1 (1); the times then say little\n";

struct Options {
  std::vector<const WorkloadKind*> workloads;
  std::string library = SOFTGL_TEST_LIBRARY, against;
  int runs = 0, size = 1024;
  double seconds = 1, scale = 1;
};

/// What a run reports to the process that started it.
struct Result {
  double milliseconds, rate;
  uint64_t hash; // of picture 0
  char unit[24];
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

uint64_t hash_of(const std::vector<uint64_t>& words) {
  uint64_t h = 0xcbf29ce484222325u;
  for (uint64_t w : words) h = (h ^ w) * 0x100000001b3u, h ^= h >> 29;
  return h;
}

Result measure(const std::string& library, const WorkloadKind& kind, const Options& o) {
  const double begin = now();
  Gl gl = test::load_gl(library, library);
  void* context = gl.OSMesaCreateContextExt(test::kOSMesaRgba, 24, 8, 0, nullptr);
  std::vector<uint64_t> pixels(size_t(o.size) * size_t(o.size) / 2);
  if (!context || !gl.OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, o.size, o.size))
    throw std::runtime_error(library + " makes no context");
  if (kind.phong &&
      !std::strstr(reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS)), "GL_WIN_phong_shading")) {
    gl = test::with_shaders(gl, test::Twins::Phong);
    gl.OSMesaMakeCurrent(context, pixels.data(), GL_UNSIGNED_BYTE, o.size, o.size);
  }
  auto workload = kind.make(gl, o.size, o.scale);
  auto frame = [&](int turn) {
    workload->frame(turn);
    gl.Finish();
  };
  frame(0);
  const double first = now() - begin;
  Result result{};
  result.hash = hash_of(pixels);
  result.milliseconds = first * 1e3;
  if (!kind.first_frame) {
    const double start = now();
    double elapsed;
    int frames = 0;
    do frame(++frames);
    while ((elapsed = now() - start) < o.seconds);
    result.milliseconds = elapsed / frames * 1e3;
    frame(0);
    if (hash_of(pixels) != result.hash) throw std::runtime_error("drawn again, the picture is another one");
  }
  result.rate = workload->units / result.milliseconds * 1e3;
  std::strncpy(result.unit, workload->unit, sizeof result.unit - 1);
  if (GLenum error = gl.GetError()) throw std::runtime_error("GL error " + std::to_string(error));
  return result;
}

/// Measures in a process of its own, so that no run finds a library warm or a thread waiting.
Result measure_apart(const std::string& library, const WorkloadKind& kind, const Options& o) {
  int ends[2];
  if (pipe(ends)) throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child == 0) {
    try {
      const Result result = measure(library, kind, o);
      _exit(write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "softgl_frames: %s: %s\n", kind.name, e.what());
      _exit(1);
    }
  }
  close(ends[1]);
  Result result{};
  const bool complete = child > 0 && read(ends[0], &result, sizeof result) == sizeof result;
  close(ends[0]);
  int status = 1;
  if (child > 0) waitpid(child, &status, 0);
  if (!complete || status) throw std::runtime_error(std::string(kind.name) + " was not measured");
  return result;
}

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

int run(Options& o) {
  if (o.workloads.empty())
    for (const WorkloadKind& kind : workloads()) o.workloads.push_back(&kind);
  if (!o.runs) o.runs = o.against.empty() ? 1 : 5;
  for (const WorkloadKind* kind : o.workloads) {
    std::vector<double> ours, theirs, ratio;
    Result a{}, b{};
    for (int i = 0; i < o.runs; i++) {
      a = measure_apart(o.library, *kind, o);
      ours.push_back(a.milliseconds);
      if (o.against.empty()) continue;
      b = measure_apart(o.against, *kind, o);
      theirs.push_back(b.milliseconds);
      ratio.push_back(b.milliseconds / a.milliseconds);
    }
    std::printf("%-14s %9.3f ms %9.2f %-11s %016llx", kind->name, median(ours), a.rate, a.unit,
                static_cast<unsigned long long>(a.hash));
    if (!o.against.empty())
      std::printf("  %9.3f ms %016llx  %6.2f times", median(theirs), static_cast<unsigned long long>(b.hash),
                  median(ratio));
    std::printf("\n");
    std::fflush(stdout);
  }
  return 0;
}

int usage() { return std::fputs(kUsage, stderr), 2; }

} // namespace

int main(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; i++) {
    const std::string option = argv[i];
    if (option == "--list") {
      for (const WorkloadKind& kind : workloads()) std::printf("%-14s %s\n", kind.name, kind.what);
      return 0;
    }
    if (option[0] != '-') {
      const auto& all = workloads();
      auto kind =
          std::find_if(all.begin(), all.end(), [&](const WorkloadKind& k) { return option == k.name; });
      if (kind == all.end()) return std::fprintf(stderr, "no workload is called %s\n", option.c_str()), 2;
      o.workloads.push_back(&*kind);
    } else if (i + 1 == argc)
      return usage();
    else if (option == "--library")
      o.library = argv[++i];
    else if (option == "--against")
      o.against = argv[++i];
    else if (option == "--runs")
      o.runs = std::atoi(argv[++i]);
    else if (option == "--seconds")
      o.seconds = std::atof(argv[++i]);
    else if (option == "--size")
      o.size = std::atoi(argv[++i]);
    else if (option == "--scale")
      o.scale = std::atof(argv[++i]);
    else
      return usage();
  }
  if (o.runs < 0 || o.size < 16 || o.size > 4096 || !(o.scale > 0 && o.scale <= 1) || !(o.seconds >= 0))
    return usage();
  try {
    return run(o);
  } catch (const std::exception& e) { return std::fprintf(stderr, "softgl_frames: %s\n", e.what()), 1; }
}
