// The panels of the app, and what feeds them.
#pragma once

#include "preview/app.h"
#include "preview/check_feed.h"
#include "preview/compare/compare_panel.h"
#include "preview/paths/path_panel.h"
#include "preview/progress/progress_panel.h"
#include "preview/samples/sample_panel.h"

#include <functional>
#include <memory>

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
  void drawOver(Tab tab, const Frame& frame, const Placement& placement);
  void pick(int column, int row) { paths_.pick(column, row); }
  ShownPixels shown(const Frame& frame);

  // Whether a panel will show more than it does now without anything being done.
  bool busy(Tab tab, const Frame& frame) const;

 private:
  CheckFeed feed_;
  ProgressPanel progress_;
  SamplePanel samples_;
  PathPanel paths_;
  ComparePanel compare_;
};

}  // namespace pathmark::preview
