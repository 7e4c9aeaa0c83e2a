#include "view/light_turn.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"
#include "options/option_values.h"
#include "view/number_text.h"

namespace softgl::cli {
namespace {

// The viewer's right, up and back.
struct Turn {
  double right, down; // degrees
  const Axes& axes;

  void of_viewer(double* v) const {
    const double x = v[0] * cosine(right) + v[2] * sine(right);
    const double z = v[2] * cosine(right) - v[0] * sine(right);
    const double y = v[1] * cosine(down) - z * sine(down);
    v[2] = z * cosine(down) + v[1] * sine(down);
    v[0] = x;
    v[1] = y;
  }

  void of_model(double* v) const {
    double seen[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      seen[0] += axes.right[i] * v[i];
      seen[1] += axes.up[i] * v[i];
      seen[2] += axes.back[i] * v[i];
    }
    of_viewer(seen);
    for (int i = 0; i < 3; ++i)
      v[i] = axes.right[i] * seen[0] + axes.up[i] * seen[1] + axes.back[i] * seen[2];
  }
};

// Not longer than 1, so that rounding costs the same everywhere.
std::string direction_text(const double* v) {
  const double largest = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  return triple_text({v[0] / largest, v[1] / largest, v[2] / largest}, 4);
}

std::string float_triple(const float* v) {
  return shortest_text(v[0]) + "," + shortest_text(v[1]) + "," + shortest_text(v[2]);
}

} // namespace

std::string text_of(const LightOptions& light) {
  const LightOptions plain;
  std::string text;
  switch (light.kind) {
  case LightOptions::kKey: text = "key"; break;
  case LightOptions::kHeadlight: text = "headlight"; break;
  case LightOptions::kThreePoint: text = "three-point"; break;
  case LightOptions::kDirection: text = direction_text(light.value); break;
  case LightOptions::kModelDirection: text = "model:" + direction_text(light.value); break;
  case LightOptions::kModelPosition:
    text = "at:" + triple_text({light.value[0], light.value[1], light.value[2]}, 12);
    break;
  }
  if (!std::equal(light.color, light.color + 3, plain.color)) text += "/color:" + float_triple(light.color);
  if (light.cutoff != plain.cutoff) {
    text += "/spot:" + direction_text(light.spot_direction) + "/cutoff:" + shortest_text(light.cutoff);
    if (light.exponent != plain.exponent) text += "/exponent:" + shortest_text(light.exponent);
  }
  if (!std::equal(light.attenuation, light.attenuation + 3, plain.attenuation))
    text += "/attenuation:" + float_triple(light.attenuation);
  return text;
}

std::string turned_light(const std::string& text, double right, double down, const Axes& axes,
                         const std::array<double, 3>& middle) {
  LightOptions light = parse_light(text);
  const Turn turn{right, down, axes};
  const auto start_at = [&light](double x, double y, double z) {
    light.kind = LightOptions::kDirection;
    light.value[0] = x;
    light.value[1] = y;
    light.value[2] = z;
  };
  // The first parts, as lighting_setup has them.
  if (light.kind == LightOptions::kKey) start_at(-0.45, 0.65, 0.9);
  if (light.kind == LightOptions::kHeadlight) start_at(0, 0, 1);
  if (light.kind == LightOptions::kThreePoint) start_at(-0.8, 0.6, 0.7);
  switch (light.kind) {
  case LightOptions::kModelDirection: turn.of_model(light.value); break;
  case LightOptions::kModelPosition:
    for (size_t i = 0; i < 3; ++i) light.value[i] -= middle[i];
    turn.of_model(light.value);
    for (size_t i = 0; i < 3; ++i) light.value[i] += middle[i];
    turn.of_model(light.spot_direction);
    break;
  default: turn.of_viewer(light.value);
  }
  return text_of(light);
}

} // namespace softgl::cli
