// Log-log charts as SVG, for pages and for files.
//
//   ChartPoint, ChartLine, LogChart   what is drawn
//   chartSvg        one chart; its colours are classes of chartStyle, so that it follows light,
//                   dark and print
//   chartStyle      the classes, for a page
//   chartFile       charts below each other as a file of its own, dark on white
//   escaped         text for HTML and XML
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pathmark::bench {

struct ChartPoint {
  double x = 0.0, y = 0.0;       // positive
  double low = 0.0, high = 0.0;  // of y; equal, or not positive, where unknown
};

struct ChartLine {
  std::string name, note;  // in the legend
  std::vector<ChartPoint> points;
  int colour = 0;  // lines of one colour belong together
  int kind = 0;    // 0, 1, 2: circles and a full line, squares and dashes, triangles and dots
};

struct LogChart {
  std::string title, xLabel, yLabel;
  std::vector<ChartLine> lines;
  double guideSlope = 0.0;  // of a thin line for the eye; 0: none
};

std::string chartSvg(const LogChart& chart);
std::string_view chartStyle();
std::string chartFile(const std::vector<LogChart>& charts);

std::string escaped(std::string_view text);

}  // namespace pathmark::bench
