#include "bench/stress/block_difference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pathmark::bench {

namespace {

constexpr int kBlock = 8;
constexpr double kDarkest = 1e-3;

// Two pictures that are both black do not differ.
double relative(double difference, double value) {
  return difference == 0.0 ? 0.0 : std::abs(difference) / value;
}

}  // namespace

std::vector<double> blockSums(const Image& image) {
  const auto blocks = [](int pixels) { return static_cast<std::size_t>(pixels / kBlock); };
  const std::size_t across = blocks(image.width + kBlock - 1),
                    down = blocks(image.height + kBlock - 1);
  std::vector<double> sums(across * down);
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i)
      for (const float value : image.pixel(i, j))
        sums[blocks(j) * across + blocks(i)] += static_cast<double>(value);
  return sums;
}

BlockDifference blockDifference(const std::vector<double>& sums,
                                const std::vector<double>& original) {
  const double whole = std::accumulate(original.begin(), original.end(), 0.0);
  const double dark = kDarkest * whole / static_cast<double>(original.size());
  BlockDifference result;
  result.mean = relative(std::accumulate(sums.begin(), sums.end(), 0.0) - whole, whole);
  for (std::size_t i = 0; i < original.size(); ++i)
    result.block =
        std::max(result.block, relative(sums[i] - original[i], std::max(original[i], dark)));
  return result;
}

BlockDifference blockDifference(const Image& image, const Image& original) {
  return blockDifference(blockSums(image), blockSums(original));
}

}  // namespace pathmark::bench
