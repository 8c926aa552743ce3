#include "preview/compare/verdict.h"

#include "stats/quantiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::preview {

namespace {

constexpr const char* kChannels[] = {"red", "green", "blue"};

const char* channelOf(const RegionResult& region) { return kChannels[region.channel]; }

// " (-1.92 %)"; empty where it would say nothing.
std::string inPercent(const RegionResult& region) {
  if (!(region.b > 0.0)) return {};
  return fmt::format(" ({:+.3g} %)", 100.0 * (region.a / region.b - 1.0));
}

std::string numbersOf(const RegionResult& region) {
  const int digits = std::abs(region.z) < 100.0 ? 1 : 0;
  return fmt::format("{} {:.4g} instead of {:.4g}{}, {:+.{}f} standard errors", channelOf(region),
                     region.a, region.b, inPercent(region), region.z, digits);
}

bool lessLikely(const RegionResult& x, const RegionResult& y) {
  return x.pValue != y.pValue ? x.pValue < y.pValue : std::abs(x.z) > std::abs(y.z);
}

std::uint64_t brokenPixels(const Flaws& flaws) { return flaws.invalid + flaws.broken(); }

std::string pixels(std::uint64_t count) {
  return fmt::format("{} pixel{}", count, count == 1 ? " has" : "s have");
}

std::string wholeLine(const Comparison& comparison) {
  const auto worst = std::min_element(comparison.whole.begin(), comparison.whole.end(), lessLikely);
  if (worst == comparison.whole.end()) return {};
  if (!worst->differs) return "The means of the whole image agree.\n";
  return fmt::format("Whole image: {}.\n", numbersOf(*worst));
}

std::string tileLine(const Comparison& comparison, Verdict& verdict) {
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i + 2 < comparison.tiles.size(); i += 3)
    differing += comparison.tiles[i].differs || comparison.tiles[i + 1].differs ||
                         comparison.tiles[i + 2].differs
                     ? 1
                     : 0;
  if (differing == 0) return "No tile by itself is beyond its noise.\n";
  const RegionResult& worst = *worstTile(comparison);
  verdict.worst = worst.region;
  const PixelRegion& r = worst.region;
  return fmt::format("{} of {} tiles differ{}. Worst: columns {} to {}, rows {} to {}, {}.\n",
                     differing, comparison.tiles.size() / 3, differing == 1 ? "s" : "", r.left,
                     r.left + r.width - 1, r.top, r.top + r.height - 1, numbersOf(worst));
}

// The largest, over the channels, of what is found with a probability of 97.7 %: two standard
// errors beyond the threshold.
double smallestFound(const Comparison& comparison) {
  constexpr double kBeyond = 2.0;
  const double critical =
      stats::studentCritical(comparison.alphaOfWhole, std::numeric_limits<double>::infinity());
  double largest = 0.0;
  for (const RegionResult& channel : comparison.whole)
    if (channel.b > 0.0)
      largest = std::max(
          largest, (critical + kBeyond) * std::hypot(channel.errorA, channel.errorB) / channel.b);
  return largest;
}

Verdict without(const Comparison& comparison) {
  const std::uint64_t a = brokenPixels(comparison.pixels.a), b = brokenPixels(comparison.pixels.b);
  Verdict verdict{.judgement = Judgement::kDiffers,
                  .headline = "They differ: there are pixels without a value."};
  if (a > 0)
    verdict.detail += fmt::format(
        "{} no valid value in your picture (magenta): NaN, infinite or negative radiance.\n",
        pixels(a));
  if (b > 0) verdict.detail += fmt::format("{} none in the reference.\n", pixels(b));
  return verdict;
}

Verdict different(const Comparison& comparison) {
  Verdict verdict{.judgement = Judgement::kDiffers, .headline = "They differ by more than noise."};
  verdict.detail = wholeLine(comparison);
  verdict.detail += tileLine(comparison, verdict);
  return verdict;
}

Verdict equalSoFar(const Comparison& comparison) {
  if (comparison.equal)
    return {.judgement = Judgement::kSame, .headline = "The same: every value is equal."};
  return {.judgement = Judgement::kSame,
          .headline = "No difference beyond noise so far.",
          .detail = fmt::format("If the mean of the image were off by {:.2g} %, it would have been "
                                "found (with a probability of 97.7 %).\n",
                                100.0 * smallestFound(comparison))};
}

}  // namespace

const RegionResult* worstTile(const Comparison& comparison) {
  const auto worst = std::min_element(comparison.tiles.begin(), comparison.tiles.end(), lessLikely);
  return worst == comparison.tiles.end() ? nullptr : &*worst;
}

Verdict verdictOf(const Comparison& comparison, double raysPerPixel) {
  const UsablePixels& pixels = comparison.pixels;
  const bool broken = !pixels.sameMarks || pixels.a.broken() > 0 || pixels.b.broken() > 0;
  Verdict verdict = comparison.same ? equalSoFar(comparison)
                    : broken        ? without(comparison)
                                    : different(comparison);
  verdict.raysPerPixel = raysPerPixel;
  return verdict;
}

}  // namespace pathmark::preview
