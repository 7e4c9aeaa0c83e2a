// What a picture shows: the colors, a part of them, or something else about each pixel.
#pragma once

#include <string>
#include <vector>

namespace softgl::cli {

enum class Pass {
  kColor,
  kDepth,  // distance from the camera's plane, in the model's units
  kNormal, // in the model's axes
  kUv,     // texture coordinates
  kId,     // number of the material
  kAmbient,
  kDiffuse,
  kSpecular,
  kEmission,
  kCoverage, // part of the pixel that the model covers
};

// False if the name is unknown.
bool named_pass(const std::string& name, Pass& pass);
const char* name_of(Pass pass);
std::vector<std::string> pass_names();

// Drawn as numbers, not as light: one sample a pixel, without blending.
inline bool is_data(Pass pass) { return pass >= Pass::kDepth && pass <= Pass::kId; }
inline bool is_term(Pass pass) { return pass >= Pass::kAmbient && pass <= Pass::kEmission; }

} // namespace softgl::cli
