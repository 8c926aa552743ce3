// The panels of the app.
#pragma once

#include "preview/app.h"

namespace pathmark::preview {

struct App::Panels {
  void takeNews(const EngineState& state);
  void draw(Tab tab, const Frame& frame);
  void drawDisplay();
  void drawOver(const Frame& frame, const Placement& placement);
  void pick(int column, int row);
  ShownPixels shown(const Frame& frame);

  // Whether a panel will show more than it does now without anything being done.
  bool busy(Tab tab, const Frame& frame) const;

  std::vector<std::uint8_t> rgba;
  std::uint64_t version = 0;
};

}  // namespace pathmark::preview
