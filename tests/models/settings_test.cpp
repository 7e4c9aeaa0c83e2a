// Options from the environment and from files: which of them counts, and what is said about wrong ones.
#include <catch2/catch.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "models/program_runner.h"

using namespace softgl::test;

namespace {

std::string folder() { return output_folder("settings"); }

std::string write(const std::string& name, const std::string& text) {
  return write_bytes(folder() + name, text);
}

std::string model() { return write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"); }

ProgramRun run(std::vector<std::string> options, const std::vector<std::string>& environment = {}) {
  options.insert(options.begin(), {model(), "-o", "-", "--format", "ppm"});
  return run_softgl(options, {}, environment);
}

int width_of(const ProgramRun& run) {
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return parse_ppm(run.output).width;
}

} // namespace

TEST_CASE("settings: command line, environment, file, default", "[models][program]") {
  const std::string file = write("own/softgl/config", "# my size\n\n size = 30x30 \r\nbg = #ff0000\n");
  const std::string own = "XDG_CONFIG_HOME=" + folder() + "own", variable = "SOFTGL_OPT_SIZE=20x20";
  CHECK(width_of(run({})) == 1024);
  CHECK(width_of(run({}, {own})) == 30);
  CHECK(width_of(run({}, {own, variable})) == 20);
  CHECK(width_of(run({"--size", "10x10"}, {own, variable})) == 10);
  CHECK(parse_ppm(run({}, {own}).output).at(0, 0)[0] == 255); // what looks like a comment is a color
  const std::string other = write("other", "size = 40x40\n");
  CHECK(width_of(run({"--config", other}, {own})) == 40);
  CHECK(width_of(run({}, {own, "SOFTGL_OPT_CONFIG=" + other})) == 40);
  CHECK(width_of(run({"--config", file}, {"SOFTGL_OPT_CONFIG=" + other})) == 30);
  CHECK(width_of(run({"--config", "", "-s", "9x9"}, {own})) == 9);
  CHECK(width_of(run({"--config", ""}, {own})) == 1024);
  // Without XDG_CONFIG_HOME it is below the home folder.
  write("home/.config/softgl/config", "size = 50x50\n");
  CHECK(width_of(run({}, {"XDG_CONFIG_HOME=", "HOME=" + folder() + "home"})) == 50);
}

TEST_CASE("settings: flags, repeated options and parts for a command", "[models][program]") {
  const auto picture = [](const std::string& text, std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--config", write("config", "size = 40x40\n" + text)});
    const ProgramRun result = run(options);
    INFO(result.errors);
    REQUIRE(result.exit_code == 0);
    return result.output;
  };
  const auto plain = picture("");
  CHECK(picture("ortho\n") == picture("", {"--ortho"}));
  CHECK(picture("ortho\n") != plain);
  CHECK(picture("ortho = true\n") == picture("ortho\n"));
  CHECK(picture("ortho = false\n") == plain);
  CHECK(picture("ortho\n", {"--ortho=false"}) == plain);
  CHECK(picture("wireframe = false\n") == plain);
  CHECK(picture("wireframe = yes\n") == picture("", {"--wireframe"}));
  CHECK(picture("light = headlight\nlight = +Y/color:red\n") ==
        picture("", {"--light", "headlight", "--light", "+Y/color:red"}));
  CHECK(picture("light = headlight\n", {"--light", "+Y"}) == picture("", {"--light", "+Y"}));
  CHECK(picture("zoom = 0.1\nzoom = 0.5\n") == picture("", {"--zoom", "0.5"}));
  CHECK(picture("[compare]\ntolerance = 3\n") == plain);
  // An option is for each command that has it, a part for one.
  const std::string warned = write("warned.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
  const auto info = [&](const std::string& text) {
    return run_softgl({"info", warned, "--config", write("config", text)}).exit_code;
  };
  CHECK(info("strict\nsize = 9x9\n") == 3);
  CHECK(info("[info]\nstrict\n") == 3);
  CHECK(info("[compare]\nquiet\n[figure]\n") == 0);
  // The options of a figure are those of a picture.
  const ProgramRun figure =
      run_softgl({"figure", "-o", "-", "--format", "ppm", "--bg", "black"}, {},
                 {"SOFTGL_OPT_SIZE=20x20", "SOFTGL_OPT_CONFIG=" + write("config", "[figure]\nks = 0\n")});
  CHECK(width_of(figure) < 1000);
  const std::string red = folder() + "red.ppm", blue = folder() + "blue.ppm";
  REQUIRE(run_softgl({model(), "-o", red, "-s", "9x9", "--color", "#ff0000"}).exit_code == 0);
  REQUIRE(run_softgl({model(), "-o", blue, "-s", "9x9", "--color", "#e00000"}).exit_code == 0);
  CHECK(run_softgl({"compare", red, blue}).exit_code == 1);
  CHECK(run_softgl({"compare", red, blue, "--config", write("config", "[compare]\ntolerance = 40\n")})
            .exit_code == 0);
  CHECK(
      run_softgl({"compare", red, blue}, {}, {"SOFTGL_OPT_TOLERANCE=40", "SOFTGL_OPT_SIZE=9x9"}).exit_code ==
      0);
}

TEST_CASE("settings: a wrong one is one sentence with its place", "[models][program]") {
  const std::string path = folder() + "config";
  const struct {
    std::string text, sentence;
  } files[] = {{"size = 9x9\nszie = 9x9\n", path + ":2: there is no option --szie"},
               {"\n\nsize = wide\n", path + ":3: --size: \"wide\" is not a size"},
               {"aa = 3\n", path + ":1: --aa: 3 not in {1,4,16}"},
               {"light = headlight\nlight = dark\n", path + ":2: --light: \"dark\" is not a light"},
               {"--size = 9x9\n", path + ":1: a setting is NAME = VALUE"},
               {"two words\n", path + ":1: a setting is NAME = VALUE"},
               {"= 1\n", path + ":1: a setting is NAME = VALUE"},
               {"[compare\n", path + ":1: a part begins with [COMMAND]"},
               {"[draw]\n", path + ":1: there is no command \"draw\""},
               {"[compare]\nsize = 9x9\n", path + ":2: there is no option --size"},
               {"help\n", path + ":1: there is no option --help"},
               {"config = x\n", path + ":1: there is no option --config"},
               {"zoom = \n", path + ":1: --zoom: must be a number"},
               {"ortho = perhaps\n", path + ":1: "}};
  const auto check = [](const ProgramRun& result, const std::string& sentence) {
    CAPTURE(result.errors, sentence);
    CHECK(result.exit_code == 2);
    CHECK(result.output.empty());
    CHECK(result.errors.rfind("softgl: " + sentence, 0) == 0);
    CHECK(std::count(result.errors.begin(), result.errors.end(), '\n') == 1);
  };
  for (const auto& file : files) check(run({"--config", write("config", file.text)}), file.sentence);
  check(run({"--config", folder() + "absent"}), folder() + "absent: cannot open");
  check(run({"--config", folder() + "."}), folder() + ".: this is not a file");
  check(run({}, {"SOFTGL_OPT_SZIE=9x9"}), "SOFTGL_OPT_SZIE: there is no option --szie");
  check(run({}, {"SOFTGL_OPT_AA=3"}), "SOFTGL_OPT_AA: --aa: 3 not in {1,4,16}");
}

TEST_CASE("settings: every command says what it took", "[models][program]") {
  const std::string first = folder() + "first.png", second = folder() + "second.png";
  REQUIRE(run_softgl({model(), "-o", first, "-s", "30x30"}).exit_code == 0);
  REQUIRE(run_softgl({model(), "-o", second, "-s", "30x30", "--az", "0"}).exit_code == 0);
  const struct {
    std::vector<std::string> arguments;
    std::vector<const char*> stages;
    bool to_errors;
  } commands[] = {
      {{model(), "-o", first, "-s", "30x30"},
       {"read", "prepare", "upload", "draw", "resolve", "write"},
       false},
      {{model(), "-o", "-", "-s", "30x30"}, {"read", "prepare", "upload", "draw", "resolve", "write"}, true},
      {{"info", model()}, {"read", "prepare", "measure"}, true},
      {{"figure", "-o", folder() + "figure.png", "-s", "20x20"}, {"read", "prepare", "draw"}, false},
      {{"compare", first, second}, {"read", "compare", "write"}, true}};
  for (auto [arguments, stages, to_errors] : commands) {
    CAPTURE(arguments);
    const ProgramRun plain = run_softgl(arguments);
    arguments.insert(arguments.end(), {"--stats", "json"});
    const ProgramRun result = run_softgl(arguments);
    CHECK(result.exit_code == plain.exit_code);
    if (to_errors) CHECK(result.output == plain.output);
    const nlohmann::json stats = nlohmann::json::parse(to_errors ? result.errors : result.output);
    CHECK(stats.at("peak_kib") > 1000);
    CHECK(stats.at("milliseconds").at("cpu") > 0);
    CHECK(stats.at("milliseconds").at("total") > 0);
    CHECK(stats.at("milliseconds").size() == stages.size() + 2);
    for (const char* stage : stages) CHECK(stats.at("milliseconds").at(stage) >= 0);
  }
}
