// Passes: what each stores, in whole numbers and in floats.
#include <catch2/catch.hpp>

#include "models/picture_files.h"
#include "models/program_runner.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

using namespace softgl::test;

namespace {

std::string folder() { return output_folder("passes"); }

std::string write(const std::string& name, const std::string& text) {
  std::ofstream(folder() + name, std::ios::binary) << text;
  return folder() + name;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Two squares that face the front, the left one 20 units behind the right one, which leans back by 45
// degrees.
std::string squares() {
  write("squares.mtl", "newmtl left\nKd .8 .2 .2\nKa .8 .2 .2\nKs .5 .5 .5\nNs 20\nKe .1 0 .1\n"
                       "newmtl right\nKd .2 .8 .2\n");
  return write("squares.obj", "mtllib squares.mtl\n"
                              "v -20 0 -20\nv 0 0 -20\nv 0 20 -20\nv -20 20 -20\n"
                              "v 0 0 0\nv 20 0 0\nv 20 20 -20\nv 0 20 -20\n"
                              "vt 0 0\nvt 2 0\nvt 2 4\nvt 0 4\n"
                              "usemtl left\nf 1/1 2/2 3/3 4/4\nusemtl right\nf 5/1 6/2 7/3 8/4\n");
}

ProgramRun draw(const std::string& model, std::vector<std::string> options) {
  options.insert(options.begin(), model);
  options.insert(options.end(), {"--size", "80x40", "--view", "front", "--ortho", "--up", "+Y"});
  return run_softgl(options);
}

struct Floats {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;
  const float* at(int x, int y) const { // rows from the top
    return &values[size_t(channels) * (size_t(height - 1 - y) * size_t(width) + size_t(x))];
  }
};

Floats pass_in_floats(const std::string& model, const std::string& pass, std::vector<std::string> more = {}) {
  more.insert(more.end(), {"-o", "-", "--format", "pfm", "--pass", pass});
  const std::string bytes = draw(model, more).output;
  Floats floats;
  char kind = 0;
  int used = 0;
  REQUIRE(std::sscanf(bytes.c_str(), "P%c %d %d -1.0%n", &kind, &floats.width, &floats.height, &used) == 3);
  floats.channels = kind == 'F' ? 3 : 1;
  floats.values.resize(size_t(floats.channels) * size_t(floats.width) * size_t(floats.height));
  REQUIRE(bytes.size() == size_t(used) + 1 + floats.values.size() * sizeof(float));
  std::memcpy(floats.values.data(), &bytes[size_t(used) + 1], floats.values.size() * sizeof(float));
  return floats;
}

std::string png_of(const std::string& model, std::vector<std::string> options) {
  options.insert(options.end(), {"-o", "-"});
  return draw(model, options).output;
}

double note_of(const std::string& png, const std::string& name) {
  for (const std::string& chunk : png_chunks(png, "tEXt"))
    if (chunk.rfind(name + '\0', 0) == 0) return std::stod(chunk.substr(name.size() + 1));
  FAIL("no note " << name);
  return 0;
}

} // namespace

TEST_CASE("passes: depth is in the model's units", "[models][passes]") {
  const std::string model = squares();
  for (const bool perspective : {false, true}) {
    std::vector<std::string> options = {"--pass", "depth"};
    Floats depth = pass_in_floats(model, "depth");
    if (perspective) {
      const std::string file = folder() + "depth.pfm";
      run_softgl({model, "--size", "80x40", "--view", "front", "--up", "+Y", "--pass", "depth", "-o", file});
      const std::string bytes = read_bytes(file);
      std::memcpy(depth.values.data(), &bytes[bytes.size() - depth.values.size() * 4],
                  depth.values.size() * 4);
    }
    CHECK(depth.channels == 1);
    CHECK(std::isinf(*depth.at(0, 0)));
    // The right square leans back from the left one's plane: at its lower edge it is 20 before it.
    CHECK(*depth.at(20, 20) - *depth.at(60, 37) == Approx(18.5).margin(1));
    CHECK(*depth.at(20, 15) == Approx(*depth.at(25, 25)).epsilon(1e-5));
    CHECK(*depth.at(60, 10) > *depth.at(60, 30) + 5);
  }
  const std::string png = png_of(model, {"--pass", "depth", "--bits", "16"});
  const double near = note_of(png, "softgl near"), far = note_of(png, "softgl far");
  const Floats depth = pass_in_floats(model, "depth");
  CHECK(near < *depth.at(60, 37));
  CHECK(far > *depth.at(20, 20));
  const std::string file = folder() + "depth16.png";
  std::ofstream(file, std::ios::binary) << png;
  const TestPicture gray = decode_picture(png);
  for (const auto& [x, y] : {std::pair(20, 20), std::pair(60, 30), std::pair(60, 10)})
    CHECK(near + gray.at(x, y)[0] / 255.0 * (far - near) ==
          Approx(*depth.at(x, y)).margin((far - near) / 250));
  CHECK(gray.at(0, 0)[0] == 255);
}

TEST_CASE("passes: normals are unit and in the model's axes", "[models][passes]") {
  const Floats normal = pass_in_floats(squares(), "normal");
  const float *left = normal.at(20, 20), *right = normal.at(60, 20), h = std::sqrt(0.5f);
  for (int c = 0; c < 3; ++c) {
    CHECK(left[c] == Approx(c == 2 ? 1 : 0).margin(1e-5));
    CHECK(right[c] == Approx(c == 0 ? 0 : h).margin(1e-5));
    CHECK(normal.at(0, 0)[c] == 0);
  }
  const TestPicture bytes = decode_picture(png_of(squares(), {"--pass", "normal"}));
  CHECK(int(bytes.at(20, 20)[0]) == 128);
  CHECK(int(bytes.at(20, 20)[2]) == 255);
  CHECK(int(bytes.at(60, 20)[1]) == 218);
}

TEST_CASE("passes: texture coordinates", "[models][passes]") {
  const Floats uv = pass_in_floats(squares(), "uv");
  const TestPicture box = decode_picture(png_of(squares(), {"--pass", "uv"}));
  // Halfway along the left square u is 1, and v rises by 4 over its height.
  CHECK(uv.at(20, 20)[0] == Approx(1).margin(0.06));
  CHECK(uv.at(20, 20)[1] == Approx(2).margin(0.12));
  CHECK(uv.at(20, 30)[1] < 1.2f);
  CHECK(uv.at(20, 20)[2] == 0);
  const float u = uv.at(30, 30)[0];
  CHECK(int(box.at(30, 30)[0]) == Approx((u - std::floor(u)) * 255).margin(1));
}

TEST_CASE("passes: materials have numbers, colors and names", "[models][passes]") {
  const Floats id = pass_in_floats(squares(), "id");
  CHECK(*id.at(0, 0) == 0);
  CHECK(*id.at(60, 20) == *id.at(20, 20) + 1);
  const std::string png = png_of(squares(), {"--pass", "id"});
  const TestPicture colors = decode_picture(png);
  CHECK(colors.colors() == 3);
  std::string notes;
  for (const std::string& chunk : png_chunks(png, "tEXt")) notes += chunk + "\n";
  char hex[8];
  const uint8_t* p = colors.at(60, 20);
  std::snprintf(hex, sizeof hex, "#%02x%02x%02x", p[0], p[1], p[2]);
  CHECK(has(notes, std::string("softgl id ") + hex + '\0' + "right\n"));
}

TEST_CASE("passes: the terms of the light add up to the color", "[models][passes]") {
  const std::string model = squares();
  const ProgramRun run = draw(model, {"-o", folder() + "{pass}.ppm", "--bg", "black", "--light", "0.3,0.3,1",
                                      "--pass", "specular,color,ambient,emission,diffuse"});
  CHECK(run.exit_code == 0);
  const TestPicture color = read_ppm(folder() + "color.ppm");
  std::vector<int> sum(color.rgb.size());
  for (const char* pass : {"ambient", "diffuse", "specular", "emission"}) {
    const TestPicture term = read_ppm(folder() + pass + std::string(".ppm"));
    CHECK(
        term.rgb ==
        parse_ppm(draw(model, {"-o", "-", "--format", "ppm", "--pass", pass, "--light", "0.3,0.3,1"}).output)
            .rgb);
    CHECK(term.colors() > 1);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += term.rgb[i];
  }
  int largest = 0;
  for (size_t i = 0; i < sum.size(); ++i)
    largest = std::max(largest, std::abs(std::min(sum[i], 255) - color.rgb[i]));
  CHECK(largest <= 2);
  // What is not lit emits its color.
  write("plain.mtl", "newmtl plain\nKd .5 .5 .5\nillum 0\n");
  const std::string plain =
      write("plain.obj", "mtllib plain.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl plain\nf 1 2 3 4\n");
  CHECK(decode_picture(png_of(plain, {"--pass", "diffuse"})).colors() == 1);
  CHECK(int(decode_picture(png_of(plain, {"--pass", "emission"})).at(40, 20)[0]) == 128);
}

TEST_CASE("passes: coverage is a mask of the model", "[models][passes]") {
  const std::string model = write("triangle.obj", "v 0 0 0\nv 4 0 0\nv 0 2 0\nf 1 2 3\n");
  const std::string hard = png_of(model, {"--pass", "coverage"}),
                    soft = png_of(model, {"--pass", "coverage", "--aa", "16"});
  CHECK(decode_picture(hard).colors() == 2);
  CHECK(int(decode_picture(hard).at(10, 30)[0]) == 255);
  CHECK(decode_picture(soft).colors() > 5);
  CHECK(png_chunks(hard, "IHDR").at(0)[9] == 0); // gray
  const Floats floats = pass_in_floats(model, "coverage", {"--aa", "16"});
  const TestPicture bytes = decode_picture(soft);
  for (int x = 0; x < 80; ++x) CHECK(*floats.at(x, 20) * 255 == Approx(bytes.at(x, 20)[0]).margin(0.51));
}

TEST_CASE("passes: nothing is where a texture has a hole", "[models][passes]") {
  write("hole.mtl", "newmtl net\nKd 1 1 1\nmap_Kd hole.tga\n");
  // Two texels: one opaque, one clear.
  std::string tga(18, '\0');
  tga[2] = 2, tga[12] = 2, tga[14] = 1, tga[16] = 32, tga[17] = 8;
  write("hole.tga", tga + std::string("\xff\xff\xff\xff\xff\xff\xff\x00", 8));
  const std::string model =
      write("hole.obj", "mtllib hole.mtl\nv 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\n"
                        "vt 0.25 0\nvt .75 0\nvt .75 1\nvt .25 1\nusemtl net\nf 1/1 2/2 3/3 4/4\n");
  const Floats normal = pass_in_floats(model, "normal");
  CHECK(normal.at(10, 20)[2] == 1);
  CHECK(normal.at(70, 20)[2] == 0);
}

TEST_CASE("passes: 16 bits and floats hold the same picture as 8 bits", "[models][passes]") {
  const std::string model = squares();
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{}, {"--aa", "4"}, {"--bg", "transparent", "--aa", "4"}}) {
    std::vector<std::string> options = more, deep = more;
    deep.insert(deep.end(), {"--bits", "16"});
    const std::string eight = png_of(model, options), sixteen = png_of(model, deep);
    CHECK(int(png_chunks(sixteen, "IHDR").at(0)[8]) == 16);
    const std::string a = folder() + "eight.png", b = folder() + "sixteen.png";
    std::ofstream(a, std::ios::binary) << eight;
    std::ofstream(b, std::ios::binary) << sixteen;
    CHECK(run_softgl({"compare", a, b, "--tolerance", "2"}).exit_code == 0);
    CHECK(run_softgl({"compare", a, b}).exit_code == 1);
  }
  const std::string exr = folder() + "color.exr";
  const ProgramRun run = draw(model, {"-o", exr, "--bg", "transparent"});
  if (has(run.errors, "without tinyexr")) return;
  CHECK(run.exit_code == 0);
  const std::string bytes = read_bytes(exr);
  CHECK(bytes.substr(0, 4) == "\x76\x2f\x31\x01");
  CHECK(has(bytes, std::string("A\0\2\0\0\0", 6))); // a channel of floats
  draw(model, {"-o", exr, "--pass", "depth"});
  CHECK(has(read_bytes(exr), "softgl far"));
}

TEST_CASE("passes: wrong usage", "[models][passes]") {
  const std::string model = squares();
  const std::vector<std::vector<std::string>> cases = {
      {"-o", "x.png", "--pass", "shadow"},      {"-o", "x.png", "--pass", "depth,depth"},
      {"-o", "x.png", "--pass", "depth,color"}, {"-o", "x.jpg", "--bits", "16"},
      {"-o", "x.png", "--bits", "12"},          {"-o", "x.pfm", "--sheet", "2"}};
  for (const auto& options : cases) CHECK(draw(model, options).exit_code == 2);
}
