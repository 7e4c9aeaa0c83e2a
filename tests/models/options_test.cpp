// Every option by what it does: option_tests.tsv names a case for each, and what no other file tests is here.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sys/stat.h>
#include <unistd.h>

#include "models/command_line.h"
#include "models/picture_files.h"
#include "models/program_runner.h"
#include "test_paths.h"

using namespace softgl::test;
using softgl::cli::CommandRow;
using softgl::cli::OptionRow;
namespace fs = std::filesystem;

namespace {

std::string folder() { return output_folder("options"); }

std::string write(const std::string& name, const std::string& text) {
  std::ofstream(folder() + name, std::ios::binary) << text;
  return folder() + name;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A wedge, no two of whose sides look alike.
std::string wedge() {
  return write("wedge.obj", "v -1 0 -1\nv 1.5 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 0.5 2 0\n"
                            "f 1 2 3 4\nf 1 5 6 2\nf 2 6 3\nf 3 6 5 4\nf 4 5 1\n");
}

// Two faces that meet at 90 degrees.
std::string roof() {
  return write("roof.obj",
               "v -1 0 1\nv 1 0 1\nv 1 1 0\nv -1 1 0\nv -1 0 -1\nv 1 0 -1\nf 1 2 3 4\nf 4 3 6 5\n");
}

// A model with something to warn of in line 5.
std::string faulty() { return write("faulty.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"); }

TestPicture draw(const std::string& model, std::vector<std::string> options) {
  options.insert(options.begin(), {model, "-o", "-", "--format", "ppm", "--size", "60x60", "--up", "+Y"});
  const ProgramRun run = run_softgl(options);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return parse_ppm(run.output);
}

int width_of(const TestPicture& picture) { return picture.drawn().right - picture.drawn().left; }

// Cases of tests/*/*_test.cpp: the code of each, without comments.
std::map<std::string, std::string> read_cases() {
  std::map<std::string, std::string> cases;
  const std::string mark = "\nTEST_CASE(\"";
  for (const auto& entry : fs::recursive_directory_iterator(SOFTGL_TEST_SOURCE_DIR "/tests")) {
    if (!entry.path().string().ends_with("_test.cpp")) continue;
    const std::string text =
        std::regex_replace(read_bytes(entry.path().string()), std::regex("(^|\\n)\\s*//[^\\n]*"), "$1");
    for (size_t at = text.find(mark); at != std::string::npos;) {
      const size_t name = at + mark.size(), next = text.find(mark, name);
      cases[text.substr(name, text.find('"', name) - name)] = text.substr(at, next - at);
      at = next;
    }
  }
  return cases;
}

struct Row {
  std::string option, test_case;
};

std::vector<Row> read_rows() {
  std::vector<Row> rows;
  for (const std::string& line :
       text_lines(read_bytes(SOFTGL_TEST_SOURCE_DIR "/tests/models/option_tests.tsv"))) {
    if (line.empty() || line[0] == '#') continue;
    const size_t tab = line.find('\t');
    REQUIRE(tab != std::string::npos);
    rows.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return rows;
}

// Why a row is wrong; empty if it is right.
std::string fault_of(const Row& row, const CommandRow& command, const OptionRow& option,
                     const std::map<std::string, std::string>& cases) {
  const auto found = cases.find(row.test_case);
  if (found == cases.end()) return "there is no such case";
  const std::string& code = found->second;
  const auto named = [&](const std::string& name) { return has(code, "\"" + name + "\""); };
  if (std::none_of(option.names.begin(), option.names.end(), named))
    return "the case does not use the option";
  if (!has(code, "CHECK") && !has(code, "REQUIRE")) return "the case checks nothing";
  const std::string& word = command.word;
  if (!word.empty() && main_name(option) != "--help" && !has(code, "\"" + word + "\"") &&
      !has(code, word + "({"))
    return "the case does not use the command";
  return {};
}

} // namespace

TEST_CASE("options: each has a case that tests it", "[models][program]") {
  const auto cases = read_cases();
  const std::vector<Row> rows = read_rows();
  size_t known = 0;
  for (const CommandRow& command : all_commands())
    for (const OptionRow& option : command.options) {
      const std::string name = words_of(command) + " " + main_name(option);
      size_t count = 0;
      for (const Row& row : rows)
        if (row.option == name) {
          CAPTURE(row.option, row.test_case);
          CHECK(fault_of(row, command, option, cases) == "");
          ++count;
        }
      CAPTURE(name);
      CHECK(count > 0);
      known += count;
    }
  CHECK(known == rows.size()); // no row of an option that is gone

  // What the table cannot say.
  const CommandRow program = softgl::cli::describe_command_line();
  OptionRow option;
  option.names = {"--stats"};
  const std::string tested = "batch: statistics of each model";
  CHECK(fault_of({"softgl --stats", tested}, program, option, cases) == "");
  CHECK(fault_of({"softgl --stats", "no case"}, program, option, cases) == "there is no such case");
  option.names = {"--fps"};
  CHECK(fault_of({"softgl --fps", tested}, program, option, cases) == "the case does not use the option");
  option.names = {"--tolerance"};
  CHECK(fault_of({"softgl info --tolerance", "compare: what may differ"}, program.commands.at(0), option,
                 cases) == "the case does not use the command");
}

TEST_CASE("options: all names of an option do the same", "[models][program]") {
  // Values with which each shows.
  const std::map<std::string, std::vector<std::string>> kValues = {
      {"--output", {"-"}},        {"--size", {"40x30"}},    {"--fov", {"90"}}, {"--eye", {"1,2,9"}},
      {"--target", {"0,0,0"}},    {"--view-up", {"1,0,0"}}, {"--bg", {"red"}}, {"--color", {"lime"}},
      {"--line-color", {"blue"}}, {"--quiet", {}},          {"--verbose", {}}, {"--help", {}}};
  for (const OptionRow& option : softgl::cli::describe_command_line().options) {
    if (option.names.size() == 1) continue;
    CAPTURE(option.names);
    REQUIRE(kValues.count(main_name(option)) == 1);
    const auto run = [&](const std::string& name) {
      std::vector<std::string> arguments = {faulty(), "--format", "ppm", "--edges", "all"};
      if (main_name(option) != "--output") arguments.insert(arguments.end(), {"-o", "-"});
      if (main_name(option) != "--size") arguments.insert(arguments.end(), {"-s", "20x20"});
      if (main_name(option) == "--target" || main_name(option) == "--view-up")
        arguments.insert(arguments.end(), {"--eye", "3,2,9"});
      if (!name.empty()) arguments.push_back(name);
      for (const std::string& value : kValues.at(main_name(option)))
        if (!name.empty()) arguments.push_back(value);
      const ProgramRun result = run_softgl(arguments);
      return std::pair(result.output, result.errors);
    };
    const auto first = run(option.names.front());
    for (const std::string& name : option.names) CHECK(run(name) == first);
    CHECK(run("") != first);
  }
}

TEST_CASE("options: the effort for a PNG file changes its size, not its pixels", "[models][program]") {
  std::map<std::string, std::string> bytes;
  for (const char* effort : {"fast", "default", "small"}) {
    const ProgramRun run =
        run_softgl({wedge(), "-o", "-", "--size", "200x200", "--aa", "4", "--png", effort});
    REQUIRE(run.exit_code == 0);
    bytes[effort] = run.output;
  }
  CHECK(bytes["fast"].size() > bytes["small"].size());
  CHECK(bytes["default"].size() >= bytes["small"].size());
  CHECK(bytes["default"] != bytes["fast"]);
  for (const char* effort : {"default", "small"})
    CHECK(decode_picture(bytes[effort]).rgb == decode_picture(bytes["fast"]).rgb);
}

TEST_CASE("options: the format of a picture whose name says none", "[models][program]") {
  const auto begins = [](const std::vector<std::string>& more, const std::string& start) {
    std::vector<std::string> arguments = {wedge(), "-o", "-", "-s", "9x9"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_softgl(arguments).output.rfind(start, 0) == 0;
  };
  CHECK(begins({}, "\x89PNG"));
  CHECK(begins({"--format", "pam"}, "P7\n"));
  CHECK(begins({"--format", "bmp"}, "BM"));
  CHECK(begins({"--format", "pfm"}, "PF\n9 9\n"));
  CHECK(run_softgl({wedge(), "-o", "-", "-s", "9x9", "--format", "raw"}).output.size() == 9 * 9 * 3);
}

TEST_CASE("options: an edge is smooth up to the crease angle", "[models][program]") {
  const std::vector<std::string> view = {"--view", "front", "--el", "45", "--ks", "0"};
  const auto colors = [&](const char* angle) {
    std::vector<std::string> options = view;
    options.insert(options.end(), {"--crease", angle});
    return draw(roof(), options).colors();
  };
  CHECK(colors("80") <= 3);  // a color for each face, and the background
  CHECK(colors("100") > 10); // from one to the other
}

TEST_CASE("options: angles turn the camera, and zoom the picture", "[models][program]") {
  CHECK(draw(wedge(), {"--view", "front", "--az", "90"}).rgb == draw(wedge(), {"--view", "right"}).rgb);
  CHECK(draw(wedge(), {"--az", "180", "--el", "0"}).rgb == draw(wedge(), {"--view", "back"}).rgb);
  CHECK(draw(wedge(), {"--view", "front", "--el", "90"}).rgb == draw(wedge(), {"--view", "top"}).rgb);
  const TestPicture plain = draw(wedge(), {"--pass", "coverage"});
  TestPicture turned = draw(wedge(), {"--pass", "coverage", "--roll", "180"});
  size_t different = 0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) different += plain.at(x, y)[0] != turned.at(59 - x, 59 - y)[0];
  CHECK(different < 60); // pixels that an edge only touches
  const TestPicture half = draw(wedge(), {"--zoom", "0.5"});
  CHECK(std::abs(2 * width_of(half) - width_of(plain)) <= 3);
  // Without perspective the wide near side hides nothing more: the sizes of near and far are the same.
  const std::string corridor = write(
      "corridor.obj", "v -1 -1 5\nv 1 -1 5\nv 0 1 5\nf 1 2 3\nv -1 -1 -5\nv 1 -1 -5\nv 0 1 -5\nf 4 5 6\n"
                      "v 3 -1 -5\nv 5 -1 -5\nv 4 1 -5\nf 7 8 9\n");
  const auto span = [](const TestPicture& picture, int from, int to) {
    int count = 0;
    for (int x = from; x < to; ++x)
      count += picture.at(x, picture.drawn().bottom - 1)[0] != picture.at(0, 0)[0];
    return count;
  };
  const TestPicture parallel = draw(corridor, {"--view", "front", "--ortho"});
  CHECK(std::abs(span(parallel, 0, 30) - span(parallel, 31, 60)) <= 1);
  const TestPicture wide = draw(corridor, {"--view", "front", "--fov", "60"});
  CHECK(width_of(wide) > 0);
  CHECK(wide.rgb != parallel.rgb);
  // Z up is the model, turned.
  const std::string lying =
      write("lying.obj", "v -1 1 0\nv 1.5 1 0\nv 1 -1 0\nv -1 -1 0\nv -1 1 1\nv 0.5 0 2\n"
                         "f 1 2 3 4\nf 1 5 6 2\nf 2 6 3\nf 3 6 5 4\nf 4 5 1\n");
  CHECK(parse_ppm(run_softgl({lying, "-o", "-", "--format", "ppm", "--size", "60x60", "--up", "+Z"}).output)
            .rgb == draw(wedge(), {}).rgb);
}

TEST_CASE("options: one color for the whole model", "[models][program]") {
  write("color.mtl", "newmtl own\nKd 0 0 1\nKe .2 .2 .2\n");
  const std::string model =
      write("color.obj", "mtllib color.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                         "f 1 2 3 4\n");
  const TestPicture picture =
      draw(model, {"--view", "front", "--color", "#ff8040", "--terms", "ambient", "--ambient-light", "1"});
  const uint8_t* middle = picture.at(30, 30);
  CHECK(std::array<int, 3>{middle[0], middle[1], middle[2]} == std::array<int, 3>{0xff, 0x80, 0x40});
}

TEST_CASE("options: what is said about a model", "[models][program]") {
  const std::vector<std::string> drawing = {faulty(), "-o", folder() + "said.png", "-s", "9x9"};
  const auto errors = [&](std::vector<std::string> more) {
    more.insert(more.begin(), drawing.begin(), drawing.end());
    return run_softgl(more).errors;
  };
  CHECK(has(errors({}), "warning: "));
  CHECK_FALSE(has(errors({}), "note: "));
  CHECK(errors({"--quiet"}) == "");
  CHECK(has(errors({"--verbose"}), "note: "));
  CHECK(has(errors({"--verbose"}), "faulty.obj: 1 triangles from 1 faces, 3 vertices"));
}

TEST_CASE("options: info takes those of the models", "[models][program]") {
  const auto info = [](std::vector<std::string> options) {
    options.insert(options.begin(), "info");
    return run_softgl(options);
  };
  CHECK(info({faulty()}).exit_code == 0);
  CHECK(has(info({faulty()}).errors, "faulty.obj:5"));
  CHECK(info({faulty(), "--quiet"}).errors == "");
  CHECK(info({faulty(), "--strict"}).exit_code == 3);
  write("noted.mtl", "newmtl own\nKd 1 1 1\nmap_Bump bumps.png\n");
  const std::string noted =
      write("noted.obj", "mtllib noted.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK_FALSE(has(info({noted}).errors, "note: "));
  CHECK(has(info({noted, "--verbose"}).errors, "note: "));
  CHECK(info({noted, "--json", "--threads", "1"}).output == info({noted, "--json", "--threads", "2"}).output);
  // A library in another folder is not read, unless it may be.
  fs::create_directories(folder() + "inner");
  write("outer.mtl", "newmtl own\n");
  const std::string inner =
      write("inner/inner.obj", "mtllib ../outer.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(has(info({inner, "--json"}).output, "\"materials\": 0"));
  CHECK(has(info({inner, "--json", "--allow-any-path"}).output, "\"materials\": 1"));
  REQUIRE(run_softgl({faulty(), "-q", "-o", folder() + "black.png", "-s", "9x9"}).exit_code == 0);
  write("black.mtl", "newmtl own\nKd 0 0 0\nmap_Kd black.png\n");
  const std::string black =
      write("black.obj", "mtllib black.mtl\nusemtl own\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(has(info({black, "--verbose"}).errors, "drawn as Kd 1 1 1"));
  CHECK_FALSE(has(info({black, "--verbose", "--strict-mtl"}).errors, "drawn as Kd 1 1 1"));
}

TEST_CASE("options: info takes the limits of models of unknown origin", "[models][program]") {
  const auto info = [](std::vector<std::string> options) {
    options.insert(options.begin(), "info");
    return run_softgl(options);
  };
  CHECK(info({roof(), "--max-triangles", "4", "--max-input", "1", "--timeout", "60"}).exit_code == 0);
  CHECK(has(info({roof(), "--max-triangles", "3"}).errors, "more than --max-triangles allows"));
  const std::string large = write("large.obj", read_bytes(roof()) + "#" + std::string(1 << 20, '-') + "\n");
  CHECK(has(info({large, "--max-input", "1"}).errors, "more than 1 MiB"));
  std::string vertices = "v 0 0 0\n";
  for (int i = 0; i < 18; ++i) vertices += vertices;
  const std::string many = write("many.obj", read_bytes(roof()) + vertices);
#ifndef SOFTGL_ADDRESS_SANITIZER // whose own memory is more
  CHECK(info({roof(), "--max-memory", "200", "--threads", "1"}).exit_code == 0);
  CHECK(has(info({many, "--max-memory", "8", "--threads", "1"}).errors, "not enough memory"));
#endif
  const std::string pipe = folder() + "never.obj";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int held = ::open(pipe.c_str(), O_RDWR); // so that reading waits
  const ProgramRun waiting = info({pipe, "--timeout", "0.1"});
  ::close(held);
  CHECK(waiting.exit_code == 3);
  CHECK(waiting.errors == "softgl: error: not finished after 0.1 s (--timeout)\n");
}
