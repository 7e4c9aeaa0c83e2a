#include <catch2/catch.hpp>

#include "command/model_loader.h"
#include "common/trigonometry.h"
#include "mesh/mesh_builder.h"
#include "mesh/normal_generator.h"

#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <tuple>

using namespace softgl::cli;

namespace {

struct Shaded {
  Mesh mesh;
  ModelFrame frame;
};

Shaded shade(const std::string& text, const NormalOptions& options = {}) {
  RemarkList remarks;
  Warnings warnings, notes;
  Shaded result;
  LoadedModel loaded = load_model(SourceText::from_string(text, "test.obj"), 1, remarks, warnings, notes);
  result.frame = frame_model(loaded.model);
  generate_normals(loaded.model, result.frame, options);
  result.mesh = build_mesh(loaded.model, result.frame, loaded.library, {}, remarks);
  return result;
}

std::string vertex(double x, double y, double z, const char* keyword = "v") {
  char text[100];
  std::snprintf(text, sizeof text, "%s %.9f %.9f %.9f\n", keyword, x, y, z);
  return text;
}

// Two rectangles that meet at the y axis under `degrees` (0: one plane).
std::string roof(double degrees, const std::string& between = {}) {
  return vertex(-1, 0, 0) + vertex(-1, 1, 0) + vertex(0, 0, 0) + vertex(0, 1, 0) +
         vertex(cosine(degrees), 0, sine(degrees)) + vertex(cosine(degrees), 1, sine(degrees)) + between +
         "f 1 3 4 2\n" + between + "f 3 5 6 4\n";
}

size_t vertex_count(const Shaded& shaded) { return shaded.mesh.positions.size() / 3; }

std::string sphere(int around, int across, bool texcoords) {
  std::string text;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i < around; ++i)
      text += vertex(sine(180.0 * j / across) * cosine(360.0 * i / around), cosine(180.0 * j / across),
                     sine(180.0 * j / across) * sine(360.0 * i / around));
  if (texcoords)
    for (int j = 0; j <= across; ++j)
      for (int i = 0; i <= around; ++i) text += vertex(double(i) / around, double(j) / across, 0, "vt");
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      text += "f";
      for (const auto& [di, dj] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
        text += " " + std::to_string((j + dj) * around + (i + di) % around + 1);
        if (texcoords) text += "/" + std::to_string((j + dj) * (around + 1) + i + di + 1);
      }
      text += "\n";
    }
  return text;
}

} // namespace

TEST_CASE("normals: an edge is smooth up to the crease angle", "[models][normals]") {
  for (const double angle : {1.0, 20.0, 39.9, 40.0}) CHECK(vertex_count(shade(roof(angle))) == 6);
  for (const double angle : {40.1, 60.0, 90.0, 170.0}) CHECK(vertex_count(shade(roof(angle))) == 8);
  CHECK(vertex_count(shade(roof(60), {60, false})) == 6);
  CHECK(vertex_count(shade(roof(10), {5, false})) == 8);
}

TEST_CASE("normals: smoothing groups decide, whatever the angle", "[models][normals]") {
  CHECK(vertex_count(shade(roof(90, "s 1\n"))) == 6);
  CHECK(vertex_count(shade(roof(90, "s 7\n"))) == 6);
  CHECK(vertex_count(shade(roof(5, "s off\n"))) == 8);
  CHECK(vertex_count(shade(roof(5, "s 0\n"))) == 8);
  CHECK(vertex_count(shade(roof(90, "s 1\n"), {40, true})) == 8); // --crease overrules
  std::string two = roof(5);
  two.insert(two.find("f 1"), "s 1\n");
  two.insert(two.find("f 3"), "s 2\n");
  CHECK(vertex_count(shade(two)) == 8);
}

TEST_CASE("normals: those of a sphere point outwards, also across a texture seam", "[models][normals]") {
  for (const bool texcoords : {false, true}) {
    const Shaded shaded = shade(sphere(32, 16, texcoords));
    double worst = 1;
    for (size_t i = 0; i < shaded.mesh.positions.size(); i += 3) {
      const float* p = &shaded.mesh.positions[i];
      const float* n = &shaded.mesh.normals[i];
      const double length = std::sqrt(double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2]);
      worst = std::min(worst, std::fabs(p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / length);
    }
    CHECK(worst > cosine(3));
  }
  // At the seam, positions with two texture coordinates have one normal.
  const Shaded seam = shade("v 0 0 0\nv 1 0 0.2\nv 1 1 0.2\nv 0 1 0\nv -1 0 0.2\nv -1 1 0.2\nvt 0 0\nvt 1 "
                            "0\nvt 1 1\nvt 0 1\nmtllib x\n"
                            "f 1/1 2/2 3/3 4/4\nf 5/1 1/2 4/3 6/4\n");
  std::set<std::tuple<float, float, float>> at_origin;
  size_t copies = 0;
  for (size_t i = 0; i < seam.mesh.positions.size(); i += 3)
    if (seam.mesh.positions[i] == 0 && seam.mesh.positions[i + 1] < 0) {
      at_origin.emplace(seam.mesh.normals[i], seam.mesh.normals[i + 1], seam.mesh.normals[i + 2]);
      ++copies;
    }
  CHECK(copies == 2);
  CHECK(at_origin.size() == 1);
}

TEST_CASE("normals: tessellation does not pull them", "[models][normals]") {
  // A cube's corner, one face of it cut into many triangles at that corner: smoothed over all, the normal is
  // the diagonal.
  std::string text = "s 1\nv 0 0 0\n" + vertex(1, 0, 0) + vertex(0, 1, 0) + vertex(0, 0, 1);
  std::string fan = "f";
  const int steps = 9;
  for (int i = 1; i < steps; ++i) text += vertex(cosine(90.0 * i / steps), sine(90.0 * i / steps), 0);
  text += "f 1 3 4\nf 1 4 2\n"; // the faces x = 0 and y = 0
  int previous = 2;
  for (int i = 1; i <= steps; ++i) {
    const int next = i < steps ? 4 + i : 3;
    text += "f 1 " + std::to_string(previous) + " " + std::to_string(next) + "\n";
    previous = next;
  }
  const Shaded shaded = shade(text);
  bool found = false;
  for (size_t i = 0; i < shaded.mesh.positions.size(); i += 3)
    if (shaded.mesh.positions[i] < -0.49f && shaded.mesh.positions[i + 1] < -0.49f &&
        shaded.mesh.positions[i + 2] < -0.49f) {
      found = true;
      for (size_t axis = 0; axis < 3; ++axis)
        CHECK(shaded.mesh.normals[i + axis] == Approx(1 / std::sqrt(3.0)).margin(0.001));
    }
  CHECK(found);
}

TEST_CASE("normals: those of the file are kept", "[models][normals]") {
  const Shaded shaded = shade("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 3 0 4\nf 1//1 2//1 3//1\n");
  for (size_t i = 0; i < shaded.mesh.normals.size(); i += 3) {
    CHECK(shaded.mesh.normals[i] == 0.6f);
    CHECK(shaded.mesh.normals[i + 1] == 0);
    CHECK(shaded.mesh.normals[i + 2] == 0.8f);
  }
}

TEST_CASE("normals: the hub of a very large fan", "[models][normals]") {
  std::string text = vertex(0, 0, 1);
  const int corners = 5000;
  for (int i = 0; i < corners; ++i) text += vertex(cosine(360.0 * i / corners), sine(360.0 * i / corners), 0);
  for (int i = 0; i < corners; ++i)
    text += "f 1 " + std::to_string(i + 2) + " " + std::to_string((i + 1) % corners + 2) + "\n";
  const Shaded shaded = shade(text);
  CHECK(shaded.mesh.triangles.size() == 3 * corners);
  for (size_t i = 0; i < shaded.mesh.normals.size(); i += 3) REQUIRE(shaded.mesh.normals[i + 2] > 0.5f);
}

TEST_CASE("normals: tiny and huge triangles of one model", "[models][normals]") {
  std::string text;
  for (int i = 0; i < 12; ++i) {
    const double size = std::pow(10.0, -i);
    text += vertex(i, 0, 0) + vertex(i + size, 0, 0) + vertex(i, size, 0) + "f -3 -2 -1\n";
  }
  const Shaded shaded = shade(text);
  for (size_t i = 0; i < shaded.mesh.normals.size(); i += 3) CHECK(shaded.mesh.normals[i + 2] == Approx(1));
}
