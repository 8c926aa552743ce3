#include "preview/samples/sample_plot.h"

#include "preview/panel_colours.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

constexpr double kFarOff = 3.0;  // standard deviations

// From shares and coordinates to the screen.
struct Axes {
  ImVec2 low, size;  // the corner at the bottom left; upwards
  double most;       // share at the top

  float x(double place) const { return low.x + static_cast<float>(place) * size.x; }
  float y(double share) const {
    return low.y - static_cast<float>(std::clamp(share / most, 0.0, 1.0)) * size.y;
  }
};

double highest(const Histogram& histogram) {
  double most = 1e-9;
  for (const Bar& bar : histogram.bars)
    most = std::max({most, bar.share, bar.expected + 2.0 * bar.sigma});
  return 1.08 * most;
}

bool isFarOff(const Bar& bar) {
  return std::abs(bar.share - bar.expected) > kFarOff * bar.sigma + 1e-9;
}

void drawBars(ImDrawList& list, const Axes& axes, const Histogram& histogram) {
  const double count = static_cast<double>(histogram.bars.size());
  for (std::size_t k = 0; k < histogram.bars.size(); ++k) {
    const Bar& bar = histogram.bars[k];
    const float left = axes.x(static_cast<double>(k) / count),
                right = axes.x(static_cast<double>(k + 1) / count);
    list.AddRectFilled({left, axes.y(bar.expected + 2.0 * bar.sigma)},
                       {right, axes.y(bar.expected - 2.0 * bar.sigma)},
                       IM_COL32(255, 255, 255, 38));
    const ImU32 colour = isFarOff(bar) ? kBadColour : faded(kGoodColour, 0.8f);
    list.AddRectFilled({left + 1.0f, axes.y(bar.share)},
                       {std::max(right - 1.0f, left + 2.0f), axes.low.y}, colour);
  }
}

void drawCurve(ImDrawList& list, const Axes& axes, const Histogram& histogram, float scale) {
  std::vector<ImVec2> points;
  for (std::size_t k = 0; k < histogram.curve.size(); ++k)
    points.emplace_back(
        axes.x((static_cast<double>(k) + 0.5) / static_cast<double>(histogram.curve.size())),
        axes.y(histogram.curve[k]));
  list.AddPolyline(points.data(), static_cast<int>(points.size()), kTextColour, 0, 1.5f * scale);
}

void showBar(const Histogram& histogram, std::size_t k, std::size_t samples) {
  const double width =
      (histogram.high - histogram.low) / static_cast<double>(histogram.bars.size());
  const double from = histogram.low + width * static_cast<double>(k);
  const double n = static_cast<double>(samples);
  const Bar& bar = histogram.bars[k];
  ImGui::SetTooltip("%s", fmt::format("{:.3g} to {:.3g}: {:.4g} of {} points,\nexpected {:.4g} +- "
                                      "{:.3g} (two standard deviations)",
                                      from, from + width, bar.share * n, samples, bar.expected * n,
                                      2.0 * bar.sigma * n)
                              .c_str());
}

void drawNumbers(ImDrawList& list, const Axes& axes, const Histogram& histogram) {
  const auto write = [&](double place, float align) {
    const double span = histogram.high - histogram.low, value = histogram.low + place * span;
    const std::string text = fmt::format("{:.3g}", std::abs(value) < 1e-6 * span ? 0.0 : value);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    list.AddText({axes.x(place) - align * width, axes.low.y + 1.0f}, kNeutralColour, text.c_str());
  };
  write(0.0, 0.0f);
  write(0.5, 0.5f);
  write(1.0, 1.0f);
}

void drawHistogram(const Histogram& histogram, std::size_t samples, float width, float scale) {
  const float line = ImGui::GetTextLineHeight(), height = 66.0f * scale;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(histogram.name.c_str());
  ImGui::InvisibleButton("histogram", {width, height + 2.0f * line});
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered();
  list.PushClipRect(corner, {corner.x + width, corner.y + height + 2.0f * line}, true);
  list.AddText(corner, kTextColour, histogram.name.c_str());
  const Axes axes{{corner.x, corner.y + line + height}, {width, height}, highest(histogram)};
  list.AddRectFilled({corner.x, corner.y + line}, {corner.x + width, axes.low.y}, kPaper);
  drawBars(list, axes, histogram);
  drawCurve(list, axes, histogram, scale);
  drawNumbers(list, axes, histogram);
  list.PopClipRect();
  if (!hovered) return;
  const double count = static_cast<double>(histogram.bars.size());
  const double at = static_cast<double>((ImGui::GetIO().MousePos.x - corner.x) / width) * count;
  showBar(histogram, static_cast<std::size_t>(std::clamp(at, 0.0, count - 1.0)), samples);
}

}  // namespace

void drawHistograms(const std::vector<Histogram>& histograms, std::size_t samples, float scale) {
  const float all = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  const std::size_t columns = all < 340.0f * scale ? 1 : 2;
  const float width = (all - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  for (std::size_t k = 0; k < histograms.size(); ++k) {
    if (k % columns != 0) ImGui::SameLine();
    const bool alone = k + 1 == histograms.size() && k % columns == 0;
    drawHistogram(histograms[k], samples, alone ? all : width, scale);
  }
}

}  // namespace pathmark::preview
