// Picture files as textures.
#pragma once

#include <cstdint>
#include <string>

#include "common/growing_array.h"
#include "common/warnings.h"
#include "obj/material.h"

namespace softgl::cli {

struct TextureImage {
  int width = 0, height = 0;
  int channels = 3;             // 4: RGBA, if any texel is not opaque; 1: alpha alone
  GrowingArray<uint8_t> texels; // rows from the bottom, as GL counts
};

// The diffuse picture with its own or the opacity picture's alpha; the opacity picture alone where there is
// no other. What cannot be read is warned of; false if nothing is left.
bool load_texture(const Material& material, TextureImage& image, Warnings& warnings);

// Halves (box filter) until no side exceeds `largest`; with `power_of_two`, then stretches to powers of two.
void fit_texture(TextureImage& image, int largest, bool power_of_two);

} // namespace softgl::cli
