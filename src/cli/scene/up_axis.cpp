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

struct Vector {
  double v[3];
  double operator[](int axis) const { return v[axis]; }
};

// Sums over the triangles of a mesh.
class Surface {
public:
  Surface(const Mesh& mesh, const std::vector<Material>& materials) : mesh_(mesh) {
    for (int axis = 0; axis < 3; ++axis) low_[axis] = 1e30, high_[axis] = -1e30;
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const double value = mesh.positions[i];
      low_[i % 3] = std::min(low_[i % 3], value);
      high_[i % 3] = std::max(high_[i % 3], value);
    }
    grid_.assign(size_t(kCells) * kCells * kCells, 0);
    const size_t stride = mesh.triangles.size() / 3 / kMostTriangles + 1;
    for (const Batch& batch : mesh.triangle_batches) {
      const bool floor = is_floor(materials[batch.material].name);
      for (size_t i = batch.first; i + 2 < size_t(batch.first) + batch.count; i += 3 * stride) add(i, floor);
    }
  }

  double area() const { return area_; }
  double extent(int axis) const { return high_[axis] - low_[axis]; }
  // Flat area within the lowest 2 %, as a share of the box's underside.
  double underside(int axis) const {
    double box = 1;
    for (int other = 0; other < 3; ++other)
      if (other != axis) box *= extent(other);
    return box > 0 ? std::min(1.0, underside_[axis] / box) : 0;
  }
  double net_normal(int axis) const { return area_ > 0 ? net_[axis] / area_ : 0; }
  // From 0, all at the lowest place, to 1.
  double center(int axis) const {
    return area_ > 0 && extent(axis) > 0 ? (center_[axis] / area_ - low_[axis]) / extent(axis) : 0.5;
  }
  // What part of the surface has its like on the other side of the middle.
  double symmetry(int axis) const {
    double same = 0, all = 0;
    for (int z = 0; z < kCells; ++z)
      for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x) {
          int place[3] = {x, y, z};
          const double here = grid_[cell(place)];
          place[axis] = kCells - 1 - place[axis];
          same += std::min<double>(here, grid_[cell(place)]);
          all += here;
        }
    return all > 0 ? same / all : 0;
  }
  // Of the faces with the names of floors: the share that lies level if `axis` is up.
  double floor(int axis) const { return floor_area_ > 0 ? floor_[axis] / floor_area_ : 0; }

private:
  static bool is_floor(std::string name) {
    for (char& c : name) c = char(c >= 'A' && c <= 'Z' ? c + 32 : c);
    for (const char* word : {"floor", "ground", "grass", "terrain", "lawn", "street", "pavement", "boden"})
      if (name.find(word) != std::string::npos) return true;
    return false;
  }

  static size_t cell(const int* place) {
    return (size_t(place[2]) * kCells + size_t(place[1])) * kCells + size_t(place[0]);
  }

  Vector corner(size_t index) const {
    const float* p = &mesh_.positions[3 * size_t(mesh_.triangles[index])];
    return {{double(p[0]), double(p[1]), double(p[2])}};
  }

  void add(size_t first, bool floor) {
    const Vector p[3] = {corner(first), corner(first + 1), corner(first + 2)};
    double a[3], b[3];
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = p[1][axis] - p[0][axis];
      b[axis] = p[2][axis] - p[0][axis];
    }
    const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0)) return;
    const double area = length / 2;
    area_ += area;
    floor_area_ += floor * area;
    for (int axis = 0; axis < 3; ++axis) {
      const bool level = std::fabs(n[axis]) > 0.95 * length;
      const double border = low_[axis] + 0.02 * extent(axis);
      if (level && p[0][axis] <= border && p[1][axis] <= border && p[2][axis] <= border)
        underside_[axis] += area;
      net_[axis] += n[axis] / 2;
      center_[axis] += area * (p[0][axis] + p[1][axis] + p[2][axis]) / 3;
      if (floor) floor_[axis] += area * std::fabs(n[axis]) / length;
    }
    spread(p, area);
  }

  // The area of a triangle over the cells that it meets, by points no farther apart than a cell.
  void spread(const Vector* p, double area) {
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
          grid_[cell(place)] += float(area / (parts * parts));
        }
  }

  const Mesh& mesh_;
  double low_[3], high_[3];
  double area_ = 0, floor_area_ = 0;
  double underside_[3] = {0, 0, 0}, net_[3] = {0, 0, 0}, center_[3] = {0, 0, 0}, floor_[3] = {0, 0, 0};
  std::vector<float> grid_;
};

double standing(const ModelFrame& frame, int axis) {
  const double extent = frame.high[axis] - frame.low[axis];
  return extent > 0 && std::fabs(frame.low[axis]) < 0.01 * extent ? 1 : 0;
}

// +1: programs whose models stand on the XY plane; -1: those that write Y up unless told otherwise.
double exporter(std::string_view comments) {
  for (const char* name : {"# STL", "OBJ file written 2", "# Regions:", "Tinkercad", "FreeCAD", "OpenSCAD",
                           "OpenFOAM", "Onshape", "netfabb", "AutoCAD", "CloudCompare"})
    if (comments.find(name) != comments.npos) return 1;
  for (const char* name : {"Blender", "3ds Max", "Maya", "CINEMA 4D", "ZBrush", "MilkShape", "SketchUp",
                           "Modo", "Houdini", "Unity", "Wings 3D", "Anim8or"})
    if (comments.find(name) != comments.npos) return -1;
  return 0;
}

} // namespace

UpEvidence up_evidence(const Mesh& mesh, const ModelFrame& frame, const std::vector<Material>& materials,
                       std::string_view comments) {
  constexpr int y = 1, z = 2;
  UpEvidence evidence;
  auto& values = evidence.values;
  values[UpEvidence::kExporter] = exporter(comments);
  if (mesh.triangles.size() / 3 <= kTooFewTriangles) return {};
  const Surface surface(mesh, materials);
  values[UpEvidence::kUnderside] = surface.underside(z) - surface.underside(y);
  values[UpEvidence::kSymmetry] = surface.symmetry(y) - surface.symmetry(z);
  values[UpEvidence::kNormals] = surface.net_normal(z) - surface.net_normal(y);
  values[UpEvidence::kStanding] = standing(frame, z) - standing(frame, y);
  const double low_y = std::max(surface.extent(y), 1e-3), low_z = std::max(surface.extent(z), 1e-3);
  values[UpEvidence::kFlatness] = std::clamp(std::log10(low_y / low_z), -1.0, 1.0);
  values[UpEvidence::kWeight] = surface.center(y) - surface.center(z);
  values[UpEvidence::kNames] = surface.floor(z) - surface.floor(y);
  return evidence;
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
