#include "preview/panels.h"

#include <algorithm>
#include <cmath>

namespace pathmark::preview {

void App::Panels::takeNews(const EngineState&) {}
void App::Panels::draw(Tab, const Frame&) {}
void App::Panels::drawDisplay() {}
void App::Panels::drawOver(const Frame&, const Placement&) {}
void App::Panels::pick(int, int) {}
bool App::Panels::busy(Tab, const Frame&) const { return false; }

ShownPixels App::Panels::shown(const Frame& frame) {
  const Image& image = frame.picture->image;
  rgba.clear();
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c)
      rgba.push_back(static_cast<std::uint8_t>(
          255.0 * std::pow(std::clamp(image.rgb[i + c] * frame.exposure, 0.0, 1.0), 1 / 2.2)));
    rgba.push_back(255);
  }
  return {image.width, image.height, rgba, ++version};
}

}  // namespace pathmark::preview
