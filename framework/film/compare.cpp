#include "film/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

struct TileSums {
  PixelRegion region;
  RegionSums sums;
};

// The fewest that can give any variance where their number is not known.
std::uint32_t replicatesOf(const ImageFile& file) {
  return file.image.variance.empty() ? 0 : std::max(file.origin.replicates, 2u);
}

std::uint32_t blockOf(const ImageFile& file) {
  return std::clamp(file.origin.pixelsPerBlock, 1u, PathSharing::kMost);
}

void addDifferences(const Image& a, const Image& b, Comparison& result) {
  constexpr double kFloor = 0.01;
  double sum = 0.0, relativeSum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    if (result.pixels.usable[i / 3] == 0) continue;
    const double reference = b.rgb[i], difference = static_cast<double>(a.rgb[i]) - reference;
    result.differentValues += difference != 0.0 ? 1 : 0;
    sum += difference * difference;
    relativeSum += difference * difference / (reference * reference + kFloor);
  }
  const double values = 3.0 * static_cast<double>(std::max<std::uint64_t>(result.pixels.count, 1));
  result.mse = sum / values;
  result.relativeMse = relativeSum / values;
}

std::vector<TileSums> sumTiles(const Image& a, const Image& b, int tile,
                               const Comparison& comparison) {
  std::vector<TileSums> tiles;
  for (int top = 0; top < a.height; top += tile)
    for (int left = 0; left < a.width; left += tile) {
      TileSums sums{
          .region = {left, top, std::min(tile, a.width - left), std::min(tile, a.height - top)},
          .sums = {}};
      for (int row = top; row < top + sums.region.height; ++row)
        for (int column = left; column < left + sums.region.width; ++column) {
          const std::size_t pixel =
              static_cast<std::size_t>(row) * static_cast<std::size_t>(a.width) +
              static_cast<std::size_t>(column);
          if (comparison.pixels.usable[pixel] != 0)
            sums.sums.add(a, b, pixel, comparison.replicates);
        }
      if (sums.sums.pixels > 0) tiles.push_back(sums);
    }
  return tiles;
}

void testRegions(const std::vector<TileSums>& tiles, const PixelRegion& image,
                 const CompareSettings& settings, Comparison& result) {
  RegionSums whole;
  for (const TileSums& tile : tiles) whole.merge(tile.sums);
  if (whole.pixels == 0) return;
  const double n = 3.0 * static_cast<double>(whole.pixels);
  const double magnitude = whole.magnitude[0] + whole.magnitude[1] + whole.magnitude[2];
  RegionTolerance tolerance{.relative = settings.within.value_or(0.0),
                            .dark = kDark * std::abs(whole.b[0] + whole.b[1] + whole.b[2]) / n,
                            .leastError = kLeastError * magnitude / n};
  result.alphaOfWhole = 0.5 * settings.alpha / 3.0;
  result.alphaOfTile = 0.5 * settings.alpha / (3.0 * static_cast<double>(tiles.size()));
  tolerance.alpha = result.alphaOfWhole;
  for (int c = 0; c < 3; ++c)
    result.whole.push_back(testRegion(whole, image, c, result.replicates, tolerance));
  tolerance.alpha = result.alphaOfTile;
  for (const TileSums& tile : tiles)
    for (int c = 0; c < 3; ++c)
      result.tiles.push_back(testRegion(tile.sums, tile.region, c, result.replicates, tolerance));
  if (result.judged) return;
  for (RegionResult& region : result.whole) region.differs = false;
  for (RegionResult& region : result.tiles) region.differs = false;
}

}  // namespace

Comparison compareImages(const Image& a, const Image& b, const Replicates& replicates,
                         const CompareSettings& settings) {
  if (a.width != b.width || a.height != b.height)
    throw ImageError(fmt::format(
        "The images have {}x{} and {}x{} pixels; only images of the same size can be compared.",
        a.width, a.height, b.width, b.height));
  Comparison result;
  result.pixels = findUsablePixels(a, b);
  result.replicates = replicates;
  result.judged = replicates.any() || settings.within;
  addDifferences(a, b, result);
  testRegions(sumTiles(a, b, settings.tile, result), {0, 0, a.width, a.height}, settings, result);
  const bool sound =
      result.pixels.sameMarks && result.pixels.a.broken() == 0 && result.pixels.b.broken() == 0;
  const auto differs = [](const RegionResult& region) { return region.differs; };
  result.equal = sound && result.differentValues == 0;
  result.same = result.equal || (sound && result.judged &&
                                 std::none_of(result.whole.begin(), result.whole.end(), differs) &&
                                 std::none_of(result.tiles.begin(), result.tiles.end(), differs));
  result.undecided =
      !result.same && sound && replicates.any() && !replicates.both() && !settings.within;
  return result;
}

Comparison compareImages(const ImageFile& a, const ImageFile& b, const CompareSettings& settings) {
  return compareImages(a.image, b.image, {replicatesOf(a), replicatesOf(b), blockOf(a), blockOf(b)},
                       settings);
}

}  // namespace pathmark
