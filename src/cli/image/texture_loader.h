// Picture files as textures.
#pragma once

#include <cstdint>
#include <set>
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

// How much the pictures of one model may be: a small file may be a large picture, and be named a thousand
// times.
struct TexelBudget {
  int64_t left = int64_t(1) << 26;
  std::set<std::string> files; // which were read: their own size pays for texels once
};

// The diffuse picture with its own or the opacity picture's alpha; the opacity picture alone where there is
// no other. What cannot be read is warned of, and so is
// what is left out because the budget is used up; false if nothing is left.
bool load_texture(const Material& material, TextureImage& image, TexelBudget& budget, Warnings& warnings);

// Halves (box filter) until no side exceeds `largest`; with `power_of_two`, then stretches to powers of two.
void fit_texture(TextureImage& image, int largest, bool power_of_two);

} // namespace softgl::cli
