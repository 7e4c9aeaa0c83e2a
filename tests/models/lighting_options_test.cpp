// What the program is told about light and reflectances.
#include <catch2/catch.hpp>

#include "options/option_values.h"

#include "models/program_runner.h"

#include <fstream>
#include <stdexcept>

using namespace softgl::cli;
using namespace softgl::test;

TEST_CASE("lighting options: lights and their properties", "[models][program]") {
  const LightOptions place =
      parse_light("at:1,2,-3/color:1,0.5,0/spot:0,0,-8/cutoff:25/exponent:6/attenuation:1,0.5,0.25");
  CHECK(place.kind == LightOptions::kModelPosition);
  CHECK(place.value[2] == -3);
  CHECK(place.color[1] == 0.5f);
  CHECK(place.spot_direction[2] == -1);
  CHECK(place.cutoff == 25);
  CHECK(place.exponent == 6);
  CHECK(place.attenuation[2] == 0.25f);
  CHECK(parse_light("at:0,0,5/spot:0,0,-1").cutoff < 90);
  CHECK(parse_light("at:0,0,5").cutoff == 180);
  CHECK(parse_light("headlight/color:red").color[0] == 1);
  CHECK(parse_light("+Y/color:0.3").color[2] == 0.3f);
  for (const char* wrong :
       {"at:0,0,5/", "at:0,0,5/spot:0,0,0", "at:0,0,5/cutoff:91", "at:0,0,5/cutoff:-1",
        "at:0,0,5/exponent:129", "at:0,0,5/attenuation:0,0,0", "at:0,0,5/attenuation:1,2",
        "headlight/cutoff:20", "+Y/spot:1,0,0", "key/color:2", "at:0,0,5/shape:round", "/color:1"}) {
    INFO(wrong);
    CHECK_THROWS_AS(parse_light(wrong), std::invalid_argument);
  }
}

TEST_CASE("lighting options: terms and reflectances", "[models][program]") {
  CHECK(parse_terms("ambient") == kAmbient);
  CHECK(parse_terms("Diffuse,specular") == (kDiffuse | kSpecular));
  CHECK(parse_terms("all") == kAllTerms);
  for (const char* wrong : {"", "ambient,", "shine", "ambient diffuse"})
    CHECK_THROWS_AS(parse_terms(wrong), std::invalid_argument);
  CHECK(parse_reflectance("0.25") == std::array<float, 3>{0.25f, 0.25f, 0.25f});
  CHECK(parse_reflectance("1,0.5,0") == std::array<float, 3>{1, 0.5f, 0});
  CHECK(parse_reflectance("#ff0000") == std::array<float, 3>{1, 0, 0});
  for (const char* wrong : {"1.5", "-0.1", "1,2,3", "1,0", "", "shiny"})
    CHECK_THROWS_AS(parse_reflectance(wrong), std::invalid_argument);
}

namespace {

// The quadrilateral from -1 to 1, seen from its front, filling the picture.
TestPicture draw_square(std::vector<std::string> options) {
  const std::string folder = output_folder("lighting-options");
  std::ofstream(folder + "square.obj")
      << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\n";
  std::vector<std::string> arguments = {
      folder + "square.obj", "-o", "-", "--format", "ppm", "--size", "41x41", "--ortho", "--view", "front"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_softgl(arguments);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return parse_ppm(run.output);
}

int middle(const TestPicture& picture, int channel = 0) { return picture.at(20, 20)[channel]; }

} // namespace

// With n = s = v = r = h in the middle, each term is its reflectance times its light: ambient 0.2, others
// 0.8, rounded.
TEST_CASE("lighting options: each term is what its formula says", "[models][program]") {
  const std::vector<std::string> base = {"--light",    "headlight", "--ka",  "0.5",  "--kd",
                                         "0.25,0.5,0", "--ks",      "0.125", "--ns", "10"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), base.begin(), base.end());
    return draw_square(more);
  };
  CHECK(middle(with({"--terms", "ambient"})) == 26);     // 0.1 * 255 = 25.5
  CHECK(middle(with({"--terms", "diffuse"})) == 51);     // 0.2 * 255
  CHECK(middle(with({"--terms", "diffuse"}), 1) == 102); // 0.4 * 255
  CHECK(middle(with({"--terms", "specular"})) == 26);    // 0.1 * 255
  CHECK(middle(with({"--terms", "emission"})) == 0);
  CHECK(middle(with({})) == 102); // 0.1 + 0.2 + 0.1
  CHECK(middle(with({"--shading", "phong"})) == 102);
  CHECK(middle(with({"--shading", "phong", "--specular", "reflection"})) == 102);
  CHECK(middle(with({"--terms", "ambient", "--ambient-light", "1"})) == 128);
}

TEST_CASE("lighting options: a spot lights its cone only, per pixel", "[models][program]") {
  const std::vector<std::string> base = {"--kd", "1",       "--ka",
                                         "0",    "--light", "at:0,0,1/spot:0,0,-1/cutoff:20/color:1"};
  std::vector<std::string> per_pixel = base;
  per_pixel.insert(per_pixel.end(), {"--shading", "phong"});
  const TestPicture phong = draw_square(per_pixel), gouraud = draw_square(base);
  CHECK(middle(phong) == 255);
  CHECK(middle(gouraud) == 0); // no vertex is in the cone
  // tan(20 degrees) = 0.364 of 1: 20 pixels for 1 make 7.2.
  CHECK(phong.at(20 + 6, 20)[0] > 200);
  CHECK(phong.at(20 + 9, 20)[0] == 0);
}

TEST_CASE("lighting options: several lights add up, nine are too many", "[models][program]") {
  const std::vector<std::string> two = {
      "--kd", "1", "--ka", "0", "--light", "headlight/color:0.25,0,0", "--light", "0,0,1/color:0.25,0.5,0"};
  const TestPicture picture = draw_square(two);
  CHECK(middle(picture, 0) == 128);
  CHECK(middle(picture, 1) == 128);
  std::vector<std::string> nine = {"absent.obj", "-o", "-"};
  for (int i = 0; i < 9; ++i) nine.insert(nine.end(), {"--light", "headlight"});
  CHECK(run_softgl(nine).exit_code == 2);
}
