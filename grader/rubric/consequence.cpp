#include "rubric/consequence.h"

#include "stats/efficiency.h"

#include <fmt/format.h>

#include <cmath>

namespace pathmark::rubric {

namespace {

double biasCredit(double bias, const Rubric& rubric) {
  for (const BiasBand& band : rubric.biasBands)
    if (bias <= band.biasAtMost) return band.credit;
  return 0.0;
}

Consequence consequence(const record::PictureRecord& picture, const Rubric& rubric) {
  if (!picture.failure.empty())
    return {0.0, fmt::format("there is no picture of {}: {}", picture.scene, picture.failure)};
  return {biasCredit(picture.bias.low, rubric),
          fmt::format("the picture of {} is {} off", picture.scene, interval(picture.bias))};
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

std::optional<Consequence> worstPicture(std::span<const record::PictureRecord> pictures,
                                        const Rubric& rubric) {
  const record::PictureRecord* worst = nullptr;
  for (const record::PictureRecord& picture : pictures) {
    const bool fails = !picture.failure.empty();
    if (worst == nullptr || (fails && worst->failure.empty()) ||
        (!fails && worst->failure.empty() && picture.bias.low > worst->bias.low))
      worst = &picture;
  }
  if (worst == nullptr) return std::nullopt;
  return consequence(*worst, rubric);
}

std::optional<Economy> worstEfficiency(std::span<const record::PictureRecord> pictures,
                                       const Rubric& rubric) {
  const record::PictureRecord* worst = nullptr;
  for (const record::PictureRecord& picture : pictures)
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
