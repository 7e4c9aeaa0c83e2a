#include "run/verdict.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace softgl::suite {
namespace {

// How far the pixel is from the answer, at worst over its components; in steps of 1/255.
double distance(const Interval* color, const uint8_t* pixel, const Precision& precision, int* worst) {
  double most = 0;
  for (int c = 0; c < 4; c++) {
    if (c == 3 && precision.bits[3] == 0) continue; // reads as 1 (4.3.2)
    const double half = precision.half_step(c) * 255, low = color[c].low * 255 - half,
                 high = color[c].high * 255 + half;
    const double off = std::max(low - pixel[c], pixel[c] - high);
    if (off > most) most = off, *worst = c;
  }
  return most;
}

constexpr double kRounding = 0.02; // of the comparison itself

// Whether a component of so many bits, read as a byte, may have this value. Bits may be repeated, or scaled.
bool can_be(uint8_t value, int bits) {
  if (bits >= 8 || bits == 0) return true;
  const int most = (1 << bits) - 1, step = (value * most + 127) / 255;
  return std::abs(step * 255 / most - value) <= 1;
}

// A GL that says that its colors have few bits gets wide intervals: its picture must show it.
std::string too_many_values(const std::vector<uint8_t>& color, const Precision& precision) {
  for (size_t i = 0; i < color.size(); i++)
    if (!can_be(color[i], precision.bits[i % 4]))
      return std::string((const char*[]){"red", "green", "blue", "alpha"}[i % 4]) + " is " +
             std::to_string(color[i]) + ", which " + std::to_string(precision.bits[i % 4]) +
             " bits cannot hold";
  return "";
}

} // namespace

Verdict judge(const Expectation& expected, const std::vector<uint8_t>& color, const Precision& precision) {
  Verdict verdict;
  for (size_t i = 0; i < expected.pixels.size(); i++) {
    double nearest = 1e9;
    size_t answer = 0;
    int component = 0;
    for (size_t a = 0; a < expected.pixels[i].size(); a++) {
      int worst = 0;
      const double off = distance(expected.pixels[i][a].color, &color[4 * i], precision, &worst);
      if (off < nearest) nearest = off, answer = a, component = worst;
      if (off <= kRounding) break;
    }
    if (nearest <= kRounding) {
      verdict.other_side += answer > 0;
      continue;
    }
    verdict.wrong_pixels++;
    if (nearest > verdict.difference) {
      const Interval& wanted = expected.pixels[i][answer].color[component];
      verdict.difference = nearest, verdict.component = component,
      verdict.got = color[4 * i + size_t(component)];
      verdict.low = wanted.low * 255, verdict.high = wanted.high * 255;
      verdict.x = int(i) % expected.width, verdict.y = int(i) / expected.width;
    }
  }
  for (const Witness& witness : expected.witnesses) {
    double nearest = 1e9;
    int ignored = 0, count = 0;
    for (int pixel : witness.pixels) {
      const double off = distance(witness.color, &color[size_t(4 * pixel)], precision, &ignored);
      nearest = std::min(nearest, off), count += off <= kRounding;
    }
    if (count >= witness.least && count <= witness.most) continue;
    verdict.wrong_pixels++;
    // Too many or too few pixels of the right color are less wrong than a color that is not there.
    if (count > 0) nearest = std::max(nearest, 0.5);
    if (nearest > verdict.difference) {
      verdict.difference = nearest, verdict.component = 0;
      verdict.low = witness.color[0].low * 255, verdict.high = witness.color[0].high * 255;
      const int pixel = witness.pixels.empty() ? 0 : witness.pixels[0];
      verdict.x = pixel % expected.width, verdict.y = pixel / expected.width;
      verdict.got = color[size_t(4 * pixel)];
    }
  }
  const std::string lie = too_many_values(color, precision);
  verdict.pass = verdict.wrong_pixels == 0 && lie.empty(), verdict.text = lie;
  if (verdict.wrong_pixels) {
    char text[200];
    std::snprintf(text, sizeof text, "%d pixels are wrong; at %d,%d %s is %d and should be %.1f to %.1f",
                  verdict.wrong_pixels, verdict.x, verdict.y,
                  (const char*[]){"red", "green", "blue", "alpha"}[verdict.component], verdict.got,
                  verdict.low, verdict.high);
    verdict.text = text;
  }
  return verdict;
}

std::vector<uint8_t> expected_bytes(const Expectation& expected) {
  std::vector<uint8_t> bytes;
  for (const auto& answers : expected.pixels)
    for (const Interval& c : answers[0].color) bytes.push_back(uint8_t(std::lround(c.middle() * 255)));
  for (const Witness& w : expected.witnesses)
    if (!w.pixels.empty())
      for (size_t c = 0; c < 4; c++)
        bytes[size_t(4 * w.pixels[w.pixels.size() / 2]) + c] =
            uint8_t(std::lround(w.color[c].middle() * 255));
  return bytes;
}

} // namespace softgl::suite
