#include "bench/image_error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace pathmark::bench {

namespace {

double varianceAt(const Image& image, std::size_t value) {
  return image.variance.empty() ? 0.0 : static_cast<double>(image.variance[value]);
}

// The denominator of a relative squared error.
double scaleOf(double reference) { return reference * reference + 0.01; }

double shareOfWorst(std::vector<double> errors) {
  double all = 0.0;
  for (const double e : errors) all += e;
  if (!(all > 0.0)) return 0.0;
  const std::size_t worst = (errors.size() + 999) / 1000;
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(worst - 1),
                   errors.end(), std::greater<>());
  double theirs = 0.0;
  for (std::size_t k = 0; k < worst; ++k) theirs += errors[k];
  return theirs / all;
}

}  // namespace

Deviation deviationOf(const Image& image, const Image& reference) {
  Deviation deviation;
  double sum = 0.0, referenceSum = 0.0;
  std::vector<double> pixelErrors(reference.rgb.size() / 3);
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    const auto x = static_cast<double>(image.rgb[i]), r = static_cast<double>(reference.rgb[i]);
    const double squared = (x - r) * (x - r), own = varianceAt(reference, i);
    deviation.mse += squared - own;
    deviation.relativeMse += (squared - own) / scaleOf(r);
    pixelErrors[i / 3] += squared / scaleOf(r);
    sum += x;
    referenceSum += r;
  }
  deviation.mse /= static_cast<double>(reference.rgb.size());
  deviation.relativeMse /= static_cast<double>(reference.rgb.size());
  deviation.mean = sum / referenceSum - 1.0;
  deviation.worstShare = shareOfWorst(std::move(pixelErrors));
  return deviation;
}

// The square of a normal error of variance v has the standard deviation sqrt(2) v, and the estimate
// of v from R replicates that of sqrt(2 / (R - 1)) v. The three channels of a pixel are taken to
// err together, which is the worst that they can do.
OwnDeviation ownDeviation(const Image& reference, std::uint32_t replicates) {
  OwnDeviation own;
  if (reference.variance.empty()) return own;
  double squares = 0.0;
  for (std::size_t i = 0; i < reference.rgb.size(); ++i) {
    const double relative =
        varianceAt(reference, i) / scaleOf(static_cast<double>(reference.rgb[i]));
    own.relativeMse += relative;
    squares += relative * relative;
  }
  const auto values = static_cast<double>(reference.rgb.size());
  const double estimated = 1.0 + 1.0 / std::max(static_cast<double>(replicates) - 1.0, 1.0);
  own.relativeMse /= values;
  own.relativeMseError = std::sqrt(3.0 * 2.0 * estimated * squares) / values;
  return own;
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

Mean ratioOf(const Mean& a, const Mean& b) {
  const double value = a.value / b.value;
  return {value, value * std::hypot(a.error / a.value, b.error / b.value)};
}

}  // namespace pathmark::bench
