#include "preview/picture_area.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

namespace {

constexpr double kRadiansPerUnit = 0.006;
constexpr double kDollyPerNotch = 0.9;
constexpr float kMagnifyPerNotch = 1.2f;
constexpr float kMostMagnified = 64.0f;
constexpr float kStill = 4.0f;  // a mouse that moves less between press and release has clicked

}  // namespace

// As large as it fits, in the middle.
Placement PictureArea::place(const ShownPixels& shown, float left, float top, float width,
                             float height) {
  const auto w = static_cast<float>(shown.width), h = static_cast<float>(shown.height);
  const float zoom = std::min(width / w, height / h) * magnification_;
  return {left + 0.5f * (width - zoom * w) + offsetX_, top + 0.5f * (height - zoom * h) + offsetY_,
          zoom};
}

bool PictureArea::moveCamera(CameraPose& pose, const Placement& placement, float scale) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 by = io.MouseDelta;
  bool moved = false;
  if (ImGui::IsItemActive() && (by.x != 0.0f || by.y != 0.0f)) {
    const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    const bool right = ImGui::IsMouseDragging(ImGuiMouseButton_Right);
    if (right || (left && io.KeyShift)) {
      pose.pan(by.x / placement.zoom, by.y / placement.zoom);
      moved = true;
    } else if (left) {
      pose.orbit(-kRadiansPerUnit * by.x / scale, kRadiansPerUnit * by.y / scale);
      moved = true;
    }
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0.0f && !io.KeyCtrl) {
    pose.dolly(std::pow(kDollyPerNotch, io.MouseWheel));
    moved = true;
  }
  return moved;
}

// What is under the mouse stays there.
void PictureArea::magnify(float middleX, float middleY) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Middle)) {
    offsetX_ += io.MouseDelta.x;
    offsetY_ += io.MouseDelta.y;
  }
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0f || !io.KeyCtrl) return;
  const float before = magnification_;
  magnification_ =
      std::clamp(before * std::pow(kMagnifyPerNotch, io.MouseWheel), 1.0f, kMostMagnified);
  if (magnification_ == 1.0f) return fit();
  const float by = magnification_ / before;
  offsetX_ = io.MousePos.x - middleX - by * (io.MousePos.x - middleX - offsetX_);
  offsetY_ = io.MousePos.y - middleY - by * (io.MousePos.y - middleY - offsetY_);
}

bool PictureArea::draw(const ShownPixels& shown, float scale, const Actions& actions) {
  hovered_.reset();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  if (size.x < 1.0f || size.y < 1.0f || shown.width == 0) return false;
  if (uploaded_ != shown.version) {
    texture_.upload(shown.width, shown.height, shown.rgba);
    uploaded_ = shown.version;
  }
  const Placement at = place(shown, corner.x, corner.y, size.x, size.y);
  ImGui::InvisibleButton("picture", size,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ImGui::SetItemAllowOverlap();
  const bool moved = actions.pose != nullptr && moveCamera(*actions.pose, at, scale);
  magnify(corner.x + 0.5f * size.x, corner.y + 0.5f * size.y);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int column = static_cast<int>(std::floor((mouse.x - at.left) / at.zoom));
  const int row = static_cast<int>(std::floor((mouse.y - at.top) / at.zoom));
  const bool inside = column >= 0 && column < shown.width && row >= 0 && row < shown.height;
  if (inside && ImGui::IsItemHovered()) hovered_ = {column, row};
  const float dragged = std::sqrt(ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left]);
  const bool still = dragged < kStill * scale;
  if (inside && ImGui::IsItemHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) && still &&
      !ImGui::GetIO().KeyShift && actions.pick)
    actions.pick(column, row);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
  list.AddImage(texture_.id(), {at.left, at.top}, {at.x(shown.width), at.y(shown.height)});
  if (actions.drawOver) actions.drawOver(at);
  list.PopClipRect();
  return moved;
}

}  // namespace pathmark::preview
