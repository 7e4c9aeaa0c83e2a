// softgl batch as the engines of a farm start it: the scripts and files of reference/farm.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "models/command_line.h"
#include "models/program_runner.h"
#include "test_paths.h"

using namespace softgl::test;
namespace fs = std::filesystem;

namespace {

const std::string kFarm = SOFTGL_TEST_SOURCE_DIR "/reference/farm/",
                  kTests = SOFTGL_TEST_SOURCE_DIR "/tests/farm/";
const std::string kSoftgl = std::string(SOFTGL_TEST_BINARY_DIR) + "/softgl";

std::string empty_folder(const std::string& name) {
  const std::string folder = output_folder("farm") + name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("farm: a Slurm array draws 500 pictures although a node dies", "[farm][slow]") {
  // Names of sockets are short.
  std::string folder = "/tmp/softgl-farm-XXXXXX";
  REQUIRE(::mkdtemp(folder.data()));
  const ShellRun run = run_shell("timeout -k 20 560 python3 '" + kTests + "slurm_cluster.py' '" + kSoftgl +
                                 "' '" + kFarm + "slurm.sh' " + folder + " 2>&1");
  INFO(run.output);
  fs::remove_all(folder);
  if (run.output.rfind("SKIPPED: ", 0) == 0) {
    WARN(run.output);
    return;
  }
  CHECK(run.code == 0);
  CHECK(std::regex_search(run.output,
                          std::regex("n\\d died with task \\d after \\d+ pictures; restarts [1-9]")));
  CHECK(has(run.output, "500 pictures are those of a single run\n"));
}

TEST_CASE("farm: GNU parallel draws a list in parts", "[farm]") {
  if (!has_program("parallel")) {
    WARN("SKIPPED: this needs GNU parallel");
    return;
  }
  const std::string folder = empty_folder("parallel") + "/";
  {
    std::ofstream jobs(folder + "jobs.tsv");
    for (int i = 0; i < 9; ++i) {
      std::ofstream(folder + std::to_string(i) + ".obj")
          << "v 0 0 0\nv 1 0 0\nv 0 " << i + 1 << " 0\nf 1 2 3\n";
      jobs << i << ".obj\t--size " << 20 + i << "\tout/" << i << ".ppm\n";
    }
  }
  const ShellRun run =
      run_shell("cd '" + folder + "' && SOFTGL='" + kSoftgl + "' OPTIONS='--up +Y --view front' HOME='" +
                folder + "' sh '" + kFarm + "parallel.sh' 3 2>&1");
  INFO(run.output);
  CHECK(run.code == 0);
  CHECK(has(run.output, "jobs of shard 3/3"));
  for (int i = 0; i < 9; ++i) {
    const ProgramRun alone = run_softgl({folder + std::to_string(i) + ".obj", "--up", "+Y", "--view", "front",
                                         "--size", std::to_string(20 + i), "-o", "-", "--format", "ppm"});
    CHECK(read_bytes(folder + "out/" + std::to_string(i) + ".ppm") == alone.output);
  }
}

TEST_CASE("farm: the files for Kubernetes, Argo and Nextflow have what these ask for", "[farm]") {
  if (run_shell("python3 -c 'import yaml'").code != 0) {
    WARN("SKIPPED: this needs python3-yaml");
    return;
  }
  const ShellRun run = run_shell("python3 '" + kTests + "farm_files.py' '" + kFarm + "kubernetes.yaml' '" +
                                 kFarm + "argo.yaml' '" + kFarm + "nextflow.nf' 2>&1");
  INFO(run.output);
  REQUIRE(run.code == 0);
  // What they start is a command line of softgl: in an empty folder only the list is missing.
  const std::string folder = empty_folder("commands");
  size_t commands = 0;
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line); ++commands) {
    CAPTURE(line);
    REQUIRE(line.rfind("softgl batch ", 0) == 0);
    line = std::regex_replace(line, std::regex("\\{\\{[^}]*(number|shards)\\}\\}"), "3");
    line = std::regex_replace(line, std::regex("\\$\\{jobs\\}"), "jobs.tsv");
    line = std::regex_replace(line, std::regex("\\$\\{[^}]*\\}"), "3");
    const ShellRun softgl = run_shell(
        "cd '" + folder + "' && JOB_COMPLETION_INDEX=2 '" + kSoftgl + "'" +
        std::regex_replace(line.substr(6), std::regex("log/\\{shard\\}"), "'log/{shard}'") + " 2>&1");
    CHECK(softgl.output == "softgl: error: jobs.tsv: cannot open: No such file or directory\n");
    CHECK(softgl.code == 3);
  }
  CHECK(commands == 3);
  // A field that is missing is found, and one that is not known.
  for (const char* change :
       {"s/completions:/completionz:/", "s/^kind: Job/kind: Jub/", "s/completions: 20/completions: 7/"}) {
    const ShellRun wrong = run_shell(
        "cd '" + folder + "' && sed '" + change + "' '" + kFarm + "kubernetes.yaml' > k.yaml && python3 '" +
        kTests + "farm_files.py' k.yaml '" + kFarm + "argo.yaml' '" + kFarm + "nextflow.nf' 2>&1");
    CHECK(wrong.code != 0);
  }
}
