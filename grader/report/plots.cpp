#include "report/plots.h"

#include "report/svg_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::report {

namespace {

constexpr double kHeadroom = 1.08;  // between the highest bar and the frame

Markup figure(const Markup& plot, const Markup& caption) {
  return markup("<figure class=\"plot-figure\">{}<figcaption>{}</figcaption></figure>\n", plot,
                caption);
}

double usable(double value) { return std::isfinite(value) && value > 0.0 ? value : 0.0; }

double largestOf(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, usable(value));
  return largest;
}

// The outline of equal bins, from left to right.
std::vector<Point> outline(const PlotFrame& frame, double low, double high,
                           std::span<const double> bins) {
  std::vector<Point> points;
  const double width = (high - low) / static_cast<double>(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i)
    for (const std::size_t end : {i, i + 1})
      points.push_back(frame.at(low + width * static_cast<double>(end), usable(bins[i])));
  return points;
}

Markup bars(const PlotFrame& frame, double low, double high, std::span<const double> bins) {
  Markup drawn;
  const double width = (high - low) / static_cast<double>(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double left = low + width * static_cast<double>(i);
    drawn += frame.bar(left, left + width, usable(bins[i]), "bar-yours");
  }
  return drawn;
}

// Points of a curve; values that a logarithm does not have are left out.
std::vector<Point> curve(const PlotFrame& frame, std::span<const double> x,
                         std::span<const double> y) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
    if (usable(x[i]) > 0.0 && usable(y[i]) > 0.0) points.push_back(frame.at(x[i], y[i]));
  return points;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;

  void add(std::span<const double> values) {
    for (const double value : values)
      if (usable(value) > 0.0) low = std::min(low, value), high = std::max(high, value);
  }
  bool empty() const { return high <= 0.0; }
};

Axis percentAxis(std::string label, const Range& range) {
  Axis axis = logAxis(std::move(label), range.low, range.high, 10.0);
  for (Tick& tick : axis.ticks) tick.label = fmt::format("{:.6g} %", 100.0 * tick.value);
  return axis;
}

// How errors of noise fall, for the eye: from the upper left corner of what is drawn.
std::vector<Point> slope(const PlotFrame& frame, const Range& rays, const Range& errors) {
  return {frame.at(rays.low, errors.high),
          frame.at(rays.high, errors.high * std::sqrt(rays.low / rays.high))};
}

}  // namespace

Markup histogramPlot(const record::Histogram& histogram) {
  const double highest = std::max(largestOf(histogram.yours), largestOf(histogram.expected));
  if (highest == 0.0) return {};
  const Axis x = linearAxis(histogram.axis, histogram.low, histogram.high);
  const PlotFrame frame(x, linearAxis("share of samples", 0.0, kHeadroom * highest));
  Markup inside = bars(frame, x.low, x.high, histogram.yours);
  if (!histogram.expected.empty())
    inside += lineThrough(outline(frame, x.low, x.high, histogram.expected), "line-expected");
  return figure(frame.svg(fmt::format("Histogram of {}", histogram.axis), inside),
                Markup{"<span class=\"key key-bar\">yours</span> "
                       "<span class=\"key key-expected\">expected</span>"});
}

Markup pValuePlot(std::span<const std::uint32_t> bins) {
  std::vector<double> counts(bins.begin(), bins.end());
  const double highest = largestOf(counts);
  if (highest == 0.0) return {};
  double sum = 0.0;
  for (const double count : counts) sum += count;
  const double flat = sum / static_cast<double>(counts.size());
  const PlotFrame frame(linearAxis("p-value", 0.0, 1.0),
                        linearAxis("pixels", 0.0, kHeadroom * highest));
  Markup inside = bars(frame, 0.0, 1.0, counts);
  const Point line[] = {frame.at(0.0, flat), frame.at(1.0, flat)};
  inside += lineThrough(line, "line-expected");
  return figure(frame.svg("Histogram of the p-values of pixels", inside),
                Markup{"<span class=\"key key-bar\">p-values of pixels</span> "
                       "<span class=\"key key-expected\">nothing but noise</span>"});
}

Markup convergencePlot(const record::PictureRecord::Convergence& convergence) {
  Range rays, errors;
  rays.add(convergence.raysPerPixel);
  errors.add(convergence.yours);
  errors.add(convergence.solutions);
  // Room for the slope above the curves.
  errors.high *= 1.6;
  if (rays.empty() || errors.empty()) return {};
  const PlotFrame frame(logAxis("rays per pixel", rays.low, rays.high, 4.0),
                        percentAxis("relative error", errors));
  const std::vector<Point> yours = curve(frame, convergence.raysPerPixel, convergence.yours);
  const std::vector<Point> solutions =
      curve(frame, convergence.raysPerPixel, convergence.solutions);
  Markup inside = lineThrough(slope(frame, rays, errors), "line-slope");
  inside += lineThrough(solutions, "line-expected");
  inside += squaresAt(solutions, "square-expected");
  inside += lineThrough(yours, "line-yours");
  inside += dotsAt(yours, "dot-yours");
  return figure(frame.svg("Error against rays per pixel", inside),
                Markup{"<span class=\"key key-yours\">yours</span> "
                       "<span class=\"key key-expected\">solutions</span> "
                       "<span class=\"key key-slope\">1/&#8730;N</span>"});
}

Markup distributionPlot(std::span<const double> points, double outOf) {
  if (points.empty() || !(outOf > 0.0)) return {};
  constexpr std::size_t kBins = 10;
  std::vector<double> counts(kBins, 0.0);
  for (const double p : points) {
    const double bin = std::clamp(usable(p) / outOf * kBins, 0.0, kBins - 1.0);
    counts[static_cast<std::size_t>(bin)] += 1.0;
  }
  // Ticks at whole submissions.
  const PlotFrame frame(
      linearAxis("points", 0.0, outOf),
      linearAxis("submissions", 0.0, std::max(kHeadroom * largestOf(counts), 4.0)));
  return frame.svg("Distribution of the marks", bars(frame, 0.0, outOf, counts));
}

Markup pointsBar(double points, double outOf) {
  const double share = outOf > 0.0 ? std::clamp(points / outOf, 0.0, 1.0) : 0.0;
  return markup(
      "<svg class=\"bar\" viewBox=\"0 0 100 8\" preserveAspectRatio=\"none\" aria-hidden=\"true\">"
      "<rect class=\"bar-rest\" width=\"100\" height=\"8\"/>"
      "<rect class=\"bar-got\" width=\"{:.1f}\" height=\"8\"/></svg>",
      std::isfinite(share) ? 100.0 * share : 0.0);
}

}  // namespace pathmark::report
