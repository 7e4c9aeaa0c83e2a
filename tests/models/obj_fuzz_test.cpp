// Random damage to OBJ and MTL files: whatever they hold, reading ends, stays within bounds and gives a
// finite mesh. SOFTGL_FUZZ_ROUNDS=n runs more rounds; under the asan preset this looks for reads out of
// bounds.
#include <catch2/catch.hpp>

#include "models/hard_files.h"
#include "models/program_runner.h"
#include "test_paths.h"

#include "command/model_loader.h"
#include "common/program_error.h"
#include "mesh/face_triangulation.h"
#include "mesh/mesh_builder.h"
#include "mesh/normal_generator.h"
#include "scene/camera.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

using namespace softgl;
using namespace softgl::test;

namespace {

using Random = std::mt19937;

const char* const kTokens[] = {"v ",         "vn ",
                               "vt ",        "f ",
                               "l ",         "p ",
                               "usemtl ",    "mtllib ",
                               "s ",         "o ",
                               "g ",         "\n",
                               "\r",         "\\\n",
                               "\\",         "#",
                               "/",          "//",
                               "-1",         "0",
                               "1e308",      "1e-320",
                               "nan",        "inf",
                               "-",          "99999999999999999999",
                               "2147483648", "-2147483648",
                               "newmtl ",    "map_Kd ",
                               "Kd ",        "d ",
                               "Tr ",        "-s ",
                               "-o ",        "checker.png",
                               "red",        "cstype ",
                               "\t",         " ",
                               "1/1/1",      "1//1",
                               ".",          "e",
                               "+",          "\"",
                               ":",          "C:\\",
                               "../",        "s off\n",
                               "f 1 2 3\n",  "\xef\xbb\xbf"};

std::string damaged(std::string text, Random& random) {
  const auto place = [&](size_t size) { return size ? random() % size : 0; };
  const int wounds = 1 + int(random() % 12);
  for (int i = 0; i < wounds; ++i) {
    const size_t at = place(text.size() + 1);
    switch (random() % 8) {
    case 0:
      if (at < text.size()) text[at] = char(random() % 256);
      break;
    case 1: text.insert(at, kTokens[random() % std::size(kTokens)]); break;
    case 2: text.erase(at, random() % 20); break;
    case 3: text.insert(at, text.substr(place(text.size() + 1), random() % 200)); break;
    case 4: text.resize(at); break;
    case 5: text.insert(at, 1, '\0'); break;
    case 6:
      if (at < text.size()) text[at] = char(text[at] ^ (1 << random() % 8));
      break;
    default:
      for (int k = 0; k < 5; ++k) text.insert(at, kTokens[random() % std::size(kTokens)]);
    }
    if (text.size() > 200000) text.resize(200000);
  }
  return text;
}

std::string soup(Random& random) {
  std::string text = random() % 2 ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvn 0 0 1\n" : "";
  const int tokens = int(random() % 400);
  for (int i = 0; i < tokens; ++i) text += kTokens[random() % std::size(kTokens)];
  return text;
}

void read_and_check(const std::string& text, const std::string& name, unsigned threads) {
  cli::RemarkList remarks;
  cli::Warnings warnings, notes;
  try {
    const cli::SourceText source = cli::SourceText::from_string(text, name);
    cli::LoadedModel loaded = cli::load_model(source, threads, remarks, warnings, notes);
    const cli::ModelFrame frame = cli::frame_model(loaded.model);
    cli::generate_normals(loaded.model, frame, {});
    const cli::Mesh mesh = cli::build_mesh(loaded.model, frame, loaded.library, {}, remarks);
    warnings.add(remarks, source);
    const size_t vertices = mesh.positions.size() / 3;
    bool good = mesh.normals.size() == mesh.positions.size();
    for (const uint32_t index : mesh.triangles) good &= index < vertices;
    for (const float value : mesh.positions) good &= std::fabs(value) <= 1.0f;
    for (const float value : mesh.normals) good &= std::fabs(value) <= 1.001f;
    for (const float value : mesh.texcoords) good &= std::isfinite(value);
    for (const float value : mesh.colors) good &= value >= 0 && value <= 1;
    const cli::Camera camera = cli::fit_camera(mesh, {});
    for (const double value : camera.view) good &= std::isfinite(value);
    for (const double value : camera.projection) good &= std::isfinite(value);
    REQUIRE(good);
    REQUIRE(warnings.sentences().size() < 1000);
  } catch (const cli::ProgramError& error) { REQUIRE(error.code == cli::kCannotRead); }
}

int rounds(int usual) {
  const char* text = std::getenv("SOFTGL_FUZZ_ROUNDS");
  return text ? std::atoi(text) : usual;
}

} // namespace

TEST_CASE("damaged OBJ files", "[models][fuzz]") {
  const std::string folder = write_hard_files();
  std::vector<std::string> seeds;
  for (const HardFile& file : hard_files())
    if (file.text.size() < 20000) seeds.push_back(file.text);
  seeds.push_back(read_bytes(std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/models/lantern.obj"));
  for (int round = 0; round < rounds(1500); ++round) {
    Random random{uint32_t(round)};
    INFO("round " << round);
    const std::string text = round % 5 == 0 ? soup(random) : damaged(seeds[random() % seeds.size()], random);
    read_and_check(text, folder + "damaged.obj", 1 + round % 2);
  }
}

TEST_CASE("damaged MTL files", "[models][fuzz]") {
  const std::string folder = write_hard_files();
  std::vector<std::string> seeds;
  for (const auto& [name, bytes] : hard_file_companions())
    if (name.ends_with(".mtl")) seeds.push_back(bytes);
  for (int round = 0; round < rounds(1500); ++round) {
    Random random{uint32_t(round)};
    INFO("round " << round);
    cli::MaterialLibrary library;
    cli::Warnings warnings, notes;
    const std::string text = round % 5 == 0 ? soup(random) : damaged(seeds[random() % seeds.size()], random);
    library.read(cli::SourceText::from_string(text, "damaged.mtl"), cli::ModelFiles(folder + "damaged.mtl"),
                 folder, warnings, notes);
    bool good = true;
    for (const cli::Material& material : library.materials()) {
      for (const float* color : {material.ambient, material.diffuse, material.specular, material.emission})
        for (int i = 0; i < 3; ++i) good &= color[i] >= 0 && color[i] <= 1;
      good &= material.opacity >= 0 && material.opacity <= 1 && material.shininess >= 0 &&
              material.shininess <= 128;
    }
    REQUIRE(good);
  }
}
