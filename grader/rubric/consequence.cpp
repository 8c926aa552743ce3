#include "rubric/consequence.h"

#include "stats/efficiency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::rubric {

namespace {

using record::PictureRecord;

double biasCredit(double bias, const Rubric& rubric) {
  for (const BiasBand& band : rubric.biasBands)
    if (bias <= band.biasAtMost) return band.credit;
  return 0.0;
}

// Values that are no radiance are in no bias: what they do to the picture is not seen there.
double creditOf(const PictureRecord& picture, const Rubric& rubric) {
  if (!picture.failure.empty()) return 0.0;
  const double credit = biasCredit(picture.bias.low, rubric);
  return picture.invalid.empty() ? credit : std::min(credit, rubric.withoutPicture);
}

std::string wordsOf(const PictureRecord& picture) {
  if (!picture.failure.empty())
    return fmt::format("there is no picture of {}: {}", picture.scene, picture.failure);
  return fmt::format("the picture of {} is {} off{}{}", picture.scene, interval(picture.bias),
                     picture.invalid.empty() ? "" : ", and ", picture.invalid);
}

// Among equal credits too, the words should be of the worst.
bool isWorse(const PictureRecord& a, const PictureRecord& b, const Rubric& rubric) {
  if (a.failure.empty() != b.failure.empty()) return b.failure.empty();
  const double creditA = creditOf(a, rubric), creditB = creditOf(b, rubric);
  if (creditA != creditB) return creditA < creditB;
  return a.bias.low != b.bias.low ? a.bias.low > b.bias.low : a.bias.value > b.bias.value;
}

double efficiencyCredit(const record::Estimate& efficiency, const Rubric& rubric) {
  std::vector<double> thresholds;
  for (const EfficiencyBand& band : rubric.efficiencyBands) thresholds.push_back(band.ratioAtLeast);
  const int band =
      stats::bandRange({efficiency.value, efficiency.low, efficiency.high}, thresholds).highest;
  return band == 0 ? 0.0 : rubric.efficiencyBands[static_cast<std::size_t>(band) - 1].credit;
}

}  // namespace

std::string percent(double share) {
  const double value = 100.0 * share;
  if (value == 0.0 || std::abs(value) < 0.005) return "0 %";
  return std::abs(value) < 9.95 ? fmt::format("{:.2g} %", value) : fmt::format("{:.0f} %", value);
}

std::string interval(const record::Estimate& shares) {
  return fmt::format("{} ({} to {})", percent(shares.value), percent(shares.low),
                     percent(shares.high));
}

std::optional<Consequence> worstPicture(std::span<const PictureRecord> pictures,
                                        const Rubric& rubric) {
  const PictureRecord* worst = nullptr;
  for (const PictureRecord& picture : pictures)
    if (worst == nullptr || isWorse(picture, *worst, rubric)) worst = &picture;
  if (worst == nullptr) return std::nullopt;
  return Consequence{creditOf(*worst, rubric), wordsOf(*worst)};
}

bool isRight(const PictureRecord& picture, const Rubric& rubric) {
  return picture.failure.empty() && picture.invalid.empty() &&
         biasCredit(picture.bias.low, rubric) >= biasCredit(0.0, rubric);
}

std::optional<Economy> worstEfficiency(std::span<const PictureRecord> pictures,
                                       const Rubric& rubric) {
  const PictureRecord* worst = nullptr;
  for (const PictureRecord& picture : pictures)
    if (picture.efficiency &&
        (worst == nullptr || picture.efficiency->high < worst->efficiency->high))
      worst = &picture;
  if (worst == nullptr) return std::nullopt;
  const record::Estimate& ratio = *worst->efficiency;
  return Economy{efficiencyCredit(ratio, rubric),
                 fmt::format("in {}, 1 / (variance x rays) is {:.2g} ({:.2g} to {:.2g}) times that "
                             "of the solutions",
                             worst->scene, ratio.value, ratio.low, ratio.high)};
}

}  // namespace pathmark::rubric
