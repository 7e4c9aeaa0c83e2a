// Every hard file is read as it should be, and drawn or refused by the program with the right exit code.
#include <catch2/catch.hpp>

#include "models/hard_files.h"
#include "models/program_runner.h"

#include "command/model_loader.h"
#include "common/compressed_text.h"
#include "common/program_error.h"
#include "mesh/face_triangulation.h"
#include "mesh/mesh_builder.h"
#include "mesh/normal_generator.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace softgl;
using namespace softgl::test;

namespace {

const std::string& folder() {
  static const std::string written = write_hard_files();
  return written;
}

struct Reading {
  cli::LoadedModel loaded;
  cli::ModelFrame frame;
  cli::Mesh mesh;
  cli::Warnings warnings, notes;
  double area = 0;
  std::string error;
  int exit_code = 0;
};

Reading read(const std::string& name, unsigned threads = 1) {
  Reading result;
  const cli::SourceText text = cli::open_text(folder() + name + ".obj");
  cli::RemarkList remarks;
  try {
    result.loaded = cli::load_model(text, threads, remarks, result.warnings, result.notes);
    result.area = cli::surface_area(result.loaded.model);
    result.frame = cli::frame_model(result.loaded.model);
    cli::generate_normals(result.loaded.model, result.frame, {});
    result.mesh = cli::build_mesh(result.loaded.model, result.frame, result.loaded.library, {}, remarks);
    result.warnings.add(remarks, text);
  } catch (const cli::ProgramError& error) {
    result.error = error.what();
    result.exit_code = error.code;
  }
  return result;
}

bool contains(const std::vector<std::string>& sentences, const std::string& part) {
  for (const std::string& sentence : sentences)
    if (sentence.find(part) != std::string::npos) return true;
  return false;
}

const cli::Material& material_of(const Reading& reading, size_t batch) {
  return reading.loaded.library.materials()[reading.mesh.triangle_batches.at(batch).material];
}

std::array<float, 3> diffuse_of(const Reading& reading, size_t batch) {
  const float* rgb = material_of(reading, batch).diffuse;
  return {rgb[0], rgb[1], rgb[2]};
}

const cli::Material& named(const Reading& reading, const std::string& name) {
  const uint32_t number = reading.loaded.library.find(name);
  REQUIRE(number != 0);
  return reading.loaded.library.materials()[number];
}

using Rgb = std::array<float, 3>;

} // namespace

TEST_CASE("hard files: geometry, warnings and errors", "[models]") {
  REQUIRE(hard_files().size() == 75);
  for (const HardFile& file : hard_files()) {
    INFO(file.name);
    const Reading reading = read(file.name);
    for (const std::string& warning : reading.warnings.sentences()) UNSCOPED_INFO(warning);
    CHECK(reading.exit_code == file.exit_code);
    CHECK(reading.error.find(file.error) != std::string::npos);
    CHECK(reading.loaded.report.triangles * (file.exit_code == 0) == file.triangles);
    CHECK(reading.mesh.triangles.size() / 3 == file.triangles);
    CHECK(reading.mesh.segment_positions.size() / 6 == file.segments);
    CHECK(reading.mesh.point_positions.size() / 3 == file.points);
    if (file.area >= 0) CHECK(reading.area == Approx(file.area));
    for (const std::string& warning : file.warnings) {
      INFO("expected: " << warning);
      CHECK(contains(reading.warnings.sentences(), warning));
    }
    if (file.warnings.empty()) CHECK(reading.warnings.count() == 0);
    // Whatever the file: nothing that reaches GL is infinite or no number.
    for (const float value : reading.mesh.positions) REQUIRE(std::fabs(value) <= 1.0f);
    for (size_t i = 0; i < reading.mesh.normals.size(); i += 3) {
      const float* n = &reading.mesh.normals[i];
      REQUIRE(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] == Approx(1).margin(1e-5));
    }
  }
}

TEST_CASE("hard files: the program draws them or says why not", "[models][program]") {
  for (const HardFile& file : hard_files()) {
    INFO(file.name);
    const std::string picture = folder() + file.name + ".ppm";
    std::filesystem::remove(picture);
    const ProgramRun run = run_softgl({folder() + file.name + ".obj", "-o", picture, "--size", "64x64"});
    INFO(run.errors);
    CHECK(run.exit_code == file.exit_code);
    CHECK(run.output.empty());
    CHECK(run.errors.find(file.error) != std::string::npos);
    CHECK(std::filesystem::exists(picture) == (file.exit_code == 0));
    CHECK(run.errors.size() < 4000); // a summary, not a flood
    if (file.exit_code == 0) CHECK(read_ppm(picture).colors() > 1);
  }
  CHECK_FALSE(std::filesystem::exists("executed.txt"));
  CHECK_FALSE(std::filesystem::exists(folder() + "executed.txt"));
}

TEST_CASE("hard files: materials", "[models]") {
  CHECK(diffuse_of(read("14_usemtl_unknown"), 0) == Rgb{0.8f, 0.8f, 0.8f});
  for (const char* name : {"16_crlf", "38_mtllib_with_spaces"})
    CHECK(diffuse_of(read(name), 0) == Rgb{0.8f, 0.1f, 0.1f});
  CHECK(diffuse_of(read("14_usemtl_unknown"), 1) == Rgb{0.8f, 0.1f, 0.1f});
  CHECK(diffuse_of(read("39_mtllib_multiple"), 0) == Rgb{1, 0, 0});
  CHECK(diffuse_of(read("39_mtllib_multiple"), 1) == Rgb{0, 1, 0});
  CHECK(diffuse_of(read("49_usemtl_before_mtllib"), 0) == Rgb{0.8f, 0.1f, 0.1f});
  CHECK(diffuse_of(read("74_unicode_names"), 0) == Rgb{0.1f, 0.8f, 0.1f});

  const Reading transparency = read("45_tr_vs_d");
  CHECK(named(transparency, "m1").opacity == 1);
  CHECK(named(transparency, "m2").opacity == 1);
  CHECK(named(transparency, "m3").opacity == 0.5f);
  CHECK(named(transparency, "m4").opacity == 0.5f);
  CHECK(named(transparency, "lone").opacity == 1);

  const Reading pbr = read("46_pbr_ext");
  CHECK(named(pbr, "p").emission[0] == 0.1f);
  CHECK(pbr.notes.count() == 0);

  const Reading illum = read("47_illum_and_ns");
  CHECK_FALSE(named(illum, "i0").lit);
  CHECK(named(illum, "i1").specular[0] == 0); // illum 1, and Ns 0
  CHECK(named(illum, "i2").specular[0] == 1);
  CHECK(named(illum, "i2").shininess == 128);
  CHECK(named(illum, "i3").shininess == 128);
  CHECK(named(illum, "i4").shininess == 0);
  CHECK(named(illum, "i8").shininess == 10);
  CHECK(named(illum, "i2").ambient[0] == 0.1f);

  const Reading kd = read("48_kd_forms");
  CHECK(diffuse_of(kd, 0) == Rgb{0, 1, 0}); // the later of two
  CHECK(diffuse_of(kd, 1) == Rgb{0.8f, 0.8f, 0.8f});
  CHECK(diffuse_of(kd, 4) == Rgb{1, 0, 1});
  CHECK(diffuse_of(kd, 5) == Rgb{0, 0, 1});
  CHECK(named(kd, "indented").ambient[2] == 1); // Ka is missing
}

TEST_CASE("hard files: textures", "[models]") {
  const cli::TextureReference map = material_of(read("40_map_options"), 0).diffuse_map;
  CHECK(map.file == folder() + "checker.png");
  CHECK(map.scale[0] == 2);
  CHECK(map.scale[1] == 2);
  CHECK(map.offset[0] == 0.25f);
  CHECK(map.offset[1] == 0);
  CHECK_FALSE(map.clamp);
  CHECK(material_of(read("41_map_spaces"), 0).diffuse_map.file == folder() + "my checker 01.png");
  CHECK(material_of(read("42_map_backslash"), 0).diffuse_map.file == folder() + "./checker.png");
  CHECK(material_of(read("43_map_missing_file"), 0).diffuse_map.file.empty());
  CHECK(diffuse_of(read("43_map_missing_file"), 0) == Rgb{0, 0, 1});
  const Reading bump = read("44_map_bump_opts");
  CHECK_FALSE(material_of(bump, 0).diffuse_map.file.empty());
  CHECK(contains(bump.notes.sentences(), "ump\" has no place"));
}

TEST_CASE("hard files: vertex colors and w", "[models]") {
  const Reading colored = read("28_vertex_colors");
  REQUIRE(colored.mesh.colors.size() == 16);
  const float expected[16] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1};
  for (size_t i = 0; i < 16; ++i) CHECK(colored.mesh.colors[i] == expected[i]);
  CHECK(read("29_vertex_w").mesh.colors.empty());
}

TEST_CASE("hard files: normals", "[models]") {
  const Reading cube = read("09_no_normals_cube");
  CHECK(cube.mesh.positions.size() / 3 == 24); // every edge is a crease

  const Reading groups = read("36_smoothing_groups");
  // 3-4 is inside group 1 and shared, 5-6 lies between the groups and is not.
  CHECK(groups.mesh.positions.size() / 3 == 2 + 2 + 2 + 2 + 2);
  const Reading flat = read("37_smoothing_off_vs_on");
  CHECK(flat.mesh.positions.size() / 3 >= 8);
  for (size_t i = 0; i < flat.mesh.normals.size(); i += 3) {
    const float y = std::fabs(flat.mesh.normals[i + 1]), z = std::fabs(flat.mesh.normals[i + 2]);
    CHECK((y == Approx(1) || z == Approx(1)));
  }
  for (const char* name : {"10_partial_normals", "11_zero_normals", "12_unnormalized_normals"}) {
    const Reading reading = read(name);
    for (size_t i = 0; i < reading.mesh.normals.size(); i += 3)
      CHECK(reading.mesh.normals[i + 2] == Approx(1));
  }
}

TEST_CASE("hard files: the triangles of a concave quadrilateral", "[models]") {
  const Reading arrow = read("04_concave_arrow");
  uint32_t uses[4] = {0, 0, 0, 0};
  for (const uint32_t corner : arrow.mesh.triangles)
    for (size_t vertex = 0; vertex < 4; ++vertex)
      uses[vertex] += std::equal(&arrow.frame.positions[3 * vertex], &arrow.frame.positions[3 * vertex + 3],
                                 &arrow.mesh.positions[3 * size_t(corner)]);
  CHECK(uses[1] == 2); // the diagonal is 2-4
  CHECK(uses[3] == 2);
}

TEST_CASE("hard files: objects and precision", "[models]") {
  CHECK(read("55_groups_objects").loaded.report.objects == 2);
  const Reading far = read("60_far_from_origin");
  for (size_t i = 0; i < far.mesh.positions.size(); ++i) CHECK(std::fabs(far.mesh.positions[i]) == 0.5f);
}

TEST_CASE("hard files: the number of threads changes nothing", "[models]") {
  for (const HardFile& file : hard_files()) {
    INFO(file.name);
    const Reading one = read(file.name, 1), three = read(file.name, 3);
    CHECK(one.warnings.sentences() == three.warnings.sentences());
    CHECK(one.mesh.triangles.size() == three.mesh.triangles.size());
  }
}
