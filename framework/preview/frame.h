// Frame: what a panel may look at while it is drawn.
//
// Panels are drawn by the window's thread, once a frame, and must not block it: what takes longer
// runs on a thread of the panel's own, which calls `wake` when there is something new to see.
#pragma once

#include "preview/checker.h"
#include "preview/picture.h"

#include <functional>
#include <memory>

namespace pathmark::preview {

struct Frame {
  std::shared_ptr<const Picture> picture;             // null before the first
  std::shared_ptr<const CourseworkState> coursework;  // never null
  std::shared_ptr<const CheckReport> checks;          // null before the first
  int part = 0;                                       // chosen in the window, 0 to 9
  float scale = 1.0f;                           // of the interface: 2 on a high-density screen
  double exposure = 1.0;                        // factor on linear radiance, for display
  const std::function<void()>* wake = nullptr;  // asks for a frame; from any thread
};

// Where the picture lies in the window, in the interface's coordinates.
struct Placement {
  float left = 0.0f, top = 0.0f;
  float zoom = 1.0f;  // of the interface's units for a pixel of the picture

  float x(double column) const { return left + static_cast<float>(column) * zoom; }
  float y(double row) const { return top + static_cast<float>(row) * zoom; }
};

}  // namespace pathmark::preview
