#include "preview/panels.h"

#include <utility>

namespace pathmark::preview {

App::Panels::Panels(std::function<void()> wake, std::function<void(CourseworkFunction)> choose)
    : feed_(makeChecker({}), std::move(wake)),
      progress_([this](CourseworkFunction f) { return feed_.hints(f); }) {
  progress_.onChoose = std::move(choose);
}

void App::Panels::takeNews(const EngineState& state) { feed_.submit(state.coursework); }

void App::Panels::draw(Tab tab, const Frame& frame) {
  switch (tab) {
    case Tab::kProgress:
      progress_.draw(frame);
      break;
    case Tab::kSamples:
    case Tab::kPaths:
      break;
    case Tab::kCompare:
      compare_.draw(frame);
      break;
    case Tab::kView:
      break;
  }
}

void App::Panels::drawDisplay() { compare_.drawDisplay(); }

void App::Panels::drawOver(const Frame& frame, const Placement& placement) {
  compare_.drawOver(frame, placement);
}

void App::Panels::pick(int, int) {}

bool App::Panels::busy(Tab tab, const Frame& frame) const {
  return (tab == Tab::kProgress && ProgressPanel::busy(frame)) ||
         (tab == Tab::kCompare && compare_.busy(frame));
}

ShownPixels App::Panels::shown(const Frame& frame) {
  const Shown& shown = compare_.shown(frame);
  return {shown.width, shown.height, shown.rgba, shown.version};
}

}  // namespace pathmark::preview
