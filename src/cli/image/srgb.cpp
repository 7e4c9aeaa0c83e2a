#include "image/srgb.h"

#include <cmath>

namespace softgl::cli {

float from_srgb(float value) {
  return value <= 0.04045f ? value / 12.92f : float(std::pow((double(value) + 0.055) / 1.055, 2.4));
}

float to_srgb(float light) {
  return light <= 0.0031308f ? light * 12.92f : float(1.055 * std::pow(double(light), 1 / 2.4) - 0.055);
}

} // namespace softgl::cli
