#include "film/own_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pathmark {

OwnError ownError(const Image& image) {
  std::array<double, 3> sum{}, variance{};
  double relative = 0.0;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const auto value = static_cast<double>(image.rgb[i]),
               v = static_cast<double>(image.variance[i]);
    sum[i % 3] += value;
    variance[i % 3] += v;
    relative += v / (value * value + 0.01);
  }
  OwnError error;
  error.ofPixels = std::sqrt(relative / static_cast<double>(image.rgb.size()));
  for (std::size_t c = 0; c < 3; ++c) {
    if (sum[c] > 0.0) error.ofMean = std::max(error.ofMean, std::sqrt(variance[c]) / sum[c]);
  }
  return error;
}

}  // namespace pathmark
