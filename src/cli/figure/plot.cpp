#include "figure/plot.h"

#include <algorithm>
#include <cmath>

#include "common/trigonometry.h"

namespace softgl::cli {
namespace {

constexpr double kMarkSize = 12;

} // namespace

Plot::Plot(Drawing& drawing, Frame frame, const Axis& x, const Axis& y, Language language)
    : drawing_(drawing), frame_(frame), x_(x), y_(y) {
  const double bottom = frame.top + frame.height, right = frame.left + frame.width;
  const auto marks = [](const Axis& axis) { return int(std::lround((axis.high - axis.low) / axis.step)); };
  for (int i = 0; i <= marks(x); ++i) {
    const double value = x.low + i * x.step, at = place(value, y.low).x;
    drawing.line({at, frame.top}, {at, bottom}, kPale, 1);
    drawing.words({at, bottom + 18}, number_text(value, x.digits, language), kMarkSize, Words::kMiddle,
                  kGray);
  }
  for (int i = 0; i <= marks(y); ++i) {
    const double value = y.low + i * y.step, at = place(x.low, value).y;
    drawing.line({frame.left, at}, {right, at}, kPale, 1);
    drawing.words({frame.left - 7, at + 4}, number_text(value, y.digits, language), kMarkSize, Words::kEnd,
                  kGray);
  }
  const Point zero = place(std::clamp(0.0, x.low, x.high), std::clamp(0.0, y.low, y.high));
  drawing.line({frame.left, zero.y}, {right, zero.y}, kGray, 1.5);
  drawing.line({frame.left, frame.top}, {frame.left, bottom}, kGray, 1.5);
  drawing.formula({frame.left + frame.width / 2, bottom + 38}, x.name, 14, Words::kMiddle);
  drawing.formula({frame.left - 8, frame.top - 14}, y.name, 14);
}

Point Plot::place(double x, double y) const {
  return {frame_.left + (x - x_.low) / (x_.high - x_.low) * frame_.width,
          frame_.top + (y_.high - y) / (y_.high - y_.low) * frame_.height};
}

void Plot::curve(const std::string& name, const std::vector<Point>& values, const Color& color, double width,
                 bool dashed) {
  Shape shape;
  for (const Point value : values) shape.points.push_back(place(value.x, value.y));
  shape.line = color;
  shape.width = width;
  shape.dashed = dashed;
  shape.name = name;
  const Point zero = place(0, 0), one = place(1, 1);
  shape.scale = {zero, {one.x - zero.x, zero.y - one.y}};
  drawing_.parts.emplace_back(std::move(shape));
}

void Plot::curve(const std::string& name, int steps, const std::function<double(double)>& y,
                 const Color& color, double width, bool dashed) {
  std::vector<Point> values;
  for (int i = 0; i <= steps; ++i) {
    const double x = x_.low + (x_.high - x_.low) * i / steps;
    values.push_back({x, y(x)});
  }
  curve(name, values, color, width, dashed);
}

void Plot::legend(const std::string& formula, const Color& color) {
  const double y = frame_.top + 12 + 24 * entries_++, x = frame_.left + frame_.width + 14;
  drawing_.line({x, y - 5}, {x + 22, y - 5}, color, 3);
  drawing_.formula({x + 30, y}, formula, 13);
}

PolarPlot::PolarPlot(Drawing& drawing, Point origin, double unit, Language language)
    : drawing_(drawing), origin_(origin), unit_(unit) {
  for (const double radius : {0.5, 1.0}) {
    Shape circle;
    for (int angle = -90; angle <= 90; angle += 3) circle.points.push_back(place(angle, radius));
    circle.line = kPale;
    circle.width = 1;
    drawing.parts.emplace_back(std::move(circle));
    drawing.words({origin.x + radius * unit, origin.y + 18}, number_text(radius, 1, language), kMarkSize,
                  Words::kMiddle, kGray);
  }
  for (int angle = -60; angle <= 60; angle += 30) drawing.line(origin, place(angle, 1), kPale, 1);
  drawing.line(place(-90, 1.1), place(90, 1.1), kInk, 3);
}

Point PolarPlot::place(double angle, double radius) const {
  return {origin_.x + unit_ * radius * sine(angle), origin_.y - unit_ * radius * cosine(angle)};
}

void PolarPlot::lobe(const std::string& name, double from, double to, int steps,
                     const std::function<double(double)>& radius, const Color& color, double opacity) {
  Shape shape;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    shape.points.push_back(place(angle, radius(angle)));
  }
  shape.line = color;
  shape.width = 2.5;
  shape.name = name;
  shape.scale = {origin_, {unit_, unit_}};
  if (opacity > 0) {
    shape.fill = color;
    shape.opacity = opacity;
  }
  drawing_.parts.emplace_back(std::move(shape));
}

void PolarPlot::vector(double angle, double radius, const std::string& letter, const Color& color) {
  drawing_.arrow(origin_, place(angle, radius), color);
  const Point end = place(angle, radius + 16 / unit_);
  drawing_.formula({end.x, end.y + 5}, letter, 17, Words::kMiddle, color);
}

} // namespace softgl::cli
