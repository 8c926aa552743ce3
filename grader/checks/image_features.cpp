#include "checks/image_features.h"

#include "stats/replicate_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

constexpr int kModes = 4, kTiles = 8;  // in each direction
constexpr const char* kChannels[] = {"red", "green", "blue"};

// Errors that are found, relative to what is there; of a tile that is darker than a fifth of the
// image's mean, relative to that.
constexpr double kDeltaOfMode = 0.02, kDeltaOfTile = 0.1, kDarkTile = 0.2;

// What rounding, and the reference with its own, may be off.
constexpr double kTolerance = 2e-4, kToleranceOfTile = 1e-3;

stats::Guarantee guaranteeOf(const ImageFeatures& features, std::size_t k,
                             const std::vector<double>& sizes, double alpha) {
  const double mean = std::max({std::abs(sizes[k % 3]), 1e-3 * std::abs(sizes[0]),
                                1e-3 * std::abs(sizes[1]), 1e-3 * std::abs(sizes[2])});
  const bool tile = features.isTile(k);
  const double scale = tile ? std::max(std::abs(sizes[k]), kDarkTile * mean) : mean;
  stats::Guarantee guarantee;
  guarantee.alpha = alpha;
  guarantee.looks = 1;
  guarantee.tolerance = (tile ? kToleranceOfTile : kTolerance) * scale;
  guarantee.delta = (features.isMean(k) ? kDeltaOfImage
                     : tile             ? kDeltaOfTile
                                        : kDeltaOfMode) *
                    scale;
  guarantee.deviationFloor = 0.5 * guarantee.delta;
  return guarantee;
}

}  // namespace

std::string placeInWords(double x, double y) {
  const int column = std::clamp(static_cast<int>(3.0 * x), 0, 2),
            row = std::clamp(static_cast<int>(3.0 * y), 0, 2);
  if (column == 1 && row == 1) return "middle";
  constexpr const char* kRows[] = {"upper", "middle", "lower"};
  constexpr const char* kColumns[] = {"left", "middle", "right"};
  return fmt::format("{} {}", kRows[row], kColumns[column]);
}

ImageFeatures::ImageFeatures(int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto add = [&](std::string name, bool tile, const auto& weightAt) {
    Feature feature{std::move(name), tile, {}};
    feature.weights.reserve(pixels);
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) feature.weights.push_back(weightAt(i, j));
    features_.push_back(std::move(feature));
  };
  for (int b = 0; b < kModes; ++b)
    for (int a = 0; a < kModes; ++a)
      add(a + b == 0 ? "mean of the picture"
                     : fmt::format("mean of radiance x cos({} pi x) cos({} pi y), x and y from 0 "
                                   "to 1 over the picture",
                                   a, b),
          false, [&](int i, int j) {
            return std::cos(std::numbers::pi * a * (i + 0.5) / width) *
                   std::cos(std::numbers::pi * b * (j + 0.5) / height) /
                   static_cast<double>(pixels);
          });
  for (int row = 0; row < kTiles; ++row)
    for (int column = 0; column < kTiles; ++column) {
      const int left = column * width / kTiles, right = (column + 1) * width / kTiles,
                top = row * height / kTiles, bottom = (row + 1) * height / kTiles;
      if (left == right || top == bottom) continue;
      add(fmt::format("mean of the tile in column {} and row {} of {} x {} ({})", column + 1,
                      row + 1, kTiles, kTiles,
                      placeInWords((column + 0.5) / kTiles, (row + 0.5) / kTiles)),
          true, [=](int i, int j) {
            const bool inside = i >= left && i < right && j >= top && j < bottom;
            return inside ? 1.0 / ((right - left) * (bottom - top)) : 0.0;
          });
    }
}

std::vector<double> ImageFeatures::of(const PlainImage& image) const {
  std::vector<double> values;
  values.reserve(count());
  for (const Feature& feature : features_) {
    double sum[3] = {};
    for (std::size_t p = 0; p < feature.weights.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c) sum[c] += feature.weights[p] * image.rgb[3 * p + c];
    values.insert(values.end(), sum, sum + 3);
  }
  return values;
}

std::vector<double> ImageFeatures::errors(const PlainImage& variances) const {
  std::vector<double> values;
  values.reserve(count());
  for (const Feature& feature : features_) {
    double sum[3] = {};
    for (std::size_t p = 0; p < feature.weights.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += feature.weights[p] * feature.weights[p] * variances.rgb[3 * p + c];
    for (const double variance : sum) values.push_back(std::sqrt(variance));
  }
  return values;
}

Finding judgeFeatures(CheckRun& run, const ImageFeatures& features, const FeatureTarget& target,
                      const std::vector<std::vector<double>>& replicates,
                      const std::string& where) {
  Finding finding;
  for (std::size_t k = 0; k < features.count(); ++k) {
    const stats::Guarantee guarantee = guaranteeOf(features, k, target.sizes, run.budget.take());
    const double error = target.errors.empty() ? 0.0 : target.errors[k];
    stats::ReplicateTest test(target.expected[k], error, guarantee);
    for (const std::vector<double>& replicate : replicates) test.add(replicate[k]);
    const stats::Judgement judgement = test.judge(0);
    if (features.isMean(k)) {
      finding.shown = std::max(finding.shown, kDeltaOfImage * judgement.shown / guarantee.delta);
      if (judgement.outcome == stats::Outcome::kUndecided) finding.status = Status::kUndecided;
    }
    const bool failed = judgement.outcome == stats::Outcome::kFail;
    if (!failed && !(features.isMean(k) && finding.status == Status::kUndecided)) continue;
    finding.where = where;
    finding.expected =
        fmt::format("{}, {} = {:.6g}", features.name(k), kChannels[k % 3], target.expected[k]);
    finding.got =
        fmt::format("{}, {} = {:.6g}", features.name(k), kChannels[k % 3], judgement.mean);
    finding.tolerance =
        fmt::format("{:.2g} and {:.1f} standard errors of {:.2g}", guarantee.tolerance,
                    judgement.critical, judgement.standardError);
    if (!failed) continue;
    finding.status = Status::kFail;
    break;
  }
  return finding;
}

}  // namespace pathmark::checks
