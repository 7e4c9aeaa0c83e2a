// `softgl compare`: two pictures, or the pictures of two folders.
#pragma once

#include <optional>
#include <string>

#include "image/comparison.h"

namespace softgl::cli {

struct CompareOptions {
  std::string first, second;
  std::string difference; // picture, or folder of pictures; empty: none
  std::string sheet;      // both and their difference side by side; a folder for folders
  std::string mask;
  std::string junit;
  std::array<float, 4> tolerance = {0, 0, 0, 0};
  bool ignore_edges = false;
  double most_pixels = 0;                 // that may differ
  bool most_pixels_is_percentage = false; // of those compared
  std::optional<double> least_similarity; // decides instead of differing pixels
  bool json = false, quiet = false;
  bool stats = false; // times to standard error
  unsigned threads = 1;
};

// Prints to standard output and returns the exit code: kSuccess, or kDiffers.
int run_compare(const CompareOptions& options);

} // namespace softgl::cli
