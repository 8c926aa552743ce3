#include "preview/compare/log_plot.h"

#include "preview/compare/log_axis.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pathmark::preview {

namespace {

constexpr ImU32 kFrame = IM_COL32(120, 120, 125, 255);
constexpr ImU32 kGrid = IM_COL32(70, 70, 75, 255), kFineGrid = IM_COL32(42, 42, 46, 255);
constexpr ImU32 kText = IM_COL32(190, 190, 190, 255);

// The plot's rectangle in the window, and its axes.
struct Area {
  ImVec2 low, high;  // top left and bottom right corner
  LogAxis x, y;

  ImVec2 at(const PlotPoint& point) const {
    return {low.x + static_cast<float>(x.place(point.x)) * (high.x - low.x),
            high.y - static_cast<float>(y.place(point.y)) * (high.y - low.y)};
  }
};

std::vector<double> coordinates(const std::vector<PlotCurve>& curves, double PlotPoint::*of) {
  std::vector<double> values;
  for (const PlotCurve& curve : curves)
    if (!curve.guide)
      for (const PlotPoint& point : curve.points) values.push_back(point.*of);
  return values;
}

float widestLabel(const std::vector<LogTick>& ticks) {
  float width = 0.0f;
  for (const LogTick& tick : ticks)
    width = std::max(width, ImGui::CalcTextSize(tick.label.c_str()).x);
  return width;
}

// Labels that would run into the one before are left out.
void drawAxes(ImDrawList& list, const Area& area, const std::vector<LogTick>& xTicks,
              const std::vector<LogTick>& yTicks, float gap) {
  const float font = ImGui::GetFontSize();
  float free = area.low.x - font;
  for (const LogTick& tick : xTicks) {
    const float x = area.at({tick.value, area.y.low}).x;
    list.AddLine({x, area.low.y}, {x, area.high.y}, tick.label.empty() ? kFineGrid : kGrid);
    const float half = 0.5f * ImGui::CalcTextSize(tick.label.c_str()).x;
    if (tick.label.empty() || x - half < free) continue;
    list.AddText({x - half, area.high.y + gap}, kText, tick.label.c_str());
    free = x + half + font * 0.5f;
  }
  for (const LogTick& tick : yTicks) {
    const float y = area.at({area.x.low, tick.value}).y;
    list.AddLine({area.low.x, y}, {area.high.x, y}, tick.label.empty() ? kFineGrid : kGrid);
    const ImVec2 size = ImGui::CalcTextSize(tick.label.c_str());
    list.AddText({area.low.x - size.x - gap, y - 0.5f * size.y}, kText, tick.label.c_str());
  }
  list.AddRect(area.low, area.high, kFrame);
}

void drawMark(ImDrawList& list, const ImVec2& at, PlotMark mark, ImU32 colour, float radius) {
  if (mark == PlotMark::kDot) list.AddCircleFilled(at, radius, colour, 12);
  if (mark == PlotMark::kSquare)
    list.AddRect({at.x - 1.6f * radius, at.y - 1.6f * radius},
                 {at.x + 1.6f * radius, at.y + 1.6f * radius}, colour, 0.0f, 0,
                 std::max(1.0f, 0.4f * radius));
}

void drawDashes(ImDrawList& list, const ImVec2& from, const ImVec2& to, ImU32 colour, float scale) {
  const float dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  const float dash = 5.0f * scale;
  for (float at = 0.0f; at < length; at += 2.0f * dash) {
    const float a = at / length, b = std::min(1.0f, (at + dash) / length);
    list.AddLine({from.x + a * dx, from.y + a * dy}, {from.x + b * dx, from.y + b * dy}, colour,
                 1.5f * scale);
  }
}

void drawCurve(ImDrawList& list, const Area& area, const PlotCurve& curve, float scale) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ImVec2 at = area.at(curve.points[i]);
    if (i > 0) {
      const ImVec2 before = area.at(curve.points[i - 1]);
      if (curve.dashed)
        drawDashes(list, before, at, curve.colour, scale);
      else
        list.AddLine(before, at, curve.colour, 1.5f * scale);
    }
    drawMark(list, at, curve.mark, curve.colour, 2.5f * scale);
  }
}

struct Nearest {
  const PlotCurve* curve;
  PlotPoint point;
};

std::optional<Nearest> nearestTo(const ImVec2& mouse, const Area& area,
                                 const std::vector<PlotCurve>& curves, float reach) {
  std::optional<Nearest> nearest;
  float best = reach * reach;
  for (const PlotCurve& curve : curves) {
    if (curve.guide) continue;
    for (const PlotPoint& point : curve.points) {
      const ImVec2 at = area.at(point);
      const float dx = at.x - mouse.x, dy = at.y - mouse.y, distance = dx * dx + dy * dy;
      if (distance > best) continue;
      best = distance;
      nearest = Nearest{&curve, point};
    }
  }
  return nearest;
}

// A line, the curve's mark on it, and its name, as many side by side as there is room for.
void drawLegend(const std::vector<PlotCurve>& curves, float scale) {
  const float font = ImGui::GetFontSize(), sample = 2.0f * font;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  for (const PlotCurve& curve : curves) {
    if (curve.name.empty()) continue;
    const float width = sample + ImGui::CalcTextSize(curve.name.c_str()).x;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    if (!first && ImGui::GetItemRectMax().x + 2.0f * spacing + width < right)
      ImGui::SameLine(0.0f, 2.0f * spacing);
    first = false;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 a{corner.x, corner.y + 0.5f * font}, b{corner.x + 0.8f * sample, a.y};
    if (curve.dashed)
      drawDashes(list, a, b, curve.colour, scale);
    else
      list.AddLine(a, b, curve.colour, 1.5f * scale);
    drawMark(list, {0.5f * (a.x + b.x), a.y}, curve.mark, curve.colour, 2.5f * scale);
    list.AddText({corner.x + sample, corner.y}, kText, curve.name.c_str());
    ImGui::Dummy({width, font});
  }
}

}  // namespace

void LogPlot::draw(float height, float scale) const {
  const float font = ImGui::GetFontSize(), gap = 0.3f * font;
  const LogAxis xAxis = axisFor(coordinates(curves, &PlotPoint::x));
  const LogAxis yAxis = axisFor(coordinates(curves, &PlotPoint::y));
  const float width = ImGui::GetContentRegionAvail().x;
  const auto xTicks = xAxis.ticks(std::max(2, static_cast<int>(width / (4.0f * font))));
  const auto yTicks = yAxis.ticks(std::max(2, static_cast<int>(height / (1.6f * font))));
  ImGui::TextDisabled("%s", yName.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width, height});
  const bool hovered = ImGui::IsItemHovered();
  const Area area{{corner.x + widestLabel(yTicks) + 2.0f * gap, corner.y + 0.5f * font},
                  {corner.x + width - font, corner.y + height - font - 2.0f * gap},
                  xAxis,
                  yAxis};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawAxes(list, area, xTicks, yTicks, gap);
  list.PushClipRect(area.low, area.high, true);
  for (const PlotCurve& curve : curves) drawCurve(list, area, curve, scale);
  list.PopClipRect();
  const float nameWidth = ImGui::CalcTextSize(xName.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, width - font - nameWidth));
  ImGui::TextDisabled("%s", xName.c_str());
  drawLegend(curves, scale);
  if (!hovered) return;
  const auto nearest = nearestTo(ImGui::GetIO().MousePos, area, curves, 2.0f * font);
  if (!nearest) return;
  list.AddCircle(area.at(nearest->point), 5.0f * scale, nearest->curve->colour, 16, 1.5f * scale);
  ImGui::SetTooltip("%s\n%s: %.4g\n%s: %.3g", nearest->curve->name.c_str(), xName.c_str(),
                    nearest->point.x, yName.c_str(), nearest->point.y);
}

PlotCurve slopeGuide(const PlotPoint& point, double slope, double from, double to) {
  const auto at = [&](double x) { return PlotPoint{x, point.y * std::pow(x / point.x, slope)}; };
  return {.name = {}, .points = {at(from), at(to)}, .dashed = true, .guide = true};
}

}  // namespace pathmark::preview
