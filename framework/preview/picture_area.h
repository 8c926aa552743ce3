// PictureArea: the picture in the window, and what the mouse does to it.
//
//   drag             orbits the camera        shift-drag, right drag   pans
//   wheel            dollies                  ctrl-wheel               magnifies the picture
//   click            chooses a pixel          middle drag              moves a magnified picture
#pragma once

#include "preview/camera_pose.h"
#include "preview/frame.h"
#include "preview/window.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace pathmark::preview {

struct ShownPixels {
  int width = 0, height = 0;
  std::span<const std::uint8_t> rgba;
  std::uint64_t version = 0;  // to be uploaded again when it changes
};

class PictureArea {
 public:
  struct Actions {
    CameraPose* pose = nullptr;  // null: nothing to move
    std::function<void(int column, int row)> pick;
    std::function<void(const Placement&)> drawOver;  // on the picture, clipped to it
  };

  // Fills what is left of the current window. Returns whether the camera was moved.
  bool draw(const ShownPixels& shown, float scale, const Actions& actions);

  void fit() { magnification_ = 1.0f, offsetX_ = offsetY_ = 0.0f; }

  // The pixel under the mouse.
  const std::optional<std::pair<int, int>>& hovered() const { return hovered_; }

 private:
  Placement place(const ShownPixels& shown, float left, float top, float width, float height);
  bool moveCamera(CameraPose& pose, const Placement& placement, float scale);
  void magnify(float middleX, float middleY);  // about the middle of the area

  Texture texture_;
  std::uint64_t uploaded_ = ~std::uint64_t{0};
  float magnification_ = 1.0f, offsetX_ = 0.0f, offsetY_ = 0.0f;
  std::optional<std::pair<int, int>> hovered_;
};

}  // namespace pathmark::preview
