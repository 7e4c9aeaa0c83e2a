// Which axis of a model points up, by what the model shows of it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/mesh_builder.h"
#include "obj/material.h"

namespace softgl::cli {

// What speaks for +Z (positive) or for +Y (negative), each from -1 to 1. reference/UP_AXIS.md says how much
// each weighs.
struct UpEvidence {
  enum Kind {
    kUnderside, // flat faces at the lowest place, as a share of the box's underside
    kSymmetry,  // left and right look alike, top and bottom do not
    kNormals,   // open surfaces, as a terrain is, face up
    kStanding,  // the lowest place is zero, and that of the other axis is not
    kFlatness,  // what is flat lies
    kWeight,    // more surface in the lower half
    kNames,     // faces whose materials are called floor, ground, roof ...
    kExporter,  // the comment of a program that is known for its axis
    kKinds
  };
  std::array<double, kKinds> values{};
};

// To the places of the mesh's triangles.
void extend_bounds(const Mesh& mesh, double* low, double* high);

// Sums over the triangles of a model, of which each process may have a part. They are whole numbers, so that
// neither the order of the triangles nor who adds them matters.
class SurfaceSums {
public:
  // Bounds of all triangles' places, and their number: of very many only some are looked at.
  SurfaceSums(const double* low, const double* high, uint64_t triangles);

  // `before`: for each batch how many triangles of its material other processes have before it; none: 0.
  void add(const Mesh& mesh, const std::vector<Material>& materials,
           const std::vector<uint64_t>& before = {});

  // All sums, for processes to add up.
  std::vector<int64_t>& values() { return sums_; }
  UpEvidence evidence(const ModelFrame& frame, double exporter) const;

private:
  // Places of the sums; those of three axes stand together, and the grid is last.
  enum Sum {
    kArea,
    kFloorArea,
    kUnderside,
    kNet = kUnderside + 3,
    kCenter = kNet + 3,
    kFloor = kCenter + 3,
    kGrid = kFloor + 3
  };

  double sum(int place) const;
  void add(int place, double value);
  void add_triangle(const Mesh& mesh, size_t first, bool floor);
  void spread(const double (*p)[3], double area);
  double extent(int axis) const { return high_[axis] - low_[axis]; }
  double underside(int axis) const;
  double net_normal(int axis) const;
  double center(int axis) const;
  double symmetry(int axis) const;
  double floor(int axis) const;

  double low_[3], high_[3];
  uint64_t triangles_, stride_;
  std::vector<int64_t> sums_;
};

// What the program that wrote the file is known for, by the first lines of the file: 1, -1 or 0.
double exporter_evidence(std::string_view comments);

// `comments`: the first lines of the model's file.
UpEvidence up_evidence(const Mesh& mesh, const ModelFrame& frame, const std::vector<Material>& materials,
                       std::string_view comments);

// "underside +0.76, symmetry -0.12 ...": all that is not zero.
std::string as_text(const UpEvidence& evidence);

// True if +Z is more probable than +Y.
bool z_is_up(const UpEvidence& evidence);

} // namespace softgl::cli
