// Where two pictures differ, and by how much.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/picture.h"
#include "image/picture_reader.h"

namespace softgl::cli {

struct ComparisonRules {
  std::array<float, 4> tolerance = {0, 0, 0, 0}; // of red, green, blue, alpha; 255 is all
  // A pixel counts as the same if each picture has its color, within the tolerance, in the other's 3 x 3
  // pixels around it: an edge that has moved by less than a pixel.
  bool ignore_edges = false;
  const PictureSamples* mask = nullptr; // of the same size; only where it is brighter than half is compared
};

enum class Verdict : uint8_t { kSame, kDiffers, kEdge, kMasked };

// Numbers are of the compared pixels, which the mask leaves. Where both pictures are fully transparent, their
// colors do not count.
struct Comparison {
  uint64_t compared = 0, differing = 0, edges = 0;
  std::array<double, 4> largest = {0, 0, 0, 0};   // difference of each channel, of 255
  double mean = 0, root_mean_square = 0;          // over all channels that either picture uses
  double similarity = 1, least_similarity = 1;    // structural_similarity(): mean and least
  int left = 0, top = 0, right = -1, bottom = -1; // around what differs
  std::vector<Verdict> verdicts;                  // for each pixel, rows from the top
};

// Both have one size.
Comparison compare_pictures(const PictureSamples& a, const PictureSamples& b, const ComparisonRules& rules);

// `a` in pale gray, what differs in red, ignored edges in yellow, what is masked darker.
Picture draw_differences(const PictureSamples& a, const Comparison& comparison);

// RGB over white.
Picture as_opaque_picture(const PictureSamples& samples);

} // namespace softgl::cli
