#include "preview/compare/compare_overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pathmark::preview {

namespace {

constexpr ImU32 kLine = IM_COL32(255, 255, 255, 255), kShadow = IM_COL32(0, 0, 0, 160);
constexpr ImU32 kWorst = IM_COL32(255, 165, 50, 255);

// Text on a dark ground, its left or right edge at x.
void label(const std::string& text, float x, float y, bool rightAligned) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = 0.3f * ImGui::GetFontSize();
  const float left = rightAligned ? x - size.x - 2.0f * pad : x;
  list.AddRectFilled({left, y}, {left + size.x + 2.0f * pad, y + size.y + pad}, kShadow, pad);
  list.AddText({left + pad, y + 0.5f * pad}, kLine, text.c_str());
}

// Top of the picture, or of what is seen of it.
float visibleTop(const Placement& placement) {
  return std::max(placement.top, ImGui::GetWindowDrawList()->GetClipRectMin().y);
}

float visibleLeft(const Placement& placement) {
  return std::max(placement.left, ImGui::GetWindowDrawList()->GetClipRectMin().x);
}

void dragSlider(const CompareOverlay& overlay, float& slider) {
  const Image& image = overlay.frame.picture->image;
  const Placement& at = overlay.placement;
  const float scale = overlay.frame.scale, reach = 7.0f * scale;
  const float x = at.x(static_cast<double>(slider) * image.width);
  const float top = at.y(0), bottom = at.y(image.height);
  const ImVec2 before = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({x - reach, top});
  ImGui::InvisibleButton("slider", {2.0f * reach, std::max(bottom - top, 1.0f)});
  const bool held = ImGui::IsItemActive();
  if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (held)
    slider = std::clamp(
        (ImGui::GetIO().MousePos.x - at.left) / (at.zoom * static_cast<float>(image.width)), 0.0f,
        1.0f);
  ImGui::SetCursorScreenPos(before);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({x, top}, {x, bottom}, kShadow, 4.0f * scale);
  list.AddLine({x, top}, {x, bottom}, kLine, 1.5f * scale);
  const float middle = 0.5f * (top + bottom), r = 7.0f * scale;
  list.AddCircleFilled({x, middle}, r + scale, kShadow, 20);
  list.AddCircle({x, middle}, r, kLine, 20, 1.5f * scale);
  const float gap = 6.0f * scale, y = visibleTop(at) + gap;
  label("yours", x - gap, y, true);
  label("reference", x + gap, y, false);
}

const char* nameOf(View view) {
  switch (view) {
    case View::kReference:
      return "reference";
    case View::kError:
      return "yours - reference";
    case View::kScores:
      return "z of tiles";
    case View::kNoise:
      return "noise";
    default:
      return "";
  }
}

std::optional<std::pair<int, int>> pixelUnderMouse(const CompareOverlay& overlay) {
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) ||
      ImGui::IsMouseDown(ImGuiMouseButton_Left))
    return std::nullopt;
  const Image& image = overlay.frame.picture->image;
  const Placement& at = overlay.placement;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int column = static_cast<int>(std::floor((mouse.x - at.left) / at.zoom));
  const int row = static_cast<int>(std::floor((mouse.y - at.top) / at.zoom));
  if (column < 0 || row < 0 || column >= image.width || row >= image.height) return std::nullopt;
  return std::pair(column, row);
}

void outline(const PixelRegion& region, const Placement& at, ImU32 colour, float scale) {
  const ImVec2 a{at.x(region.left), at.y(region.top)};
  const ImVec2 b{at.x(region.left + region.width), at.y(region.top + region.height)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect({a.x - scale, a.y - scale}, {b.x + scale, b.y + scale}, kShadow, 0.0f, 0,
               3.0f * scale);
  list.AddRect(a, b, colour, 0.0f, 0, 1.5f * scale);
}

bool contains(const PixelRegion& r, int column, int row) {
  return column >= r.left && column < r.left + r.width && row >= r.top && row < r.top + r.height;
}

void tileTooltip(const CompareOverlay& overlay, int column, int row) {
  const std::vector<RegionResult>& tiles = overlay.result->comparison->tiles;
  const auto tile = std::find_if(tiles.begin(), tiles.end(), [&](const RegionResult& t) {
    return contains(t.region, column, row);
  });
  if (tile == tiles.end()) return;
  outline(tile->region, overlay.placement, kLine, overlay.frame.scale);
  constexpr const char* kNames[] = {"red", "green", "blue"};
  const PixelRegion& r = tile->region;
  std::string text = fmt::format("Tile: columns {} to {}, rows {} to {}", r.left,
                                 r.left + r.width - 1, r.top, r.top + r.height - 1);
  for (int c = 0; c < 3; ++c) {
    const RegionResult& channel = tile[c];
    text += fmt::format("\n{}: yours {:.4g}, reference {:.4g}, z {:+.1f}{}", kNames[c], channel.a,
                        channel.b, channel.z, channel.differs ? " !" : "");
  }
  ImGui::SetTooltip("%s", text.c_str());
}

void pixelTooltip(const CompareOverlay& overlay, int column, int row) {
  const CompareResult& result = *overlay.result;
  const auto pixel =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(result.picture->image.width) +
      static_cast<std::size_t>(column);
  if (pixel >= result.colours.values.size()) return;
  const auto value = static_cast<double>(result.colours.values[pixel]);
  std::string text = fmt::format("Column {}, row {}: ", column, row);
  if (std::isnan(value))
    text += "no valid value";
  else if (overlay.view == View::kNoise)
    text += fmt::format("{:.3g} %", 100.0 * value);
  else
    text += fmt::format("{:+.3g}", value);
  ImGui::SetTooltip("%s", text.c_str());
}

void tooltip(const CompareOverlay& overlay) {
  if (overlay.result == nullptr || overlay.result->colours.view != overlay.view) return;
  const auto under = pixelUnderMouse(overlay);
  if (!under) return;
  if (overlay.view == View::kScores)
    tileTooltip(overlay, under->first, under->second);
  else
    pixelTooltip(overlay, under->first, under->second);
}

}  // namespace

void drawCompareOverlay(const CompareOverlay& overlay, float& slider) {
  if (overlay.view == View::kPicture) return;
  const float gap = 6.0f * overlay.frame.scale;
  if (overlay.view == View::kSlider)
    dragSlider(overlay, slider);
  else
    label(nameOf(overlay.view), visibleLeft(overlay.placement) + gap,
          visibleTop(overlay.placement) + gap, false);
  const bool worst = overlay.result != nullptr && overlay.view != View::kNoise &&
                     overlay.result->verdict.worst.width > 0;
  if (worst) outline(overlay.result->verdict.worst, overlay.placement, kWorst, overlay.frame.scale);
  if (isFalseColour(overlay.view)) tooltip(overlay);
}

}  // namespace pathmark::preview
