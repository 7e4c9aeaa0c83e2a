#include "view/text_box.h"

#include <algorithm>

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <stb/stb_easy_font.h>
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

namespace softgl::cli {
namespace {

constexpr int kLine = 11;   // units of the font
constexpr int kMargin = 10; // pixels
constexpr uint8_t kGround[4] = {16, 18, 22, 208}, kText[4] = {235, 238, 242, 255};

// The font has the letters of ASCII; others, letter by letter of UTF-8, become question marks.
std::string ascii_only(const std::string& text) {
  std::string out;
  for (const char c : text)
    if ((uint8_t(c) & 0xc0) != 0x80) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

int width_of(std::string text) { return stb_easy_font_width(text.data()); } // in units

// A line, in one or two columns.
struct Line {
  std::string left, right;
};

std::vector<Line> broken(const std::vector<std::string>& lines, int most) {
  std::vector<Line> parts;
  for (const std::string& line : lines) {
    const size_t tab = line.find('\t');
    if (tab != std::string::npos) {
      parts.push_back({ascii_only(line.substr(0, tab)), ascii_only(line.substr(tab + 1))});
      continue;
    }
    std::string part;
    for (const char c : ascii_only(line)) {
      if (width_of(part + c) > most) {
        const size_t space = part.rfind(' ');
        const size_t cut = space == std::string::npos || space == 0 ? part.size() : space + 1;
        parts.push_back({part.substr(0, cut), {}});
        part.erase(0, cut);
      }
      part += c;
    }
    parts.push_back({part, {}});
  }
  return parts;
}

// Each letter is a few upright rectangles.
void draw_line(std::string text, int left, int top, int unit, Picture& box) {
  struct Vertex { // stb_easy_font's
    float x, y, z;
    uint8_t color[4];
  };
  std::vector<Vertex> vertices(4 * 70 * (text.size() + 1)); // at most 70 rectangles a letter
  const int count =
      stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(), int(vertices.size() * sizeof(Vertex)));
  for (size_t i = 0; i < 4 * size_t(count); i += 4) {
    const Vertex &low = vertices[i], &high = vertices[i + 2];
    for (int y = top + unit * int(low.y); y < top + unit * int(high.y); ++y)
      for (int x = left + unit * int(low.x); x < left + unit * int(high.x); ++x)
        if (x >= 0 && y >= 0 && x < box.width && y < box.height)
          std::copy(kText, kText + 4, &box.pixels[4 * (size_t(y) * size_t(box.width) + size_t(x))]);
  }
}

// `unit`: pixels of the font's unit.
Picture draw_box(const std::vector<std::string>& lines, int most_width, int unit) {
  const std::vector<Line> parts = broken(lines, (most_width - 2 * kMargin) / unit);
  int column = 0, width = 0;
  for (const Line& part : parts)
    if (!part.right.empty()) column = std::max(column, width_of(part.left) + kLine);
  for (const Line& part : parts)
    width = std::max(width, part.right.empty() ? width_of(part.left) : column + width_of(part.right));
  Picture box;
  box.channels = 4;
  box.width = unit * width + 2 * kMargin;
  box.height = int(parts.size()) * unit * kLine + 2 * kMargin - unit;
  uint8_t* pixel = box.pixels.extend(size_t(4) * size_t(box.width) * size_t(box.height));
  for (size_t i = 0; i < box.pixels.size(); i += 4) std::copy(kGround, kGround + 4, pixel + i);
  for (size_t i = 0; i < parts.size(); ++i) {
    const int top = kMargin + int(i) * unit * kLine;
    draw_line(parts[i].left, kMargin, top, unit, box);
    draw_line(parts[i].right, kMargin + unit * column, top, unit, box);
  }
  return box;
}

} // namespace

Picture draw_text_box(const std::vector<std::string>& lines, int most_width, int most_height) {
  Picture box = draw_box(lines, std::max(most_width, 100), 2);
  if (box.width > most_width || box.height > most_height) box = draw_box(lines, std::max(most_width, 100), 1);
  return box;
}

} // namespace softgl::cli
