#include "figure/drawing.h"

#include <algorithm>
#include <cmath>

#include "figure/formula.h"
#include "image/lettering.h"

namespace softgl::cli {

void Drawing::line(Point from, Point to, const Color& color, double line_width, bool dashed) {
  Shape shape;
  shape.points = {from, to};
  shape.line = color;
  shape.width = line_width;
  shape.dashed = dashed;
  parts.emplace_back(std::move(shape));
}

void Drawing::arrow(Point from, Point to, const Color& color, double line_width) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  if (length == 0) return;
  const double x = dx / length, y = dy / length, head = 4.5 * line_width, half = 0.4 * head;
  const Point neck{to.x - head * x, to.y - head * y};
  line(from, neck, color, line_width);
  polygon({to, {neck.x - half * y, neck.y + half * x}, {neck.x + half * y, neck.y - half * x}}, color);
}

void Drawing::polygon(std::vector<Point> points, const Color& fill, double opacity) {
  Shape shape;
  shape.points = std::move(points);
  shape.closed = true;
  shape.fill = fill;
  shape.opacity = opacity;
  parts.emplace_back(std::move(shape));
}

void Drawing::words(Point at, std::string text, double size, Words::Anchor anchor, const Color& color) {
  parts.emplace_back(Words{at, std::move(text), size, anchor, color, false});
}

void Drawing::formula(Point at, std::string text, double size, Words::Anchor anchor, const Color& color) {
  parts.emplace_back(Words{at, std::move(text), size, anchor, color, true});
}

void Drawing::append(Drawing other, Point offset) {
  const auto move = [offset](Point& p) { p.x += offset.x, p.y += offset.y; };
  for (DrawingPart& part : other.parts) {
    if (auto* shape = std::get_if<Shape>(&part)) {
      for (Point& p : shape->points) move(p);
      move(shape->scale.origin);
    } else if (auto* text = std::get_if<Words>(&part))
      move(text->at);
    else
      move(std::get<PlacedPicture>(part).at);
    parts.push_back(std::move(part));
  }
}

double width_of(const Words& words) {
  return words.formula ? formula_width(words.text, words.size) : text_width(words.text, words.size);
}

std::vector<std::string> text_lines(const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    std::string longer = line;
    if (!longer.empty()) longer += ' ';
    longer += word;
    if (!line.empty() && text_width(longer, size) > width) {
      lines.push_back(line);
      line = word;
    } else
      line = longer;
    at = end + 1;
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

} // namespace softgl::cli
