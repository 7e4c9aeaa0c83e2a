// What is on a page: lines, areas, words and pictures. svg_writer makes SVG of it, drawing_painter pixels.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "image/shape_filling.h"

namespace softgl::cli {

inline constexpr Color kInk = {0x22, 0x26, 0x2b}, kGray = {0x8a, 0x90, 0x96}, kPale = {0xdd, 0xe1, 0xe5},
                       kBlue = {0x1f, 0x5f, 0xa8}, kOrange = {0xd0, 0x74, 0x1c}, kGreen = {0x2f, 0x85, 0x44},
                       kRed = {0xbd, 0x2f, 0x37}, kYellow = {0xf2, 0xb9, 0x1d}, kPaper = {0xff, 0xff, 0xff};

// A curve's points are values of x and y: x = (page x - origin.x) / unit.x, y = (origin.y - page y) / unit.y.
struct CurveScale {
  Point origin, unit;
};

struct Shape {
  std::vector<Point> points;
  bool closed = false;
  std::optional<Color> fill, line;
  double opacity = 1; // of the area
  double width = 1.5; // of the line
  bool dashed = false;
  std::string name; // of a curve, ASCII without spaces; other shapes have none
  CurveScale scale;
};

struct Words {
  enum Anchor { kStart, kMiddle, kEnd };
  Point at; // on the line that the letters stand on
  std::string text;
  double size = 14;
  Anchor anchor = kStart;
  Color color = kInk;
  bool formula = false;
};

struct PlacedPicture {
  Point at; // left top corner
  double width = 0, height = 0;
  std::shared_ptr<const Picture> picture; // RGB
  std::string name, description;
};

using DrawingPart = std::variant<Shape, Words, PlacedPicture>;

struct Drawing {
  double width = 0, height = 0;
  std::vector<DrawingPart> parts;

  void line(Point from, Point to, const Color& color = kInk, double width = 1.5, bool dashed = false);
  void arrow(Point from, Point to, const Color& color, double width = 2.5);
  void polygon(std::vector<Point> points, const Color& fill, double opacity = 1);
  void words(Point at, std::string text, double size = 14, Words::Anchor anchor = Words::kStart,
             const Color& color = kInk);
  void formula(Point at, std::string text, double size = 14, Words::Anchor anchor = Words::kStart,
               const Color& color = kInk);
  // Moves the parts of another drawing here.
  void append(Drawing other, Point offset);
};

// How wide the words are in the program's typeface.
double width_of(const Words& words);
// Lines of text that are no wider than `width`; words that are wider stand alone.
std::vector<std::string> text_lines(const std::string& text, double size, double width);

} // namespace softgl::cli
