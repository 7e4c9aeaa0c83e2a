#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "test_paths.h"

#include "common/trigonometry.h"
#include "scene/camera.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

using namespace softgl;
using namespace softgl::cli;

namespace {

Mesh mesh_of(const std::vector<float>& positions) {
  Mesh mesh;
  mesh.positions.append(positions.data(), positions.size());
  for (uint32_t i = 0; i < positions.size() / 3; ++i) mesh.triangles.append(i);
  return mesh;
}

Mesh random_mesh(uint32_t seed, float sx, float sy, float sz) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1);
  std::vector<float> positions;
  for (int i = 0; i < 300; ++i)
    positions.insert(positions.end(), {place(random) * sx, place(random) * sy, place(random) * sz});
  return mesh_of(positions);
}

struct Extent {
  double left = 2, right = -2, bottom = 2, top = -2, near_z = 2, far_z = -2;
};

Extent project(const Mesh& mesh, const Camera& camera) {
  Extent e;
  for (size_t i = 0; i < mesh.positions.size(); i += 3) {
    const double p[4] = {mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2], 1};
    double eye[4] = {0, 0, 0, 0}, clip[4] = {0, 0, 0, 0};
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) eye[r] += camera.view[4 * c + r] * p[c];
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) clip[r] += camera.projection[4 * c + r] * eye[c];
    REQUIRE(clip[3] > 0);
    const double x = clip[0] / clip[3], y = clip[1] / clip[3], z = clip[2] / clip[3];
    e.left = std::min(e.left, x);
    e.right = std::max(e.right, x);
    e.bottom = std::min(e.bottom, y);
    e.top = std::max(e.top, y);
    e.near_z = std::min(e.near_z, z);
    e.far_z = std::max(e.far_z, z);
  }
  return e;
}

} // namespace

TEST_CASE("camera: every model fills its frame and none is cut", "[models][camera]") {
  const double border = 1 - 2 * kMargin;
  for (uint32_t seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](double low, double high) {
      return low + (high - low) * (random() % 10000) / 10000.0;
    };
    const Mesh mesh = random_mesh(seed, float(pick(0.01, 1)), float(pick(0.01, 1)), float(pick(0.01, 1)));
    CameraOptions options;
    options.azimuth = pick(-360, 360);
    options.elevation = pick(-90, 90);
    options.roll = pick(-180, 180);
    options.field_of_view = pick(5, 120);
    options.orthographic = seed % 4 == 0;
    options.up = UpAxis(random() % 6);
    options.width = int(pick(100, 2000));
    options.height = int(pick(100, 2000));
    INFO("seed " << seed);
    const Extent e = project(mesh, fit_camera(mesh, options));
    CHECK(e.left >= -border - 1e-6);
    CHECK(e.right <= border + 1e-6);
    CHECK(e.bottom >= -border - 1e-6);
    CHECK(e.top <= border + 1e-6);
    CHECK(e.near_z >= -1);
    CHECK(e.far_z <= 1);
    // One dimension is filled from side to side, the other is centered.
    CHECK(std::max(e.right - e.left, e.top - e.bottom) >= 2 * border - 0.004);
    CHECK(std::fabs(e.left + e.right) < 0.02);
    CHECK(std::fabs(e.bottom + e.top) < 0.02);
  }
}

TEST_CASE("camera: flat, thin and single-place models give finite cameras", "[models][camera]") {
  const std::vector<float> models[] = {{0, 0, 0, 0, 0, 0, 0, 0, 0},     // one place
                                       {-1, 0, 0, 1, 0, 0, 0, 0, 0},    // a line along x
                                       {0, 0, -1, 0, 0, 1, 0, 0, 0},    // along z: end-on from the front
                                       {-1, 0, -1, 1, 0, -1, 1, 0, 1}}; // a plane: edge-on from the front
  for (const auto& positions : models)
    for (const bool orthographic : {false, true})
      for (const double azimuth : {0.0, 35.0, 90.0}) {
        const Mesh mesh = mesh_of(positions);
        CameraOptions options;
        options.azimuth = azimuth;
        options.elevation = 0;
        options.orthographic = orthographic;
        const Camera camera = fit_camera(mesh, options);
        for (const double value : camera.view) CHECK(std::isfinite(value));
        for (const double value : camera.projection) CHECK(std::isfinite(value));
        const Extent e = project(mesh, camera);
        CHECK(e.left >= -1);
        CHECK(e.right <= 1);
        CHECK(e.near_z >= -1);
        CHECK(e.far_z <= 1);
      }
}

TEST_CASE("camera: named views and up axes look where they say", "[models][camera]") {
  const struct {
    const char* view;
    UpAxis up;
    double eye[3];
  } cases[] = {{"front", UpAxis::kPlusY, {0, 0, 1}},  {"back", UpAxis::kPlusY, {0, 0, -1}},
               {"right", UpAxis::kPlusY, {1, 0, 0}},  {"left", UpAxis::kPlusY, {-1, 0, 0}},
               {"top", UpAxis::kPlusY, {0, 1, 0}},    {"bottom", UpAxis::kPlusY, {0, -1, 0}},
               {"front", UpAxis::kPlusZ, {0, -1, 0}}, {"right", UpAxis::kPlusZ, {1, 0, 0}},
               {"top", UpAxis::kPlusZ, {0, 0, 1}},    {"top", UpAxis::kMinusY, {0, -1, 0}}};
  const Mesh mesh = random_mesh(1, 1, 1, 1);
  for (const auto& c : cases) {
    INFO(c.view);
    CameraOptions options;
    REQUIRE(named_view(c.view, options.azimuth, options.elevation));
    options.up = c.up;
    const Camera camera = fit_camera(mesh, options);
    for (int i = 0; i < 3; ++i) CHECK(camera.eye[i] == Approx(c.eye[i]).margin(1e-12));
  }
}

TEST_CASE("camera: sine and cosine", "[models][camera]") {
  for (int i = -2000; i <= 2000; ++i) {
    const double degrees = i * 0.37;
    CHECK(sine(degrees) == Approx(std::sin(degrees * 3.14159265358979323846 / 180)).margin(1e-14));
    CHECK(cosine(degrees) == Approx(std::cos(degrees * 3.14159265358979323846 / 180)).margin(1e-14));
  }
  CHECK(sine(180) == 0);
  CHECK(cosine(90) == 0);
  CHECK(sine(30) == Approx(0.5).margin(1e-16));
}

TEST_CASE("camera: the picture touches the frame", "[models][program]") {
  const std::string folder = test::output_folder("camera");
  // A body without symmetry, seen in many ways.
  std::ofstream(folder + "body.obj")
      << "v 0 0 0\nv 3 0 0.5\nv 1 2 0\nv 0.5 0.7 4\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
  const std::vector<std::string> views[] = {{},
                                            {"--view", "front"},
                                            {"--view", "top", "--ortho"},
                                            {"--az", "-100", "--el", "-40"},
                                            {"--fov", "90", "--up", "+Z"},
                                            {"--ortho", "--roll", "33"}};
  for (const auto& view : views)
    for (const char* size : {"200x200", "300x120", "90x250"}) {
      std::vector<std::string> arguments = {folder + "body.obj", "-o", folder + "body.ppm", "--size", size};
      arguments.insert(arguments.end(), view.begin(), view.end());
      const test::ProgramRun run = test::run_softgl(arguments);
      INFO(size << " " << (view.empty() ? "" : view.back()) << " " << run.errors);
      REQUIRE(run.exit_code == 0);
      const test::TestPicture picture = test::read_ppm(folder + "body.ppm");
      const auto box = picture.drawn();
      CHECK(box.left >= 1);
      CHECK(box.top >= 1);
      CHECK(box.right <= picture.width - 2);
      CHECK(box.bottom <= picture.height - 2);
      const int free_x = box.left + picture.width - 1 - box.right,
                free_y = box.top + picture.height - 1 - box.bottom;
      CHECK((free_x <= 0.03 * picture.width + 3 || free_y <= 0.03 * picture.height + 3));
      CHECK(std::abs(box.left - (picture.width - 1 - box.right)) <= 3);
      CHECK(std::abs(box.top - (picture.height - 1 - box.bottom)) <= 3);
    }
}
