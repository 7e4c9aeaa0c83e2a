#include "figure/drawing_painter.h"

#include <algorithm>
#include <cmath>

#include "figure/formula.h"
#include "image/lettering.h"

namespace softgl::cli {
namespace {

constexpr double kLineScale = 2;

// The pieces of a dashed line, `dash` long with gaps of the same length.
std::vector<std::vector<Point>> dashes(const std::vector<Point>& points, double dash) {
  std::vector<std::vector<Point>> pieces;
  double done = 0; // of the present dash or gap
  bool drawn = true;
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    Point a = points[i];
    const Point b = points[i + 1];
    if (drawn && (pieces.empty() || done == 0)) pieces.push_back({a});
    for (double left = std::hypot(b.x - a.x, b.y - a.y); left > 0;) {
      const double step = std::min(left, dash - done);
      a = {a.x + (b.x - a.x) * step / left, a.y + (b.y - a.y) * step / left};
      left -= step;
      done += step;
      if (drawn) pieces.back().push_back(a);
      if (done < dash - 1e-9) continue;
      done = 0;
      drawn = !drawn;
      if (drawn && left > 0) pieces.push_back({a});
    }
  }
  return pieces;
}

class Painter {
public:
  Painter(Picture& picture, double scale) : picture_(picture), scale_(scale) {}

  void operator()(const Shape& shape) const {
    std::vector<Point> points = shape.points;
    for (Point& p : points) p = {p.x * scale_, p.y * scale_};
    if (shape.fill) fill_polygons(picture_, {points}, *shape.fill, shape.opacity);
    if (!shape.line) return;
    const double width = shape.width * scale_;
    if (!shape.dashed) return stroke_line(picture_, points, shape.closed, width, *shape.line);
    for (const std::vector<Point>& dash : dashes(points, 3 * width))
      stroke_line(picture_, dash, false, width, *shape.line);
  }

  void operator()(const Words& words) const {
    const double size = words.size * scale_, width = width_of(words) * scale_;
    double x = words.at.x * scale_ - (words.anchor == Words::kStart    ? 0
                                      : words.anchor == Words::kMiddle ? width / 2
                                                                       : width);
    const double y = words.at.y * scale_;
    if (!words.formula) return draw_text(picture_, x, y, size, words.text, words.color);
    for (const FormulaRun& run : formula_runs(words.text)) {
      const bool small = run.level != FormulaRun::kBase;
      const double letters = small ? size * kSmallLetters : size;
      const double down = run.level == FormulaRun::kBelow   ? kMovedDown * size
                          : run.level == FormulaRun::kAbove ? -kMovedUp * size
                                                            : 0;
      draw_text(picture_, x, y + down, letters, run.text, words.color);
      x += text_width(run.text, letters);
    }
  }

  // Sampled at the nearest pixel, which at the natural scale is a copy.
  void operator()(const PlacedPicture& placed) const {
    const Picture& from = *placed.picture;
    const int left = int(std::lround(placed.at.x * scale_)), top = int(std::lround(placed.at.y * scale_));
    const int width = int(std::lround(placed.width * scale_)),
              height = int(std::lround(placed.height * scale_));
    for (int y = std::max(0, -top); y < std::min(height, picture_.height - top); ++y)
      for (int x = std::max(0, -left); x < std::min(width, picture_.width - left); ++x) {
        const auto column = size_t(int64_t(x) * from.width / width),
                   row = size_t(int64_t(y) * from.height / height);
        std::copy_n(&from.pixels[3 * (row * size_t(from.width) + column)], 3,
                    &picture_.pixels[3 * (size_t(top + y) * size_t(picture_.width) + size_t(left + x))]);
      }
  }

private:
  Picture& picture_;
  double scale_;
};

} // namespace

Picture paint(const Drawing& drawing, double scale) {
  Picture picture;
  picture.width = int(std::ceil(drawing.width * scale));
  picture.height = int(std::ceil(drawing.height * scale));
  picture.pixels.fill(size_t(3) * size_t(picture.width) * size_t(picture.height), 255);
  const Painter painter(picture, scale);
  for (const DrawingPart& part : drawing.parts) std::visit(painter, part);
  return picture;
}

double natural_scale(const Drawing& drawing) {
  for (const DrawingPart& part : drawing.parts)
    if (const auto* placed = std::get_if<PlacedPicture>(&part)) return placed->picture->width / placed->width;
  return kLineScale;
}

} // namespace softgl::cli
