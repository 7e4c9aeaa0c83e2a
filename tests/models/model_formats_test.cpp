// Models that are no plain OBJ file: compressed ones, and what other programs put into OBJ files.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "image/image_writer.h"

#include <algorithm>
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

TEST_CASE("model formats: UTF-16 in either order of bytes", "[models][formats]") {
  // In the material's name a letter of two bytes, one of three and one of four in UTF-8.
  const std::u16string name = u"gr\u00fcn\u20ac\U0001f600",
                       model = u"mtllib wide.mtl\nusemtl " + name + u"\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto encoded = [](const std::u16string& text, bool little) {
    std::string bytes = little ? "\xff\xfe" : "\xfe\xff";
    for (const char16_t unit : text) {
      bytes += char(little ? unit & 255 : unit >> 8);
      bytes += char(little ? unit >> 8 : unit & 255);
    }
    return bytes;
  };
  write("narrow.mtl", "newmtl gr\xc3\xbcn\xe2\x82\xac\xf0\x9f\x98\x80\nKd 0 1 0\n");
  const ProgramRun plain =
      draw("narrow.obj", "mtllib narrow.mtl\nusemtl gr\xc3\xbcn\xe2\x82\xac\xf0\x9f\x98\x80\n" + kTriangle);
  REQUIRE(plain.errors.empty());
  for (const bool little : {true, false}) {
    write("wide.mtl", encoded(u"newmtl " + name + u"\nKd 0 1 0\n", !little));
    const ProgramRun wide = draw("wide.obj", encoded(model, little));
    CHECK(wide.errors == "");
    CHECK(wide.output == plain.output);
    // Half a letter and half a pair are no letters; the rest is read.
    const ProgramRun cut = draw("cut.obj", encoded(u"# \xd83d\n" + model + u"#\xdc00", little) + "x");
    CHECK(cut.output == plain.output);
  }
}

TEST_CASE("model formats: Blender's word for no material", "[models][formats]") {
  for (const std::string word : {"None", "(null)"}) {
    CHECK(draw("none.obj", "usemtl " + word + "\n" + kTriangle).errors == "");
    write("named.mtl", "newmtl " + word + "\nKd 0 0 1\n"); // unless it is a name
    const ProgramRun named = draw("named.obj", "mtllib named.mtl\nusemtl " + word + "\n" + kTriangle);
    CHECK(named.output != draw("none.obj", kTriangle).output);
  }
  CHECK(has(draw("other.obj", "usemtl none\n" + kTriangle).errors, "material \"none\" is unknown"));
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
  CHECK(green("newmtl m\nKd 0 0 0\nmap_Kd missing.png\n") > 100);
  CHECK(green("newmtl m\nKd 0 0 0\nmap_Kd missing.png\n", {"--strict-mtl"}) < 5);
  CHECK(green("newmtl m\nKd 0 0 0\n") < 5); // without a picture black is black
}

TEST_CASE("model formats: alpha of a diffuse picture", "[models][formats]") {
  const auto picture = [](const std::string& name, std::initializer_list<uint8_t> alpha) {
    cli::Picture p;
    p.width = p.height = 2, p.channels = 4;
    for (const uint8_t a : alpha)
      for (const uint8_t value : {uint8_t(0), uint8_t(200), uint8_t(0), a}) p.pixels.append(value);
    const auto bytes = cli::encode_image(p, "png", cli::PngEffort::kDefault);
    write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  picture("half.png", {0, 0, 0, 255}); // the square's middle is transparent
  picture("none.png", {0, 0, 0, 0});
  const auto run = [](const std::string& mtl, std::vector<std::string> options = {}) {
    write("a.mtl", mtl);
    return draw("a.obj",
                "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0.6\nvt 0.2 0.6\n"
                "vt 0.2 0.8\nvt 0 0.8\nf 1/1 2/2 3/3 4/4\n",
                std::move(options));
  };
  const auto opaque = [&](const std::string& mtl, std::vector<std::string> options = {}) {
    const std::string output = run(mtl, std::move(options)).output;
    return parse_ppm(output).at(20, 20)[1] > 100;
  };
  const std::string half = "newmtl m\nKd 1 1 1\nmap_Kd half.png\n";
  CHECK_FALSE(opaque(half));
  CHECK(opaque(half, {"--strict-mtl"}));
  CHECK_FALSE(opaque(half + "map_d half.png\n", {"--strict-mtl"}));
  CHECK(opaque("# Blender MTL File: 'None'\n# Material Count: 1\n" + half));
  CHECK_FALSE(opaque("# Blender MTL File: 'None'\n" + half + "map_d half.png\n"));
  CHECK_FALSE(opaque("# not of Blender\n" + half));
  const std::string none = "newmtl m\nKd 1 1 1\nmap_Kd none.png\n";
  CHECK(opaque(none));
  CHECK(has(run(none).errors,
            "none.png: this picture is transparent everywhere; it is drawn without its alpha"));
}

namespace {

std::string little_endian(std::initializer_list<float> values) {
  std::string bytes;
  for (const float value : values) bytes.append(reinterpret_cast<const char*>(&value), 4);
  return bytes;
}

std::string reversed_words(std::string bytes) {
  for (size_t i = 0; i + 3 < bytes.size(); i += 4)
    std::reverse(bytes.begin() + long(i), bytes.begin() + long(i) + 4);
  return bytes;
}

// A tetrahedron, as the others are below.
const std::string kTetrahedron = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
constexpr float kPlaces[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string text_stl() {
  std::string text = "solid t\n";
  for (const auto& face : kFaces) {
    text += " facet normal 0 0 1\n  outer loop\n";
    for (const int corner : face) {
      text += "   vertex";
      for (const float value : kPlaces[corner]) text += " " + std::to_string(value);
      text += "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid t\n";
}

std::string binary_stl() {
  std::string bytes = std::string(80, 's') + std::string("\4\0\0\0", 4);
  for (const auto& face : kFaces) {
    bytes += little_endian({0, 0, 1});
    for (const int corner : face)
      bytes += little_endian({kPlaces[corner][0], kPlaces[corner][1], kPlaces[corner][2]});
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string ply(const std::string& format) {
  std::string text = "ply\nformat " + format +
                     " 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
                     "z\nelement face 4\nproperty list int int vertex_indices\nend_header\n";
  const bool ascii = format == "ascii";
  std::string body;
  for (const auto& place : kPlaces)
    for (const float value : place) body += ascii ? std::to_string(value) + " " : little_endian({value});
  for (const auto& face : kFaces) {
    const int words[4] = {3, face[0], face[1], face[2]};
    for (const int word : words)
      body += ascii ? std::to_string(word) + " " : std::string(reinterpret_cast<const char*>(&word), 4);
  }
  return text + (format == "binary_big_endian" ? reversed_words(body) : body);
}

} // namespace

TEST_CASE("model formats: STL and PLY are drawn as the same OBJ file", "[models][formats]") {
  const std::vector<std::string> look = {"--up", "+Y", "--az", "30", "--el", "20"};
  const ProgramRun obj = draw("t.obj", kTetrahedron, look);
  CHECK(parse_ppm(obj.output).colors() > 1);
  const std::pair<const char*, std::string> files[] = {
      {"text.stl", text_stl()}, {"binary.stl", binary_stl()},           {"named.dat", binary_stl()},
      {"a.ply", ply("ascii")},  {"l.ply", ply("binary_little_endian")}, {"b.ply", ply("binary_big_endian")}};
  for (const auto& [name, bytes] : files) {
    INFO(name);
    const ProgramRun run = draw(name, bytes, look);
    CHECK(run.errors.empty());
    CHECK(run.output == obj.output);
    CHECK(has(run_softgl({"info", write(name, bytes)}).output, "4 triangles from 4 faces, 4 vertices"));
    for (size_t length = 0; length < bytes.size(); length += 37) { // whatever is cut off: drawn or refused
      const ProgramRun cut = run_softgl({"info", write("cut" + std::string(name), bytes.substr(0, length))});
      CHECK((cut.exit_code == 0 || cut.exit_code == 3));
      if (cut.exit_code == 3) CHECK(has(cut.errors, "softgl: error: "));
    }
  }
}

TEST_CASE("model formats: what STL and PLY files get wrong", "[models][formats]") {
  const ProgramRun cut = draw("cut.stl", binary_stl().substr(0, 84 + 50 * 3 + 20));
  CHECK(cut.exit_code == 0);
  CHECK(has(cut.errors, "cut.stl: the file is cut off: it has 3 of 4 triangles"));
  const ProgramRun words =
      draw("w.stl", "solid\nfacet\nvertex a b c\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n" + text_stl());
  CHECK(has(words.errors, "w.stl:3: a vertex needs three numbers; its facet is skipped"));
  std::string index = ply("ascii");
  index.replace(index.rfind("3 1 2 3"), 7, "3 1 2 9");
  CHECK(has(draw("i.ply", index).errors,
            "a face names a vertex that does not exist or is not finite (the file has 4)"));
  CHECK(has(draw("h.ply", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n").errors,
            "has no vertices with x, y and z"));
  CHECK(has(draw("h.ply", "ply\nformat ascii 1.0\nelement vertex 3\n").errors, "has no end of its header"));
  CHECK(has(draw("h.ply", "ply\nelement vertex 99999999999999999999\nend_header\n").errors,
            "count that is no number"));
}

TEST_CASE("model formats: only the first vertex element of a PLY file has vertices", "[models][formats]") {
  for (const int first : {0, 3}) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(first) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
      text += std::string("property float ") + name + "\n";
    text += "element vertex 3\nproperty float x\nelement face 1\nproperty list uchar int vertex_index\n"
            "end_header\n";
    for (int i = 0; i < first; ++i)
      text += std::to_string(i % 2) + " " + std::to_string(i / 2) + " 0 0 0 1\n";
    const ProgramRun run = draw("two.ply", text + "0\n1\n2\n3 0 1 2\n");
    INFO(run.errors);
    CHECK(run.exit_code == (first ? 0 : 3));
  }
}

TEST_CASE("model formats: properties of PLY vertices", "[models][formats]") {
  const auto middle = [](const std::string& type, const std::string& one, const std::string& zero) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    for (const char* name : {"red", "green", "blue"}) text += "property " + type + " " + name + "\n";
    text += "element other 1\nproperty list uchar int whatever\nelement face 1\nproperty list uchar int "
            "vertex_index\nend_header\n";
    for (const char* place : {"-1 -1 0 ", "1 -1 0 ", "1 1 0 ", "-1 1 0 "})
      text += place + zero + " " + one + " " + zero + "\n";
    const ProgramRun run = draw("c.ply", text + "2 7 8\n4 0 1 2 3\n");
    INFO(run.errors);
    const TestPicture picture = parse_ppm(run.output);
    const uint8_t* p = picture.at(20, 20);
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  const auto bytes = middle("uchar", "255", "0");
  CHECK(bytes[0] == 0);
  CHECK(bytes[1] > 150);
  CHECK(middle("float", "1", "0") == bytes);
  CHECK(middle("ushort", "65535", "0") == bytes);
}
