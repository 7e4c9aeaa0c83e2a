#include "scene/up_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace softgl::cli {
namespace {

constexpr int kCells = 16; // of the grid that is compared with its mirror image, along each axis
constexpr size_t kMostTriangles = 100000; // more are sampled
constexpr size_t kTooFewTriangles = 12;   // a cube, a picture on a wall: they show nothing of what is up

constexpr double kUnit = 1.0 / (int64_t(1) << 36); // of sums; no model's is larger than 2^26

bool is_floor(std::string name) {
  for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
  for (const char* word : {"floor", "ground", "grass", "terrain", "lawn", "street", "pavement", "boden"})
    if (name.find(word) != std::string::npos) return true;
  return false;
}

int cell(const int* place) { return (place[2] * kCells + place[1]) * kCells + place[0]; }

double standing(const ModelFrame& frame, int axis) {
  const double extent = frame.high[axis] - frame.low[axis];
  return extent > 0 && std::fabs(frame.low[axis]) < 0.01 * extent ? 1 : 0;
}

} // namespace

void extend_bounds(const Mesh& mesh, double* low, double* high) {
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const double value = mesh.positions[i];
    low[i % 3] = std::min(low[i % 3], value);
    high[i % 3] = std::max(high[i % 3], value);
  }
}

SurfaceSums::SurfaceSums(const double* low, const double* high, uint64_t triangles)
    : triangles_(triangles), stride_(triangles / kMostTriangles + 1),
      sums_(size_t(kGrid) + size_t(kCells) * kCells * kCells, 0) {
  for (int axis = 0; axis < 3; ++axis) low_[axis] = low[axis], high_[axis] = high[axis];
}

double SurfaceSums::sum(int place) const { return double(sums_[size_t(place)]) * kUnit; }
void SurfaceSums::add(int place, double value) { sums_[size_t(place)] += std::llrint(value / kUnit); }

void SurfaceSums::add(const Mesh& mesh, const std::vector<Material>& materials,
                      const std::vector<uint64_t>& before) {
  for (size_t b = 0; b < mesh.triangle_batches.size(); ++b) {
    const Batch& batch = mesh.triangle_batches[b];
    const bool floor = is_floor(materials[batch.material].name);
    const uint64_t skipped = before.empty() ? 0 : (stride_ - before[b] % stride_) % stride_;
    for (uint64_t i = 3 * skipped; i + 2 < batch.count; i += 3 * stride_)
      add_triangle(mesh, batch.first + i, floor);
  }
}

// Flat area within the lowest 2 %, as a share of the box's underside.
double SurfaceSums::underside(int axis) const {
  double box = 1;
  for (int other = 0; other < 3; ++other)
    if (other != axis) box *= extent(other);
  return box > 0 ? std::min(1.0, sum(kUnderside + axis) / box) : 0;
}

double SurfaceSums::net_normal(int axis) const { return sum(kArea) > 0 ? sum(kNet + axis) / sum(kArea) : 0; }

// From 0, all at the lowest place, to 1.
double SurfaceSums::center(int axis) const {
  const double area = sum(kArea);
  return area > 0 && extent(axis) > 0 ? (sum(kCenter + axis) / area - low_[axis]) / extent(axis) : 0.5;
}

// What part of the surface has its like on the other side of the middle.
double SurfaceSums::symmetry(int axis) const {
  double same = 0, all = 0;
  for (int z = 0; z < kCells; ++z)
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kCells; ++x) {
        int place[3] = {x, y, z};
        const double here = sum(kGrid + cell(place));
        place[axis] = kCells - 1 - place[axis];
        same += std::min(here, sum(kGrid + cell(place)));
        all += here;
      }
  return all > 0 ? same / all : 0;
}

// Of the faces with the names of floors: the share that lies level if `axis` is up.
double SurfaceSums::floor(int axis) const {
  return sum(kFloorArea) > 0 ? sum(kFloor + axis) / sum(kFloorArea) : 0;
}

void SurfaceSums::add_triangle(const Mesh& mesh, size_t first, bool floor) {
  double p[3][3], a[3], b[3];
  for (size_t k = 0; k < 3; ++k)
    for (size_t axis = 0; axis < 3; ++axis)
      p[k][axis] = double(mesh.positions[3 * size_t(mesh.triangles[first + k]) + axis]);
  for (int axis = 0; axis < 3; ++axis) {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (!(length > 0)) return;
  const double area = length / 2;
  add(kArea, area);
  if (floor) add(kFloorArea, area);
  for (int axis = 0; axis < 3; ++axis) {
    const bool level = std::fabs(n[axis]) > 0.95 * length;
    const double border = low_[axis] + 0.02 * extent(axis);
    if (level && p[0][axis] <= border && p[1][axis] <= border && p[2][axis] <= border)
      add(kUnderside + axis, area);
    add(kNet + axis, n[axis] / 2);
    add(kCenter + axis, area * (p[0][axis] + p[1][axis] + p[2][axis]) / 3);
    if (floor) add(kFloor + axis, area * std::fabs(n[axis]) / length);
  }
  spread(p, area);
}

// The area of a triangle over the cells that it meets, by points no farther apart than a cell.
void SurfaceSums::spread(const double (*p)[3], double area) {
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (extent(axis) > 0)
      for (int k = 0; k < 3; ++k)
        longest = std::max(longest, std::fabs(p[k][axis] - p[(k + 1) % 3][axis]) / extent(axis));
  const int parts = std::clamp(int(longest * kCells * 1.5), 1, 2 * kCells);
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j)
      for (int half = 0; half < (i + j + 1 < parts ? 2 : 1); ++half) {
        const double u = (i + (half ? 2.0 : 1.0) / 3) / parts, v = (j + (half ? 2.0 : 1.0) / 3) / parts;
        int place[3];
        for (int axis = 0; axis < 3; ++axis) {
          const double value = p[0][axis] + u * (p[1][axis] - p[0][axis]) + v * (p[2][axis] - p[0][axis]);
          place[axis] = extent(axis) > 0
                            ? std::clamp(int((value - low_[axis]) / extent(axis) * kCells), 0, kCells - 1)
                            : 0;
        }
        add(kGrid + cell(place), area / (parts * parts));
      }
}

UpEvidence SurfaceSums::evidence(const ModelFrame& frame, double exporter) const {
  constexpr int y = 1, z = 2;
  if (triangles_ <= kTooFewTriangles) return {};
  UpEvidence evidence;
  auto& values = evidence.values;
  values[UpEvidence::kExporter] = exporter;
  values[UpEvidence::kUnderside] = underside(z) - underside(y);
  values[UpEvidence::kSymmetry] = symmetry(y) - symmetry(z);
  values[UpEvidence::kNormals] = net_normal(z) - net_normal(y);
  values[UpEvidence::kStanding] = standing(frame, z) - standing(frame, y);
  const double low_y = std::max(extent(y), 1e-3), low_z = std::max(extent(z), 1e-3);
  values[UpEvidence::kFlatness] = std::clamp(std::log10(low_y / low_z), -1.0, 1.0);
  values[UpEvidence::kWeight] = center(y) - center(z);
  values[UpEvidence::kNames] = floor(z) - floor(y);
  return evidence;
}

// +1: programs whose models stand on the XY plane; -1: those that write Y up unless told otherwise.
double exporter_evidence(std::string_view comments) {
  for (const char* name : {"# STL", "OBJ file written 2", "# Regions:", "Tinkercad", "FreeCAD", "OpenSCAD",
                           "OpenFOAM", "Onshape", "netfabb", "AutoCAD", "CloudCompare"})
    if (comments.find(name) != comments.npos) return 1;
  for (const char* name : {"Blender", "3ds Max", "Maya", "CINEMA 4D", "ZBrush", "MilkShape", "SketchUp",
                           "Modo", "Houdini", "Unity", "Wings 3D", "Anim8or"})
    if (comments.find(name) != comments.npos) return -1;
  return 0;
}

UpEvidence up_evidence(const Mesh& mesh, const ModelFrame& frame, const std::vector<Material>& materials,
                       std::string_view comments) {
  double low[3] = {1e30, 1e30, 1e30}, high[3] = {-1e30, -1e30, -1e30};
  extend_bounds(mesh, low, high);
  SurfaceSums sums(low, high, mesh.triangles.size() / 3);
  if (mesh.triangles.size() / 3 > kTooFewTriangles) sums.add(mesh, materials);
  return sums.evidence(frame, exporter_evidence(comments));
}

std::string as_text(const UpEvidence& evidence) {
  static constexpr const char* kNames[] = {"underside", "symmetry", "normals", "standing",
                                           "flatness",  "weight",   "names",   "exporter"};
  std::string text;
  for (size_t i = 0; i < UpEvidence::kKinds; ++i) {
    char value[48];
    std::snprintf(value, sizeof value, "%s%s %+.2f", text.empty() ? "" : ", ", kNames[i], evidence.values[i]);
    if (evidence.values[i] != 0) text += value;
  }
  return text.empty() ? "nothing" : text;
}

bool z_is_up(const UpEvidence& evidence) {
  // In the order of UpEvidence::Kind.
  static constexpr double kWeights[UpEvidence::kKinds] = {1, 2, 0.7, 1.1, 0.8, 0.3, 1.5, 0.9};
  double sum = -0.6; // +Y is what OBJ files usually have
  for (size_t i = 0; i < UpEvidence::kKinds; ++i) sum += kWeights[i] * evidence.values[i];
  return sum > 0;
}

} // namespace softgl::cli
