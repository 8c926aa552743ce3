#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>

namespace pathmark::report {

namespace {

// Small units, so that text of 11 units can be read where a plot is as wide as a phone.
constexpr double kWidth = 320.0, kHeight = 200.0;
constexpr double kLeft = 54.0, kRight = 18.0, kTop = 10.0, kBottom = 36.0;

double niceStep(double range) {
  const double rough = range / 4.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough * 0.999) return factor * power;
  return 10.0 * power;
}

}  // namespace

double Axis::position(double value) const {
  const double t =
      logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return std::isnan(t) ? 0.0 : std::clamp(t, 0.0, 1.0);
}

Axis linearAxis(std::string label, double low, double high) {
  if (!std::isfinite(low)) low = 0.0;
  if (!std::isfinite(high - low) || high <= low) high = low + 1.0;
  Axis axis{std::move(label), low, high, false, {}};
  const double step = niceStep(high - low);
  const double first = std::ceil(low / step - 1e-6);
  for (int i = 0; (first + i) * step <= high + 1e-6 * step; ++i) {
    // A sum of 0 avoids "-0".
    const double value = (first + i) * step + 0.0;
    axis.ticks.push_back(
        {value, fmt::format("{:.4g}", std::abs(value) < 1e-9 * step ? 0.0 : value)});
  }
  return axis;
}

Axis logAxis(std::string label, double low, double high, double base) {
  const double first = std::floor(std::log(low) / std::log(base) + 1e-9);
  const double last = std::max(std::ceil(std::log(high) / std::log(base) - 1e-9), first + 1.0);
  Axis axis{std::move(label), std::pow(base, first), std::pow(base, last), true, {}};
  const double step = std::ceil((last - first) / 6.0);
  for (double power = first; power <= last; power += step) {
    const double value = std::pow(base, power);
    axis.ticks.push_back({value, fmt::format("{:.4g}", value)});
  }
  return axis;
}

double PlotFrame::x(double value) const {
  return kLeft + (kWidth - kLeft - kRight) * x_.position(value);
}

double PlotFrame::y(double value) const {
  return kHeight - kBottom - (kHeight - kTop - kBottom) * y_.position(value);
}

Markup PlotFrame::bar(double low, double high, double value, std::string_view kind) const {
  const double left = x(low), top = y(value);
  return markup("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>",
                kind, left + 0.4, top, std::max(x(high) - left - 0.8, 0.2),
                kHeight - kBottom - top);
}

Markup PlotFrame::axes() const {
  const double bottom = kHeight - kBottom, right = kWidth - kRight;
  Markup drawn;
  for (const Tick& tick : x_.ticks)
    drawn += markup(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4}</text>",
        x(tick.value), kTop, bottom + 3.0, bottom + 14.0, tick.label);
  for (const Tick& tick : y_.ticks)
    drawn += markup(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>",
        kLeft - 3.0, right, y(tick.value), kLeft - 6.0, y(tick.value) + 4.0, tick.label);
  drawn += markup("<path class=\"axis\" d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\"/>", kLeft, kTop,
                  bottom, right);
  drawn +=
      markup("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>",
             0.5 * (kLeft + right), kHeight - 6.0, x_.label);
  drawn += markup(
      "<text class=\"label\" transform=\"translate(10 {:.1f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>",
      0.5 * (kTop + bottom), y_.label);
  return drawn;
}

Markup PlotFrame::svg(std::string_view title, const Markup& inside) const {
  return markup(
      "<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}{}</svg>", kWidth,
      kHeight, title, axes(), inside);
}

Markup lineThrough(std::span<const Point> points, std::string_view kind) {
  std::string list;
  for (const Point& p : points) list += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  if (!list.empty()) list.pop_back();
  return markup("<polyline class=\"{}\" points=\"{}\"/>", kind, list);
}

Markup dotsAt(std::span<const Point> points, std::string_view kind) {
  Markup dots;
  for (const Point& p : points)
    dots += markup("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", kind, p.x, p.y);
  return dots;
}

Markup squaresAt(std::span<const Point> points, std::string_view kind) {
  Markup squares;
  for (const Point& p : points)
    squares += markup("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"5\" height=\"5\"/>",
                      kind, p.x - 2.5, p.y - 2.5);
  return squares;
}

}  // namespace pathmark::report
