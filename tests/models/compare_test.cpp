// `softgl compare` from outside: what it says about pictures whose differences are known.
#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "test_paths.h"

#include <filesystem>
#include <fstream>

using namespace softgl::test;

namespace {

std::string folder() { return output_folder("compare"); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TestPicture gray(int width, int height) {
  TestPicture picture;
  picture.width = width;
  picture.height = height;
  picture.rgb.assign(size_t(3) * size_t(width) * size_t(height), 128);
  return picture;
}

void set(TestPicture& picture, int x, int y, std::array<uint8_t, 3> color) {
  std::copy(color.begin(), color.end(), picture.rgb.begin() + 3 * (long(y) * picture.width + x));
}

std::string write(const std::string& name, const TestPicture& picture) {
  const std::string path = folder() + name;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << picture.width << " " << picture.height << "\n255\n";
  file.write(reinterpret_cast<const char*>(picture.rgb.data()), long(picture.rgb.size()));
  return path;
}

ProgramRun compare(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "compare");
  return run_softgl(arguments);
}

bool is(const uint8_t* pixel, std::array<uint8_t, 3> color) {
  return std::equal(color.begin(), color.end(), pixel);
}

} // namespace

TEST_CASE("compare: same, different and wrong usage", "[models][compare]") {
  TestPicture picture = gray(20, 10);
  const std::string a = write("a.ppm", picture);
  set(picture, 3, 4, {138, 128, 125});
  const std::string b = write("b.ppm", picture);
  CHECK(compare({a, a}).exit_code == 0);
  const ProgramRun run = compare({a, b});
  CHECK(run.exit_code == 1);
  CHECK(has(run.output, "1 of 200 pixels (0.5 %), largest difference 10 of 255"));
  CHECK(compare({a, b, "--quiet"}).output.empty());
  const ProgramRun numbers = compare({a, b, "--json"});
  CHECK(numbers.exit_code == 1);
  for (const char* part :
       {"\"differing_pixels\": 1,", "\"largest_difference\": [10, 0, 3, 0]",
        "\"mean_difference\": 0.0216666667", "\"box\": [3, 4, 3, 4]", "\"rms\": 0.426223728"})
    CHECK(has(numbers.output, part));
  CHECK(has(compare({a, a, "--json"}).output, "\"psnr\": null, \"ssim\": 1") == false); // a line each
  CHECK(has(compare({a, a, "--json"}).output, "\"psnr\": null,\n  \"ssim\": 1,"));
  const std::string other = write("other.ppm", gray(10, 20));
  const ProgramRun sizes = compare({a, other});
  CHECK(sizes.exit_code == 1);
  CHECK(has(sizes.output, "20x10 against 10x20"));
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{a},
                                             {},
                                             {a, folder()},
                                             {a, b, "--tolerance", "300"},
                                             {a, b, "--tolerance", "1,2"},
                                             {a, b, "--max-pixels", "1.5"},
                                             {a, b, "--max-pixels", "101%"},
                                             {a, b, "--min-ssim", "2"}})
    CHECK(compare(arguments).exit_code == 2);
  CHECK(compare({a, folder() + "absent.ppm"}).exit_code == 3);
  std::ofstream(folder() + "words.png") << "no picture";
  CHECK(compare({a, folder() + "words.png"}).exit_code == 3);
  CHECK(compare({a, b, folder() + "no/folder/d.png"}).exit_code == 4);
}

TEST_CASE("compare: what may differ", "[models][compare]") {
  TestPicture picture = gray(20, 10);
  const std::string a = write("tolerant_a.ppm", picture);
  set(picture, 3, 4, {138, 128, 125});
  set(picture, 4, 4, {128, 131, 128});
  const std::string b = write("tolerant_b.ppm", picture);
  CHECK(compare({a, b, "--tolerance", "10"}).exit_code == 0);
  CHECK(compare({a, b, "--tolerance", "9.5"}).exit_code == 1);
  CHECK(compare({a, b, "--tolerance", "10,3,3"}).exit_code == 0);
  CHECK(compare({a, b, "--tolerance", "10,2,3"}).exit_code == 1);
  CHECK(compare({a, b, "--max-pixels", "2"}).exit_code == 0);
  CHECK(compare({a, b, "--max-pixels", "1"}).exit_code == 1);
  CHECK(compare({a, b, "--max-pixels", "1%"}).exit_code == 0);
  CHECK(compare({a, b, "--max-pixels", "0.9%"}).exit_code == 1);
  CHECK(compare({a, b, "--min-ssim", "0.5"}).exit_code == 0);
  CHECK(compare({a, b, "--min-ssim", "0.99999"}).exit_code == 1);
  TestPicture mask = gray(20, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x)
      set(mask, x, y, x < 10 ? std::array<uint8_t, 3>{0, 0, 0} : std::array<uint8_t, 3>{255, 255, 255});
  const std::string right = write("mask.ppm", mask);
  const ProgramRun masked = compare({a, b, "--mask", right, "--json"});
  CHECK(masked.exit_code == 0);
  CHECK(has(masked.output, "\"compared_pixels\": 100,"));
}

TEST_CASE("compare: an edge that has moved, and pictures of the differences", "[models][compare]") {
  TestPicture first = gray(30, 20), second = first;
  for (int y = 0; y < 20; ++y) {
    for (int x = 10; x < 30; ++x) set(first, x, y, {250, 250, 250});
    for (int x = 11; x < 30; ++x) set(second, x, y, {250, 250, 250});
  }
  set(second, 3, 5, {0, 0, 0});
  const std::string a = write("edge_a.ppm", first), b = write("edge_b.ppm", second);
  CHECK(has(compare({a, b}).output, "21 of 600 pixels"));
  const ProgramRun run = compare({a, b, folder() + "d.ppm", "--ignore-edges", "--sheet", folder() + "s.ppm"});
  CHECK(run.exit_code == 1);
  CHECK(has(run.output, "1 of 600 pixels (0.1667 %), 20 more at edges"));
  const TestPicture difference = read_ppm(folder() + "d.ppm");
  CHECK(is(difference.at(3, 5), {224, 0, 0}));
  CHECK(is(difference.at(10, 5), {224, 224, 0}));
  CHECK(is(difference.at(0, 0), {224, 224, 224}));
  const TestPicture sheet = read_ppm(folder() + "s.ppm");
  CHECK(is(sheet.at(12, 12), {128, 128, 128}));
  CHECK(sheet.colors() > 5);
  CHECK(sheet.width > 3 * 30);
  set(second, 3, 5, {128, 128, 128});
  CHECK(compare({a, write("edge_b.ppm", second), "--ignore-edges"}).exit_code == 0);
}

TEST_CASE("compare: the structural similarity of known pictures", "[models][compare]") {
  // Constant pictures of brightness m and n: only the first factor is not 1.
  TestPicture first = gray(16, 16), second = first;
  std::fill(first.rgb.begin(), first.rgb.end(), 100);
  std::fill(second.rgb.begin(), second.rgb.end(), 150);
  const double c = 0.01 * 255 * 0.01 * 255, expected = (2 * 100 * 150 + c) / (100 * 100 + 150 * 150 + c);
  const ProgramRun run = compare({write("flat_a.ppm", first), write("flat_b.ppm", second), "--json"});
  const size_t at = run.output.find("\"ssim\": ");
  REQUIRE(at != std::string::npos);
  CHECK(std::stod(run.output.substr(at + 8)) == Approx(expected).epsilon(1e-5));
}

TEST_CASE("compare: folders, with a report for continuous integration", "[models][compare]") {
  TestPicture picture = gray(12, 12);
  for (const char* side : {"left/", "right/"}) {
    write(side + std::string("same.ppm"), picture);
    write(side + std::string("in/deep.ppm"), picture);
  }
  write("left/gone.ppm", picture);
  write("left/changed.ppm", picture);
  set(picture, 1, 1, {0, 0, 0});
  write("right/changed.ppm", picture);
  const std::string left = folder() + "left", right = folder() + "right";
  const ProgramRun run = compare({left, right, folder() + "diffs", "--junit", folder() + "report.xml"});
  CHECK(run.exit_code == 1);
  CHECK(has(run.output, "changed.ppm: different: 1 of 144 pixels"));
  CHECK(has(run.output, "gone.ppm: missing"));
  CHECK(has(run.output, "2 of 4 are the same\n"));
  CHECK(is(read_ppm(folder() + "diffs/changed.ppm").at(1, 1), {224, 0, 0}));
  CHECK_FALSE(std::filesystem::exists(folder() + "diffs/same.ppm"));
  const std::string report = read_bytes(folder() + "report.xml");
  CHECK(has(report, "tests=\"4\" failures=\"2\" errors=\"0\""));
  CHECK(has(report, "<failure type=\"missing\""));
  CHECK(has(report, "name=\"in/deep.ppm\""));
  CHECK(compare({left, left}).exit_code == 0);
  CHECK(has(compare({left, right, "--json"}).output, "\"result\": \"missing\""));
  std::filesystem::create_directories(folder() + "none");
  CHECK(compare({folder() + "none", folder() + "none"}).exit_code == 3);
}

TEST_CASE("compare: pictures of 16 bits and with alpha", "[models][compare]") {
  const auto pgm = [](const std::string& name, uint8_t low) {
    std::ofstream(folder() + name, std::ios::binary) << "P5\n1 1\n65535\n" << char(0x40) << char(low);
    return folder() + name;
  };
  const ProgramRun run = compare({pgm("deep_a.pgm", 0), pgm("deep_b.pgm", 1)});
  CHECK(run.exit_code == 1);
  CHECK(has(run.output, "largest difference 0.003891"));
  const std::string model = folder() + "model.obj";
  std::ofstream(model) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string opaque = folder() + "opaque.png", clear = folder() + "clear.png";
  run_softgl({model, "-o", opaque, "--size", "20x20", "--bg", "black"});
  run_softgl({model, "-o", clear, "--size", "20x20", "--bg", "transparent"});
  const ProgramRun alpha = compare({opaque, clear, "--json"});
  CHECK(alpha.exit_code == 1);
  CHECK(has(alpha.output, "\"largest_difference\": [0, 0, 0, 255]"));
}
