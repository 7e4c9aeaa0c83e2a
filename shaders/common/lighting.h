// The data of the lighting kernel (GL 1.5, 2.14.1): lanes in, lanes out, and the constants of lights and
// materials. The lanes are vertices (Gouraud) or fragments (Phong).
#pragma once

#include "shaders/common/limits.h"
#include "shaders/common/surface.h"
#include "shaders/common/vertex_attributes.h"

namespace softgl {

/// Constants of one enabled light. Products are light * material, rounded once; they are used where the
/// face's material does not vary over the draw. Index 0 = front, 1 = back.
struct LightConstants {
  bool positional, attenuated, spot;
  float position[3];    // positional: divided by w. Directional: normalized, towards the light
  float half_vector[3]; // directional light and infinite viewer
  float attenuation[3]; // constant, linear, quadratic
  float spot_direction[3], spot_cosine, spot_exponent;
  float ambient[3], diffuse[3], specular[3];
  float ambient_product[2][3], diffuse_product[2][3], specular_product[2][3];
};

struct LightingConstants {
  bool two_sided, separate_specular, local_viewer;
  bool shininess_zero; // both faces' exponents are zero all over the draw
  bool varies[2];      // some material parameter of the face is an array of lanes
  bool reflection;     // highlights by the reflection vector instead of the half vector
  bool for_fragments;  // the lanes are fragments: their normals are renormalized
  bool zero_powers;    // anything to the power of zero is 1 (2.14.1), also what is 0
  int32_t light_count;
  float model_ambient[3];
  float material[kMaterialParameters][2][4]; // [MaterialParameter][face], where constant
  // Slot that feeds a material parameter as lanes: a material slot, kColor (color material), or -1 =
  // constant.
  int8_t material_source[kMaterialParameters][2];
  float scene[2][4];                // emission + model ambient * ambient; alpha = diffuse alpha
  LightConstants light[kMaxLights]; // light_count of them
};

/// A material parameter of a face as lanes; null = LightingConstants::material.
struct MaterialLanes {
  const float* component[kMaterialParameters][2][4]; // [MaterialParameter][face][component]
};

/// One block of lanes. Lanes [0, lanes) are computed; lanes is a multiple of kStripLanes.
struct alignas(64) LightingBlock {
  int32_t lanes;
  alignas(64) float normal[3][kLanes];
  float eye[4][kLanes];          // position, where a light is positional or the viewer is local
  float eye_unit[3][kLanes];     // position normalized, where the viewer is local
  float color[2][4][kLanes];     // out: [face]; back only when two-sided. Not clamped
  float secondary[2][3][kLanes]; // out: with separate specular only
  // scratch
  float light_vector[3][kLanes], half_vector[3][kLanes];
  float attenuation[kLanes];
  float diffuse[2][kLanes], specular[2][kLanes];
};

} // namespace softgl
