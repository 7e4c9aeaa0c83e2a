// The program from outside: exit codes, messages, formats, standard input and output.
#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "test_paths.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

using namespace softgl::test;

namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string folder() { return output_folder("program"); }

std::string write(const std::string& name, const std::string& text) {
  std::ofstream(folder() + name, std::ios::binary) << text;
  return folder() + name;
}

ProgramRun draw(const std::string& text, std::vector<std::string> options = {}) {
  std::vector<std::string> arguments = {
      write("model.obj", text), "-o", "-", "--format", "ppm", "--size", "60x40"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_softgl(arguments);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

size_t lines(const std::string& text) { return size_t(std::count(text.begin(), text.end(), '\n')); }

} // namespace

TEST_CASE("program: wrong usage is exit code 2 and one sentence", "[models][program]") {
  const std::string model = write("usage.obj", kTriangle);
  const std::vector<std::string> mistakes[] = {{},
                                               {model},
                                               {model, "-o"},
                                               {model, "-o", "x.xyz"},
                                               {model, "-o", "-", "--format", "xyz"},
                                               {model, "-o", "x.png", "--size", "0x10"},
                                               {model, "-o", "x.png", "--size", "10x"},
                                               {model, "-o", "x.png", "--size", "99999"},
                                               {model, "-o", "x.png", "--view", "sideways"},
                                               {model, "-o", "x.png", "--up", "W"},
                                               {model, "-o", "x.png", "--bg", "#12"},
                                               {model, "-o", "x.png", "--bg", "nocolor"},
                                               {model, "-o", "x.png", "--color", "2,0,0"},
                                               {model, "-o", "x.png", "--light", "0,0,0"},
                                               {model, "-o", "x.png", "--aa", "3"},
                                               {model, "-o", "x.png", "--fov", "0"},
                                               {model, "-o", "x.png", "--zoom", "nan"},
                                               {model, "-o", "x.png", "--threads", "0"},
                                               {model, "-o", "x.png", "--nonsense"},
                                               {model, "more.obj", "-o", "x.png"},
                                               {model, "-o", "x.png", "--size", "9000x9000", "--aa", "4"},
                                               {"info"}};
  for (const auto& arguments : mistakes) {
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    INFO(line);
    const ProgramRun run = run_softgl(arguments);
    INFO(run.errors);
    CHECK(run.exit_code == 2);
    CHECK(run.output.empty());
    CHECK(lines(run.errors) == 1);
    CHECK(run.errors.rfind("softgl: ", 0) == 0);
  }
}

TEST_CASE("program: help and version", "[models][program]") {
  const ProgramRun help = run_softgl({"--help"});
  CHECK(help.exit_code == 0);
  for (const char* part : {"--size", "--view", "--light", "Examples:", "Exit codes:"})
    CHECK(has(help.output, part));
  const ProgramRun version = run_softgl({"--version"});
  CHECK(version.exit_code == 0);
  CHECK(version.output.rfind("softgl ", 0) == 0);
}

TEST_CASE("program: what cannot be read is exit code 3", "[models][program]") {
  const std::string picture = folder() + "unread.png";
  std::filesystem::remove(picture);
  const struct {
    std::string model, sentence;
  } cases[] = {{folder() + "absent.obj", "absent.obj: cannot open: No such file or directory"},
               {write("empty.obj", ""), "no geometry; the file is empty"},
               {write("words.obj", "These are words.\n"), "no geometry"},
               {write("page.obj", "\n <html></html>"), "file looks like HTML"},
               {write("rejected.obj", "v 0 0 0\nf 1 2 3\n"), "no geometry"}};
  for (const auto& c : cases) {
    const ProgramRun run = run_softgl({c.model, "-o", picture});
    INFO(run.errors);
    CHECK(run.exit_code == 3);
    CHECK(has(run.errors, c.sentence));
    CHECK(run.output.empty());
    CHECK_FALSE(std::filesystem::exists(picture));
  }
}

TEST_CASE("program: what cannot be written is exit code 4", "[models][program]") {
  const std::string model = write("triangle.obj", kTriangle);
  for (const std::string& output :
       {folder() + "no/such/folder/x.png", folder() + "." + "/", std::string("/dev/full")}) {
    const ProgramRun run = run_softgl({model, "-o", output, "--format", "png", "--size", "64x64"});
    INFO(run.errors);
    CHECK(run.exit_code == 4);
    CHECK(has(run.errors, "cannot write"));
    CHECK(lines(run.errors) == 1);
  }
}

TEST_CASE("program: messages name file and line", "[models][program]") {
  const ProgramRun run = draw(kTriangle + "f 1 2 7\nnonsense 1\nnonsense 2\n");
  CHECK(run.exit_code == 0);
  CHECK(has(run.errors,
            "model.obj:5: a corner names a vertex that does not exist (the file has 3); face skipped\n"));
  CHECK(has(run.errors, "model.obj:6: unknown statement \"nonsense\" ignored (2 times)\n"));
  CHECK(parse_ppm(run.output).colors() > 1);
  const ProgramRun quiet = draw(kTriangle + "f 1 2 7\n", {"--quiet"});
  CHECK(quiet.errors.empty());
  CHECK(quiet.exit_code == 0);
  const ProgramRun strict = draw(kTriangle + "f 1 2 7\n", {"--strict"});
  CHECK(strict.exit_code == 3);
  CHECK(strict.output.empty());
  CHECK(has(strict.errors, "1 warning with --strict"));
  CHECK(draw(kTriangle, {"--strict"}).exit_code == 0);
}

TEST_CASE("program: a file whose elements have no vertices says where they stand", "[models][program]") {
  const ProgramRun faces = draw("# no vertices\nf 1 2 3\nf 4 5 6\n");
  CHECK(faces.exit_code == 3);
  for (const char* place : {"model.obj:2: ", "model.obj:3: "})
    CHECK(has(
        faces.errors,
        place + std::string("a corner names a vertex that does not exist (the file has 0); face skipped\n")));
  CHECK(has(faces.errors, "no geometry"));
  for (const char* elements : {"l 1 2\n", "p 1\n"}) {
    const ProgramRun run = draw(elements);
    CHECK(run.exit_code == 3);
    CHECK(lines(run.errors) == 2);
  }
  const ProgramRun prose = draw("These are words.\nThat is no model.\n");
  CHECK(prose.exit_code == 3);
  CHECK(lines(prose.errors) == 1);
}

TEST_CASE("program: standard input and output", "[models][program]") {
  const ProgramRun direct = draw(kTriangle);
  const ProgramRun piped = run_softgl({"-", "-o", "-", "--format", "ppm", "--size", "60x40"}, kTriangle);
  CHECK(piped.exit_code == 0);
  CHECK(piped.output == direct.output);
  const ProgramRun png = run_softgl({"-", "-o", "-", "--size", "60x40", "--stats", "json"}, kTriangle);
  CHECK(png.output.rfind("\x89PNG", 0) == 0);
  CHECK(has(png.errors, "\"triangles\": 1"));
  CHECK(has(run_softgl({"-", "-o", "-"}, "rubbish").errors, "standard input: no geometry"));
}

TEST_CASE("program: every picture format begins as it should", "[models][program]") {
  const std::string model = write("formats.obj", kTriangle);
  const struct {
    const char* end;
    std::string start;
  } formats[] = {{"png", "\x89PNG\r\n\x1a\n"},
                 {"ppm", "P6\n60 40\n255\n"},
                 {"pam", "P7\n"},
                 {"jpg", "\xff\xd8\xff"},
                 {"bmp", "BM"},
                 {"tga", std::string("\0\0", 2)}};
  for (const auto& format : formats) {
    INFO(format.end);
    const std::string picture = folder() + "picture." + format.end;
    REQUIRE(run_softgl({model, "-o", picture, "--size", "60x40"}).exit_code == 0);
    CHECK(read_bytes(picture).rfind(format.start, 0) == 0);
  }
}

TEST_CASE("program: backgrounds", "[models][program]") {
  const auto corner = [](const ProgramRun& run) {
    const TestPicture picture = parse_ppm(run.output);
    const uint8_t* p = picture.at(0, 0);
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  CHECK(corner(draw(kTriangle, {"--bg", "#123456"})) == std::array<int, 3>{0x12, 0x34, 0x56});
  CHECK(corner(draw(kTriangle, {"--bg", "SteelBlue"})) == std::array<int, 3>{0x46, 0x82, 0xb4});
  CHECK(corner(draw(kTriangle, {"--bg", "1,0,0.5"})) == std::array<int, 3>{255, 0, 128});
  const ProgramRun transparent = run_softgl({write("t.obj", kTriangle), "-o", "-", "--format", "pam", "--bg",
                                             "transparent", "--size", "60x40", "--aa", "4"});
  const std::string header = "P7\nWIDTH 60\nHEIGHT 40\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n";
  REQUIRE(transparent.output.rfind(header, 0) == 0);
  REQUIRE(transparent.output.size() == header.size() + 60 * 40 * 4);
  size_t clear = 0, solid = 0, edge = 0;
  for (size_t i = header.size() + 3; i < transparent.output.size(); i += 4) {
    const auto alpha = uint8_t(transparent.output[i]);
    (alpha == 0 ? clear : alpha == 255 ? solid : edge)++;
  }
  CHECK(clear > 500);
  CHECK(solid > 300);
  CHECK(edge > 10);
  CHECK(edge < 200);
}

TEST_CASE("program: antialiasing changes edges only", "[models][program]") {
  const std::string quad = "v -1 -1 0\nv 1 -1 0.2\nv 1 1 0\nv -1 1 0.2\nf 1 2 3 4\n";
  const auto picture = [&](const char* samples) {
    return parse_ppm(draw(quad, {"--aa", samples, "--shading", "flat"}).output);
  };
  const TestPicture one = picture("1"), four = picture("4"), sixteen = picture("16");
  CHECK(four.colors() > one.colors());
  CHECK(sixteen.colors() >= four.colors());
  size_t different = 0;
  for (size_t i = 0; i < one.rgb.size(); i += 3)
    different += !std::equal(&one.rgb[i], &one.rgb[i] + 3, &four.rgb[i]);
  CHECK(different < 60 * 40 / 8);
}

TEST_CASE("program: a surface seen from its edge is not a blank picture", "[models][program]") {
  const ProgramRun edge_on = draw("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nf 1 2 3\n", {"--view", "front"});
  CHECK(edge_on.exit_code == 0);
  CHECK(has(edge_on.errors, "their edges are drawn instead"));
  CHECK(parse_ppm(edge_on.output).colors() > 1);
  CHECK(draw("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n").exit_code == 0);
}

TEST_CASE("program: two-sided, so that mixed winding does not show", "[models][program]") {
  const ProgramRun same = draw("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 3 4\n",
                               {"--view", "front", "--shading", "flat"});
  const ProgramRun mixed = draw("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3\nf 1 4 3\n",
                                {"--view", "front", "--shading", "flat"});
  CHECK(parse_ppm(same.output).drawn().right == parse_ppm(mixed.output).drawn().right);
  CHECK(parse_ppm(mixed.output).colors() == 2);
}

TEST_CASE("program: transparent faces let the others through", "[models][program]") {
  write("glass.mtl", "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\nd 0.5\nillum 0\n");
  // The glass is nearer but stands first in the file.
  const std::string model =
      "mtllib glass.mtl\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
      "usemtl glass\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\n";
  const TestPicture picture = parse_ppm(draw(model, {"--view", "front"}).output);
  const uint8_t* middle = picture.at(30, 20);
  CHECK(middle[0] > 60);
  CHECK(middle[2] > 120);
}

TEST_CASE("program: threads and light", "[models][program]") {
  const ProgramRun one = draw(kTriangle, {"--threads", "1"}), two = draw(kTriangle, {"--threads", "2"});
  CHECK(one.output == two.output);
  for (const char* light : {"headlight", "1,2,3", "model:0,1,0", "+Z", "at:0,0,5"}) {
    INFO(light);
    CHECK(draw(kTriangle, {"--light", light}).exit_code == 0);
  }
  CHECK(draw(kTriangle, {"--light", "-1,0,0.1"}).output != draw(kTriangle, {"--light", "headlight"}).output);
}

TEST_CASE("program: info", "[models][program]") {
  const std::string model =
      write("info.obj", "o thing\nv 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4\nl 1 2\np 3\n");
  const ProgramRun json = run_softgl({"info", model, "--json"});
  CHECK(json.exit_code == 0);
  for (const char* part : {"\"vertices\": 4", "\"faces\": 1", "\"triangles\": 2", "\"line_segments\": 1",
                           "\"points\": 1", "\"objects\": 1", "\"low\": [0, 0, 0]", "\"high\": [2, 3, 0]",
                           "\"area\": 6", "\"warning_count\": 0"}) {
    INFO(part);
    CHECK(has(json.output, part));
  }
  CHECK(has(run_softgl({"info", model}).output, "2 triangles from 1 faces, 4 vertices"));
  CHECK(run_softgl({"info", folder() + "absent.obj"}).exit_code == 3);
}

TEST_CASE("program: the model that comes with softgl", "[models][program]") {
  const std::string model = std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/models/lantern.obj";
  const ProgramRun run = run_softgl({model, "-o", "-", "--format", "ppm", "--size", "300x375", "--strict"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors.empty());
  const TestPicture picture = parse_ppm(run.output);
  CHECK(picture.colors() > 2000); // texture, glass and highlights are all there
  const auto box = picture.drawn();
  CHECK(box.top <= 6);
  CHECK(box.bottom >= 375 - 7);
}

TEST_CASE("program: a file of vertices only is a point cloud", "[models][program]") {
  const ProgramRun cloud = draw("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\n");
  CHECK(cloud.exit_code == 0);
  CHECK(has(cloud.errors, "the vertices are drawn as points"));
  CHECK(parse_ppm(cloud.output).colors() == 2);
}
