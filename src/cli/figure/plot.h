// Curves over axes, and lobes around a point of a surface.
#pragma once

#include <functional>

#include "figure/drawing.h"
#include "figure/language.h"

namespace softgl::cli {

struct Frame {
  double left, top, width, height;
};

struct Axis {
  double low, high, step; // of the marks
  std::string name;       // a formula
  int digits = 0;         // of the marks' numbers
};

class Plot {
public:
  // Draws the axes around the frame. The drawing outlives the plot.
  Plot(Drawing& drawing, Frame frame, const Axis& x, const Axis& y, Language language);

  Point place(double x, double y) const;
  // Through these values.
  void curve(const std::string& name, const std::vector<Point>& values, const Color& color,
             double width = 2.5, bool dashed = false);
  // At x from the axis' beginning to its end, in equal steps.
  void curve(const std::string& name, int steps, const std::function<double(double)>& y, const Color& color,
             double width = 2.5, bool dashed = false);
  // What a curve is, beside the frame: the first entry at the top.
  void legend(const std::string& formula, const Color& color);

private:
  Drawing& drawing_;
  Frame frame_;
  Axis x_, y_;
  int entries_ = 0;
};

// Angles in degrees from the normal, which points up, to the right.
class PolarPlot {
public:
  // A surface, its normal, and half circles where the value is a half and one; `unit` on the page is one.
  PolarPlot(Drawing& drawing, Point origin, double unit, Language language);

  Point place(double angle, double radius) const;
  void lobe(const std::string& name, double from, double to, int steps,
            const std::function<double(double)>& radius, const Color& color, double opacity = 0);
  // From the surface's point to a radius, with a letter at its end.
  void vector(double angle, double radius, const std::string& letter, const Color& color);

private:
  Drawing& drawing_;
  Point origin_;
  double unit_;
};

} // namespace softgl::cli
