// The program when memory ends: the k-th allocation of a run fails, for every k, once or with all after it.
#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "models/program_runner.h"
#include "test_paths.h"

using namespace softgl::test;

namespace {

// Two materials with textures, one of which lets light through, a line and a point; a name that is found only
// by looking through the folder.
std::string write_model(const std::string& folder) {
  std::ofstream(folder + "model.mtl")
      << "newmtl wood\nKd 1 0.9 0.8\nKs 0.5 0.5 0.5\nNs 30\nmap_Kd checker.bmp\n"
         "newmtl glass\nKd 0.2 0.4 1\nd 0.5\nmap_Kd LEAVES.JPG\nmap_d checker.bmp\n";
  std::ofstream(folder + "model.obj") << "mtllib model.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1\n"
                                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\nusemtl wood\nf 1/1 2/2 "
                                         "5/5\nf 2/2 3/3 5/5\nusemtl glass\n"
                                         "f 1/1 2/2 3/3 4/4 5/5\nl 1 5\np 5\n";
  const std::string plain = folder + "plain.obj";
  std::ofstream(plain) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* picture : {"checker.bmp", "leaves.jpg"})
    REQUIRE(run_softgl({plain, "-o", folder + picture, "--size", "20x20"}).exit_code == 0);
  return folder + "model.obj";
}

struct MemoryRuns {
  std::vector<std::string> arguments;
  std::string folder;

  ProgramRun run(uint64_t k, bool persistent) const {
    return run_softgl(arguments, {},
                      {"LD_PRELOAD=" SOFTGL_TEST_FAILING_MALLOC, "SOFTGL_FAIL_AT=" + std::to_string(k),
                       std::string("SOFTGL_FAIL_PERSISTENT=") + (persistent ? "1" : "0"),
                       "SOFTGL_FAIL_COUNT=" + folder + "count"});
  }

  uint64_t count() const {
    uint64_t calls = 0;
    std::ifstream(folder + "count") >> calls;
    return calls;
  }
};

// A finished run is right to the byte; any other says in one sentence that memory ended.
void check(const ProgramRun& run, const ProgramRun& good) {
  if (run.exit_code == 0) {
    CHECK(run.output == good.output);
    CHECK(run.errors == good.errors);
  } else {
    CHECK(run.exit_code == 3);
    CHECK(run.output.empty());
    CHECK(std::count(run.errors.begin(), run.errors.end(), '\n') == 1);
    CHECK(run.errors.rfind("softgl: error: ", 0) == 0);
    CHECK(run.errors.find("not enough memory") != std::string::npos);
  }
}

void fail_every_allocation(const MemoryRuns& runs, const std::string& model) {
#ifdef SOFTGL_ADDRESS_SANITIZER
  WARN("SKIPPED: the sanitizer's library must be the first that is loaded");
  return;
#endif
  const ProgramRun good = run_softgl(runs.arguments);
  REQUIRE(good.exit_code == 0);
  REQUIRE(good.errors.empty());
  CHECK(runs.run(0, false).output == good.output);
  const uint64_t calls = runs.count();
  REQUIRE(calls > 300);
  bool named = false;
  // Each of the last three hundred, where the model is read and drawn, and a sample of those before: most of
  // them belong to the command line.
  const uint64_t dense = calls - 300, step = std::max<uint64_t>(1, dense / 100);
  for (const bool persistent : {false, true})
    for (uint64_t k = 1; k <= calls; k += k < dense ? step : 1) {
      INFO("allocation " << k << " of " << calls << " fails" << (persistent ? ", and all later ones" : ""));
      const ProgramRun run = runs.run(k, persistent);
      INFO(run.errors);
      check(run, good);
      named |= run.errors.find(model + ": not enough memory") != std::string::npos;
    }
  CHECK(named);
}

} // namespace

TEST_CASE("program memory: a picture is right or refused, whatever allocation fails", "[faults][program]") {
  const std::string folder = output_folder("program-memory"), model = write_model(folder);
  for (const char* threads : {"1", "2"}) {
    INFO(threads << " threads");
    fail_every_allocation(
        {{model, "-o", "-", "--format", "png", "--size", "48x36", "--aa", "4", "--threads", threads}, folder},
        model);
  }
}

TEST_CASE("program memory: a description is right or refused, whatever allocation fails",
          "[faults][program]") {
  const std::string folder = output_folder("program-memory"), model = write_model(folder);
  fail_every_allocation({{"info", model, "--json"}, folder}, model);
}

TEST_CASE("program memory: a model of many chunks ends its threads", "[faults][program]") {
  const std::string folder = output_folder("program-memory"), model = folder + "large.obj";
  {
    std::ofstream file(model);
    file << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string comment = "#" + std::string(1000, '-') + "\n";
    for (int i = 0; i < 10000; ++i) file << comment;
    file << "v 0 0 1\nf 1 2 4\n";
  }
  fail_every_allocation({{"info", model, "--json", "--threads", "3"}, folder}, model);
}
