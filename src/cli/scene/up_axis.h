// Which axis of a model points up, by what the model shows of it.
#pragma once

#include <array>
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

// `comments`: the first lines of the model's file.
UpEvidence up_evidence(const Mesh& mesh, const ModelFrame& frame, const std::vector<Material>& materials,
                       std::string_view comments);

// "underside +0.76, symmetry -0.12 ...": all that is not zero.
std::string as_text(const UpEvidence& evidence);

// True if +Z is more probable than +Y.
bool z_is_up(const UpEvidence& evidence);

} // namespace softgl::cli
