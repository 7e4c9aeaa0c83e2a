// Models that are no plain OBJ file: compressed ones, and what other programs put into OBJ files.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "image/image_writer.h"

#include <array>
#include <cstdlib>
#include <fstream>

using namespace softgl;
using namespace softgl::test;

namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; // what the two hold
[[maybe_unused]] constexpr std::string_view kGzip =
    "1f8b08000000000002032b53300041ae320543286d006271a501492305632e0043f96e2a20000000";
[[maybe_unused]] constexpr std::string_view kZstd =
    "28b52ffd2420dd0000887620300a762031300a662031203220330a03002d41ac24c97243dc47cf34";

std::string from_hex(std::string_view hex) {
  std::string bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += char(std::strtoul(std::string(hex.substr(i, 2)).c_str(), nullptr, 16));
  return bytes;
}

std::string write(const std::string& name, const std::string& bytes) {
  const std::string path = output_folder("formats") + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ProgramRun draw(const std::string& name, const std::string& bytes, std::vector<std::string> options = {}) {
  std::vector<std::string> arguments = {write(name, bytes), "-o",    "-",    "--format", "ppm", "-s", "40x40",
                                        "--view",           "front", "--bg", "#000000"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_softgl(arguments);
}

[[maybe_unused]] void check_compressed(const std::string& name, const std::string& bytes) {
  const ProgramRun plain = draw("plain.obj", kTriangle), packed = draw(name, bytes);
  CHECK(packed.errors.empty());
  CHECK(packed.output == plain.output);
  const ProgramRun twice = draw(name, bytes + bytes, {"-v"}); // one text after another
  CHECK(has(twice.errors, "2 triangles from 2 faces, 6 vertices"));
  for (const size_t length : {size_t(3), bytes.size() / 2, bytes.size() - 1}) {
    const ProgramRun cut = draw(name, bytes.substr(0, length));
    INFO(length << cut.errors);
    CHECK(cut.exit_code == 3);
    CHECK((has(cut.errors, "the file is damaged or cut off") || has(cut.errors, "no geometry")));
  }
}

} // namespace

TEST_CASE("model formats: gzip", "[models][formats]") {
#ifdef SOFTGL_HAVE_ZLIB
  check_compressed("t.obj.gz", from_hex(kGzip));
#else
  CHECK(has(draw("t.obj.gz", from_hex(kGzip)).errors,
            "file is compressed with gzip, which this program was built"));
#endif
}

TEST_CASE("model formats: zstd", "[models][formats]") {
#ifdef SOFTGL_HAVE_ZSTD
  check_compressed("t.obj.zst", from_hex(kZstd));
#else
  CHECK(has(draw("t.obj.zst", from_hex(kZstd)).errors,
            "file is compressed with zstd, which this program was built"));
#endif
}

TEST_CASE("model formats: colors that ZBrush paints", "[models][formats]") {
  const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
  const auto middle = [](const ProgramRun& run) {
    CHECK(run.errors.empty());
    const TestPicture picture = parse_ppm(run.output);
    const uint8_t* p = picture.at(20, 20);
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  const auto red =
      middle(draw("z.obj", square + "#MRGB ffff0000ffff0000ffff0000\n#MRGB FFFF0000\nf 1 2 3 4\n"));
  CHECK(red[0] > 150);
  CHECK(red[1] == 0);
  // Fewer than vertices: the rest is white. More, or no digits: no harm.
  const auto some = middle(draw("z.obj", square + "#MRGB ffff0000\nf 2 3 4\n"));
  CHECK(some[0] == some[1]);
  CHECK(middle(draw("z.obj", square + "#MRGB ffff0000ffff0000ffff0000ffff0000ffff0000\nf 1 2 3 4\n")) == red);
  const auto none = middle(draw("z.obj", square + "#MRGB \n#MRGB fff\n#MRGB color\nf 1 2 3 4\n"));
  CHECK(none == middle(draw("z.obj", square + "f 1 2 3 4\n")));
}

TEST_CASE("model formats: black under a picture", "[models][formats]") {
  cli::Picture picture;
  picture.width = picture.height = 2;
  for (int i = 0; i < 4; ++i)
    for (const uint8_t value : {0, 200, 0}) picture.pixels.append(value);
  const auto bytes = cli::encode_image(picture, "png", cli::PngEffort::kDefault);
  write("green.png", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const std::string model =
      "mtllib k.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\n";
  const auto green = [&](const std::string& mtl, std::vector<std::string> options = {}) {
    write("k.mtl", mtl);
    const ProgramRun run = draw("k.obj", model, std::move(options));
    return int(parse_ppm(run.output).at(20, 20)[1]);
  };
  const int white = green("newmtl m\nKd 1 1 1\nmap_Kd green.png\n");
  CHECK(white > 100);
  for (const char* mtl :
       {"newmtl m\nKd 0 0 0\nmap_Kd green.png\n", "newmtl m\nKa 0 0 0\nmap_Kd green.png\nKd 0 0 0\n"}) {
    CHECK(green(mtl) == white);
    CHECK(green(mtl, {"--strict-mtl"}) < 5);
  }
  write("k.mtl", "newmtl m\nKd 0 0 0\nmap_Kd green.png\n");
  CHECK(has(draw("k.obj", model, {"-v"}).errors,
            "k.mtl: material \"m\" has a picture and Kd 0 0 0; drawn as Kd 1 1 1"));
  CHECK(draw("k.obj", model).errors.empty());
  CHECK(green("newmtl m\nKd 0 0 0\n") < 5); // without a picture black is black
}
