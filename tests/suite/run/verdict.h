// Compares a picture with what the specification asks for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "expect/expectation.h"

namespace softgl::suite {

struct Verdict {
  bool pass = false;
  int wrong_pixels = 0;
  int other_side = 0; // pixels at edges that belong to the other side than in the exact geometry
  // The pixel that is farthest from its answers.
  int x = 0, y = 0, component = 0;
  int got = 0;
  double low = 0, high = 0, difference = 0; // in steps of 1/255
  std::string text;                         // one sentence
};

/// `color` is RGBA, rows from below.
Verdict judge(const Expectation& expected, const std::vector<uint8_t>& color, const Precision& precision);
/// The picture of the exact geometry and the middle of every interval, and of the difference.
std::vector<uint8_t> expected_bytes(const Expectation& expected);

} // namespace softgl::suite
