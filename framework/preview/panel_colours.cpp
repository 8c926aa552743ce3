#include "preview/panel_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark::preview {

ImU32 rampColour(float place, float alpha) {
  struct Stop {
    float r, g, b;
  };
  constexpr std::array<Stop, 4> kStops{
      {{72, 92, 214}, {52, 158, 222}, {120, 214, 170}, {252, 232, 100}}};
  const float at = std::clamp(place, 0.0f, 1.0f) * (kStops.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const float w = at - static_cast<float>(k);
  const auto mix = [&](float from, float to) {
    return static_cast<int>(std::lround(from + (to - from) * w));
  };
  const Stop &a = kStops[k], &b = kStops[k + 1];
  return IM_COL32(mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b),
                  std::lround(std::clamp(alpha, 0.0f, 1.0f) * 255.0f));
}

}  // namespace pathmark::preview
