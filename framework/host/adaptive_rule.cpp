#include "host/adaptive_rule.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace pathmark {

namespace {

// Tiles darker than this share of the picture are judged as if they were as bright.
constexpr double kDarkest = 0.1;

struct TileSums {
  double value = 0.0, variance = 0.0, count = 0.0;
};

struct Sample {
  double value = 0.0, variance = 0.0;
};

// `sampleAt` tells a channel of a pixel.
std::vector<TileSums> sumsOfTiles(
    int width, int height, const std::function<Sample(std::size_t pixel, int channel)>& sampleAt) {
  std::vector<TileSums> tiles(tileCount(width, height));
  const auto count = [](int pixels) { return static_cast<std::size_t>(pixels / kTileSize); };
  const std::size_t across = count(width + kTileSize - 1);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      TileSums& tile = tiles[count(row) * across + count(column)];
      const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(column);
      for (int c = 0; c < 3; ++c) {
        const Sample sample = sampleAt(pixel, c);
        tile.value += sample.value;
        tile.variance += sample.variance;
        tile.count += 1.0;
      }
    }
  return tiles;
}

// Squared, by tile.
std::vector<double> relativeVariances(const std::vector<TileSums>& tiles) {
  double value = 0.0, count = 0.0;
  for (const TileSums& tile : tiles) {
    value += tile.value;
    count += tile.count;
  }
  const double darkest = kDarkest * value / count;
  std::vector<double> result;
  for (const TileSums& tile : tiles) {
    const double brightness = std::max(tile.value / tile.count, darkest);
    const double variance = tile.variance / tile.count;
    result.push_back(variance == 0.0 ? 0.0 : variance / (brightness * brightness));
  }
  return result;
}

double meanOf(const FilmPixel& pixel, int channel) {
  return pixel.rays > 0.0 ? pixel.sum[channel] / pixel.rays : 0.0;
}

}  // namespace

double TileErrors::median() const {
  std::vector<double> sorted = relative;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

double TileErrors::worst() const { return *std::max_element(relative.begin(), relative.end()); }

TileErrors tileErrors(const Image& image) {
  TileErrors errors;
  for (const double variance :
       relativeVariances(sumsOfTiles(image.width, image.height, [&](std::size_t pixel, int c) {
         const std::size_t at = 3 * pixel + static_cast<std::size_t>(c);
         return Sample{static_cast<double>(image.rgb[at]), static_cast<double>(image.variance[at])};
       })))
    errors.relative.push_back(std::sqrt(variance));
  return errors;
}

// The variance of the mean of four films with the pilot's rays is that of one film over four; half
// the squared difference of two estimates that.
std::vector<std::uint64_t> raysForTarget(const PilotFilms& pilot, const TargetError& target) {
  const auto tiles = sumsOfTiles(pilot.width, pilot.height, [&](std::size_t pixel, int c) {
    const double a = meanOf(pilot.first[pixel], c), b = meanOf(pilot.second[pixel], c);
    return Sample{0.5 * (a + b), 0.5 * (a - b) * (a - b) / 4.0};
  });
  const double goal = target.relative * target.relative;
  std::vector<std::uint64_t> rays;
  for (const double variance : relativeVariances(tiles)) {
    const double passes = std::ceil(static_cast<double>(pilot.rays) * variance / goal /
                                    static_cast<double>(target.raysPerPass));
    const double most = std::floor(static_cast<double>(target.mostRays) / target.raysPerPass);
    const auto wanted = static_cast<std::uint64_t>(std::min(passes, most)) * target.raysPerPass;
    rays.push_back(std::max(wanted, pilot.rays));
  }
  return rays;
}

}  // namespace pathmark
