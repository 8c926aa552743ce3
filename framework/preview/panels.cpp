#include "preview/panels.h"

#include <algorithm>
#include <cmath>
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
    case Tab::kPaths:
      paths_.draw(frame);
      break;
    case Tab::kSamples:
    case Tab::kCompare:
    case Tab::kView:
      break;
  }
}

void App::Panels::drawDisplay() {}

void App::Panels::drawOver(const Frame& frame, const Placement& placement) {
  paths_.drawOver(frame, placement);
}

void App::Panels::pick(int column, int row) { paths_.pick(column, row); }

bool App::Panels::busy(Tab tab, const Frame& frame) const {
  return (tab == Tab::kProgress && ProgressPanel::busy(frame)) ||
         (tab == Tab::kPaths && paths_.busy());
}

ShownPixels App::Panels::shown(const Frame& frame) {
  const Image& image = frame.picture->image;
  rgba_.clear();
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c)
      rgba_.push_back(static_cast<std::uint8_t>(
          255.0 * std::pow(std::clamp(image.rgb[i + c] * frame.exposure, 0.0, 1.0), 1 / 2.2)));
    rgba_.push_back(255);
  }
  return {image.width, image.height, rgba_, ++version_};
}

}  // namespace pathmark::preview
