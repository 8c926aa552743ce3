#include "preview/compare/compare_widgets.h"
#include "preview/compare/log_plot.h"

#include <imgui.h>

#include <algorithm>

namespace pathmark::preview {

namespace {

constexpr ImU32 kMeasured = IM_COL32(90, 170, 255, 255), kExpected = IM_COL32(255, 165, 50, 255);
constexpr ImU32 kBefore = IM_COL32(150, 150, 150, 255), kGuide = IM_COL32(110, 110, 115, 255);
constexpr ImU32 kFloor = IM_COL32(190, 120, 200, 255);

using Error = std::optional<double> ErrorPoint::*;

std::vector<PlotPoint> pointsOf(const ErrorCurve& curve, Error error, bool byTime) {
  std::vector<PlotPoint> points;
  for (const ErrorPoint& point : curve.points) {
    const double x = byTime ? point.seconds : point.raysPerPixel;
    if (x > 0.0 && point.*error) points.push_back({x, *(point.*error)});
  }
  return points;
}

// Curves before lie below the one in work.
void addCurves(LogPlot& plot, const CompareResult& result, bool byTime) {
  const ErrorCurves& curves = result.curves;
  const Error shown = result.found.reference ? &ErrorPoint::measured : &ErrorPoint::expected;
  for (const ErrorCurve& curve : curves.before()) {
    std::vector<PlotPoint> points = pointsOf(curve, shown, byTime);
    if (!points.empty())
      plot.curves.push_back(
          {.name = "before: " + curve.name, .points = std::move(points), .colour = kBefore});
  }
  std::vector<PlotPoint> expected = pointsOf(curves.current(), &ErrorPoint::expected, byTime);
  if (!expected.empty())
    plot.curves.push_back({.name = "expected from its noise",
                           .points = std::move(expected),
                           .colour = kExpected,
                           .mark = PlotMark::kSquare});
  std::vector<PlotPoint> measured = pointsOf(curves.current(), &ErrorPoint::measured, byTime);
  if (!measured.empty())
    plot.curves.push_back({.name = "measured",
                           .points = std::move(measured),
                           .colour = kMeasured,
                           .mark = PlotMark::kDot});
}

// Noise falls in proportion to one over the rays: a line of that slope, below the first point of
// the last curve. And the level that the reference's own noise sets.
void addGuides(LogPlot& plot, const CompareResult& result) {
  double from = plot.curves.back().points.front().x, to = from;
  for (const PlotCurve& curve : plot.curves)
    for (const PlotPoint& point : curve.points) {
      from = std::min(from, point.x);
      to = std::max(to, point.x);
    }
  constexpr double kBeyond = 4.0;
  PlotPoint below = plot.curves.back().points.front();
  below.y *= 0.5;
  PlotCurve slope = slopeGuide(below, -1.0, from / kBeyond, to * kBeyond);
  slope.name = "slope -1";
  slope.colour = kGuide;
  plot.curves.insert(plot.curves.begin(), std::move(slope));
  const double floor = result.referenceNoise.value_or(0.0);
  if (floor > 0.0)
    plot.curves.insert(plot.curves.begin(), {.name = "noise of the reference",
                                             .points = {{from, floor}, {to, floor}},
                                             .colour = kFloor,
                                             .dashed = true});
}

}  // namespace

void drawErrorCurves(const CompareResult& result, bool& byTime, float height, float scale) {
  ImGui::TextUnformatted("Error over");
  ImGui::SameLine();
  if (ImGui::RadioButton("time", byTime)) byTime = true;
  ImGui::SameLine();
  if (ImGui::RadioButton("rays per pixel", !byTime)) byTime = false;
  LogPlot plot{.xName = byTime ? "seconds" : "rays per pixel",
               .yName = "relative mean squared error",
               .curves = {}};
  addCurves(plot, result, byTime);
  if (plot.curves.empty())
    return ImGui::TextDisabled("There is nothing to draw before the noise is known.");
  addGuides(plot, result);
  plot.draw(height, scale);
}

}  // namespace pathmark::preview
