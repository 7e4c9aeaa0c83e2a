// Models of unknown origin: they learn nothing of other folders, and end when they may not go on.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "image/image_writer.h"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace softgl;
using namespace softgl::test;

namespace {

// The folder of the models; what lies beside it is none of their business.
std::string folder() {
  const std::string inner = output_folder("untrusted") + "models/";
  std::filesystem::create_directories(inner);
  return inner;
}

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_red_picture(const std::string& path) {
  cli::Picture picture;
  picture.width = picture.height = 2;
  for (int i = 0; i < 4; ++i)
    for (const uint8_t value : {255, 0, 0}) picture.pixels.append(value);
  const auto bytes = cli::encode_image(picture, "png", cli::PngEffort::kDefault);
  write(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

const std::string kModel =
    "mtllib m.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n";

ProgramRun draw(const std::string& obj, const std::string& mtl, std::vector<std::string> options = {}) {
  write(folder() + "m.obj", obj);
  write(folder() + "m.mtl", mtl);
  std::vector<std::string> arguments = {folder() + "m.obj", "-o",    "-",    "--format", "ppm", "-s", "20x20",
                                        "--view",           "front", "--aa", "1"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_softgl(arguments);
}

bool is_red(const ProgramRun& run) {
  const TestPicture picture = parse_ppm(run.output);
  return picture.at(10, 10)[0] > 100 && picture.at(10, 10)[1] == 0;
}

// The warnings without the name that they are about.
std::string sentence_of(const ProgramRun& run, const std::string& name) {
  std::string text = run.errors;
  for (size_t at; (at = text.find(name)) != std::string::npos;) text.replace(at, name.size(), "NAME");
  return text;
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

TEST_CASE("untrusted models: files elsewhere are as if they were not there", "[models][untrusted]") {
  const std::string outside = output_folder("untrusted");
  write_red_picture(outside + "secret.png");
  write_red_picture(folder() + "mine.png");
  std::filesystem::create_directories(folder() + "deep");
  write_red_picture(folder() + "deep/mine too.png");
  const auto link = [](const std::string& target, const std::string& name) {
    std::filesystem::remove(folder() + name);
    std::filesystem::create_symlink(target, folder() + name);
  };
  link("../secret.png", "out.png");
  link("../absent.png", "dangling.png");
  link("mine.png", "in.png");
  link("..", "up");
  link("/dev/zero", "zero.png");
  ::mkfifo((folder() + "pipe.png").c_str(), 0600);

  for (const char* name :
       {"mine.png", "in.png", "deep/mine too.png", "deep/../mine.png", "../models/mine.png"}) {
    INFO(name);
    const ProgramRun run = draw(kModel, "newmtl m\nmap_Kd " + std::string(name) + "\n");
    CHECK(run.errors.empty());
    CHECK(is_red(run));
  }
  const std::string usual = sentence_of(draw(kModel, "newmtl m\nmap_Kd absent.png\n"), "absent.png");
  CHECK(has(usual,
            "m.mtl:2: picture \"NAME\" not found in the model's folder (--allow-any-path looks elsewhere"));
  for (const std::string& name :
       {std::string("../secret.png"), std::string("../absent.png"), outside + "secret.png",
        outside + "absent.png", std::string("out.png"), std::string("dangling.png"),
        std::string("up/secret.png"), std::string("up/absent.png"), std::string("deep/../../secret.png"),
        std::string("/proc/self/environ"), std::string("/proc/self/mem"), std::string("/dev/zero"),
        std::string("zero.png"), std::string("pipe.png"), std::string("/etc/passwd"),
        std::string("..\\secret.png")}) {
    INFO(name);
    const ProgramRun picture = draw(kModel, "newmtl m\nmap_Kd " + name + "\n");
    CHECK(sentence_of(picture, name) == usual);
    CHECK_FALSE(is_red(picture));
    const ProgramRun opacity = draw(kModel, "newmtl m\nmap_d " + name + "\n");
    CHECK(sentence_of(opacity, name) == usual);
    const ProgramRun library = draw("mtllib " + name + "\n" + kModel, "newmtl m\n");
    CHECK(has(library.errors, "m.obj:1: material library \"" + name + "\" not found in the model's folder"));
  }
  CHECK(is_red(draw(kModel, "newmtl m\nmap_Kd ../secret.png\n", {"--allow-any-path"})));
  CHECK(is_red(draw(kModel, "newmtl m\nmap_Kd out.png\n", {"--allow-any-path"})));
  for (const char* name : {"/proc/self/environ", "/dev/zero", "pipe.png", "zero.png"}) {
    INFO(name);
    const ProgramRun run = draw(kModel, std::string("newmtl m\nmap_Kd ") + name + "\n", {"--allow-any-path"});
    CHECK(has(run.errors, "\" not found\n"));
  }
}

TEST_CASE("untrusted models: limits", "[models][untrusted]") {
  const std::string mtl = "newmtl m\n";
  CHECK(draw(kModel, mtl, {"--max-triangles", "2"}).exit_code == 0);
  const ProgramRun triangles = draw(kModel, mtl, {"--max-triangles", "1"});
  CHECK(triangles.exit_code == 3);
  CHECK(has(triangles.errors, "m.obj: about 2 triangles, more than --max-triangles allows"));

  const std::string large = kModel + "#" + std::string(1 << 20, '-') + "\n";
  CHECK(draw(large, mtl, {"--max-input", "2"}).exit_code == 0);
  const ProgramRun input = draw(large, mtl, {"--max-input", "1"});
  CHECK(input.exit_code == 3);
  CHECK(has(input.errors, "m.obj: more than 1 MiB; --max-input MIB allows more"));
  const ProgramRun piped = run_softgl({"-", "-o", "-", "--max-input", "1"}, large);
  CHECK(piped.exit_code == 3);
  CHECK(has(piped.errors, "standard input: more than 1 MiB"));
  CHECK(run_softgl({"info", "-", "--max-input", "1"}, large).exit_code == 3);

  const ProgramRun size = draw(kModel, mtl, {"--max-size", "19"});
  CHECK(size.exit_code == 2);
  CHECK(has(size.errors, "--size asks for more pixels a side than --max-size 19 allows"));

  std::string vertices = kModel;
  for (int i = 0; i < 2000000; ++i) vertices += "v 0 0 0\n";
#ifndef SOFTGL_ADDRESS_SANITIZER // whose own memory is more
  CHECK(draw(kModel, mtl, {"--max-memory", "200", "--threads", "1"}).exit_code == 0);
  const ProgramRun memory = draw(vertices, mtl, {"--max-memory", "40", "--threads", "1"});
  CHECK(memory.exit_code == 3);
  CHECK(has(memory.errors, "not enough memory"));
#endif
}

TEST_CASE("untrusted models: the time is limited", "[models][untrusted]") {
  const std::string pipe = folder() + "never.obj";
  ::mkfifo(pipe.c_str(), 0600);
  const int held = ::open(pipe.c_str(), O_RDWR); // so that reading waits
  ProgramRun run;
  const double seconds = seconds_of([&] {
    run = run_softgl({pipe, "-o", folder() + "x.png", "--timeout", "0.2"});
  });
  ::close(held);
  CHECK(run.exit_code == 3);
  CHECK(run.errors == "softgl: error: not finished after 0.2 s (--timeout)\n");
  CHECK(seconds < 5);
  CHECK(draw(kModel, "newmtl m\n", {"--timeout", "60"}).exit_code == 0);
}

TEST_CASE("untrusted models: a stream without end", "[models][untrusted]") {
  const ProgramRun run = run_softgl({"/dev/zero", "-o", "-", "--max-input", "4"});
  CHECK(run.exit_code == 3);
  CHECK(has(run.errors, "/dev/zero: more than 4 MiB"));
}
