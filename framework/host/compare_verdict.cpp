#include "film/printable.h"
#include "host/compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark {

namespace {

std::string count(std::uint64_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string percent(double fraction) { return fmt::format("{:.6g} %", 100.0 * fraction); }

std::uint64_t differing(const std::vector<RegionResult>& regions) {
  return static_cast<std::uint64_t>(std::count_if(
      regions.begin(), regions.end(), [](const RegionResult& region) { return region.differs; }));
}

std::string listOf(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return fmt::format("{}", fmt::join(parts, ""));
  return fmt::format("{} and {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

// "3 pixels with NaN and 1 infinite pixel"; empty if there are none.
std::string flawsOf(const Flaws& flaws) {
  std::vector<std::string> parts;
  const auto add = [&](std::uint64_t n, const char* before, const char* after) {
    if (n > 0) parts.push_back(fmt::format("{} {}pixel{}{}", n, before, n == 1 ? "" : "s", after));
  };
  add(flaws.invalid, "", " marked as invalid");
  add(flaws.nan, "", " with NaN");
  add(flaws.infinite, "infinite ", "");
  add(flaws.noVariance, "", " with a variance that is NaN, infinite or negative");
  return listOf(parts);
}

// Of one image with variances and one without them.
std::string undecidedSentence(const CompareReport& report) {
  const std::size_t silent = report.comparison.replicates.a > 0 ? 1 : 0;
  return fmt::format(
      "It cannot be told whether they differ by more than noise: {} does not say how noisy it is; "
      "render it to an .exr file with --replicates 16.",
      report.names[silent].string());
}

std::string_view criterion(const CompareReport& report) {
  return report.comparison.replicates.any() ? "noise explains" : "is accepted";
}

}  // namespace

std::string verdictSentence(const CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const std::optional<double>& within = report.settings.within;
  const std::string accepted = within ? fmt::format(", beyond {}", percent(*within)) : "";
  if (comparison.equal) return "The same: every value is equal.";
  if (comparison.same && !comparison.replicates.any())
    return fmt::format("The same within {}: the means of the image and of all tiles agree.",
                       percent(*within));
  if (comparison.same)
    return fmt::format(
        "The same within their noise{}: no mean of the image or of a tile is further apart than it "
        "explains.",
        within ? " and " + percent(*within) : "");
  if (comparison.pixels.a.broken() > 0 || comparison.pixels.b.broken() > 0)
    return "They differ: there are pixels without a value.";
  if (!comparison.pixels.sameMarks) return "They differ: other pixels are marked as invalid.";
  if (comparison.undecided) return undecidedSentence(report);
  if (!comparison.judged)
    return fmt::format("They differ: {} of {} are not equal.", comparison.differentValues,
                       count(3 * comparison.pixels.count, "value"));
  return fmt::format(
      "They differ: {} of 3 means of the image, and {} of {} means of tiles, are further apart "
      "than {}{}.",
      differing(comparison.whole), differing(comparison.tiles), comparison.tiles.size(),
      criterion(report), comparison.replicates.any() ? accepted : "");
}

std::vector<std::string> compareNotes(const CompareReport& report) {
  const Comparison& comparison = report.comparison;
  const ImageOrigin &a = report.files[0].origin, &b = report.files[1].origin;
  std::vector<std::string> notes;
  const std::array<const Flaws*, 2> flaws{&comparison.pixels.a, &comparison.pixels.b};
  for (std::size_t i = 0; i < 2; ++i) {
    const char name = i == 0 ? 'A' : 'B';
    if (const std::string found = flawsOf(*flaws[i]); !found.empty())
      notes.push_back(fmt::format("{} has {}: left out of all numbers.", name, found));
    if (const std::string_view lost = whatTheFormatLoses(report.names[i]); !lost.empty())
      notes.push_back(fmt::format("{} has only {}: smaller differences are not seen.", name, lost));
    if (!report.files[i].image.variance.empty() && report.files[i].origin.replicates < 2)
      notes.push_back(fmt::format(
          "{} does not say from how many replicates its variances are: 2 are assumed.", name));
  }
  const bool varianceA = comparison.replicates.a > 0, varianceB = comparison.replicates.b > 0;
  if (comparison.undecided)
    notes.push_back(
        fmt::format("Only {} has variances: if {} is exact, they differ; --within 1% accepts small "
                    "differences of means.",
                    varianceA ? 'A' : 'B', varianceA ? 'B' : 'A'));
  else if (varianceA != varianceB)
    notes.push_back(fmt::format("Only {} has variances: {} counts as exact.", varianceA ? 'A' : 'B',
                                varianceA ? 'B' : 'A'));
  const auto isFew = [](std::uint32_t replicates) {
    return replicates > 0 && replicates < kFewReplicates;
  };
  if (isFew(comparison.replicates.a) || isFew(comparison.replicates.b))
    notes.push_back(fmt::format(
        "Fewer than {} replicates say little of the noise: only large differences show, and with "
        "--replicates 16 small ones too.",
        kFewReplicates));
  if (!comparison.judged && !comparison.equal)
    notes.push_back(
        "Neither has variances, so only equal values count as the same; --within 1% accepts small "
        "differences of means.");
  if (!a.sceneHash.empty() && !b.sceneHash.empty() && a.sceneHash != b.sceneHash)
    notes.push_back(
        a.scene == b.scene
            ? fmt::format("Both are of {}, but of another version or size of it, another number of "
                          "bounces, or only one of them by --solid-angle.",
                          printable(a.scene))
            : fmt::format("They are of different scenes: {} and {}.", printable(a.scene),
                          printable(b.scene)));
  const auto pathsOf = [](const ImageOrigin& origin) {
    return origin.paths.empty() ? std::string("all light") : printable(origin.paths);
  };
  if (a.paths != b.paths)
    notes.push_back(
        fmt::format("They show different light paths: {} and {}.", pathsOf(a), pathsOf(b)));
  const bool otherPoints = !a.sampler.empty() && !b.sampler.empty() && a.sampler != b.sampler;
  const bool sameRays =
      !a.sceneHash.empty() && a.sceneHash == b.sceneHash && a.seed == b.seed && !otherPoints;
  if (sameRays && comparison.replicates.any() && !comparison.equal)
    notes.push_back(fmt::format(
        "Both are of seed {}: noise that they have in common makes z too small, but never too "
        "large.",
        a.seed));
  return notes;
}

std::vector<RegionResult> furthestTiles(const Comparison& comparison) {
  constexpr std::size_t kMost = 10;
  const bool noise = comparison.replicates.any();
  const auto further = [noise](const RegionResult& x, const RegionResult& y) {
    if (!noise) return x.relative > y.relative;
    return x.pValue != y.pValue ? x.pValue < y.pValue : std::abs(x.z) > std::abs(y.z);
  };
  std::vector<RegionResult> furthest;
  for (std::size_t i = 0; i + 2 < comparison.tiles.size(); i += 3) {
    const auto first = comparison.tiles.begin() + static_cast<std::ptrdiff_t>(i);
    const RegionResult& worst = *std::min_element(first, first + 3, further);
    if (worst.a != worst.b) furthest.push_back(worst);
  }
  const std::size_t most = std::min(kMost, furthest.size());
  std::partial_sort(furthest.begin(), furthest.begin() + static_cast<std::ptrdiff_t>(most),
                    furthest.end(), further);
  furthest.resize(most);
  return furthest;
}

}  // namespace pathmark
