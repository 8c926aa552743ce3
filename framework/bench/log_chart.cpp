#include "bench/log_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace pathmark::bench {

namespace {

constexpr double kWidth = 800.0, kLeft = 66.0, kPlotRight = 480.0, kTop = 30.0, kBottom = 46.0;
constexpr double kLeastPlot = 300.0, kLegendLine = 17.0;
constexpr int kColours = 8;

// Colours that all eyes can tell apart (Okabe & Ito 2008); on a dark page the darkest are lighter.
constexpr std::string_view kColourRules = R"(
.chart { --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #b8578f; --c4: #c98a00; --c5: #2f9bd6;
  --c6: #6b6b6b; --c7: #7a4fbf; --chart-ink: #1a1f25; --chart-soft: #56616c; --chart-grid: #d6dbe1;
  --chart-back: #fff; }
)";
constexpr std::string_view kDarkRules = R"(
@media screen and (prefers-color-scheme: dark) {
  .chart { --c0: #58aef0; --c1: #ff8a4c; --c2: #35c79b; --c3: #e79bc6; --c4: #f0b93a; --c5: #8fd0f7;
    --c6: #b5b5b5; --c7: #b79af0; --chart-ink: #e7eaed; --chart-soft: #a0abb6;
    --chart-grid: #373e46; --chart-back: #1b1f24; }
}
)";
constexpr std::string_view kShapeRules = R"(
.chart { font: 12px system-ui, "DejaVu Sans", Verdana, sans-serif; }
.chart text { fill: var(--chart-ink); }
.chart .faint { fill: var(--chart-soft); }
.chart .title { font-size: 14px; font-weight: 600; }
.chart .grid { stroke: var(--chart-grid); fill: none; }
.chart .axis { stroke: var(--chart-soft); fill: none; }
.chart .guide { stroke: var(--chart-soft); fill: none; stroke-dasharray: 1 4; }
.chart .line { fill: none; stroke-width: 1.8; stroke-linejoin: round; }
.chart .bar { fill: none; stroke-width: 1.2; }
.chart .hollow { fill: var(--chart-back); stroke-width: 1.6; }
.chart .k1 { stroke-dasharray: 7 4; }
.chart .k2 { stroke-dasharray: 2 3; }
.chart .s0 { stroke: var(--c0); } .chart .f0 { fill: var(--c0); }
.chart .s1 { stroke: var(--c1); } .chart .f1 { fill: var(--c1); }
.chart .s2 { stroke: var(--c2); } .chart .f2 { fill: var(--c2); }
.chart .s3 { stroke: var(--c3); } .chart .f3 { fill: var(--c3); }
.chart .s4 { stroke: var(--c4); } .chart .f4 { fill: var(--c4); }
.chart .s5 { stroke: var(--c5); } .chart .f5 { fill: var(--c5); }
.chart .s6 { stroke: var(--c6); } .chart .f6 { fill: var(--c6); }
.chart .s7 { stroke: var(--c7); } .chart .f7 { fill: var(--c7); }
)";

struct LogAxis {
  double low = 1.0, high = 10.0;
  std::vector<double> ticks;

  double position(double value) const { return std::log(value / low) / std::log(high / low); }
};

// Ticks at 1, 2 and 5 times powers of ten where there are few powers, else at powers only.
LogAxis axisFor(double low, double high) {
  LogAxis axis;
  if (!(low <= high)) low = high = 1.0;  // nothing to show
  const double margin = std::max(1.12, std::pow(high / low, 0.04));
  axis.low = low / margin;
  axis.high = high * margin;
  const double decades = std::log10(axis.high / axis.low);
  const double first = std::floor(std::log10(axis.low));
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 7.0)));
  for (double power = first; power <= std::log10(axis.high); power += step)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * std::pow(10.0, power);
      if (tick < axis.low || tick > axis.high || (factor > 1.0 && decades > 2.5)) continue;
      axis.ticks.push_back(tick);
    }
  return axis;
}

std::string tickLabel(double value) {
  return value >= 0.00099 && value < 1e5 ? fmt::format("{:g}", value)
                                         : fmt::format("{:.0e}", value);
}

// Where values lie in the drawing.
struct Frame {
  LogAxis x, y;
  double plotHeight = kLeastPlot;

  double height() const { return kTop + plotHeight + kBottom; }
  double bottom() const { return kTop + plotHeight; }
  double atX(double value) const { return kLeft + (kPlotRight - kLeft) * x.position(value); }
  double atY(double value) const { return bottom() - plotHeight * y.position(value); }
};

bool hasBar(const ChartPoint& p) { return p.low > 0.0 && p.high > p.low; }

Frame frameFor(const LogChart& chart) {
  constexpr double kMost = std::numeric_limits<double>::max();
  double lowX = kMost, highX = 0.0, lowY = kMost, highY = 0.0;
  for (const ChartLine& line : chart.lines)
    for (const ChartPoint& p : line.points) {
      lowX = std::min(lowX, p.x);
      highX = std::max(highX, p.x);
      // A bar that is very long may leave the drawing.
      lowY = std::min(lowY, hasBar(p) ? std::max(p.low, 0.5 * p.y) : p.y);
      highY = std::max(highY, hasBar(p) ? std::min(p.high, 2.0 * p.y) : p.y);
    }
  Frame frame{axisFor(lowX, highX), axisFor(lowY, highY)};
  frame.plotHeight =
      std::max(kLeastPlot, kLegendLine * static_cast<double>(chart.lines.size() + 1));
  return frame;
}

class Drawing {
 public:
  template <class... Args>
  void add(fmt::format_string<Args...> pattern, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), pattern, std::forward<Args>(args)...);
  }
  std::string text() const { return fmt::to_string(text_); }

 private:
  fmt::memory_buffer text_;
};

void drawAxes(Drawing& out, const LogChart& chart, const Frame& f) {
  for (const double tick : f.x.ticks)
    out.add(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>"
        "<text class=\"faint\" x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4}</text>\n",
        f.atX(tick), kTop, f.bottom(), f.bottom() + 16.0, tickLabel(tick));
  for (const double tick : f.y.ticks)
    out.add(
        "<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>"
        "<text class=\"faint\" x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
        kLeft, f.atY(tick), kPlotRight, kLeft - 7.0, f.atY(tick) + 4.0, tickLabel(tick));
  out.add("<path class=\"axis\" d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\"/>\n", kLeft, kTop,
          f.bottom(), kPlotRight);
  out.add("<text class=\"title\" x=\"{:.1f}\" y=\"18\">{}</text>\n", kLeft, escaped(chart.title));
  out.add("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
          0.5 * (kLeft + kPlotRight), f.height() - 10.0, escaped(chart.xLabel));
  out.add("<text transform=\"translate(15 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
          0.5 * (kTop + f.bottom()), escaped(chart.yLabel));
}

// Through the upper left of the plot.
void drawGuide(Drawing& out, const LogChart& chart, const Frame& f) {
  if (chart.guideSlope == 0.0) return;
  const double across = std::log(f.x.high / f.x.low);
  const double y0 = chart.guideSlope < 0.0 ? f.y.high : f.y.low;
  const double y1 = y0 * std::exp(chart.guideSlope * across);
  out.add("<path class=\"guide\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", f.atX(f.x.low), f.atY(y0),
          f.atX(f.x.high), f.atY(y1));
}

// After the last colour they begin again, with hollow marks.
std::string markClass(const ChartLine& line) {
  const int colour = line.colour % kColours;
  return line.colour < kColours ? fmt::format("f{}", colour) : fmt::format("hollow s{}", colour);
}

void drawMark(Drawing& out, const ChartLine& line, double x, double y) {
  const std::string kind = markClass(line);
  if (line.kind % 3 == 0)
    out.add("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.2\"/>", kind, x, y);
  else if (line.kind % 3 == 1)
    out.add("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"6\" height=\"6\"/>", kind,
            x - 3.0, y - 3.0);
  else
    out.add("<path class=\"{}\" d=\"M{:.1f} {:.1f}l4 7h-8z\"/>", kind, x, y - 4.2);
}

void drawLine(Drawing& out, const ChartLine& line, const Frame& f) {
  const int colour = line.colour % kColours, kind = line.kind % 3;
  Drawing path;
  for (const ChartPoint& p : line.points) path.add("{:.1f},{:.1f} ", f.atX(p.x), f.atY(p.y));
  if (line.points.size() > 1)
    out.add("<polyline class=\"line s{} k{}\" points=\"{}\"/>\n", colour, kind, path.text());
  for (const ChartPoint& p : line.points) {
    const double x = f.atX(p.x);
    if (hasBar(p)) {
      const double low = std::min(f.atY(p.low), f.bottom()), high = std::max(f.atY(p.high), kTop);
      out.add("<path class=\"bar s{0}\" d=\"M{1:.1f} {2:.1f}h6m-3 0V{3:.1f}m-3 0h6\"/>", colour,
              x - 3.0, low, high);
    }
    drawMark(out, line, x, f.atY(p.y));
    out.add("\n");
  }
}

void drawLegend(Drawing& out, const LogChart& chart) {
  double y = kTop + 6.0;
  for (const ChartLine& line : chart.lines) {
    const double x = kPlotRight + 18.0;
    out.add("<path class=\"line s{} k{}\" d=\"M{:.1f} {:.1f}h26\"/>", line.colour % kColours,
            line.kind % 3, x, y);
    drawMark(out, line, x + 13.0, y);
    out.add("<text x=\"{:.1f}\" y=\"{:.1f}\">{} <tspan class=\"faint\">{}</tspan></text>\n",
            x + 33.0, y + 4.0, escaped(line.name), escaped(line.note));
    y += kLegendLine;
  }
}

// In a place of its own, from the top left.
std::string inside(const LogChart& chart, const Frame& frame) {
  Drawing out;
  drawAxes(out, chart, frame);
  out.add(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} "
      "{1:.1f} {2:.1f} {3:.1f}\">\n",
      kLeft, kTop, kPlotRight - kLeft, frame.plotHeight);
  drawGuide(out, chart, frame);
  out.add("</svg>\n");
  for (const ChartLine& line : chart.lines) drawLine(out, line, frame);
  drawLegend(out, chart);
  return out.text();
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string chartSvg(const LogChart& chart) {
  const Frame frame = frameFor(chart);
  return fmt::format(
      "<svg class=\"chart\" viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n",
      kWidth, frame.height(), escaped(chart.title), inside(chart, frame));
}

std::string_view chartStyle() {
  static const std::string style = fmt::format("{}{}{}", kColourRules, kDarkRules, kShapeRules);
  return style;
}

std::string chartFile(const std::vector<LogChart>& charts) {
  Drawing body;
  double height = 0.0;
  for (const LogChart& chart : charts) {
    const Frame frame = frameFor(chart);
    body.add("<g transform=\"translate(0 {:.0f})\">\n{}</g>\n", height, inside(chart, frame));
    height += frame.height() + 8.0;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" viewBox=\"0 0 {0} {1:.0f}\" "
      "width=\"{0}\" height=\"{1:.0f}\">\n<style>{2}{3}</style>\n"
      "<rect width=\"{0}\" height=\"{1:.0f}\" fill=\"white\"/>\n{4}</svg>\n",
      kWidth, height, kColourRules, kShapeRules, body.text());
}

}  // namespace pathmark::bench
