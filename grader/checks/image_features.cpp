#include "checks/image_features.h"

#include "checks/channels.h"
#include "stats/replicate_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace pathmark::checks {

namespace {

constexpr int kLooks = 2;
constexpr std::uint64_t kReplicatesOfLook[kLooks] = {256, 768};

constexpr int kModes = 4, kTiles = 8;  // in each direction

// Errors of modes and tiles are judged as if no smaller ones than these were asked for.
constexpr double kDeltaOfMode = 0.02, kDeltaOfTile = 0.1;

// The variances of a reference's pixels are from few replicates, which may lack the rare bright
// values of a tile: its errors count so many times.
constexpr double kReferenceCaution = 3.0;

// What rounding, and the reference with its own, may be off.
constexpr double kTolerance = 2e-4, kToleranceOfTile = 1e-3;

// Of a channel's mean: what is darker is judged as if it were as bright.
constexpr double kDark = 0.1;

// So much of what a mean of relative values would be where nothing is dark: what is almost black
// altogether is not blown up.
constexpr double kLeastSum = 0.2;

stats::Guarantee guaranteeOf(const ImageFeatures& features, std::size_t k, double deltaOfMean,
                             double alpha) {
  stats::Guarantee guarantee;
  guarantee.alpha = alpha;
  guarantee.looks = kLooks;
  guarantee.tolerance = features.isTile(k) ? kToleranceOfTile : kTolerance;
  guarantee.delta = features.isMean(k)   ? deltaOfMean
                    : features.isTile(k) ? kDeltaOfTile
                                         : kDeltaOfMode;
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

ImageFeatures::ImageFeatures(const PlainImage& like) {
  const int width = like.width, height = like.height;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::array<double, 3> dark{};
  for (std::size_t v = 0; v < 3 * pixels; ++v)
    dark[v % 3] += kDark * like.rgb[v] / static_cast<double>(pixels);
  // A channel in which there should be nothing is relative to the others.
  const double least = 0.1 * std::max({dark[0], dark[1], dark[2]});
  for (double& d : dark) d = std::max(d, least);

  // `weightAt(i, j)` of a sum of 1, before pixels are taken relative to what they should be;
  // `scale`: channels' factors, for sums that should be 1.
  const auto add = [&](std::string name, bool tile, const auto& weightAt,
                       std::optional<std::array<double, 3>> scale) {
    Feature feature{std::move(name), tile, {}, {}};
    std::array<double, 3> sum{};
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const double weight = weightAt(i, j);
        if (weight == 0.0) continue;
        const auto p = static_cast<std::size_t>(j * width + i);
        feature.pixels.push_back(p);
        for (std::size_t c = 0; c < 3; ++c) {
          feature.weights.push_back(weight / std::max(like.rgb[3 * p + c], dark[c]));
          sum[c] += feature.weights.back() * like.rgb[3 * p + c];
        }
      }
    if (!scale)
      scale = std::array{1.0 / std::max(sum[0], kLeastSum), 1.0 / std::max(sum[1], kLeastSum),
                         1.0 / std::max(sum[2], kLeastSum)};
    for (std::size_t v = 0; v < feature.weights.size(); ++v) feature.weights[v] *= (*scale)[v % 3];
    features_.push_back(std::move(feature));
    return *scale;
  };
  std::optional<std::array<double, 3>> scaleOfMean;
  for (int b = 0; b < kModes; ++b)
    for (int a = 0; a < kModes; ++a) {
      const auto mode = [&](int i, int j) {
        return std::cos(std::numbers::pi * a * (i + 0.5) / width) *
               std::cos(std::numbers::pi * b * (j + 0.5) / height) / static_cast<double>(pixels);
      };
      scaleOfMean = add(a + b == 0 ? "the picture's mean"
                                   : fmt::format("the picture's mean with the weights cos({} pi x) "
                                                 "cos({} pi y), x and y from 0 to 1 over it",
                                                 a, b),
                        false, mode, scaleOfMean);
    }
  for (int row = 0; row < kTiles; ++row)
    for (int column = 0; column < kTiles; ++column) {
      const int left = column * width / kTiles, right = (column + 1) * width / kTiles,
                top = row * height / kTiles, bottom = (row + 1) * height / kTiles;
      if (left == right || top == bottom) continue;
      const auto tile = [&](int i, int j) {
        const bool inside = i >= left && i < right && j >= top && j < bottom;
        return inside ? 1.0 / ((right - left) * (bottom - top)) : 0.0;
      };
      add(fmt::format("the mean of tile {} in row {} of {} x {} ({})", column + 1, row + 1, kTiles,
                      kTiles, placeInWords((column + 0.5) / kTiles, (row + 0.5) / kTiles)),
          true, tile, std::nullopt);
    }
}

std::vector<double> ImageFeatures::of(const PlainImage& image) const {
  std::vector<double> values;
  values.reserve(count());
  for (const Feature& feature : features_) {
    double sum[3] = {};
    for (std::size_t k = 0; k < feature.pixels.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += feature.weights[3 * k + c] * image.rgb[3 * feature.pixels[k] + c];
    values.insert(values.end(), sum, sum + 3);
  }
  return values;
}

std::vector<double> ImageFeatures::errors(const PlainImage& variances) const {
  std::vector<double> values;
  values.reserve(count());
  for (const Feature& feature : features_) {
    double sum[3] = {};
    for (std::size_t k = 0; k < feature.pixels.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        const double weight = feature.weights[3 * k + c];
        sum[c] += weight * weight * variances.rgb[3 * feature.pixels[k] + c];
      }
    for (const double variance : sum) values.push_back(std::sqrt(variance));
  }
  return values;
}

Finding judgeFeatures(CheckRun& run, const ImageFeatures& features, const FeatureTarget& target,
                      const MakeReplicates& make, const std::string& where) {
  std::vector<stats::ReplicateTest> tests;
  for (std::size_t k = 0; k < features.count(); ++k)
    tests.emplace_back(target.expected[k],
                       target.errors.empty() ? 0.0 : kReferenceCaution * target.errors[k],
                       guaranteeOf(features, k, target.delta, run.budget.take()));
  std::uint64_t made = 0;
  Finding finding;
  for (int look = 0; look < kLooks; ++look) {
    for (const std::vector<double>& replicate : make(made, kReplicatesOfLook[look] - made))
      for (std::size_t k = 0; k < tests.size(); ++k) tests[k].add(replicate[k]);
    made = kReplicatesOfLook[look];
    finding = {};
    for (std::size_t k = 0; k < tests.size(); ++k) {
      const stats::Judgement judgement = tests[k].judge(look);
      const bool failed = judgement.outcome == stats::Outcome::kFail;
      const bool undecided = features.isMean(k) && judgement.outcome == stats::Outcome::kUndecided;
      if (features.isMean(k)) finding.shown = std::max(finding.shown, judgement.shown);
      if (!failed && !undecided) continue;
      finding.status = failed ? Status::kFail : Status::kUndecided;
      const std::string what = inChannel(features.name(k), static_cast<int>(k % 3));
      finding.where = where;
      finding.expected = fmt::format("{} = {:.5g}", what, target.expected[k]);
      finding.got = fmt::format("{} = {:.5g}, relative to the right picture", what, judgement.mean);
      finding.tolerance = fmt::format("{:.2g} and {:.1f} standard errors of {:.2g}",
                                      features.isTile(k) ? kToleranceOfTile : kTolerance,
                                      judgement.critical, judgement.standardError);
      if (failed) return finding;
    }
    if (finding.passed()) break;
  }
  return finding;
}

}  // namespace pathmark::checks
