// softgl batch where something goes wrong: no picture is there by half, and the others are drawn.
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <random>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "models/program_runner.h"
#include "models/started_program.h"

using namespace softgl::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string folder() { return output_folder("job_faults"); }

std::string write(const std::string& name, const std::string& text) {
  return write_bytes(folder() + name, text);
}

std::string model(const std::string& name, int height = 1) { return write(name, pyramid(height)); }

// Whoever reads it waits for ever.
std::string endless(const std::string& name) {
  const std::string path = folder() + name;
  fs::create_directories(fs::path(path).parent_path());
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  return path;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::vector<std::string> batch(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"batch", "--up", "+Y", "--size", "40x30"});
  return arguments;
}

void wait_until(const std::function<bool()>& condition) {
  for (int i = 0; i < 3000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(condition());
}

// The pipe's end for writing, when a process has begun to read it.
int reader_of(const std::string& pipe) {
  int writer = -1;
  wait_until([&] { return writer >= 0 || (writer = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK)) >= 0; });
  return writer;
}

bool has_reader(int writer) {
  pollfd end{writer, POLLOUT, 0};
  return ::poll(&end, 1, 0) >= 0 && !(end.revents & POLLERR);
}

Json line_of(const std::string& lines, const std::string& model) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    const Json object = Json::parse(line);
    if (object.at("model") == model) return object;
  }
  return {};
}

std::vector<std::string> files_in(const std::string& path) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path)) files.push_back(entry.path().filename().string());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

TEST_CASE("job faults: a process that dies takes its job alone", "[models][jobs]") {
  const std::string pipe = endless("dies/pipe.obj"), good = model("dies/good.obj"), out = folder() + "dies/";
  const std::string list = write("dies/jobs", pipe + "\t\t" + out + "pipe.png\n" + good + "\t\t" + out +
                                                  "1.png\n" + good + "\t\t" + out + "2.png\n");
  StartedProgram program(batch({list, "--threads", "1", "--report", out + "report"}));
  // The heaviest are drawn first, and the pipe has no bytes.
  const int writer = reader_of(pipe);
  for (const pid_t child : program.children()) ::kill(child, SIGABRT);
  CHECK(program.wait() == 128 + SIGABRT);
  ::close(writer);
  const std::string lines = read_bytes(out + "report");
  CHECK(line_of(lines, pipe).at("exit_code") == 128 + SIGABRT);
  CHECK(has(line_of(lines, pipe).at("error"), "the process that drew it was ended by signal 6"));
  CHECK(line_of(lines, good).at("exit_code") == 0);
  CHECK(has(program.errors(), "3 jobs: 2 drawn, 0 there already, 1 failed"));
}

TEST_CASE("job faults: a job that is killed is drawn once more", "[models][jobs]") {
  const std::string pipe = endless("alone/pipe.obj"), good = model("alone/good.obj"),
                    out = folder() + "alone/";
  const std::string text = read_bytes(good);
  for (const bool again : {false, true}) {
    StartedProgram program(batch({pipe, "--threads", "2", "-o", out + "{model}.ppm"}));
    const int writer = reader_of(pipe);
    const std::vector<pid_t> first = program.children();
    for (const pid_t child : first) ::kill(child, SIGKILL);
    wait_until([&] { return program.children() != first && has_reader(writer); });
    if (again)
      for (const pid_t child : program.children()) ::kill(child, SIGKILL);
    else
      CHECK(::write(writer, text.data(), text.size()) == ssize_t(text.size()));
    ::close(writer);
    CHECK(program.wait() == (again ? 128 + SIGKILL : 0));
    CHECK(has(program.errors(),
              again ? "0 drawn, 0 there already, 1 failed" : "1 drawn, 0 there already, 0 failed"));
  }
}

TEST_CASE("job faults: the time limit is that of a job", "[models][jobs]") {
  const std::string pipe = endless("late/pipe.obj"), good = model("late/good.obj"), out = folder() + "late/";
  const ProgramRun run =
      run_softgl(batch({"-", "--threads", "1", "--timeout", "0.2", "-o", out + "{model}.png"}),
                 pipe + "\n" + good + "\t--timeout 60\n");
  CHECK(run.exit_code == 3);
  CHECK(has(line_of(run.output, pipe).at("error"), "pipe.obj: not finished after 0.2 s (--timeout)"));
  CHECK(line_of(run.output, good).at("exit_code") == 0);
}

TEST_CASE("job faults: after SIGTERM what is at work is finished, or dropped", "[models][jobs]") {
  const std::string pipe = endless("term/pipe.obj"), out = folder() + "term/";
  for (const char* name : {"term/a.obj", "term/b.obj"}) model(name);
  const std::string text = read_bytes(out + "a.obj"),
                    list = write("term/jobs", out + "a.obj\n" + pipe + "\n");
  const std::vector<std::string> arguments =
      batch({list, "--threads", "1", "--report", out + "report", "--resume", "-o", out + "{model}.png"});
  {
    StartedProgram program(arguments);
    const int writer = reader_of(pipe);
    program.send_to_all(SIGTERM);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK_FALSE(program.has_ended());
    CHECK(::write(writer, text.data(), text.size()) == ssize_t(text.size()));
    ::close(writer);
    CHECK(program.wait() == 128 + SIGTERM);
    CHECK(has(program.errors(), "2 jobs: 2 drawn, 0 there already, 0 failed after signal 15"));
    CHECK(line_of(read_bytes(out + "report"), pipe).at("exit_code") == 0);
  }
  fs::remove(out + "a.png");
  fs::remove(out + "pipe.png");
  {
    StartedProgram program(arguments);
    const int writer = reader_of(pipe);
    wait_until([&] {
      program.send_to_all(SIGINT); // the second is the last
      return program.has_ended();
    });
    CHECK(program.wait() == 128 + SIGINT);
    ::close(writer);
    CHECK(has(program.errors(), "0 failed, 1 not begun or dropped after signal 2"));
    CHECK(files_in(out) == std::vector<std::string>{"a.obj", "a.png", "b.obj", "jobs", "pipe.obj", "report"});
  }
}

TEST_CASE("job faults: killed at any moment, a run leaves whole pictures, and the next one the rest",
          "[models][jobs]") {
  const std::string models = folder() + "killed/models/", out = folder() + "killed/out/",
                    expected = folder() + "killed/expected/";
  for (int i = 0; i < 60; ++i) model("killed/models/" + std::to_string(i) + ".obj", i % 7);
  CHECK(run_softgl(batch({models, "-q", "-o", expected + "{model}.png"})).exit_code == 0);
  const char* moments = std::getenv("SOFTGL_KILL_MOMENTS"); // 50 of them take half a minute
  const int count = moments ? std::atoi(moments) : 4;
  const std::vector<std::string> arguments =
      batch({models, "--resume", "--threads", "2", "--report", out + "report", "-o", out + "{model}.png"});
  const auto check_whole = [&] {
    size_t pictures = 0;
    for (const std::string& name : files_in(out)) {
      if (!name.ends_with(".png")) continue;
      CAPTURE(name);
      CHECK(read_bytes(out + name) == read_bytes(expected + name));
      ++pictures;
    }
    return pictures;
  };
  fs::create_directories(out);
  std::mt19937 random(1);
  for (int i = 0; i < count; ++i) {
    StartedProgram program(arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 150));
    program.send_to_all(SIGKILL);
    program.wait();
    if (check_whole() == 60) // from the start again
      for (const std::string& name : files_in(out)) fs::remove(out + name);
  }
  const ProgramRun rest = run_softgl(arguments);
  CHECK(rest.exit_code == 0);
  CHECK(check_whole() == 60);
  CHECK(files_in(out).size() == 61); // and the report
  CHECK(has(run_softgl(arguments).errors, "60 jobs: 0 drawn, 60 there already"));
}

TEST_CASE("job faults: two runs on one folder", "[models][jobs]") {
  const std::string models = folder() + "two/models/", out = folder() + "two/out/";
  for (int i = 0; i < 20; ++i) model("two/models/" + std::to_string(i) + ".obj", i % 7);
  const std::vector<std::string> arguments =
      batch({models, "--threads", "2", "--report", out + "report", "-o", out + "{model}.ppm", "--resume"});
  StartedProgram first(arguments), second(arguments);
  CHECK(first.wait() == 0);
  CHECK(second.wait() == 0);
  CHECK(files_in(out).size() == 21);
  for (int i = 0; i < 20; ++i) CHECK(read_bytes(out + std::to_string(i) + ".ppm").size() == 13 + 40 * 30 * 3);
  CHECK(has(run_softgl(arguments).errors, "20 jobs: 0 drawn"));
}

TEST_CASE("job faults: what a killed run left is removed, what another writes is not", "[models][jobs]") {
  const std::string out = folder() + "left/", good = model("left/good.obj");
  const std::string left = write("left/good.png.4711-0.tmp", "half"),
                    held = write("left/good.png.4712-3.tmp", "half");
  for (const char* other :
       {"left/good.png.tmp", "left/good.png.1-a.tmp", "left/else.png.4711-0.tmp", "left/.1-1.tmp"})
    write(other, "not of this run");
  const int holder = ::open(held.c_str(), O_RDONLY);
  REQUIRE(::flock(holder, LOCK_EX) == 0);
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--sandbox"}}) {
    write("left/good.png.4711-0.tmp", "half");
    std::vector<std::string> arguments = batch({good, "-o", out + "{model}.png"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = run_softgl(arguments);
    if (has(run.errors, "was built without it")) continue; // no sandbox on this processor
    CHECK(run.exit_code == 0);
    CHECK_FALSE(fs::exists(left));
    CHECK(fs::exists(held));
    CHECK(files_in(out).size() == 7);
  }
  ::close(holder);
  CHECK(run_softgl(batch({good, "-o", out + "{model}.png", "--resume"})).exit_code == 0);
  CHECK_FALSE(fs::exists(held));
}

TEST_CASE("job faults: a disk that is full, and files that nobody may read or write", "[models][jobs]") {
  const std::string out = folder() + "full/", good = model("full/good.obj");
  const std::string list = write("full/jobs", good + "\t--size 200x200\t" + out + "large.ppm\n" + good +
                                                  "\t\t" + out + "small.ppm\n");
  StartedProgram program(batch({list, "--threads", "1"}), "ulimit -f 8;"); // files of 4 KiB
  CHECK(program.wait() == 4);
  CHECK(has(program.errors(), "large.ppm: cannot write: File too large"));
  CHECK(read_bytes(out + "small.ppm").size() == 13 + 40 * 30 * 3);
  CHECK(files_in(out) == std::vector<std::string>{"good.obj", "jobs", "small.ppm"});
  const ProgramRun report = run_softgl(batch({list, "--report", "/dev/full"}));
  CHECK(report.exit_code == 4);
  CHECK(has(report.errors, "/dev/full: cannot write"));
  CHECK(fs::exists(out + "large.ppm"));
  CHECK(run_softgl(batch({list, "--report", out + "good.obj/x"})).exit_code == 4);
  if (::geteuid() == 0) return; // who may read all
  fs::permissions(good, fs::perms::none);
  const ProgramRun unreadable = run_softgl(batch({list}));
  CHECK(unreadable.exit_code == 3);
  CHECK(has(unreadable.errors, "good.obj: cannot open: Permission denied"));
}

#ifndef SOFTGL_ADDRESS_SANITIZER // whose own memory is more
TEST_CASE("job faults: a job that needs too much memory fails alone", "[models][jobs]") {
  const std::string out = folder() + "memory/", good = model("memory/good.obj");
  const ProgramRun run = run_softgl(batch({"-", "--threads", "1", "--max-memory", "1024"}),
                                    good + "\t--size 16384x16384 --aa 1\t" + out + "large.ppm\n" + good +
                                        "\t\t" + out + "small.ppm\n" + good + "\t\t" + out + "small2.ppm\n");
  CHECK(run.exit_code == 3);
  CHECK(has(run.errors, "not enough memory"));
  CHECK(has(run.errors, "3 jobs: 2 drawn, 0 there already, 1 failed"));
}
#endif
