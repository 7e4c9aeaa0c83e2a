// Faults that were found with real files, each with the pixels or the sentence that is right.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "image/image_writer.h"
#include "image/picture_decoder.h"
#include "image/picture_rows.h"

#include <array>
#include <filesystem>
#include <fstream>

using namespace softgl;
using namespace softgl::test;

namespace {

std::string folder() { return output_folder("faults"); }

std::string write(const std::string& name, const std::string& bytes) {
  std::ofstream(folder() + name, std::ios::binary) << bytes;
  return folder() + name;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
const std::string kTextured = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";

ProgramRun draw(const std::string& text, std::vector<std::string> options = {}) {
  std::vector<std::string> arguments = {write("model.obj", text),
                                        "-o",
                                        "-",
                                        "--format",
                                        "ppm",
                                        "-s",
                                        "60x60",
                                        "--view",
                                        "front",
                                        "--bg",
                                        "#000000",
                                        "--light",
                                        "0,0,1",
                                        "--ns",
                                        "0"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_softgl(arguments);
}

// The pixel a quarter from the left and above the middle: on no edge or diagonal of the square.
std::array<int, 3> pixel(const ProgramRun& run) {
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const TestPicture picture = parse_ppm(run.output);
  const uint8_t* p = picture.at(20, 28);
  return {p[0], p[1], p[2]};
}

std::string picture_file(const std::string& name, std::vector<uint8_t> pixel,
                         const std::string& format = "png") {
  cli::Picture picture;
  picture.width = picture.height = 4;
  picture.channels = int(pixel.size());
  for (int i = 0; i < 16; ++i) picture.pixels.append(pixel.data(), pixel.size());
  const auto bytes = cli::encode_image(picture, format, cli::PngEffort::kDefault);
  return write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

} // namespace

TEST_CASE("faults: vertex colors are blended like the material", "[models][reported]") {
  write("half.mtl", "newmtl half\nKd 1 1 1\nd 0.5\nnewmtl solid\nKd 1 1 1\n");
  const std::string red = "v -1 -1 0 1 0 0\nv 1 -1 0 1 0 0\nv 1 1 0 1 0 0\nv -1 1 0 1 0 0\nmtllib half.mtl\n";
  const auto blended = pixel(draw(red + "usemtl half\nf 1 2 3 4\n"));
  const auto solid = pixel(draw(red + "usemtl solid\nf 1 2 3 4\n"));
  CHECK(solid[0] > 200);
  CHECK(std::abs(blended[0] - solid[0] / 2) <= 1);
  CHECK(blended[1] == 0);
  CHECK(blended[2] == 0);
  // Both on shared vertices: each has its own opacity.
  const auto mixed =
      draw(red + "v 3 -1 0 1 0 0\nv 3 1 0 1 0 0\nusemtl half\nf 1 2 3 4\nusemtl solid\nf 2 5 6 3\n");
  const TestPicture picture = parse_ppm(mixed.output);
  CHECK(std::abs(picture.at(18, 30)[0] - solid[0] / 2) <= 1);
  CHECK(picture.at(42, 30)[0] == solid[0]);
}

TEST_CASE("faults: an opacity picture needs no color picture", "[models][reported]") {
  picture_file("gray.png", {128, 128, 128});
  picture_file("black.png", {0, 0, 0});
  picture_file("alpha.png", {255, 255, 255, 64});
  const auto with = [](const std::string& line) {
    write("maps.mtl", "newmtl m\nKd 1 1 1\n" + line);
    return draw("mtllib maps.mtl\nusemtl m\n" + kSquare + kTextured);
  };
  const int opaque = pixel(with(""))[0];
  CHECK(opaque > 200);
  CHECK(std::abs(pixel(with("map_d gray.png\n"))[0] - opaque / 2) <= 2);
  CHECK(std::abs(pixel(with("map_d alpha.png\n"))[0] - opaque / 4) <= 2);
  CHECK(std::abs(pixel(with("map_d -mm 0 0.5 gray.png\n"))[0] - opaque / 4) <= 2);
  const ProgramRun nothing = with("map_d black.png\n");
  CHECK(pixel(nothing)[0] == 0);
  CHECK(has(nothing.errors, "nothing of it shows because its materials are transparent"));
  const ProgramRun dissolved = with("d 0\n");
  CHECK(has(dissolved.errors, "materials are transparent"));
  CHECK(has(draw("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nf 1 2 3\n").errors, "no visible area in this view"));
  CHECK(has(with("map_d nowhere.png\n").errors, "\"nowhere.png\" not found"));
  write("broken.png", "\x89PNG\r\n\x1a\nrest");
  CHECK(
      has(with("map_Kd gray.png\nmap_d broken.png\n").errors, "broken.png: this picture cannot be decoded"));
}

TEST_CASE("faults: numbers as old C libraries of Windows print them", "[models][reported]") {
  for (const char* word : {"1.#QNAN", "1.#INF00", "-1.#IND", "-1.#IND00", "1.#SNAN", "-1.#INF", "1.#J"}) {
    const std::string w = word;
    INFO(w);
    for (const std::string& place : {w + " 1 1", "1 " + w + " 1", "1 1 " + w}) {
      const ProgramRun vertex = draw(kSquare + "v " + place + "\nf 1 2 3 4\nf 1 2 5\n");
      CHECK(has(vertex.errors,
                "model.obj:5: this vertex is not a finite place; faces that use it are skipped"));
      CHECK(has(vertex.errors, "model.obj:7: a corner names a vertex that is not a finite place"));
      const ProgramRun normal = draw(kSquare + "vn " + place + "\nf 1//1 2//1 3//1 4//1\n");
      CHECK(has(normal.errors, "model.obj:5: this normal has no direction"));
      CHECK(pixel(normal)[0] > 150);
    }
    for (const std::string& place : {w + " 1", "1 " + w})
      CHECK(has(draw(kSquare + "vt " + place + "\nf 1/1 2/1 3/1 4/1\n").errors,
                "model.obj:5: this texture coordinate is not a number"));
  }
  for (const char* comment : {"1 1 0#red", "1 1 0.#red", "1 1 0. # 1", "1 1 0#1.#INF"}) {
    INFO(comment);
    const ProgramRun run = draw("v -1 -1 0\nv 1 -1 0\nv " + std::string(comment) + "\nf 1 2 3\n");
    CHECK(run.errors.empty());
  }
}

TEST_CASE("faults: a vertex without a color among colored ones is white", "[models][reported]") {
  write("blue.mtl", "newmtl blue\nKd 0 0 1\n");
  const auto p = pixel(draw("mtllib blue.mtl\nusemtl blue\n" + kSquare + "v 9 9 9 1 0 0\nf 1 2 3 4\n"));
  CHECK(p[0] > 200);
  CHECK(p[0] == p[1]);
  CHECK(p[1] == p[2]);
  const auto none = pixel(draw("mtllib blue.mtl\nusemtl blue\n" + kSquare + "f 1 2 3 4\n"));
  CHECK(none[0] == 0);
  const auto bad =
      pixel(draw("v -1 -1 0 inf 0 0\nv 1 -1 0 1 1 1\nv 1 1 0 1 1 1\nv -1 1 0 1 1 1\nf 1 2 3 4\n"));
  CHECK(bad[0] == bad[2]); // not all black because one number is infinite
  CHECK(bad[0] > 200);
}

TEST_CASE("faults: indices as scripts print them", "[models][reported]") {
  const ProgramRun plain = draw(kSquare + kTextured);
  for (const char* face : {"f 1.0 2.0 3.0 4.0", "f 1. 2.000000 3 4.0", "f 1.0/1.0 2.0/2.0 3/3.0 4/4"}) {
    INFO(face);
    const ProgramRun run = draw(kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + face + "\n");
    CHECK(run.errors.empty());
    CHECK(run.output == plain.output);
  }
  CHECK(has(draw(kSquare + "f 1 2 3\nf 1.5 2 3\n").errors, "\"1.5\" is not a corner"));
}

TEST_CASE("faults: decimal commas are named", "[models][reported]") {
  const ProgramRun vertices = draw("v 0,5 0,5 0,5\nv 1,5 0 0\nv 0 1,25 0\nf 1 2 3\n");
  CHECK(vertices.exit_code == 3);
  CHECK(has(vertices.errors, "model.obj:1: this number has a decimal comma; it needs a point (1.5)"));
  CHECK(
      has(vertices.errors, "no geometry; its numbers have decimal commas (1,5), and OBJ needs points (1.5)"));
  CHECK(has(draw(kSquare + "f 1 2 3\nf 1,0 2,0 3,0\n").errors, "(it has a decimal comma)"));
  CHECK(has(draw(kSquare + "vt 0,5 0,5\nf 1/1 2/1 3/1\n").errors, "decimal comma"));
  write("comma.mtl", "newmtl m\nKd 0,5 0,5 0,5\n");
  CHECK(
      has(draw("mtllib comma.mtl\n" + kSquare + "usemtl m\nf 1 2 3\n").errors, "\"Kd\" has a decimal comma"));
}

TEST_CASE("faults: a transparent background in a format without", "[models][reported]") {
  const std::string model = write("plain.obj", kSquare + "f 1 2 3 4\n");
  for (const char* format : {"jpg", "bmp", "ppm"}) {
    const ProgramRun run =
        run_softgl({model, "-o", folder() + "t." + format, "--bg", "transparent", "-s", "32x32"});
    CHECK(run.exit_code == 0);
    CHECK(has(run.errors, std::string("t.") + format + ": pictures of format " + format +
                              " have no transparency; the background is white"));
  }
  for (const char* format : {"png", "pam", "tga"})
    CHECK(run_softgl({model, "-o", folder() + "t." + format, "--bg", "transparent", "-s", "32x32"})
              .errors.empty());
}

TEST_CASE("faults: what a file without geometry is", "[models][reported]") {
  const std::pair<std::string, const char*> files[] = {
      {"BZh91AY", "file is compressed with bzip2"},
      {std::string("PK\x03\x04rest", 8), "file is a ZIP archive"},
      {"glTF\x02", "file is a glTF model"},
      {"\x89PNG\r\n\x1a\n", "file is a PNG picture"},
      {"Kaydara FBX Binary", "file is an FBX model"}};
  for (const auto& [bytes, sentence] : files) {
    const ProgramRun run = draw(bytes);
    CHECK(run.exit_code == 3);
    CHECK(has(run.errors, sentence));
  }
}

TEST_CASE("faults: a picture of too many texels is reduced while it is read", "[models][reported]") {
  CHECK(cli::reduction_of(8192, 8192) == 1);
  CHECK(cli::reduction_of(8193, 8192) == 2);
  CHECK(cli::reduction_of(65535, 65535) == 8);
  // 2 x (2^26 + 2) texels: black but for the last columns, which a picture reduced by 2 still shows.
  const int width = (1 << 25) + 3;
  cli::DecodedPicture picture;
  cli::PictureRows rows(picture, width, 3);
  for (int y = 0; y < 3; ++y) {
    uint8_t* row = rows.next_row();
    std::fill_n(row, size_t(4) * width, uint8_t(y == 2 ? 200 : 100));
    row[4 * (width - 1)] = 40;
    rows.add_written();
  }
  CHECK(picture.width == (width + 1) / 2);
  CHECK(picture.height == 2);
  REQUIRE(picture.rgba.size() == size_t(4) * size_t(picture.width) * 2);
  CHECK(picture.rgba[0] == 100);
  CHECK(picture.rgba[4 * size_t(picture.width) - 4] == 40); // its last column is single
  CHECK(picture.rgba[4 * size_t(picture.width) - 3] == 100);
  CHECK(picture.rgba[4 * size_t(picture.width)] == 200); // so is the last row
}
