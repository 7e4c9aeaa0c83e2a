// softgl figure: one sheet with all parts of the lecture.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include <fstream>

using namespace softgl::test;

namespace {

constexpr int kPart = 200, kGap = 12, kTop = 48,
              kRow = 36 + kPart + 36; // of a sheet with letters of size one

struct Sheet {
  TestPicture picture;

  // Mean of a part's bytes; row and column from 0.
  double mean(int row, int column) const {
    double sum = 0;
    for (int y = 0; y < kPart; ++y)
      for (int x = 0; x < kPart; ++x)
        for (int channel = 0; channel < 3; ++channel) sum += at(row, column, x, y)[channel];
    return sum / (3.0 * kPart * kPart);
  }
  const uint8_t* at(int row, int column, int x, int y) const {
    return picture.at(kGap + column * (kPart + kGap) + x, kTop + row * kRow + 36 + y);
  }
};

Sheet draw(std::vector<std::string> options) {
  std::vector<std::string> arguments = {"figure", "-o",      "-",    "--format", "ppm",
                                        "--size", "200x200", "--bg", "black"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProgramRun run = run_softgl(arguments);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return {parse_ppm(run.output)};
}

} // namespace

TEST_CASE("figure: the sphere's sheet says what the lecture says", "[models][program]") {
  const Sheet sheet = draw({});
  REQUIRE(sheet.picture.width == kGap + 5 * (kPart + kGap));
  REQUIRE(sheet.picture.height == kTop + 6 * kRow);
  // The sum of the terms, at every pixel but for rounding: three roundings of half a step each against one.
  for (int y = 0; y < kPart; ++y)
    for (int x = 0; x < kPart; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const int sum =
            sheet.at(0, 0, x, y)[channel] + sheet.at(0, 1, x, y)[channel] + sheet.at(0, 2, x, y)[channel];
        REQUIRE(std::abs(std::min(sum, 255) - sheet.at(0, 3, x, y)[channel]) <= 2);
      }
  // A higher exponent makes the highlight smaller; finer triangles make Gouraud shading more like Phong
  // shading.
  for (int column = 0; column < 4; ++column) {
    CHECK(sheet.mean(1, column) > sheet.mean(1, column + 1));
    CHECK(sheet.mean(4, column) > sheet.mean(4, column + 1));
  }
  // The half vector's highlight is wider; with four times the exponent it is nearly the reflection vector's.
  CHECK(sheet.mean(5, 1) > sheet.mean(5, 0));
  CHECK(sheet.mean(5, 4) < sheet.mean(5, 2) / 3);
}

TEST_CASE("figure: of a model, at the same fineness steps", "[models][program]") {
  const std::string folder = output_folder("figure"), file = folder +
                                                             "w\xc3\xa9"
                                                             "dge, " +
                                                             std::string(60, 'w') + ".obj";
  std::ofstream(file) << "v -1 0 0\nv 0 -1 1\nv 1 0 0\nv 0 1 1\nvn -1 0 1\nvn 0 -1 1\nvn 1 0 1\nvn 0 1 1\nf "
                         "1//1 2//2 3//3 4//4\n";
  const Sheet sheet = draw({file, "--ks", "0.9", "--ns", "40", "--view", "front"});
  REQUIRE(sheet.picture.width == kGap + 5 * (kPart + kGap));
  for (int column = 0; column < 4; ++column) CHECK(sheet.mean(4, column) > sheet.mean(4, column + 1));
  // The title names the file without its folders, and fits.
  int ink = 0, beyond = 0;
  for (int y = 0; y < kTop; ++y)
    for (int x = 0; x < sheet.picture.width; ++x)
      if (sheet.picture.at(x, y)[0] < 128) ++ink, beyond += x >= sheet.picture.width - kGap;
  CHECK((ink > 500 && beyond == 0));
}

TEST_CASE("figure: wrong usage", "[models][program]") {
  CHECK(run_softgl({"figure"}).exit_code == 2);
  CHECK(run_softgl({"figure", "-o", "-", "--bg", "transparent"}).exit_code == 2);
  CHECK(run_softgl({"figure", "-o", "-", "--size", "9000x100"}).exit_code == 2);
  CHECK(run_softgl({"figure", "absent.obj", "-o", "-"}).exit_code == 3);
}
