// Picture files as textures: PNG, JPEG, BMP, TGA.
#pragma once

#include <cstdint>
#include <string>

#include "common/growing_array.h"
#include "obj/material.h"

namespace softgl::cli {

struct TextureImage {
  int width = 0, height = 0;
  int channels = 3;             // 4 if any texel is not opaque
  GrowingArray<uint8_t> texels; // rows from the bottom, as GL counts
};

// The diffuse picture with its own or the opacity picture's alpha. False: `problem` says why, as half a
// sentence.
bool load_texture(const Material& material, TextureImage& image, std::string& problem);

// Halves (box filter) until no side exceeds `largest`; with `power_of_two`, then stretches to powers of two.
void fit_texture(TextureImage& image, int largest, bool power_of_two);

} // namespace softgl::cli
