#include "preview/samples/sample_remarks.h"

#include <fmt/format.h>

#include <cmath>

namespace pathmark::preview {

namespace {

bool isUnlikely(const CellTest& test) { return test.possible && test.pValue < kUnlikely; }

// What does not fit the contract's density may fit the one that was returned.
std::string aboutDensities(const SampleSet& set) {
  if (!set.claims || !set.claimedOverExpected) return {};
  const bool plainOff = isUnlikely(set.plain.test), weightedOff = isUnlikely(set.weighted.test);
  const auto [low, high] = *set.claimedOverExpected;
  constexpr double kSame = 0.01;
  const bool constant = high - low < kSame * high && std::abs(high - 1.0) > kSame;
  if (plainOff && !weightedOff)
    return "The points do not have the density that the contract names, but they have the one that "
           "they claim: weighted, they fit. Such a sampler is another one, not a wrong one.";
  if (!plainOff && weightedOff && constant)
    return fmt::format(
        "The points fit, but the density that they claim is {:.4g} times what it should be.", high);
  if (!plainOff && weightedOff)
    return "The points fit, but the density that they claim is not the one that they have.";
  if (plainOff && weightedOff)
    return "The points have neither the density that the contract names nor the one that they "
           "claim.";
  return {};
}

}  // namespace

std::vector<std::string> remarksOn(const SampleSet& set) {
  std::vector<std::string> remarks;
  const std::size_t n = set.samples.size();
  if (const auto k = set.count(SampleKind::kNoNumber))
    remarks.push_back(fmt::format(
        "{} of {} answers are not numbers (NaN, infinite, or a negative density).", k, n));
  if (const auto k = set.count(SampleKind::kAstray))
    remarks.push_back(fmt::format("{} of {} points {}: crosses.", k, n, set.astray));
  if (const auto k = set.count(SampleKind::kNone))
    remarks.push_back(fmt::format("{} of {} answers have density 0: no sample.", k, n));
  if (std::string about = aboutDensities(set); !about.empty()) remarks.push_back(std::move(about));
  return remarks;
}

std::string describe(const CellTest& test, SamplerKind points) {
  if (!test.possible) return "Too few points for a chi-square test.";
  const std::string p = test.pValue < 1e-4 ? "p < 0.0001" : fmt::format("p = {:.4f}", test.pValue);
  std::string text = fmt::format("{} (chi-square, {} cells)", p, test.cells);
  constexpr double kEven = 0.99;
  if (test.pValue < kUnlikely)
    text += ": hardly chance.";
  else if (test.pValue > kEven && points != SamplerKind::kPcg)
    text += ": more even than chance, as this point set is made to be.";
  else
    text += ": could be chance.";
  return text;
}

}  // namespace pathmark::preview
