// How the picture is lit, as the command line says it.
#pragma once

#include <softgl/softgl.h>
#include <vector>

namespace softgl::cli {

struct LightOptions {
  enum Kind {
    kKey,            // over the viewer's left shoulder, with a weak fill light from the right
    kHeadlight,      // from the viewer
    kThreePoint,     // a key light from the left, a fill light from the right, a rim light from behind
    kDirection,      // towards `value` as the viewer sees it: x right, y up, z to the viewer
    kModelDirection, // towards `value` in the model's axes
    kModelPosition,  // at `value` in the model's coordinates
  };
  Kind kind = kKey;
  double value[3] = {0, 0, 1};
  float color[3] = {0.8f, 0.8f, 0.8f};   // diffuse and specular
  double spot_direction[3] = {0, 0, -1}; // in the model's axes
  float cutoff = 180, exponent = 0;      // degrees, 180: no spot; 0..128
  float attenuation[3] = {1, 0, 0};      // constant, linear, quadratic; distances in the model's units
};

enum class Shading { kFlat, kGouraud, kPhong };

enum Term : unsigned {
  kAmbient = GL_AMBIENT_TERM_BIT_SOFTGL,
  kDiffuse = GL_DIFFUSE_TERM_BIT_SOFTGL,
  kSpecular = GL_SPECULAR_TERM_BIT_SOFTGL,
  kEmission = GL_EMISSION_TERM_BIT_SOFTGL,
  kAllTerms = GL_ALL_TERM_BITS_SOFTGL,
};

struct LightingOptions {
  Shading shading = Shading::kGouraud;
  bool reflection_vector = false; // (v.r)^n instead of (n.h)^n
  unsigned terms = kAllTerms;
  float ambient[3] = {0.2f, 0.2f, 0.2f};
  std::vector<LightOptions> lights; // none: kKey
};

} // namespace softgl::cli
