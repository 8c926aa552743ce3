// A plot with two logarithmic axes.
//
//   PlotCurve   points that are joined
//   LogPlot     curves, lines that guide the eye, axes, a legend, and the numbers under the mouse
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pathmark::preview {

struct PlotPoint {
  double x = 1.0, y = 1.0;  // positive
};

enum class PlotMark { kNone, kDot, kSquare };

struct PlotCurve {
  std::string name;  // in the legend; empty: not there
  std::vector<PlotPoint> points;
  std::uint32_t colour = 0xffffffff;  // as IM_COL32 has it
  PlotMark mark = PlotMark::kNone;
  bool dashed = false;
  bool guide = false;  // does not make the axes longer, and has no numbers to be read
};

struct LogPlot {
  std::string xName, yName;
  std::vector<PlotCurve> curves;

  // In the current window, as wide as it is; `height` is that of the plot without its legend.
  void draw(float height, float scale) const;
};

// A curve through `point`, y being proportional to x^slope, over the whole of [from, to].
PlotCurve slopeGuide(const PlotPoint& point, double slope, double from, double to);

}  // namespace pathmark::preview
