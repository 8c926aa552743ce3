#include "bench/image_error.h"

#include <cmath>

namespace pathmark::bench {

Deviation deviationOf(const Image& image, const Image& reference) {
  double relative = 0.0, sum = 0.0, referenceSum = 0.0;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    const auto x = static_cast<double>(image.rgb[i]), r = static_cast<double>(reference.rgb[i]),
               variance = static_cast<double>(reference.variance[i]);
    relative += ((x - r) * (x - r) - variance) / (r * r + 0.01);
    sum += x;
    referenceSum += r;
  }
  return {relative / static_cast<double>(reference.rgb.size()), sum / referenceSum - 1.0};
}

Mean meanOf(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = sum / n;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, values.size() < 2 ? 0.0 : std::sqrt(squares / (n * (n - 1.0)))};
}

Mean inverseOfProduct(const Mean& a, const Mean& b) {
  const double value = 1.0 / (a.value * b.value);
  return {value, value * std::hypot(a.error / a.value, b.error / b.value)};
}

}  // namespace pathmark::bench
