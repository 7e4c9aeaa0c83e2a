// softgl-mpi: several processes draw the bytes that one draws.
#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "test_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sys/stat.h>

using namespace softgl::test;
namespace fs = std::filesystem;

namespace {

std::string folder() { return output_folder("mpi"); }

std::string write(const std::string& name, const std::string& text) {
  const std::string path = folder() + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string program() { return std::string(SOFTGL_TEST_BINARY_DIR) + "/softgl-mpi"; }

// False, and said, where MPI is missing: the program is built where CMake finds it.
bool can_run() {
  if (!fs::exists(program())) {
    WARN("SKIPPED: softgl-mpi is not built (Debian: openmpi-bin, libopenmpi-dev; left out under sanitizers)");
    return false;
  }
  if (std::system("command -v mpirun > /dev/null 2>&1") != 0) {
    WARN("SKIPPED: there is no mpirun (Debian: openmpi-bin)");
    return false;
  }
  return true;
}

// In a container as root, on one machine, whatever its network is.
const std::vector<std::string> kEnvironment = {"OMPI_ALLOW_RUN_AS_ROOT=1",
                                               "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                                               "OMPI_MCA_rmaps_base_oversubscribe=1",
                                               "OMPI_MCA_btl=vader,self",
                                               "OMPI_MCA_btl_vader_single_copy_mechanism=none",
                                               "OMPI_MCA_btl_vader_backing_directory=/tmp",
                                               "OMPI_MCA_oob_tcp_if_include=lo",
                                               "OMPI_MCA_plm_rsh_agent=false",
                                               "OMPI_MCA_mpi_yield_when_idle=1",
                                               "OMPI_MCA_hwloc_base_binding_policy=none"};

// One process needs no mpirun.
ProgramRun run(int processes, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program()};
  std::vector<std::string> environment = kEnvironment;
  if (processes > 1)
    words = {"mpirun", "-q", "--timeout", "100", "-n", std::to_string(processes), program()};
  else
    environment.push_back("OMPI_MCA_ess_singleton_isolated=1");
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_command(words, {}, environment);
}

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// The picture's bytes of that many processes, which must have gone well.
std::string draw(int processes, const std::vector<std::string>& arguments) {
  const std::string path = folder() + "drawn.ppm";
  fs::remove(path);
  const ProgramRun done = run(processes, with(arguments, {"-o", path, "--size", "96x64"}));
  INFO(done.errors);
  CHECK(done.exit_code == 0);
  return read_bytes(path);
}

std::string draw_alone(const std::vector<std::string>& arguments) {
  const ProgramRun done = run_softgl(with(arguments, {"-o", "-", "--format", "ppm", "--size", "96x64"}));
  INFO(done.errors);
  CHECK(done.exit_code == 0);
  return done.output;
}

std::string number(double value) { return std::to_string(value); }

// Parts that one file can hold, too, one after the other: `first` is the number of the next vertex.
struct Parts {
  std::vector<std::string> texts;
  std::string whole = "mtllib parts.mtl\n";
  int first = 1;

  void add(const std::string& material, const std::vector<std::string>& vertices,
           const std::vector<std::vector<int>>& faces, const std::string& keyword = "f") {
    std::string text = "mtllib parts.mtl\n";
    for (std::string* to : {&text, &whole}) {
      *to += "usemtl " + material + "\n";
      for (const std::string& vertex : vertices) *to += "v " + vertex + "\n";
      for (const std::vector<int>& face : faces) {
        *to += keyword;
        for (const int corner : face) *to += " " + std::to_string(to == &text ? corner : first + corner - 1);
        *to += "\n";
      }
    }
    first += int(vertices.size());
    texts.push_back(text);
  }

  static void write_materials() {
    write("parts.mtl", "newmtl red\nKd .9 .2 .1\nnewmtl green\nKd .1 .7 .2\nKs .6 .6 .6\nNs 20\n"
                       "newmtl blue\nKd .2 .3 .9\nnewmtl glass\nKd 1 1 1\nd .5\n");
  }
  std::vector<std::string> write_parts(const std::string& name) const {
    write_materials();
    std::vector<std::string> paths;
    for (size_t i = 0; i < texts.size(); ++i)
      paths.push_back(write(name + std::to_string(i) + ".obj", texts[i]));
    return paths;
  }
  std::string write_whole(const std::string& name) const {
    write_materials();
    return write(name + ".obj", whole);
  }
};

const char* color_of(size_t i) { return std::vector<const char*>{"red", "green", "blue"}[i % 3]; }

// Balls that stick in each other.
Parts balls() {
  Parts parts;
  for (int ball = 0; ball < 7; ++ball) {
    constexpr int kRows = 8, kColumns = 12;
    std::vector<std::string> vertices;
    std::vector<std::vector<int>> faces;
    for (int row = 0; row <= kRows; ++row)
      for (int column = 0; column < kColumns; ++column) {
        const double t = 3.14159 * (row + .5) / (kRows + 1), p = 6.28318 * column / kColumns;
        vertices.push_back(number(.7 * ball - 2 + std::sin(t) * std::cos(p)) + " " +
                           number(.4 * (ball % 3) + std::cos(t)) + " " +
                           number(.3 * (ball % 2) + std::sin(t) * std::sin(p)));
        if (row == kRows) continue;
        const int a = row * kColumns + column + 1, b = row * kColumns + (column + 1) % kColumns + 1;
        faces.push_back({a, b, b + kColumns, a + kColumns});
      }
    parts.add(color_of(size_t(ball)), vertices, faces);
  }
  return parts;
}

} // namespace

TEST_CASE("mpi: any number of processes draws the bytes of softgl", "[mpi]") {
  if (!can_run()) return;
  const Parts parts = balls();
  const std::vector<std::string> files = with(parts.write_parts("ball"), {"--up", "+Y"});
  const std::string whole = parts.write_whole("balls");
  const std::string expected = draw_alone({whole, "--up", "+Y"});
  CHECK(parse_ppm(expected).colors() > 100);
  for (int processes = 1; processes <= 4; ++processes) {
    INFO(processes << " processes");
    CHECK((draw(processes, files) == expected));
  }
  CHECK((draw(9, files) == expected)); // more processes than parts
  // Which axis points up is guessed from all parts.
  const std::vector<std::string> guessed(files.begin(), files.end() - 2);
  CHECK((draw(2, guessed) == draw_alone({whole})));
  CHECK((draw(3, with(files, {"--deal", "turns"})) == expected));
  const std::vector<std::string> look = {"--aa",       "4",     "--view", "front",           "--ortho",
                                         "--shading",  "phong", "--bg",   "#aabbcc:#224466", "--light",
                                         "three-point"};
  CHECK(
      (draw(4, with(files, with(look, {"--radix", "4"}))) == draw_alone(with({whole, "--up", "+Y"}, look))));
}

TEST_CASE("mpi: of equal depths the last part's is seen, whoever draws it", "[mpi]") {
  if (!can_run()) return;
  // Each square a color of its own, which the order of materials cannot tell: that of its vertices.
  std::string whole;
  int first = 1;
  std::vector<std::string> files;
  for (int i = 0; i < 9; ++i) {
    const double x = i % 3 * .4, y = i / 3 * .4 + i % 2 * .1;
    const std::string color =
        " " + number(i % 3 * .5) + " " + number(i / 3 * .5) + " " + number(i % 2) + "\n";
    std::string text;
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      text += "v " + number(x + dx) + " " + number(y + dy) + " 0" + color;
    files.push_back(write("square" + std::to_string(i) + ".obj", text + "f 1 2 3 4\n"));
    whole += text + "f " + std::to_string(first) + " " + std::to_string(first + 1) + " " +
             std::to_string(first + 2) + " " + std::to_string(first + 3) + "\n";
    first += 4;
  }
  const std::vector<std::string> look = {"--up", "+Y", "--view", "front"};
  const std::string expected = draw_alone(with({write("squares.obj", whole)}, look));
  CHECK(parse_ppm(expected).colors() == 10);
  for (const auto& [processes, deal] : {std::pair{1, "blocks"}, {2, "turns"}, {3, "blocks"}, {4, "turns"}}) {
    INFO(processes << " processes, " << deal);
    CHECK((draw(processes, with(with(files, look), {"--deal", deal})) == expected));
  }
  // The other way round another one is on top.
  std::vector<std::string> reversed(files.rbegin(), files.rend());
  CHECK((draw(2, with(reversed, look)) != expected));
}

TEST_CASE("mpi: lines and points of one part lie over the surfaces of all", "[mpi]") {
  if (!can_run()) return;
  Parts parts;
  const std::vector<std::string> square = {"0 0 0", "1 0 0", "1 1 0", "0 1 0"};
  const std::vector<std::string> shifted = {".5 .5 0", "1.5 .5 0", "1.5 1.5 0", ".5 1.5 0"};
  parts.add("red", square, {{1, 2, 3, 4}});
  parts.add("green", {"0 .2 0", "1.5 1.2 0", ".2 1 0", "1.2 .1 0"}, {{1, 2}, {3, 4}}, "l");
  parts.add("blue", {"0.5 0.5 0", "1 1 0", ".7 .1 0"}, {{1}, {2}, {3}}, "p");
  parts.add("green", shifted, {{1, 2, 3, 4}});
  parts.add("red", {"0 1 0", "1.5 .3 0", ".1 .1 0", "1.4 1.4 0"}, {{1, 2}, {3, 4}}, "l");
  const std::vector<std::string> look = {"--up", "+Y", "--view", "front", "--el", "10"};
  const std::string expected = draw_alone(with({parts.write_whole("mixed")}, look));
  const std::vector<std::string> files = with(parts.write_parts("mixed"), look);
  CHECK((draw(1, files) == expected));
  CHECK((draw(2, files) == expected));
  CHECK((draw(3, with(files, {"--deal", "turns"})) == expected));
}

TEST_CASE("mpi: a plane that is seen from its edge is drawn by its edges", "[mpi]") {
  if (!can_run()) return;
  Parts parts;
  parts.add("red", {"0 0 0", "1 0 0", "1 0 1"}, {{1, 2, 3}});
  parts.add("red", {"1 0 0", "2 0 0", "2 0 1"}, {{1, 2, 3}});
  const std::vector<std::string> look = {"--up", "+Y", "--view", "front", "--ortho"};
  const std::string expected = draw_alone(with({parts.write_whole("edge")}, look));
  CHECK(parse_ppm(expected).colors() == 2);
  CHECK((draw(2, with(parts.write_parts("edge"), look)) == expected));
}

TEST_CASE("mpi: what cannot be composed is refused with one sentence", "[mpi]") {
  if (!can_run()) return;
  const std::string part = balls().write_parts("ball")[0];
  const std::string output = folder() + "none.png";
  const auto refused = [&](const std::vector<std::string>& more, int code, const std::string& sentence) {
    const ProgramRun done = run(1, with({part, "--up", "+Y"}, more));
    INFO(done.errors);
    CHECK(done.exit_code == code);
    CHECK(has(done.errors, sentence));
    CHECK(std::count(done.errors.begin(), done.errors.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(output));
  };
  refused({"-o", output, "--ground"}, 2, "the shadow of --ground");
  refused({"-o", output, "--edges", "sharp"}, 2, "no --edges");
  refused({"-o", output, "--pass", "depth"}, 2, "not --pass depth");
  refused({"-o", output, "--bits", "16"}, 2, "no --bits 16");
  refused({"--turntable", "4", "-o", folder() + "{n}.png"}, 2, "one picture of one view");
  refused({"-o", output, "--deal", "cards"}, 2, "--deal is blocks or turns");
  refused({"-o", output, "--radix", "1"}, 2, "--radix is a number");
  refused({"-o", output, "--aa", "3"}, 2, "--aa");
  const std::string glass =
      write("glass.obj", "mtllib parts.mtl\nusemtl glass\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  refused({"-o", output, glass}, 3, "material \"glass\" is transparent");
}

namespace {

// A rough sheet with everything that makes a file hard to cut: vertices that stand far from their faces,
// relative indices, smoothing groups and materials that hold for many lines, normals and colors for some
// corners only.
std::string sheet(bool vertices_first) {
  constexpr int kSide = 30;
  std::mt19937 random(17);
  const auto chance = [&random](unsigned percent) { return random() % 100 < percent; };
  std::string vertices, text = "mtllib parts.mtl\n", faces;
  const auto say = [&](const std::string& line) { (vertices_first ? faces : text) += line + "\n"; };
  int last = 0;
  for (int row = 0; row <= kSide; ++row) {
    for (int column = 0; column <= kSide; ++column, ++last) {
      std::string& to = vertices_first ? vertices : text;
      to += "v " + number(column * .1) + " " + number((random() % 100) * .004) + " " + number(row * .1);
      if (row > kSide / 2) to += " " + number((random() % 10) * .1) + " .5 .2";
      to += "\n";
      if (chance(20)) to += "vn " + number((random() % 10) * .1) + " 1 0\n";
    }
    if (row % 7 == 3) say("s " + std::string(chance(30) ? "off" : chance(50) ? "1" : "2"));
    if (row % 5 == 2) say(std::string("usemtl ") + color_of(random() % 3));
    for (int column = 0; row > 0 && column < kSide; ++column) {
      const int corner = row * (kSide + 1) + column + 1; // its number, from 1
      const int four[4] = {corner - kSide - 1, corner - kSide, corner + 1, corner};
      std::string face = "f";
      const int count = chance(30) ? 3 : 4;
      for (int i = 0; i < count; ++i) {
        const bool relative = !vertices_first && chance(50);
        face += " " + std::to_string(relative ? four[i] - last - 1 : four[i]);
        if (chance(20)) face += "//" + std::to_string(random() % 20 + 1);
      }
      say(face);
      if (chance(3)) say("l " + std::to_string(four[0]) + " " + std::to_string(four[2]));
      if (chance(3)) say("p " + std::to_string(four[1]));
    }
  }
  for (int i = 0; i < 20; ++i) { // from one end of the sheet to the other
    std::string face = "f";
    for (int k = 0; k < 3; ++k) face += " " + std::to_string(random() % unsigned(last) + 1);
    say(face);
  }
  return vertices + text + faces;
}

} // namespace

TEST_CASE("mpi: one file is read in stretches, and the picture is that of the whole", "[mpi]") {
  if (!can_run()) return;
  balls().write_parts("ball"); // the materials
  for (const bool vertices_first : {false, true}) {
    const std::string file = write("sheet.obj", sheet(vertices_first));
    const std::string expected = draw_alone({file});
    CHECK(parse_ppm(expected).colors() > 500);
    for (int processes = 2; processes <= 4; ++processes) {
      if (vertices_first && processes == 2) continue;
      INFO(processes << " processes");
      CHECK((draw(processes, {file}) == expected));
    }
  }
  // Vertices that no face names are points. Faces with vertices of their own are smooth across their places.
  std::string cloud, soup;
  for (int i = 0; i < 200; ++i)
    cloud += "v " + number(i % 7) + " " + number(i % 5) + " " + number(i % 11) + "\n";
  for (int i = 0; i < 200; ++i) {
    const auto place = [](int x, int z) {
      return "v " + number(x * .1) + " " + number(.02 * (x * z % 7)) + " " + number(z * .1) + "\n";
    };
    const int x = i / 20, z = i % 20;
    soup += place(x, z) + place(x, z + 1) + place(x + 1, z + 1) + "f -3 -2 -1\n";
    soup += place(x, z) + place(x + 1, z + 1) + place(x + 1, z) + "f -3 -2 -1\n";
  }
  for (const std::string& text : {cloud, soup}) {
    const std::string file = write("places.obj", text);
    CHECK((draw(3, {file}) == draw_alone({file})));
  }
}

TEST_CASE("mpi: a failure of one process ends all with its sentence", "[mpi]") {
  if (!can_run()) return;
  std::vector<std::string> files = balls().write_parts("ball");
  const std::string output = folder() + "failed.png";
  const auto failed = [&](const std::vector<std::string>& arguments, int code, const std::string& sentence) {
    std::vector<std::string> words = with(arguments, {"--up", "+Y"});
    if (std::count(words.begin(), words.end(), "-o") == 0) words = with(words, {"-o", output});
    const ProgramRun done = run(3, words);
    INFO(done.errors);
    CHECK(done.exit_code == code);
    CHECK(has(done.errors, "softgl-mpi: error: " + sentence));
    CHECK(done.errors.find("error:") == done.errors.rfind("error:"));
    CHECK_FALSE(fs::exists(output));
  };
  std::vector<std::string> broken = files;
  broken[5] = write("broken.obj", "v 0 0 0\nno faces\n");
  failed(broken, 3, broken[5] + ": no geometry");
  broken[2] = folder() + "missing.obj";
  failed(broken, 3, broken[2] + ": cannot open");      // the lowest rank that fails is heard
  failed({broken[5]}, 3, broken[5] + ": no geometry"); // one file, of which each reads a stretch
  failed(with(files, {"-o", folder() + "no/such/folder.png"}), 4, "");
}

TEST_CASE("mpi: a process that dies ends all", "[mpi]") {
  if (!can_run()) return;
  const std::vector<std::string> files = balls().write_parts("ball");
  const std::string output = folder() + "died.png", pipe = folder() + "pipe.obj";
  // The second process reads from a pipe that nobody writes to, until it is killed; the first one waits for
  // it.
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string wait_and_kill = "\"$@\" & sleep 0.7; kill -9 $!; wait $!; kill -9 $$";
  const std::vector<std::string> words = {
      "mpirun",      "-q", "--timeout", "100",    "-n", "1",    program(), files[0], pipe,
      "--up",        "+Y", "-o",        output,   ":",  "-n",   "1",       "sh",     "-c",
      wait_and_kill, "sh", program(),   files[0], pipe, "--up", "+Y",      "-o",     output};
  const ProgramRun done = run_command(words, {}, kEnvironment);
  INFO(done.errors);
  CHECK(done.exit_code == 137);
  CHECK_FALSE(fs::exists(output));
}
