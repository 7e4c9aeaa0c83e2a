// --sandbox: the same pictures, and nothing else is left to do.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "common/program_error.h"
#include "common/sandbox.h"

#include "test_paths.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace softgl;
using namespace softgl::test;

namespace {

std::string folder() {
  const std::string inner = output_folder("sandbox") + "models/";
  std::filesystem::create_directories(inner + "deep");
  return inner;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

const std::string kModel =
    "mtllib m.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 1\nvt 0 0\nf 1/1 2/1 3/1 4/1\n";

#ifdef __x86_64__

// What fails with `error`; 0: nothing does.
struct Attempt {
  const char* name;
  int error;
  std::function<bool()> work; // false, and errno
};

// The name of the first attempt that did not end as expected, in a process that has entered the sandbox.
std::string first_surprise(const cli::SandboxPaths& paths, const std::vector<Attempt>& attempts) {
  int pipe[2];
  REQUIRE(::pipe(pipe) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::string surprise;
    try {
      cli::enter_sandbox(paths);
      for (const Attempt& attempt : attempts) {
        errno = 0;
        const int error = attempt.work() ? 0 : errno;
        if (error != attempt.error && surprise.empty())
          surprise = std::string(attempt.name) + ": error " + std::to_string(error);
      }
    } catch (const std::exception& error) { surprise = error.what(); }
    const bool told = ::write(pipe[1], surprise.data(), surprise.size()) >= 0;
    ::_exit(told ? 0 : 1);
  }
  ::close(pipe[1]);
  char text[200];
  const ssize_t size = ::read(pipe[0], text, sizeof text);
  ::close(pipe[0]);
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  return {text, size_t(size < 0 ? 0 : size)};
}

bool opens(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
  if (file >= 0) ::close(file);
  return file >= 0;
}

#endif

} // namespace

#ifdef __x86_64__

TEST_CASE("sandbox: no files outside, no programs, no network", "[models][sandbox]") {
  const std::string models = folder(), outside = output_folder("sandbox");
  std::filesystem::create_directories(outside + "out");
  write(models + "m.obj", kModel);
  write(models + "deep/m.png", "x");
  write(outside + "secret", "x");
  const bool files = cli::landlock_version() > 0;
  const int denied = files ? EACCES : 0;
  std::vector<Attempt> attempts = {
      {"a file of the model", 0, [&] { return opens(models + "m.obj", O_RDONLY); }},
      {"a file below", 0, [&] { return opens(models + "deep/m.png", O_RDONLY); }},
      {"a file beside", denied, [&] { return opens(outside + "secret", O_RDONLY); }},
      {"a detour", denied, [&] { return opens(models + "deep/../../secret", O_RDONLY); }},
      {"a file of the system", denied, [&] { return opens("/etc/passwd", O_RDONLY); }},
      {"the folder above", denied, [&] { return opens(outside, O_RDONLY | O_DIRECTORY); }},
      {"to write to the model", denied, [&] { return opens(models + "m.obj", O_WRONLY); }},
      {"to make a file beside the model", denied, [&] { return opens(models + "new", O_WRONLY | O_CREAT); }},
      {"to remove the model", denied, [&] { return ::unlink((models + "deep/m.png").c_str()) == 0; }},
      {"to write a picture", 0, [&] { return opens(outside + "out/p.tmp", O_WRONLY | O_CREAT); }},
      {"to name it", 0,
       [&] { return ::rename((outside + "out/p.tmp").c_str(), (outside + "out/p.png").c_str()) == 0; }},
      {"to move it elsewhere", denied,
       [&] { return ::rename((outside + "out/p.png").c_str(), (outside + "p.png").c_str()) == 0; }},
      {"a link out", EPERM, [&] { return ::symlink("/etc", (outside + "out/etc").c_str()) == 0; }},
      {"a socket", EPERM, [] { return ::socket(AF_INET, SOCK_STREAM, 0) >= 0; }},
      {"a socket of this machine", EPERM, [] { return ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }},
      {"a program", EPERM,
       [] {
         char* const none[] = {nullptr};
         ::execve("/bin/true", none, none);
         return false;
       }},
      {"a process", EPERM, [] { return ::fork() > 0; }},
      {"ptrace", EPERM, [] { return ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0; }},
      {"a signal to the parent", EPERM, [] { return ::kill(::getppid(), 0) == 0; }},
      {"the limits of the parent", EPERM,
       [] { return ::syscall(SYS_prlimit64, 1, 0, nullptr, nullptr) == 0; }},
      {"another root", EPERM, [] { return ::chroot("/") == 0; }},
      {"a terminal's input", EPERM, [] { return ::syscall(SYS_ioctl, 0, 0x5412, "x") == 0; }}, // TIOCSTI
      {"a call of another interface", EPERM, [] { return ::syscall(0x40000000 + SYS_getpid) > 0; }},
      {"a thread", 0,
       [] {
         int done = 0;
         std::thread([&done] { done = 1; }).join();
         return done == 1;
       }},
      {"memory", 0, [] { return std::string(1 << 24, 'x').size() > 0; }},
  };
#ifdef SOFTGL_ADDRESS_SANITIZER // takes fork() for its own
  std::erase_if(attempts, [](const Attempt& attempt) { return attempt.name == std::string("a process"); });
#endif
  CHECK(first_surprise({{models}, {outside + "out"}}, attempts) == "");
  std::filesystem::remove_all(outside + "out");
}

TEST_CASE("sandbox: a thread that runs already is in it, too", "[models][sandbox]") {
  const pid_t child = ::fork();
  if (child == 0) {
    std::atomic<bool> entered{false};
    int error = 0;
    std::thread thread([&] {
      while (!entered) std::this_thread::yield();
      error = ::socket(AF_INET, SOCK_STREAM, 0) < 0 ? errno : 0;
    });
    bool good = true;
    try {
      cli::enter_sandbox({});
    } catch (const cli::ProgramError&) { good = false; }
    entered = true;
    thread.join();
    ::_exit(good && error == EPERM ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
}

TEST_CASE("sandbox: the same pictures", "[models][sandbox]") {
  const std::string models = folder(), out = output_folder("sandbox") + "pictures/";
  std::filesystem::create_directories(out);
  const std::string source = std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/models";
  for (const char* name : {"lantern.obj", "lantern.mtl", "wood.png"})
    std::filesystem::copy_file(source + "/" + name, models + name,
                               std::filesystem::copy_options::overwrite_existing);
  write(models + "m.obj", kModel);
  write(models + "m.mtl", "newmtl m\nKd 1 0 0\nmap_Kd wood.png\n");
  write(out + "camera.json", R"({"eye": [3, 2, 5], "target": [0, 0, 0]})");
  const std::vector<std::vector<std::string>> jobs = {
      {models + "lantern.obj", "-o", out + "NAME.png", "-s", "60x60"},
      {models + "lantern.obj", "-o", "-", "--format", "ppm", "-s", "60x60", "--threads", "1"},
      {models + "m.obj", models + "lantern.obj", "-o", out + "NAME/{model}-{view}.png", "-s", "40x40",
       "--view", "iso,front", "--aa", "4"},
      {models, "-o", out + "NAME-{page}.png", "--sheet", "2x2", "-s", "40x40"},
      {models + "m.obj", "-o", out + "NAME.gif", "--turntable", "4", "-s", "30x30"},
      {models + "m.obj", "-o", out + "NAME.jpg", "-s", "40x40", "--bg", "picture:" + models + "wood.png"},
      {models + "m.obj", "-o", out + "NAME.exr", "-s", "40x40", "--pass", "depth"},
      {models + "m.obj", "-o", out + "NAME.png", "-s", "40x40", "--camera", out + "camera.json",
       "--write-camera", out + "NAME.json"},
      {"info", models + "lantern.obj", "--json"},
      {"figure", "-o", out + "NAME.png", "-s", "32x32"},
      {models + "absent.obj", "-o", out + "NAME.png"},
  };
  for (const std::vector<std::string>& job : jobs) {
    std::map<std::string, std::string> results[2];
    for (const bool sandboxed : {false, true}) {
      std::vector<std::string> arguments = job;
      for (std::string& argument : arguments)
        if (const size_t at = argument.find("NAME"); at != std::string::npos) argument.replace(at, 4, "p");
      if (sandboxed) arguments.emplace_back("--sandbox");
      // The leak sanitizer looks at the process from outside.
      const ProgramRun run = run_softgl(arguments, {}, {"ASAN_OPTIONS=detect_leaks=0"});
      auto& result = results[sandboxed];
      result["exit code"] = std::to_string(run.exit_code);
      result["output"] = run.output;
      result["errors"] = run.errors;
      for (const auto& file : std::filesystem::recursive_directory_iterator(out))
        if (file.is_regular_file() && file.path().filename() != "camera.json")
          result[file.path().string()] = read_bytes(file.path().string());
      for (const auto& file : std::filesystem::directory_iterator(out))
        if (file.path().filename() != "camera.json") std::filesystem::remove_all(file.path());
    }
    INFO(job[0] << " " << job[1] << " " << job[2]);
    INFO(results[1]["errors"]);
    CHECK(results[0]["exit code"] == (job[0].ends_with("absent.obj") ? "3" : "0"));
    CHECK(results[0] == results[1]);
  }
}

TEST_CASE("sandbox: what a model may name is narrower still", "[models][sandbox]") {
  const std::string models = folder();
  write(models + "m.obj", kModel);
  write(output_folder("sandbox") + "outside.png",
        read_bytes(std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/models/wood.png"));
  write(models + "m.mtl", "newmtl m\nmap_Kd ../outside.png\n");
  const auto draw = [&](std::vector<std::string> options) {
    std::vector<std::string> arguments = {models + "m.obj", "-o", "-", "--format", "ppm", "-s", "20x20"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_softgl(arguments, {}, {"ASAN_OPTIONS=detect_leaks=0"});
  };
  const ProgramRun plain = draw({}), sandboxed = draw({"--sandbox"});
  CHECK(plain.errors.find("not found in the model's folder") != std::string::npos);
  CHECK(plain.errors == sandboxed.errors);
  const ProgramRun any = draw({"--sandbox", "--allow-any-path"});
  CHECK(any.errors.empty());
  CHECK(any.output == draw({"--allow-any-path"}).output);
  CHECK(any.output != sandboxed.output);
}

#else

TEST_CASE("sandbox: said to be missing", "[models][sandbox]") {
  CHECK_THROWS_AS(cli::enter_sandbox({}), cli::ProgramError);
}

#endif
