#include "preview/panels.h"

#include <utility>

namespace pathmark::preview {

App::Panels::Panels(std::function<void()> wake, std::function<void(CourseworkFunction)> choose)
    : feed_(makeChecker({}), std::move(wake)),
      progress_([this](CourseworkFunction f) { return feed_.hints(f); }) {
  progress_.onChoose = [this, choose = std::move(choose)](CourseworkFunction function) {
    samples_.choose(function);
    choose(function);
  };
}

void App::Panels::takeNews(const EngineState& state) { feed_.submit(state.coursework); }

void App::Panels::draw(Tab tab, const Frame& frame) {
  switch (tab) {
    case Tab::kProgress:
      progress_.draw(frame);
      break;
    case Tab::kSamples:
      samples_.draw(frame);
      break;
    case Tab::kPaths:
      paths_.draw(frame);
      break;
    case Tab::kCompare:
      compare_.draw(frame);
      break;
    case Tab::kView:
      break;
  }
}

void App::Panels::drawDisplay() { compare_.drawDisplay(); }

// Paths are seen while their panel is.
void App::Panels::drawOver(Tab tab, const Frame& frame, const Placement& placement) {
  compare_.drawOver(frame, placement);
  if (tab == Tab::kPaths) paths_.drawOver(frame, placement);
}

ShownPixels App::Panels::shown(const Frame& frame) {
  const Shown& shown = compare_.shown(frame);
  return {shown.width, shown.height, shown.rgba, shown.version};
}

bool App::Panels::busy(Tab tab, const Frame& frame) const {
  switch (tab) {
    case Tab::kProgress:
      return ProgressPanel::busy(frame);
    case Tab::kSamples:
      return samples_.busy(frame);
    case Tab::kPaths:
      return paths_.busy();
    case Tab::kCompare:
      return compare_.busy(frame);
    case Tab::kView:
      break;
  }
  return false;
}

}  // namespace pathmark::preview
