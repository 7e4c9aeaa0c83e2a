// Files of one megabyte that once took seconds: what they take is counted, or they end.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "command/camera_file.h"
#include "command/model_loader.h"
#include "common/program_error.h"
#include "image/image_writer.h"
#include "image/picture_decoder.h"
#include "image/texture_loader.h"
#include "mesh/mesh_builder.h"
#include "mesh/model_frame.h"
#include "mesh/polygon_triangulator.h"

#include <cmath>
#include <fstream>
#include <random>

using namespace softgl;
using namespace softgl::test;

namespace {

std::string folder() { return output_folder("hostile"); }

void write(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

bool has(const std::vector<std::string>& sentences, const std::string& part) {
  for (const std::string& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

struct Reading {
  cli::LoadedModel loaded;
  cli::Mesh mesh;
  cli::Warnings warnings, notes;
};

Reading read(const std::string& text, const std::string& name = "model.obj") {
  Reading result;
  const cli::SourceText source = cli::SourceText::from_string(text, name);
  cli::RemarkList remarks;
  cli::MeshOptions flat;
  flat.flat = true;
  result.loaded = cli::load_model(source, 1, remarks, result.warnings, result.notes);
  result.mesh = cli::build_mesh(result.loaded.model, cli::frame_model(result.loaded.model),
                                result.loaded.library, flat, remarks);
  result.warnings.add(remarks, source);
  return result;
}

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

} // namespace

TEST_CASE("hostile files: faces of thousands of corners at a few places", "[models][hostile]") {
  std::mt19937 random(5);
  cli::PolygonTriangulator triangulator;
  uint64_t before = 0;
  for (int turn = 0; turn < 4; ++turn) {
    const uint32_t size = 20000;
    std::vector<double> corners;
    for (uint32_t i = 0; i < size; ++i) {
      const uint32_t place = random() % 9;
      corners.insert(corners.end(), {double(place % 3), double(place / 3), 0});
    }
    std::vector<uint32_t> triangles(3 * (size - 2), size);
    triangulator.triangulate(corners.data(), size, triangles.data());
    for (const uint32_t corner : triangles) REQUIRE(corner < size);
    // One such face may take long; a file of them takes what other faces do.
    INFO(turn << ": " << triangulator.steps() - before);
    CHECK(triangulator.steps() - before < (turn < 3 ? 75'000'000u : 12'000'000u));
    before = triangulator.steps();
  }
}

TEST_CASE("hostile files: a spiral of many turns is still cut exactly", "[models][hostile]") {
  // No corner of its walls is an ear for long: the same corners stand in the way again and again.
  std::vector<double> corners;
  const int half = 4000;
  for (int i = 0; i < 2 * half; ++i) {
    const double angle = 400.0 * (i < half ? i : 2 * half - 1 - i) / half,
                 radius = (i < half ? 1 : 3) + angle;
    corners.insert(corners.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  std::vector<uint32_t> triangles(3 * (2 * half - 2));
  cli::PolygonTriangulator triangulator;
  triangulator.triangulate(corners.data(), 2 * half, triangles.data());
  const auto cross = [&](size_t a, size_t b, size_t c) {
    const double* p = corners.data();
    return (p[3 * b] - p[3 * a]) * (p[3 * c + 1] - p[3 * a + 1]) -
           (p[3 * b + 1] - p[3 * a + 1]) * (p[3 * c] - p[3 * a]);
  };
  double area = 0, covered = 0;
  for (size_t i = 1; i + 1 < size_t(2 * half); ++i) area += cross(0, i, i + 1);
  for (size_t i = 0; i < triangles.size(); i += 3)
    covered += std::fabs(cross(triangles[i], triangles[i + 1], triangles[i + 2]));
  CHECK(covered == Approx(std::fabs(area)));
  CHECK(triangulator.steps() < 20'000'000);
}

TEST_CASE("hostile files: lines that end with a carriage return, near and far", "[models][hostile]") {
  for (const char* end : {"\r", "\n", "\r\n"})
    for (const size_t length : {0, 1, 1022, 1023, 1024, 1025, 5000, 300000}) {
      INFO(length << " characters and " << (end[1] ? "CR LF" : end[0] == '\r' ? "CR" : "LF"));
      std::string text = "#" + std::string(length, '-') + end + kTriangle + "#" + std::string(length, '-');
      CHECK(read(text).loaded.report.triangles == 1);
    }
  std::string comments = kTriangle;
  for (int i = 0; i < 500000; ++i) comments += "#\r";
  CHECK(read(comments).loaded.report.triangles == 1);
}

TEST_CASE("hostile files: names of libraries without end", "[models][hostile]") {
  std::string text = kTriangle;
  for (int line = 0; line < 300; ++line) {
    text += "mtllib";
    for (int i = 0; i < 100; ++i) text += " " + std::to_string(line) + "_" + std::to_string(i) + ".mtl";
    text += "\n";
  }
  const Reading reading = read(text, folder() + "libraries.obj");
  CHECK(has(reading.warnings.sentences(), "more times: material library not found"));
  CHECK(reading.warnings.count() < 400);
}

TEST_CASE("hostile files: a material for each line", "[models][hostile]") {
  std::string materials, text = "mtllib lines.mtl\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\n";
  const int count = 30000;
  for (int i = 0; i < count; ++i) {
    materials += "newmtl " + std::to_string(i) + "\n";
    text += "usemtl " + std::to_string(i) + "\nl " + std::to_string(i % 4 + 1) + " 1\n";
  }
  text += "usemtl 0\nl 4 2\n"; // stands with the first
  write(folder() + "lines.mtl", materials);
  const Reading reading = read(text, folder() + "lines.obj");
  REQUIRE(reading.mesh.segment_batches.size() == size_t(count));
  CHECK(reading.mesh.segment_batches[0].count == 4);
  const float* x = reading.mesh.segment_positions.data();
  CHECK(x[0] == x[3]);  // 1 1
  CHECK(x[6] > x[9]);   // 4 2
  CHECK(x[12] > x[15]); // 2 1
  CHECK(x[9] == x[12]);
}

TEST_CASE("hostile files: small pictures that claim to be large", "[models][hostile]") {
  const auto number = [](uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += char(value >> shift);
    return bytes;
  };
  // The sums of the chunks are not looked at.
  const auto png = [&](uint32_t width, uint32_t height, char bits, char kind) {
    return "\x89PNG\r\n\x1a\n" + number(13) + "IHDR" + number(width) + number(height) + bits + kind +
           std::string(3, '\0') + number(0) + number(0) + "IDAT" + number(0);
  };
  const auto problem_of = [](std::string bytes, size_t size) {
    bytes.resize(std::max(size, bytes.size()));
    cli::DecodedPicture picture;
    const std::string problem =
        cli::decode_picture(cli::SourceText::from_string(std::move(bytes), "picture"), picture);
    return problem;
  };
  const std::string refused = "has too many pixels for the size of its file";
  CHECK(problem_of(png(23000, 23000, 1, 0), 1 << 20) == refused);
  CHECK(problem_of(png(11600, 11600, 1, 0), 1 << 20) == refused); // just above 2^27 pixels
  CHECK(problem_of(png(11000, 11000, 1, 0), 0) != refused);
  CHECK(problem_of(png(11000, 11000, 16, 6), 0) == refused); // a gigabyte of rows
  CHECK(problem_of(png(23000, 23000, 1, 0), 5 << 20) != refused);
  const std::string tga("\0\0\x0a\0\0\0\0\0\0\0\0\0\0\x07\0\x07\x18\0", 18); // 1792x1792, packed
  CHECK(problem_of(tga, 0) == refused);
  CHECK(problem_of(tga, 1 << 17).empty());
  // 2 x 14,352,503 pixels, the upper row first.
  const std::string bmp("BM\0\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\2\0\0\0\x89\xff\x24\xff\1\0\x18\0", 30);
  CHECK(problem_of(bmp, 60) == refused);
  for (const char first : {'\xff', '\x89'}) // bytes that begin other kinds of pictures
    CHECK(problem_of(std::string(1, first) + tga.substr(1), 0) == refused);
}

TEST_CASE("hostile files: one picture, named again and again", "[models][hostile]") {
  cli::Picture picture;
  picture.width = picture.height = 64;
  picture.pixels.fill(3 * 64 * 64, 100);
  const auto bytes = cli::encode_image(picture, "png", cli::PngEffort::kSmall);
  const std::string file = folder() + "gray.png";
  write(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  REQUIRE(64 * bytes.size() > 64 * 64); // it pays for its pixels itself
  cli::Material material;
  material.diffuse_map.file = file;
  cli::TexelBudget budget;
  budget.left = 2 * 64 * 64;
  cli::Warnings warnings;
  int read = 0;
  for (int i = 0; i < 5; ++i) {
    cli::TextureImage image;
    read += cli::load_texture(material, image, budget, warnings);
  }
  CHECK(read == 3);
  CHECK(warnings.count() == 2);
  CHECK(
      has(warnings.sentences(), "gray.png: this picture is left out: the pictures before it have too many"));
}

TEST_CASE("hostile files: cameras", "[models][hostile]") {
  const auto problem_of = [](std::string text) -> std::string {
    try {
      cli::parse_camera(cli::SourceText::from_string(std::move(text), "camera"));
    } catch (const cli::ProgramError& error) { return error.what(); }
    return "none";
  };
  CHECK(problem_of(R"({"eye": [0, 0, 5]})") == "none");
  CHECK(problem_of(std::string(1 << 20, '[')) == "camera: no camera: the file is no JSON");
  CHECK(problem_of(std::string(1 << 19, '[') + std::string(1 << 19, ']')) ==
        "camera: no camera: there is no \"eye\"");
  CHECK(problem_of(R"({"eye": [0, 0, 1e999]})") != "none");
  std::string deep = R"({"eye": )";
  for (int i = 0; i < 100000; ++i) deep += R"({"a":)";
  CHECK(problem_of(deep + "1" + std::string(100001, '}')) == "camera: no camera: three numbers stand in []");
}
