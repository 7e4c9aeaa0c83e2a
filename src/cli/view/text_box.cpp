#include "view/text_box.h"

#include <algorithm>
#include <cmath>

#include "image/lettering.h"

namespace softgl::cli {
namespace {

constexpr int kMargin = 10; // pixels
constexpr Color kGround = {16, 18, 22}, kText = {235, 238, 242};
constexpr int kGroundAlpha = 208;

// A line, in one or two columns.
struct Line {
  std::string left, right;
};

std::vector<Line> broken(const std::vector<std::string>& lines, double size, double most) {
  std::vector<Line> parts;
  for (const std::string& line : lines) {
    const size_t tab = line.find('\t');
    if (tab != std::string::npos) {
      parts.push_back({line.substr(0, tab), line.substr(tab + 1)});
      continue;
    }
    std::string part;
    for (size_t i = 0, next; i < line.size(); i = next) {
      next = i + 1;
      while (next < line.size() && (uint8_t(line[next]) & 0xc0) == 0x80) ++next; // of one letter
      const std::string letter = line.substr(i, next - i);
      if (text_width(part + letter, size) > most) {
        const size_t space = part.rfind(' ');
        const size_t cut = space == std::string::npos || space == 0 ? part.size() : space + 1;
        parts.push_back({part.substr(0, cut), {}});
        part.erase(0, cut);
      }
      part += letter;
    }
    parts.push_back({part, {}});
  }
  return parts;
}

// Opaque where there are letters.
Picture with_alpha(const Picture& rgb) {
  Picture box;
  box.channels = 4;
  box.width = rgb.width, box.height = rgb.height;
  uint8_t* pixel = box.pixels.extend(size_t(4) * size_t(box.width) * size_t(box.height));
  for (size_t i = 0; i < rgb.pixels.size(); i += 3, pixel += 4) {
    std::copy(&rgb.pixels[i], &rgb.pixels[i] + 3, pixel);
    pixel[3] =
        uint8_t(kGroundAlpha + (255 - kGroundAlpha) * (rgb.pixels[i] - kGround[0]) / (kText[0] - kGround[0]));
  }
  return box;
}

Picture draw_box(const std::vector<std::string>& lines, int most_width, double size) {
  const std::vector<Line> parts = broken(lines, size, most_width - 2 * kMargin);
  double column = 0, width = 0;
  for (const Line& part : parts)
    if (!part.right.empty()) column = std::max(column, text_width(part.left, size) + size);
  for (const Line& part : parts)
    width = std::max(width, part.right.empty() ? text_width(part.left, size)
                                               : column + text_width(part.right, size));
  Picture box;
  box.channels = 3;
  box.width = int(std::ceil(width)) + 2 * kMargin;
  box.height = int(std::ceil(double(parts.size()) * size)) + 2 * kMargin;
  uint8_t* pixel = box.pixels.extend(size_t(3) * size_t(box.width) * size_t(box.height));
  for (size_t i = 0; i < box.pixels.size(); i += 3) std::copy(kGround.begin(), kGround.end(), pixel + i);
  for (size_t i = 0; i < parts.size(); ++i) {
    const double base = kMargin + (double(i) + 0.8) * size;
    draw_text(box, kMargin, base, size, parts[i].left, kText);
    draw_text(box, kMargin + column, base, size, parts[i].right, kText);
  }
  return with_alpha(box);
}

} // namespace

Picture draw_text_box(const std::vector<std::string>& lines, int most_width, int most_height) {
  constexpr double kLarge = 20, kSmall = 11; // of a line, in pixels
  Picture box = draw_box(lines, std::max(most_width, 100), kLarge);
  if (box.width > most_width || box.height > most_height)
    box = draw_box(lines, std::max(most_width, 100), kSmall);
  return box;
}

} // namespace softgl::cli
