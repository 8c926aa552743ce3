// Colours for throughputs: on a line through a uniform colour space, from a dark blue to a bright
// yellow, so that equal steps look equal, also to people who cannot tell red from green.
#pragma once

#include <cstdint>

namespace pathmark::preview {

struct Rgb8 {
  std::uint8_t r = 0, g = 0, b = 0;  // sRGB
};

// Throughputs outside are shown as the nearest inside.
inline constexpr double kDarkestThroughput = 0.01, kBrightestThroughput = 1.0;

// Where a throughput's luminance lies on the scale, [0,1]; logarithmic. NaN is at 0.
double placeOfThroughput(double luminance);

Rgb8 colourAt(double place);

}  // namespace pathmark::preview
