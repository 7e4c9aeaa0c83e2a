// Several models, views and frames in one run.
#include <catch2/catch.hpp>

#include "common/parallel.h"
#include "common/progress.h"
#include "models/picture_files.h"
#include "models/program_runner.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>

using namespace softgl::test;
namespace fs = std::filesystem;

namespace {

// A red and a blue box, one on the other.
const std::string kBoxes =
    "mtllib boxes.mtl\n"
    "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\n"
    "v -.5 1 -.5\nv .5 1 -.5\nv .5 1 .5\nv -.5 1 .5\nv -.5 2 -.5\nv .5 2 -.5\nv .5 2 .5\nv -.5 2 .5\n"
    "usemtl red\nf 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
    "usemtl blue\nf 9 10 11 12\nf 13 16 15 14\nf 9 13 14 10\nf 10 14 15 11\nf 11 15 16 12\nf 12 16 13 9\n";

std::string folder() { return output_folder("batch"); }

std::string write(const std::string& name, const std::string& text) {
  return write_bytes(folder() + name, text);
}

std::string boxes(const std::string& name = "boxes.obj") {
  write((fs::path(name).parent_path() / "boxes.mtl").string(),
        "newmtl red\nKd .8 .1 .1\nnewmtl blue\nKd .1 .1 .8\n");
  return write(name, kBoxes);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ProgramRun run(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--size", "48x36", "--up", "+Y"});
  return run_softgl(arguments);
}

// The picture of one view by itself.
TestPicture alone(const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {boxes(), "-o", "-", "--format", "ppm"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return parse_ppm(run(arguments).output);
}

size_t files_in(const std::string& path) {
  return size_t(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
}

} // namespace

TEST_CASE("batch: several views of several models have names of their own", "[models][batch]") {
  const std::string a = boxes("named/a.obj"), b = boxes("named/b.v2.obj");
  const ProgramRun both = run({a, b, "-o", folder() + "views/{model}-{view}.ppm", "--view", "front,top,iso"});
  CHECK(both.exit_code == 0);
  CHECK(both.errors.empty());
  CHECK(files_in(folder() + "views") == 6);
  for (const char* view : {"front", "top", "iso"})
    for (const char* model : {"a", "b.v2"}) {
      const std::string name = folder() + "views/" + model + "-" + view + ".ppm";
      CHECK(read_ppm(name).rgb == alone({"--view", view}).rgb);
    }
  CHECK(run({folder() + "named", "-o", "{dir}/{n}.ppm"}).exit_code == 0);
  CHECK(read_ppm(folder() + "named/002.ppm").rgb == alone({}).rgb);
}

TEST_CASE("batch: two pictures of one name are an error before drawing", "[models][batch]") {
  const std::string a = boxes("same/a.obj"), b = boxes("same/b.obj");
  const std::vector<std::vector<std::string>> cases = {
      {a, b, "-o", folder() + "one.png"},
      {a, "-o", folder() + "one.png", "--view", "front,left"},
      {a, "-o", folder() + "one.png", "--turntable", "3"},
      {a, b, "-o", folder() + "one.gif", "--turntable", "3"},
      {a, b, "-o", folder() + "one.png", "--sheet", "1x1"},
      {a, b, "-o", folder() + "./x/../one{view}.png"}};
  for (const auto& arguments : cases) {
    const ProgramRun same = run(arguments);
    CHECK(same.exit_code == 2);
    CHECK(has(same.errors, "would be two pictures"));
  }
  CHECK_FALSE(fs::exists(folder() + "one.png"));
  CHECK(has(run({a, "-o", folder() + "{name}.png"}).errors,
            "can have {dir}, {frame}, {model}, {n}, {pass}, {view}"));
  CHECK(run({a, "-o", folder() + "x.gif", "--sheet", "2"}).exit_code == 2);
  CHECK(run({a, "-o", folder() + "x.png", "--sheet", "0x2"}).exit_code == 2);
  CHECK(run({a, "-o", folder() + "x.png", "--view", "front,,left"}).exit_code == 2);
}

TEST_CASE("batch: a folder goes on over a bad file, or stops", "[models][batch]") {
  boxes("mixed/a.obj");
  write("mixed/b.obj", "These are words.\n");
  boxes("mixed/c.obj");
  write("mixed/notes.txt", "no model");
  const std::string models = folder() + "mixed";
  const ProgramRun going = run({models, "-o", folder() + "going/{model}.png", "--keep-going"});
  CHECK(going.exit_code == 3);
  CHECK(has(going.errors, "b.obj: no geometry"));
  CHECK(has(going.errors, "softgl: 1 of 3 models failed\n"));
  CHECK(files_in(folder() + "going") == 2);
  const ProgramRun stopped = run({models, "-o", folder() + "stopped/{model}.png", "--threads", "1"});
  CHECK(stopped.exit_code == 3);
  CHECK(files_in(folder() + "stopped") == 1);
  const ProgramRun sheet = run({models, "-o", folder() + "mixed.ppm", "--keep-going", "--sheet", "3"});
  CHECK(sheet.exit_code == 3);
  CHECK(read_ppm(folder() + "mixed.ppm").at(12 + 48 + 12 + 5, 20)[0] == 230); // the one that failed
  fs::create_directories(folder() + "empty");
  CHECK(
      has(run({folder() + "empty", "-o", "{model}.png"}).errors, "no OBJ, PLY or STL files in this folder"));
}

TEST_CASE("batch: folders within folders", "[models][batch]") {
  boxes("tree/b.obj");
  boxes("tree/inner/a.obj");
  boxes("tree/inner/deep/b.obj");
  const std::string tree = folder() + "tree";
  CHECK(run({tree, "-o", folder() + "flat/{model}.png"}).exit_code == 0);
  CHECK(files_in(folder() + "flat") == 1);
  const ProgramRun same = run({tree, "-o", folder() + "same/{model}.png", "--recursive"});
  CHECK(same.exit_code == 2); // two of one name
  CHECK(has(same.errors, "would be two pictures"));
  CHECK(run({tree, "-o", "{dir}/{model}.ppm", "--recursive"}).exit_code == 0);
  CHECK(read_ppm(tree + "/inner/deep/b.ppm").rgb == read_ppm(tree + "/b.ppm").rgb);
  CHECK(read_ppm(tree + "/inner/a.ppm").colors() > 2);
}

TEST_CASE("batch: what exists is skipped", "[models][batch]") {
  const std::string a = boxes("skip/a.obj"), b = write("skip/b.obj", "words\n");
  write("skip/b.png", "kept");
  const ProgramRun skipped = run({folder() + "skip", "-o", "{dir}/{model}.png", "--skip-existing"});
  CHECK(skipped.exit_code == 0); // b is not even read
  CHECK(read_bytes(folder() + "skip/b.png") == "kept");
  CHECK(decode_picture(read_bytes(folder() + "skip/a.png")).rgb == alone({}).rgb);
}

TEST_CASE("batch: a sheet holds the pictures, with labels", "[models][batch]") {
  const std::string path = folder() + "sheet.ppm";
  CHECK(run({boxes(), "-o", path, "--view", "front,left,top", "--sheet", "2x2"}).exit_code == 0);
  const TestPicture sheet = read_ppm(path), top = alone({"--view", "top"});
  REQUIRE(sheet.width == 12 + 2 * (48 + 12));
  const int second_row = 12 + 36 + (sheet.height - 12) / 2 - 36;
  for (int y = 0; y < 36; y += 5)
    for (int x = 0; x < 48; x += 5)
      CHECK(std::equal(top.at(x, y), top.at(x, y) + 3, sheet.at(12 + x, second_row + y)));
  bool label = false;
  for (int x = 12; x < 60; ++x) label |= sheet.at(x, 12 + 36 + 8)[0] < 128;
  CHECK(label);
  CHECK(run({boxes(), "-o", folder() + "p{page}.ppm", "--view", "front,left,top", "--sheet", "2x1"})
            .exit_code == 0);
  CHECK(read_ppm(folder() + "p002.ppm").width == 12 + 48 + 12);
}

TEST_CASE("batch: the frames of a turntable", "[models][batch]") {
  const std::string model = boxes();
  CHECK(run({model, "-o", folder() + "turn/{frame}.ppm", "--turntable", "8"}).exit_code == 0);
  std::vector<TestPicture> frames;
  for (int i = 1; i <= 8; ++i) frames.push_back(read_ppm(folder() + "turn/00" + std::to_string(i) + ".ppm"));
  // The boxes are the same after a quarter, and the camera stays at its distance and height.
  const auto box = [&](size_t i) { return frames[i].drawn(); };
  for (size_t i = 0; i < 4; ++i) {
    CHECK(box(i).left == box(i + 4).left);
    CHECK(box(i).bottom == box(i + 4).bottom);
    CHECK(frames[i].rgb != frames[(i + 1) % 4].rgb);
  }
  int least = 1000;
  for (size_t i = 0; i < 8; ++i) {
    CHECK(box(i).top >= 0);
    least = std::min({least, box(i).left, box(i).top, 47 - box(i).right, 35 - box(i).bottom});
  }
  CHECK(least >= 0);
  CHECK(least <= 3); // it fills the picture
  const std::string gif = folder() + "turn.gif", apng = folder() + "turn.apng";
  CHECK(run({model, "-o", apng, "--turntable", "8"}).exit_code == 0);
  const std::vector<TestPicture> in_apng = decode_apng(read_bytes(apng));
  REQUIRE(in_apng.size() == 8);
  for (size_t i = 0; i < 8; ++i) CHECK(in_apng[i].rgb == frames[i].rgb);
  const std::string control = png_chunks(read_bytes(apng), "fcTL").at(1);
  CHECK(control.substr(20, 4) == std::string("\0\1\0\31", 4)); // a twenty-fifth of a second
  const ProgramRun gif_run = run({model, "-o", gif, "--turntable", "8", "--fps", "50"});
  if (has(gif_run.errors, "without giflib")) return;
  CHECK(gif_run.exit_code == 0);
  const std::vector<TestPicture> in_gif = decode_gif(read_bytes(gif));
  REQUIRE(in_gif.size() == 8);
  for (size_t i = 0; i < 8; ++i) {
    double sum = 0;
    for (size_t k = 0; k < frames[i].rgb.size(); ++k) sum += std::abs(in_gif[i].rgb[k] - frames[i].rgb[k]);
    CHECK(sum / double(frames[i].rgb.size()) < 5);
  }
}

TEST_CASE("batch: the number of threads changes nothing", "[models][batch]") {
  const std::string a = boxes("threads/a.obj"), b = boxes("threads/b.obj");
  const auto with = [&](std::vector<std::string> arguments, const char* threads) {
    arguments.insert(arguments.end(), {"--threads", threads});
    return run(arguments).output;
  };
  const std::vector<std::vector<std::string>> cases = {
      {a, b, "-o", "-", "--format", "raw", "--turntable", "5"},
      {a, b, "-o", "-", "--format", "png", "--sheet", "2", "--view", "front,iso"},
      {a, "-o", "-", "--format", "apng", "--turntable", "5"}};
  for (const auto& arguments : cases) {
    const std::string one = with(arguments, "1");
    CHECK(one.size() > 100);
    CHECK(with(arguments, "2") == one);
    CHECK(with(arguments, "7") == one);
  }
  CHECK(with(cases[0], "1").size() == size_t(2 * 5 * 48 * 36 * 3));
}

TEST_CASE("batch: files are replaced at once, and links stay", "[models][batch]") {
  fs::create_directories(folder() + "link");
  write("link/real.ppm", "old");
  fs::create_symlink("real.ppm", folder() + "link/name.ppm");
  CHECK(run({boxes(), "-o", folder() + "link/name.ppm"}).exit_code == 0);
  CHECK(fs::is_symlink(folder() + "link/name.ppm"));
  CHECK(read_ppm(folder() + "link/real.ppm").rgb == alone({}).rgb);
  CHECK(files_in(folder() + "link") == 2);
}

TEST_CASE("batch: statistics of each model", "[models][batch]") {
  const std::string a = boxes("stats/a.obj"), b = boxes("stats/b.obj");
  const ProgramRun both = run({a, b, "-o", folder() + "stats/{model}.png", "--stats", "json"});
  CHECK(both.output.rfind("[\n{", 0) == 0);
  CHECK(has(both.output, "a.obj\""));
  CHECK(has(both.output, "b.obj\""));
}

TEST_CASE("batch: a progress bar for who waits at a terminal", "[models][batch]") {
  using softgl::cli::Progress;
  const auto shown = [](bool terminal, std::chrono::milliseconds delay) {
    const std::string path = folder() + "progress";
    std::FILE* file = std::fopen(path.c_str(), "w");
    {
      Progress progress(file, terminal, 4, delay);
      progress.step();
      progress.say("a line\n");
      for (int i = 0; i < 3; ++i) progress.step();
    }
    std::fclose(file);
    return read_bytes(path);
  };
  const std::string bar = shown(true, std::chrono::milliseconds(0));
  CHECK(has(bar, "\r[##########..............................] 1 of 4"));
  CHECK(has(bar, "\r\033[Ka line\n\r["));
  CHECK(bar.ends_with("\r\033[K"));
  CHECK(shown(true, std::chrono::seconds(1000)) == "a line\n");
  CHECK(shown(false, std::chrono::milliseconds(0)) == "a line\n");
}

TEST_CASE("batch: pieces of work, and the first that fails", "[models][batch]") {
  using softgl::cli::parallel_for;
  for (const unsigned threads : {1u, 3u}) {
    std::vector<int> times(1000);
    parallel_for(times.size(), threads, [&](size_t i, unsigned worker) { times[i] += worker < threads; });
    CHECK(times == std::vector<int>(1000, 1));
    std::atomic<size_t> done{0};
    const auto fail = [&](size_t i, unsigned) {
      if (i == 100 || i == 101 || i == 500) throw std::runtime_error(std::to_string(i));
      ++done;
    };
    CHECK_THROWS_WITH(parallel_for(1000, threads, fail), "100");
    CHECK(done >= 100);
  }
}
