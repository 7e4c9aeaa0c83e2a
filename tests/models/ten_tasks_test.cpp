// The commands of README's table "Ten tasks", as a reader would copy them, and what comes out.
#include <catch2/catch.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "models/command_line.h"
#include "models/picture_files.h"
#include "models/program_runner.h"
#include "test_paths.h"

using namespace softgl::test;
namespace fs = std::filesystem;

namespace {

// What the table calls a task, and its command.
std::map<std::string, std::string> read_tasks() {
  const std::string text = read_bytes(SOFTGL_TEST_SOURCE_DIR "/README.md");
  const size_t start = text.find("### Ten tasks\n");
  if (start == std::string::npos) return {};
  std::map<std::string, std::string> tasks;
  bool in_table = false;
  for (const std::string& line : text_lines(text.substr(start))) {
    if (line.empty() && in_table && !tasks.empty()) break;
    in_table = in_table || line.rfind("|---", 0) == 0;
    std::smatch parts;
    static const std::regex row("\\| ([^|]+) \\| `([^`]+)`.* \\|");
    if (in_table && std::regex_match(line, parts, row))
      tasks[parts[1]] = std::regex_replace(parts[2].str(), std::regex("\\\\\\|"), "|");
  }
  return tasks;
}

// A folder with what the commands name: the model that comes with softgl, some models, two folders of
// pictures, one of which differs, and a broken file.
class Workplace {
public:
  Workplace() : folder(output_folder("tasks")) {
    const fs::path models = SOFTGL_TEST_SOURCE_DIR "/reference/models";
    for (const char* name : {"lantern.obj", "lantern.mtl", "wood.png"})
      fs::copy_file(models / name, folder + name, fs::copy_options::overwrite_existing);
    fs::rename(folder + "lantern.obj", folder + "model.obj");
    const std::string cube =
        "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
        "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
    write("models/cube.obj", cube);
    write("models/empty.obj", "");
    write("models/tent.obj",
          "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 2 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    for (const char* name : {"expected", "actual"}) fs::create_directories(folder + name);
    for (const std::string name : {"expected/same", "actual/same", "expected/other", "actual/other"}) {
      const std::string color = name == "actual/other" ? "red" : "steelblue";
      REQUIRE(run_softgl(
                  {folder + "models/cube.obj", "-o", folder + name + ".png", "-s", "80x80", "--color", color})
                  .exit_code == 0);
    }
  }

  ShellRun run(const std::string& command) const {
    return run_shell("cd '" + folder + "' && PATH='" SOFTGL_TEST_BINARY_DIR "':$PATH && " + command);
  }
  std::string bytes(const std::string& name) const { return read_bytes(folder + name); }
  TestPicture picture(const std::string& name) const { return decode_picture(bytes(name)); }

  const std::string folder;

private:
  void write(const std::string& name, const std::string& text) const { write_bytes(folder + name, text); }
};

size_t different_pixels(const TestPicture& a, const TestPicture& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.rgb.size(); i += 3) count += !std::equal(&a.rgb[i], &a.rgb[i] + 3, &b.rgb[i]);
  return count;
}

void check_thumbnails(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 3); // of the empty model; the others are drawn
  CHECK_THAT(run.output, Catch::Contains("empty.obj: no geometry"));
  for (const char* name : {"thumbs/cube.png", "thumbs/tent.png"}) {
    const TestPicture picture = place.picture(name);
    CHECK((picture.width == 256 && picture.height == 256));
    CHECK(picture.drawn().bottom - picture.drawn().top > 200);
    CHECK(picture.colors() > 8); // edges of four samples
  }
  CHECK_FALSE(fs::exists(place.folder + "thumbs/empty.png"));
}

void check_transparent(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const TestPicture picture = place.picture("hero.png");
  CHECK((picture.width == 1600 && picture.height == 1200));
  const std::vector<uint8_t> alpha = decode_alpha(place.bytes("hero.png"));
  REQUIRE(alpha.size() == 1600 * 1200);
  for (const size_t corner : {size_t(0), size_t(1599), alpha.size() - 1600, alpha.size() - 1})
    CHECK(alpha[corner] == 0);
  CHECK(std::count(alpha.begin(), alpha.end(), 255) > 200000);
  CHECK(std::count_if(alpha.begin(), alpha.end(), [](uint8_t a) { return a > 0 && a < 255; }) > 1000);
}

void check_turntable(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const std::vector<TestPicture> frames = decode_gif(place.bytes("turn.gif"));
  REQUIRE(frames.size() == 24);
  CHECK((frames[0].width == 320 && frames[0].height == 320));
  for (size_t i = 1; i < frames.size(); ++i) CHECK(different_pixels(frames[0], frames[i]) > 1000);
}

void check_comparison(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 1);
  CHECK_THAT(run.output, Catch::Contains("other.png: different") && Catch::Contains("1 of 2 are the same"));
  CHECK_THAT(place.bytes("report.xml"), Catch::Contains("tests=\"2\" failures=\"1\" errors=\"0\""));
  CHECK(place.picture("diff/other.png").width == 80);
  CHECK_FALSE(fs::exists(place.folder + "diff/same.png"));
}

void check_depths(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const std::string header = png_chunks(place.bytes("depth.png"), "IHDR").at(0);
  CHECK(int(header[8]) == 16); // bits
  CHECK(int(header[9]) == 0);  // gray
  CHECK(place.picture("depth.png").colors() > 50);
}

void check_edges(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  REQUIRE(place.run("softgl model.obj -o plain.png").code == 0);
  const TestPicture edges = place.picture("edges.png"), plain = place.picture("plain.png");
  const size_t count = different_pixels(edges, plain);
  CHECK((count > 20000 && count < 600000)); // the surface is seen between the lines
}

void check_sheet(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const TestPicture sheet = place.picture("sheet.png");
  CHECK((sheet.width > 800 && sheet.width < 900 && sheet.height > 800 && sheet.height < 1000));
  // Four views, which differ.
  REQUIRE(place.run("softgl model.obj -o 'one-{view}.png' --view front,left,top,iso --size 400x400").code ==
          0);
  for (const auto& [name, right, low] : {std::tuple("front", false, false),
                                         {"left", true, false},
                                         {"top", false, true},
                                         {"iso", true, true}}) {
    const TestPicture one = place.picture(std::string("one-") + name + ".png");
    const int left_edge = right ? sheet.width / 2 : 0, top_edge = low ? sheet.height / 2 : 0;
    bool found = false;
    for (int y = top_edge; !found && y + 400 <= top_edge + sheet.height / 2; ++y)
      for (int x = left_edge; !found && x + 400 <= left_edge + sheet.width / 2; ++x) {
        found = true;
        for (int row = 0; found && row < 400; ++row)
          found = std::equal(one.at(0, row), one.at(0, row) + 1200, sheet.at(x, y + row));
      }
    CAPTURE(name);
    CHECK(found);
  }
}

void check_statistics(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const nlohmann::json stats = nlohmann::json::parse(run.output);
  CHECK(stats.at("triangles") > 1000);
  CHECK(stats.at("peak_kib") > 1000);
  CHECK(stats.at("milliseconds").at("total") > 0);
  CHECK(place.picture("picture.png").width == 1024);
}

void check_bad_file(const Workplace&, const ShellRun& run) {
  CHECK(run.code == 3);
  CHECK_THAT(run.output, Catch::Contains("broken.obj:5: a corner names a vertex that does not exist"));
}

void check_pipe(const Workplace& place, const ShellRun& run) {
  CHECK(run.code == 0);
  const TestPicture icon = place.picture("icon.png");
  CHECK(std::max(icon.width, icon.height) == 64);
  CHECK(icon.width < 64); // trimmed: the lantern is higher than wide
  const std::vector<uint8_t> alpha = decode_alpha(place.bytes("icon.png"));
  CHECK(std::count(alpha.begin(), alpha.end(), 0) > 100);
  CHECK(std::count(alpha.begin(), alpha.end(), 255) > 500);
}

constexpr const char* kPipe = "through ImageMagick";

struct Task {
  const char* name;
  void (*check)(const Workplace&, const ShellRun&);
};
constexpr Task kTasks[] = {{"thumbnails of a folder", check_thumbnails},
                           {"a picture with transparent background", check_transparent},
                           {"a turntable", check_turntable},
                           {"pictures compared in CI", check_comparison},
                           {"depths", check_depths},
                           {"edges over the surface", check_edges},
                           {"four views on a sheet", check_sheet},
                           {"what a run took, in JSON", check_statistics},
                           {"what a bad file is", check_bad_file}};

} // namespace

TEST_CASE("ten tasks: each is one command that does what it says", "[models][program]") {
  const std::map<std::string, std::string> tasks = read_tasks();
  REQUIRE(tasks.size() == 10);
  REQUIRE(std::size(kTasks) + 1 == tasks.size()); // and kPipe
  const Workplace place;
  for (const Task& task : kTasks) {
    const std::string& command = tasks.at(task.name);
    INFO(command);
    const ShellRun run = place.run(command);
    INFO(run.output);
    task.check(place, run);
  }
}

TEST_CASE("ten tasks: a picture goes through ImageMagick", "[models][program]") {
  if (run_shell("convert -version").output.rfind("Version: ImageMagick", 0) != 0) {
    WARN("SKIPPED: this needs ImageMagick's convert");
    return;
  }
  const Workplace place;
  const ShellRun run = place.run(read_tasks().at(kPipe));
  INFO(run.output);
  check_pipe(place, run);
}
