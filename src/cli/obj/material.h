// A material as the fixed-function pipeline knows it.
#pragma once

#include <string>

namespace softgl::cli {

struct TextureReference {
  std::string file; // a readable path; empty: no texture
  float scale[2] = {1, 1};
  float offset[2] = {0, 0};
  float base = 0, gain = 1; // -mm: texel = base + gain * texel
  bool clamp = false;
  bool alpha = true; // that of the file is opacity
};

struct Material {
  std::string name;
  float ambient[3] = {0.8f, 0.8f, 0.8f};
  float diffuse[3] = {0.8f, 0.8f, 0.8f};
  float specular[3] = {0, 0, 0};
  float emission[3] = {0, 0, 0};
  float shininess = 0; // 0..128; 0 means no highlight
  float opacity = 1;
  bool lit = true; // false: illum 0, the diffuse color as it is
  TextureReference diffuse_map;
  TextureReference opacity_map;
};

} // namespace softgl::cli
