// Which axis of a model points up: each kind of evidence alone, and what the program does with it.
#include <catch2/catch.hpp>

#include "models/program_runner.h"

#include "scene/up_axis.h"

#include <cmath>
#include <fstream>

using namespace softgl::cli;
using namespace softgl::test;

namespace {

constexpr int kSides = 24;

// A cone from y = `low` to y = `low` + 2, with or without its base: 24 or 48 triangles.
struct Cone {
  Mesh mesh;
  ModelFrame frame;
  std::vector<Material> materials{Material()};
};

Cone cone(double low, bool base, bool along_z) {
  Cone result;
  const auto add = [&](double x, double y, double z) {
    result.mesh.triangles.append(uint32_t(result.mesh.positions.size() / 3));
    for (const double value : {x, along_z ? -z : y, along_z ? y : z})
      result.mesh.positions.append(float(value));
  };
  for (int i = 0; i < kSides; ++i) {
    const double from = 2 * M_PI * i / kSides, to = 2 * M_PI * (i + 1) / kSides;
    add(std::cos(to), -1, std::sin(to));
    add(std::cos(from), -1, std::sin(from));
    add(0, 1, 0);
    if (!base) continue;
    add(std::cos(from), -1, std::sin(from));
    add(std::cos(to), -1, std::sin(to));
    add(0, -1, 0);
  }
  result.mesh.triangle_batches.push_back({0, 0, uint32_t(result.mesh.triangles.size())});
  const int up = along_z ? 2 : 1;
  for (int axis = 0; axis < 3; ++axis) {
    result.frame.low[axis] = axis == up ? low : -1;
    result.frame.high[axis] = axis == up ? low + 2 : 1;
  }
  return result;
}

UpEvidence evidence(const Cone& cone, const char* comments = "") {
  return up_evidence(cone.mesh, cone.frame, cone.materials, comments);
}

std::string cone_text(bool along_z) {
  const Cone shape = cone(0, true, along_z);
  std::string text;
  for (size_t i = 0; i < shape.mesh.positions.size(); i += 3) {
    text += "v";
    for (size_t k = 0; k < 3; ++k) text += " " + std::to_string(shape.mesh.positions[i + k]);
    text += "\n";
    if (i % 9 == 6) text += "f -3 -2 -1\n";
  }
  return text;
}

} // namespace

TEST_CASE("up axis: a cone stands on its base", "[models][up]") {
  for (const bool along_z : {false, true}) {
    const double sign = along_z ? 1 : -1;
    const UpEvidence standing = evidence(cone(0, true, along_z));
    CHECK(sign * standing.values[UpEvidence::kUnderside] > 0.7);
    CHECK(sign * standing.values[UpEvidence::kSymmetry] > 0.2);
    CHECK(sign * standing.values[UpEvidence::kWeight] > 0.1);
    CHECK(sign * standing.values[UpEvidence::kStanding] == 1);
    CHECK(std::fabs(standing.values[UpEvidence::kNormals]) < 1e-6); // closed
    CHECK(standing.values[UpEvidence::kFlatness] == Approx(0).margin(0.01));
    CHECK(z_is_up(standing) == along_z);
    CHECK(sign * evidence(cone(0, false, along_z)).values[UpEvidence::kNormals] > 0.3);
    CHECK(evidence(cone(-1, true, along_z)).values[UpEvidence::kStanding] == 0);
  }
}

TEST_CASE("up axis: names and exporters", "[models][up]") {
  Cone named = cone(-1, true, true);
  CHECK(evidence(named).values[UpEvidence::kNames] == 0);
  named.materials[0].name = "Green_Grass";
  CHECK(evidence(named).values[UpEvidence::kNames] > 0.2);
  const auto exporter = [&](const char* comments) {
    return evidence(named, comments).values[UpEvidence::kExporter];
  };
  CHECK(exporter("# Object Export From Tinkercad Server 2015\n") == 1);
  CHECK(exporter("# Wavefront OBJ file written 2018-08-07T11:43:10\n") == 1);
  CHECK(exporter("# Blender v2.71 (sub 0) OBJ File: ''\n") == -1);
  CHECK(exporter("# a file\n") == 0);
}

TEST_CASE("up axis: a few triangles, lines and points are no evidence", "[models][up]") {
  Cone few = cone(0, true, true);
  few.mesh.triangles.truncate(36);
  few.mesh.triangle_batches[0].count = 36;
  CHECK_FALSE(z_is_up(evidence(few)));
  CHECK_FALSE(z_is_up(up_evidence(Mesh(), ModelFrame(), {Material()}, "")));
}

TEST_CASE("up axis: a model that is turned says so", "[models][up]") {
  const std::string folder = output_folder("up");
  std::ofstream(folder + "y.obj") << cone_text(false);
  std::ofstream(folder + "z.obj") << cone_text(true);
  const auto draw = [&](const char* name, std::vector<std::string> options) {
    std::vector<std::string> arguments = {folder + name, "-o",    "-",      "--format", "ppm",
                                          "-s",          "64x64", "--view", "front"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_softgl(arguments);
  };
  const ProgramRun upright = draw("y.obj", {}), turned = draw("z.obj", {});
  CHECK(upright.errors.empty());
  CHECK(turned.errors ==
        "softgl: note: " + folder + "z.obj: turned: its +Z seems to point up (--up +Y draws it as it is)\n");
  CHECK(turned.output == draw("z.obj", {"--up", "+Z"}).output);
  CHECK(upright.output == draw("y.obj", {"--up", "+Y"}).output);
  CHECK(draw("z.obj", {"--up", "+Y"}).errors.empty());
  CHECK(draw("z.obj", {"--up", "+Y"}).output != turned.output);
  CHECK(draw("z.obj", {"--quiet"}).errors.empty());
  CHECK(draw("z.obj", {"--strict"}).exit_code == 0); // it is no fault of the model
  CHECK(draw("y.obj", {"-v"}).errors.find("y.obj: up is +Y\n") != std::string::npos);
  CHECK(draw("z.obj", {"-v"}).errors.find("z.obj: up is +Z\n") != std::string::npos);
  // The cone points up: narrow at the top of the picture.
  const TestPicture picture = parse_ppm(turned.output);
  const auto width_at = [&](int y) {
    int count = 0;
    for (int x = 0; x < picture.width; ++x)
      count += !std::equal(picture.at(x, y), picture.at(x, y) + 3, picture.at(0, 0));
    return count;
  };
  CHECK(width_at(8) < 10);
  CHECK(width_at(56) > 40);
}
