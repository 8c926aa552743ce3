#include "film/region_test.h"

#include "stats/quantiles.h"

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

// Radiance is computed in float, with a rounding error of 2^-24 in each of some dozen operations:
// less is no difference, even where there is no noise at all.
constexpr double kRounding = 0x1p-20;

double degreesOf(std::uint32_t replicates) {
  const double degrees = static_cast<double>(replicates) - 1.0;
  return replicates < kFewReplicates ? degrees / 16.0 : std::max(1.0, degrees / 8.0);
}

void addVariance(const Image& image, std::size_t at, std::uint32_t replicates,
                 std::uint32_t pixelsPerBlock, stats::PooledVariance& variance) {
  if (replicates == 0) return;
  const double n = pixelsPerBlock;
  variance.add(n * static_cast<double>(image.variance[at]), degreesOf(replicates) / n);
}

}  // namespace

void RegionSums::add(const Image& imageA, const Image& imageB, std::size_t pixel,
                     Replicates replicates) {
  ++pixels;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t at = 3 * pixel + c;
    const double valueA = imageA.rgb[at], valueB = imageB.rgb[at];
    a[c] += valueA;
    b[c] += valueB;
    magnitude[c] += 0.5 * (std::abs(valueA) + std::abs(valueB));
    addVariance(imageA, at, replicates.a, replicates.pixelsPerBlockOfA, varianceA[c]);
    addVariance(imageB, at, replicates.b, replicates.pixelsPerBlockOfB, varianceB[c]);
  }
}

void RegionSums::merge(const RegionSums& other) {
  pixels += other.pixels;
  for (std::size_t c = 0; c < 3; ++c) {
    a[c] += other.a[c];
    b[c] += other.b[c];
    magnitude[c] += other.magnitude[c];
    varianceA[c].merge(other.varianceA[c]);
    varianceB[c].merge(other.varianceB[c]);
  }
}

RegionResult testRegion(const RegionSums& sums, const PixelRegion& region, int channel,
                        Replicates replicates, const RegionTolerance& tolerance) {
  const auto c = static_cast<std::size_t>(channel);
  const double n = static_cast<double>(sums.pixels);
  RegionResult result{.region = region,
                      .channel = channel,
                      .pixels = sums.pixels,
                      .a = sums.a[c] / n,
                      .b = sums.b[c] / n,
                      .errorA = std::sqrt(sums.varianceA[c].variance()) / n,
                      .errorB = std::sqrt(sums.varianceB[c].variance()) / n};
  const double difference = result.a - result.b;
  const double reference = std::max(std::abs(result.b), tolerance.dark);
  if (difference != 0.0) result.relative = std::abs(difference) / reference;
  const double excess = std::abs(difference) - tolerance.relative * reference;
  if (!replicates.any()) {
    result.differs = excess > 0.0;
    return result;
  }
  stats::PooledVariance pooled = sums.varianceA[c];
  pooled.merge(sums.varianceB[c]);
  const double error = std::max(
      {std::sqrt(pooled.variance()) / n, kRounding * sums.magnitude[c] / n, tolerance.leastError});
  if (difference != 0.0) result.z = difference / error;
  if (excess > 0.0) result.pValue = stats::studentTail(excess / error, pooled.degrees());
  result.differs = result.pValue <= tolerance.alpha;
  return result;
}

}  // namespace pathmark
