// The frame of a plot as SVG: axes with ticks, and where values lie in it.
//
//   Axis          a label, a range, linear or logarithmic
//   linearAxis, logAxis
//   PlotFrame     two axes and what is drawn between them
//   lineThrough, dotsAt, squaresAt   what is drawn through points
//
// Colours are classes of report.css, so that plots follow light, dark and print.
#pragma once

#include "report/html_text.h"

#include <span>
#include <string>
#include <vector>

namespace pathmark::report {

struct Tick {
  double value = 0.0;
  std::string label;
};

struct Axis {
  std::string label;
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  std::vector<Tick> ticks;

  // 0 at `low`, 1 at `high`; values outside are moved to the nearer end, NaN to `low`.
  double position(double value) const;
};

// Ticks at multiples of 1, 2 or 5 times a power of ten. A range that is empty or not finite becomes
// one of width 1.
Axis linearAxis(std::string label, double low, double high);

// Ticks at powers of `base`, from the one below `low` to the one above `high`; both are positive.
Axis logAxis(std::string label, double low, double high, double base);

struct Point {
  double x = 0.0, y = 0.0;
};

class PlotFrame {
 public:
  PlotFrame(Axis x, Axis y) : x_(std::move(x)), y_(std::move(y)) {}

  // In units of the drawing.
  double x(double value) const;
  double y(double value) const;
  Point at(double valueX, double valueY) const { return {x(valueX), y(valueY)}; }

  // From the horizontal axis up to a value.
  Markup bar(double low, double high, double value, std::string_view kind) const;

  // `title` is for those who cannot see it.
  Markup svg(std::string_view title, const Markup& inside) const;

 private:
  Markup axes() const;

  Axis x_, y_;
};

Markup lineThrough(std::span<const Point> points, std::string_view kind);

// Round or square marks at the points.
Markup dotsAt(std::span<const Point> points, std::string_view kind);
Markup squaresAt(std::span<const Point> points, std::string_view kind);

}  // namespace pathmark::report
