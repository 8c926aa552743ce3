#include "film/noise_rounding.h"

#include <cmath>

namespace pathmark {

namespace {

float roundedTo(double step, float value) {
  return static_cast<float>(std::round(static_cast<double>(value) / step) * step);
}

// The power of two at or below x > 0.
double powerOfTwoBelow(double x) { return std::ldexp(1.0, std::ilogb(x)); }

}  // namespace

Image roundedToNoise(const Image& image) {
  constexpr double kStepsPerError = 8.0;
  constexpr double kStepsPerOctave = 8.0;
  Image rounded = image;
  for (std::size_t i = 0; i < image.variance.size(); ++i) {
    const double variance = static_cast<double>(image.variance[i]);
    if (!std::isfinite(variance) || !(variance > 0.0) || !std::isfinite(image.rgb[i])) continue;
    rounded.rgb[i] = roundedTo(powerOfTwoBelow(std::sqrt(variance) / kStepsPerError), image.rgb[i]);
    rounded.variance[i] = roundedTo(powerOfTwoBelow(variance) / kStepsPerOctave, image.variance[i]);
  }
  return rounded;
}

}  // namespace pathmark
