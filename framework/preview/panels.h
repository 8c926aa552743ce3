// The panels of the app, and what feeds them.
#pragma once

#include "preview/app.h"
#include "preview/check_feed.h"
#include "preview/path_panel.h"
#include "preview/progress_panel.h"

#include <functional>
#include <vector>

namespace pathmark::preview {

class App::Panels {
 public:
  // `choose` is called when a function is chosen in a panel.
  Panels(std::function<void()> wake, std::function<void(CourseworkFunction)> choose);

  // Before a frame is drawn.
  void takeNews(const EngineState& state);

  std::shared_ptr<const CheckReport> checks() const { return feed_.report(); }

  void draw(Tab tab, const Frame& frame);
  void drawDisplay();
  void drawOver(const Frame& frame, const Placement& placement);
  void pick(int column, int row);
  ShownPixels shown(const Frame& frame);

  // Whether a panel will show more than it does now without anything being done.
  bool busy(Tab tab, const Frame& frame) const;

 private:
  CheckFeed feed_;
  ProgressPanel progress_;
  PathPanel paths_;
  std::vector<std::uint8_t> rgba_;
  std::uint64_t version_ = 0;
};

}  // namespace pathmark::preview
