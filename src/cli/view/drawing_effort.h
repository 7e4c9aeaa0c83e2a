// How well a picture is drawn while the mouse moves.
#pragma once

#include <algorithm>

namespace softgl::cli {

// What is taken from the full quality.
struct Reduction {
  bool one_sample = false;
  int divisor = 1; // of width and height
  bool operator==(const Reduction&) const = default;
};

// Learns from the time that each picture took.
class DrawingEffort {
public:
  static constexpr double kMost = 0.050, kLittle = 0.012; // seconds

  Reduction reduction() const { return {level_ > 0, level_ < 2 ? 1 : 1 << (level_ - 1)}; }

  void took(double seconds, const Reduction& drawn) {
    const bool full = drawn == Reduction();
    if (full)
      level_ = seconds > kMost ? std::max(level_, 1) : 0;
    else if (!(drawn == reduction()))
      return; // a step on the way to the full quality
    else if (seconds > kMost)
      level_ = std::min(level_ + 1, kLevels);
    else if (seconds < kLittle)
      level_ = level_ - 1;
  }

private:
  static constexpr int kLevels = 4; // up to an eighth of width and height
  int level_ = 0;
};

} // namespace softgl::cli
