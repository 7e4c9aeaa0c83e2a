// Lines, backgrounds, lights, ground, sRGB and the camera's place, each by its pixels.
#include <catch2/catch.hpp>

#include "models/picture_files.h"
#include "models/program_runner.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

using namespace softgl::test;

namespace {

std::string folder() { return output_folder("look"); }

std::string write(const std::string& name, const std::string& text) {
  std::ofstream(folder() + name, std::ios::binary) << text;
  return folder() + name;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Two squares side by side that form one plane.
std::string plane() {
  return write("plane.obj",
               "v -2 -1 0\nv 0 -1 0\nv 0 1 0\nv -2 1 0\nv 2 -1 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n");
}

std::string cube() {
  return write("cube.obj", "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\n"
                           "f 1 2 3 4\nf 5 8 7 6\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n");
}

TestPicture draw(const std::string& model, std::vector<std::string> options) {
  options.insert(options.begin(), model);
  options.insert(options.end(), {"-o", "-", "--format", "ppm", "--size", "82x42", "--up", "+Y"});
  const ProgramRun run = run_softgl(options);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return parse_ppm(run.output);
}

TestPicture front(const std::string& model, std::vector<std::string> options) {
  options.insert(options.end(), {"--view", "front", "--ortho"});
  return draw(model, options);
}

using Color = std::array<int, 3>;
Color at(const TestPicture& picture, int x, int y) {
  return {picture.at(x, y)[0], picture.at(x, y)[1], picture.at(x, y)[2]};
}

int count(const TestPicture& picture, const Color& color) {
  int found = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) found += at(picture, x, y) == color;
  return found;
}

const Color kRed = {255, 0, 0}, kWhite = {255, 255, 255};

} // namespace

TEST_CASE("look: edges are those of the file's faces, or the sharp ones", "[models][look]") {
  const TestPicture plain = front(plane(), {});
  const TestPicture all = front(plane(), {"--edges", "all", "--line-color", "red"});
  const TestPicture sharp = front(plane(), {"--edges", "sharp", "--line-color", "red"});
  CHECK(at(all, 21, 12) == at(plain, 21, 12)); // no diagonal, which the triangles have
  const auto red_in_middle = [](const TestPicture& picture) {
    int red = 0;
    for (int x = 38; x < 44; ++x) red += at(picture, x, 20) == kRed;
    return red;
  };
  CHECK(red_in_middle(all) >= 1);
  CHECK(red_in_middle(sharp) == 0);
  CHECK(count(sharp, kRed) > 150); // the border
  const TestPicture box = draw(cube(), {"--edges", "sharp", "--line-color", "red"});
  CHECK(count(box, kRed) > 60);
  CHECK(count(front(plane(), {"--edges", "all", "--line-color", "red", "--line-width", "4"}), kRed) >
        count(all, kRed) * 7 / 5);
}

TEST_CASE("look: the angle from which on an edge is sharp", "[models][look]") {
  // Three strips that rise by 0, 30 and 60 degrees.
  const std::string strips = write(
      "strips.obj", "v -2 -1 0\nv -2 1 0\nv -1 -1 0\nv -1 1 0\nv 0 -1 .5774\nv 0 1 .5774\nv 1 -1 2.3094\n"
                    "v 1 1 2.3094\nf 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\n");
  const auto red = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--line-color", "red", "--ks", "0"});
    return count(front(strips, options), kRed);
  };
  const int border = red({"--edges", "sharp"});
  CHECK(border > 100);
  CHECK(red({"--edge-angle", "40"}) == border);
  CHECK(red({"--edge-angle", "31"}) == border);
  CHECK(red({"--edges", "sharp", "--edge-angle", "29"}) > border + 60); // two more edges of 40 pixels
  CHECK(front(strips, {"--wireframe", "--edge-angle", "90"}).rgb != front(strips, {"--wireframe"}).rgb);
  CHECK(run_softgl({strips, "-o", folder() + "x.png", "--edges", "all", "--edge-angle", "9"}).exit_code == 2);
}

TEST_CASE("look: wireframe and points, with and without what is hidden", "[models][look]") {
  const TestPicture wire = front(cube(), {"--wireframe", "--line-color", "red", "--bg", "white"});
  CHECK(at(wire, 41, 21) == kWhite);
  CHECK(count(wire, kRed) > 80);
  CHECK(wire.colors() == 2);
  const TestPicture solid = draw(cube(), {"--wireframe", "--line-color", "red"}),
                    clear = draw(cube(), {"--wireframe", "--line-color", "red", "--hidden-lines"});
  CHECK(count(clear, kRed) > count(solid, kRed) + 20);
  const TestPicture points = draw(cube(), {"--points", "--line-color", "red", "--point-size", "3"}),
                    hidden = draw(cube(),
                                  {"--points", "--line-color", "red", "--point-size", "3", "--hidden-lines"});
  CHECK(count(points, kRed) > 6 * 9 - 12);
  CHECK(count(points, kRed) <= 7 * 9);
  CHECK(count(hidden, kRed) > 7 * 9 - 9);
  CHECK(at(front(plane(), {"--wireframe"}), 20, 12) == Color{0x2e, 0x33, 0x3a});
}

TEST_CASE("look: gradients and pictures behind the model", "[models][look]") {
  const std::string triangle = write("small.obj", "v 0 0 0\nv 1 0 0\nv 0.5 1 0\nf 1 2 3\n");
  const TestPicture gradient = front(triangle, {"--bg", "#ff0000:#0000ff"});
  CHECK(at(gradient, 0, 0)[0] > 245);
  CHECK(at(gradient, 0, 41)[2] > 245);
  CHECK(std::abs(at(gradient, 0, 21)[0] - 127) < 8);
  // Four colors in the corners, in a frame of the same shape.
  std::string ppm = "P6\n82 42\n255\n";
  for (int y = 0; y < 42; ++y)
    for (int x = 0; x < 82; ++x) ppm += std::string{char(x < 41 ? 200 : 10), char(y < 21 ? 150 : 20), 7};
  const TestPicture picture = front(triangle, {"--bg", "picture:" + write("back.ppm", ppm)});
  CHECK(at(picture, 5, 5) == Color{200, 150, 7});
  CHECK(at(picture, 78, 5) == Color{10, 150, 7});
  CHECK(at(picture, 5, 38) == Color{200, 20, 7});
  CHECK(at(picture, 41, 30) == at(gradient, 41, 30)); // the model
  CHECK(run_softgl({triangle, "-o", folder() + "x.png", "--bg", "picture:" + folder() + "absent.png"})
            .exit_code == 3);
  CHECK(run_softgl({triangle, "-o", folder() + "x.png", "--bg", "red:nocolor"}).exit_code == 2);
}

TEST_CASE("look: three-point light has a key, a fill and a rim", "[models][look]") {
  const std::vector<std::string> white = {"--kd", "1", "--ks", "0", "--ambient-light", "0"};
  std::vector<std::string> options = white;
  options.insert(options.end(), {"--light", "three-point", "--el", "20", "--az", "0"});
  const TestPicture box = draw(cube(), options);
  CHECK(at(box, 41, 25)[0] > 100); // the front has key and fill
  CHECK(at(box, 41, 9)[0] > 100);  // the top has key and rim
  CHECK(box.rgb != draw(cube(), {"--el", "20", "--az", "0"}).rgb);
  CHECK(run_softgl({cube(), "-o", "x.png", "--light", "three-point", "--light", "three-point", "--light",
                    "three-point"})
            .exit_code == 2);
}

TEST_CASE("look: a soft shadow on the ground", "[models][look]") {
  const std::vector<std::string> view = {"--bg", "white", "--az", "0", "--el", "20", "--zoom", "0.5"};
  std::vector<std::string> with = view;
  with.push_back("--ground");
  const TestPicture plain = draw(cube(), view), shadow = draw(cube(), with);
  const auto box = plain.drawn();
  const int beside = box.right + 1, foot = box.bottom - 1;
  CHECK(at(plain, beside, foot) == kWhite);
  CHECK(at(shadow, beside, foot)[0] < 250);
  CHECK(at(shadow, beside, foot)[0] > 90);
  CHECK(at(shadow, beside, foot)[0] == at(shadow, beside, foot)[1]);
  CHECK(at(shadow, 0, 0) == kWhite);
  for (int y = box.top; y < box.bottom - 3; ++y) // the model hides it
    CHECK(std::abs(at(shadow, 41, y)[0] - at(plain, 41, y)[0]) <= 1);
  with.insert(with.end(), {"--pass", "coverage"});
  std::vector<std::string> mask = view;
  mask.insert(mask.end(), {"--pass", "coverage"});
  CHECK(draw(cube(), with).rgb == draw(cube(), mask).rgb);
  CHECK(draw(cube(), {"--ground", "--el", "-30"}).rgb == draw(cube(), {"--el", "-30"}).rgb); // from below
}

TEST_CASE("look: light instead of stored values", "[models][look]") {
  // A plane that leans back by 60 degrees has half the light of the headlight.
  const std::string lean =
      write("lean.obj", "v -2 0 0\nv 2 0 0\nv 2 1 -1.7320508\nv -2 1 -1.7320508\nf 1 2 3 4\n");
  const std::vector<std::string> light = {
      "--kd", "1", "--ks", "0", "--ka", "0", "--light", "headlight/color:white", "--bg", "#808080"};
  std::vector<std::string> encoded = light;
  encoded.push_back("--srgb");
  CHECK(std::abs(at(front(lean, light), 41, 21)[0] - 128) <= 1);
  CHECK(std::abs(at(front(lean, encoded), 41, 21)[0] - 188) <= 1);
  CHECK(at(front(lean, encoded), 0, 0) == Color{128, 128, 128});
  // What has no light keeps its color.
  write("plain.mtl", "newmtl plain\nKd .5 .25 1\nillum 0\n");
  const std::string plain =
      write("unlit.obj", "mtllib plain.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl plain\nf 1 2 3 4\n");
  CHECK(at(front(plain, {"--srgb"}), 41, 21) == at(front(plain, {}), 41, 21));
}

TEST_CASE("look: the camera stands where it is told", "[models][look]") {
  const std::vector<std::string> place = {"--eye", "0,0,10", "--target", "0,0,0", "--fov", "30"};
  const TestPicture seen = draw(plane(), place);
  const auto box = seen.drawn();
  const double half = 21 / (10 * std::tan(15 * 3.14159265358979 / 180)); // pixels of a unit
  CHECK(std::abs(box.right - box.left + 1 - 4 * half) <= 1.5);
  CHECK(std::abs(box.bottom - box.top + 1 - 2 * half) <= 1.5);
  const ProgramRun f3d = run_softgl({plane(), "-o", "-", "--format", "ppm", "--camera-position", "0,0,10",
                                     "--camera-focal-point", "0,0,0", "--camera-view-angle", "30",
                                     "--camera-view-up", "0,1,0", "--resolution", "82,42", "--up", "+Y"});
  CHECK(parse_ppm(f3d.output).rgb == seen.rgb);
  const auto turned = draw(plane(), {"--eye", "0,0,10", "--view-up", "1,0,0"}).drawn();
  CHECK(turned.bottom - turned.top > turned.right - turned.left);
  const TestPicture above = draw(cube(), {"--eye", "0,20,0"}); // up is found where it is not given
  CHECK(above.drawn().left == 81 - above.drawn().right);
  const std::vector<std::vector<std::string>> mistakes = {
      {"--target", "0,0,0"},
      {"--eye", "1,2"},
      {"--eye", "0,0,5", "--turntable", "4"},
      {"--eye", "0,0,5", "--view", "front,left"},
      {"--eye", "0,0,5", "--target", "0,0,5"},
      {"--eye", "0,0,5", "--camera", "x.json"},
      {"--write-camera", "x.json", "--view", "front,left"}};
  for (std::vector<std::string> options : mistakes) {
    options.insert(options.begin(), {plane(), "-o", folder() + "x{view}{n}.png"});
    CHECK(run_softgl(options).exit_code == 2);
  }
}

TEST_CASE("look: a camera is written and read", "[models][look]") {
  const std::string file = folder() + "camera.json";
  const std::vector<std::vector<std::string>> views = {
      {"--az", "20"}, {"--ortho", "--view", "left"}, {"--zoom", "2", "--roll", "10"}};
  for (std::vector<std::string> options : views) {
    options.insert(options.end(), {"--write-camera", file});
    const TestPicture first = draw(cube(), options), again = draw(cube(), {"--camera", file});
    int different = 0;
    for (size_t i = 0; i < first.rgb.size(); ++i) different += std::abs(first.rgb[i] - again.rgb[i]) > 1;
    CHECK(different <= 6);
  }
  CHECK(has(read_bytes(file), "\"fov\":"));
  for (const char* text :
       {"", "words", "[]", "{}", "{\"eye\": [1, 2]}", "{\"eye\": [1, 2, \"3\"]}", "{\"eye\": [0, 0, 1e300]}",
        "{\"eye\": [0, 0, 5], \"fov\": 180}", "{\"eye\": [0, 0, 5], \"fov\": 30, \"height\": 2}",
        "{\"eye\": [0, 0, 5], \"zoom\": 2}"}) {
    const ProgramRun run =
        run_softgl({cube(), "-o", folder() + "x.png", "--camera", write("bad.json", text)});
    INFO(text << run.errors);
    CHECK(run.exit_code == 3);
    CHECK(has(run.errors, "bad.json: no camera"));
  }
}

TEST_CASE("look: info measures the surface", "[models][look]") {
  const std::string json = run_softgl({"info", cube(), "--json"}).output;
  for (const char* part :
       {"\"volume\": 8,", "\"area\": 24,", "\"edges\": 18,", "\"open_edges\": 0,", "\"crowded_edges\": 0,"})
    CHECK(has(json, part));
  // A cube whose corners the file repeats for each face, without a lid, in two materials.
  write("two.mtl", "newmtl side\nKd 1 0 0\nnewmtl floor\nKd 0 1 0\n");
  const std::string open = write(
      "open.obj",
      "mtllib two.mtl\nusemtl floor\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 4 3 2\nusemtl side\n"
      "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nf 5 6 7 8\nv 1 0 0\nv 1 1 0\nv 1 1 1\nv 1 0 1\nf 9 10 11 12\n"
      "v 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\nf 13 14 15 16\nv 0 1 0\nv 0 0 0\nv 0 0 1\nv 0 1 1\nf 17 18 19 "
      "20\n");
  const std::string text = run_softgl({"info", open}).output;
  CHECK(has(text, "4 open, 0 of more than two triangles; not closed"));
  CHECK(has(text, "floor: 2 triangles, area 1\n"));
  CHECK(has(text, "side: 8 triangles, area 4\n"));
  CHECK(has(run_softgl({"info", open, "--json"}).output, "\"volume\": null"));
}
