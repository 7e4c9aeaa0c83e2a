// softgl view with a window: on SDL's dummy screen, which needs no X, and on a real one without a monitor.
#include <catch2/catch.hpp>

#include "models/picture_files.h"
#include "models/program_runner.h"
#include "test_paths.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

using namespace softgl::test;

namespace {

namespace fs = std::filesystem;

std::string folder() { return output_folder("view"); }

std::string write(const std::string& name, const std::string& text) {
  std::ofstream(folder() + name, std::ios::binary) << text;
  return folder() + name;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool is_built() {
  if (fs::exists(SOFTGL_TEST_BINARY_DIR "/softgl-view")) return true;
  WARN("SKIPPED: softgl-view was not built (libsdl2-dev)");
  return false;
}

std::string box(const char* material = "") {
  return std::string(material) +
         "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
         "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
}

ProgramRun play(const std::string& script, std::vector<std::string> options) {
  options.insert(options.begin(), "view");
  options.insert(options.end(), {"--script", write("script.txt", script)});
  return run_softgl(options, {}, {"SDL_VIDEODRIVER=dummy"});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TestPicture shot(const std::string& name) { return read_ppm(folder() + name); }

// Whole at any time, as editors do it.
void replace(const std::string& name, const std::string& text) {
  fs::rename(write(name + ".new", text), folder() + name);
}

// Until the file is there; what stands for a user who does something then.
void once_there(const std::string& path, const std::function<void()>& act) {
  for (int i = 0; i < 2000 && !fs::exists(path); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  act();
}

} // namespace

TEST_CASE("view: the printed command makes the picture that was saved", "[models][view]") {
  if (!is_built()) return;
  const std::string model = write("a box.obj", box()), f = folder();
  const ProgramRun run = play("save " + f +
                                  "0.png\n"
                                  "drag left 30 12\nkey p\nsave " +
                                  f +
                                  "1.png\n"
                                  "drag middle -9 4\nwheel 2\nkey v\nkey F2\nsave " +
                                  f +
                                  "2.png\n"
                                  "key o\ndrag light 20 5\nkey f\nkey b\nsave " +
                                  f +
                                  "3.png\n"
                                  "size 70x90\nkey e\nkey a\nsave " +
                                  f +
                                  "4.png\n"
                                  "key 3\nkey w\nkey x\nsave " +
                                  f + "5.png\n",
                              {model, "--size", "96x64", "--bg", "#102030", "--kd", "0.5,0.6,0.9"});
  INFO(run.output << run.errors);
  REQUIRE(run.exit_code == 0);
  const std::vector<std::string> commands = lines_of(run.output);
  REQUIRE(commands.size() == 6);
  std::vector<std::string> pictures;
  for (size_t i = 0; i < commands.size(); ++i) {
    const std::string file = f + std::to_string(i) + ".png", saved = read_bytes(file);
    REQUIRE(fs::remove(file));
    REQUIRE(std::system(("PATH=" SOFTGL_TEST_BINARY_DIR ":$PATH; " + commands[i]).c_str()) == 0);
    INFO(commands[i]);
    CHECK((read_bytes(file) == saved));
    CHECK(decode_picture(saved).colors() > 2);
    pictures.push_back(saved);
  }
  std::sort(pictures.begin(), pictures.end());
  CHECK(std::unique(pictures.begin(), pictures.end()) == pictures.end());
  CHECK(has(commands[0], "softgl '" + model + "' --size 96x64 "));
  CHECK(has(commands[0], " --bg '#102030' "));
}

TEST_CASE("view: the window shows the picture, help and messages", "[models][view]") {
  if (!is_built()) return;
  const std::string model = write("box.obj", box()), f = folder(), saved = f + "saved.ppm";
  const ProgramRun run =
      play("shot " + f + "plain.ppm\nkey h\nshot " + f + "help.ppm\nkey h\nsave\nshot " + f +
               "message.ppm\nkey 2\nsize 300x200\nshot " + f + "front.ppm\nkey q\nshot " + f + "never.ppm\n",
           {model, "--size", "640x480", "-o", saved});
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const TestPicture picture = read_ppm(saved), plain = shot("plain.ppm"), help = shot("help.ppm");
  CHECK((plain.rgb == picture.rgb));
  CHECK(plain.width == 640);
  CHECK((help.rgb != plain.rgb));
  CHECK(help.at(5, 5)[0] < 40);
  CHECK((shot("message.ppm").rgb != plain.rgb));
  CHECK(shot("front.ppm").width == 300);
  CHECK(shot("front.ppm").colors() < 8); // one side of the box
  CHECK(!fs::exists(f + "never.ppm"));
}

TEST_CASE("view: a changed file is read again, and a broken one leaves the picture", "[models][view]") {
  if (!is_built()) return;
  const std::string f = folder(), model = write("changed.obj", box("mtllib changed.mtl\nusemtl m\n"));
  write("changed.mtl", "newmtl m\nKd 1 0 0\n");
  std::thread user([&f] {
    once_there(f + "red.ppm", [] { replace("changed.mtl", "newmtl m\nKd 0 1 0\n"); });
    once_there(f + "green.ppm", [] { replace("changed.obj", "this is no model\n"); });
    once_there(f + "broken.ppm", [] { replace("changed.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"); });
  });
  const ProgramRun run =
      play("shot " + f + "red.ppm\nwait reload\nshot " + f + "green.ppm\nwait reload\ndrag left 20 0\nshot " +
               f + "broken.ppm\nwait reload\nkey r\nshot " + f + "triangle.ppm\n",
           {model, "--size", "320x240"});
  user.join();
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const TestPicture red = shot("red.ppm"), green = shot("green.ppm"), broken = shot("broken.ppm"),
                    triangle = shot("triangle.ppm");
  CHECK(red.at(160, 100)[0] > red.at(160, 100)[1] + 50);
  CHECK(green.at(160, 100)[1] > green.at(160, 100)[0] + 50);
  for (int x = 0; x < 320; x += 7)
    CHECK(std::equal(broken.at(x, 100), broken.at(x, 100) + 3, green.at(x, 100)));
  CHECK((broken.rgb != green.rgb)); // the message lies below
  CHECK(broken.at(3, 236)[0] < 40);
  CHECK(has(run.errors, "softgl: error: " + model));
  CHECK((triangle.rgb != broken.rgb));
  CHECK(std::equal(triangle.at(3, 236), triangle.at(3, 236) + 3, triangle.at(0, 0)));
}

TEST_CASE("view: several models, and those of folders", "[models][view]") {
  if (!is_built()) return;
  const std::string f = folder();
  fs::create_directories(f + "models");
  write("models/1.obj", box());
  write("models/2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("models/3.obj", "broken\n");
  const ProgramRun run = play("save " + f + "a.ppm\nkey PageDown\nsave " + f + "b.ppm\nkey PageDown\nsave " +
                                  f + "c.ppm\nkey PageUp\nsave " + f + "d.ppm\n",
                              {f + "models", "--size", "64x48"});
  REQUIRE(run.exit_code == 0);
  CHECK(lines_of(run.output).size() == 3);
  CHECK(read_bytes(f + "b.ppm") == read_bytes(f + "d.ppm"));
  CHECK(read_bytes(f + "a.ppm") != read_bytes(f + "b.ppm"));
  CHECK(!fs::exists(f + "c.ppm"));
  CHECK(has(run.errors, "3.obj"));
}

TEST_CASE("view: help, mistakes and what cannot be shown", "[models][view]") {
  // Where the window is not built.
  const std::string alone = folder() + "softgl", errors = folder() + "errors";
  fs::copy_file(SOFTGL_TEST_BINARY_DIR "/softgl", alone, fs::copy_options::overwrite_existing);
  CHECK(std::system(("PATH=/nowhere '" + alone + "' view a.obj 2> '" + errors + "'").c_str()) == 2 << 8);
  CHECK(read_bytes(errors) == "softgl: error: no window: softgl view MODEL starts softgl-view, which is "
                              "built where there is SDL 2\n");
  CHECK(std::system(("PATH=/nowhere '" + alone + "' view --help > '" + errors + "'").c_str()) == 0);
  CHECK(has(read_bytes(errors), "softgl view lantern.obj"));
  CHECK(has(run_softgl({"--help"}).output, "show models in a window"));
  CHECK(run_softgl({write("box.obj", box()), "view"}).exit_code == 2);
  if (!is_built()) return;
  const ProgramRun help = run_softgl({"view", "--help"});
  CHECK(help.exit_code == 0);
  const std::vector<std::string> lines = lines_of(help.output);
  CHECK(lines.size() <= 100);
  CHECK(std::count_if(lines.begin(), lines.end(),
                      [](const std::string& line) { return line.rfind("  softgl view ", 0) == 0; }) == 3);
  for (const char* part : {"PageDown", "left drag", "Phong", "--script", "Exit codes"})
    CHECK(has(help.output, part));
  const std::string model = folder() + "box.obj";
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{
           {}, {"-"}, {model, "--turntable", "4"}, {model, "-o", "{model}.png"}, {model, "--script"}}) {
    std::vector<std::string> words = {"view"};
    words.insert(words.end(), options.begin(), options.end());
    const ProgramRun run = run_softgl(words, {}, {"SDL_VIDEODRIVER=dummy"});
    INFO(run.errors);
    CHECK(run.exit_code == 2);
    CHECK(has(run.errors, "softgl: "));
  }
  CHECK(play("jump\n", {model}).exit_code == 2);
  CHECK(play("", {write("broken.obj", "nothing\n")}).exit_code == 3);
  CHECK(play("", {folder() + "absent.obj"}).exit_code == 3);
  const ProgramRun blind = run_softgl({"view", model}, {}, {"SDL_VIDEODRIVER=none"});
  CHECK(blind.exit_code == 4);
  CHECK(has(blind.errors, "no window"));
}

TEST_CASE("view: a screen of X shows the picture", "[models][view][clients]") {
  if (!is_built()) return;
  if (std::system("command -v Xvfb > /dev/null && command -v python3 > /dev/null") != 0) {
    WARN("SKIPPED: xvfb or python3 is not installed");
    return;
  }
  const std::string answer = folder() + "answer";
  const int code = std::system(("python3 '" SOFTGL_TEST_SOURCE_DIR "/tests/clients/view_window.py' "
                                "'" SOFTGL_TEST_BINARY_DIR "/softgl' '" +
                                write("box.obj", box()) + "' '" + folder() + "' > '" + answer + "' 2>&1")
                                   .c_str());
  INFO(read_bytes(answer));
  CHECK(code == 0);
  CHECK(has(read_bytes(answer), "the screen shows the picture"));
}
