#include "pairs/pair_table.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pathmark::pairs {

namespace {

std::string percent(double x) {
  return fmt::format("{:.{}f} %", 100.0 * x, std::abs(x) < 0.1 ? 2 : 0);
}

std::string interval(const record::Estimate& e) {
  return fmt::format("{} ({} to {})", percent(e.value), percent(e.low), percent(e.high));
}

double leastAlone(const PairFinding& finding) {
  double least = HUGE_VAL;
  for (const record::Estimate& alone : finding.alone) least = std::min(least, alone.value);
  return least;
}

std::string rowOf(const StudiedPair& studied) {
  const auto& [pair, finding] = studied;
  std::vector<std::string> mistakes, failed;
  for (const Variant& m : pair.mistakes)
    mistakes.push_back(fmt::format("{}, `{}`: {}", m.part, m.function, m.what));
  for (const std::string& function : finding.failed)
    failed.push_back(fmt::format("`{}`", function));
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", pair.name, sceneWords(pair),
                     fmt::join(mistakes, "<br>"), interval(finding.bias),
                     percent(leastAlone(finding)), fmt::join(failed, ", "));
}

constexpr std::string_view kIntroduction = R"(# Compensating mistakes

Two mistakes may hide each other: a BRDF without its 1/pi under a loop that divides by pi makes the
right picture. A grader that looks at pictures gives full marks for it, and one that looks at the
whole program cannot say which part is wrong. Here each part is linked by itself, with stand-ins
and solutions for the others, so that each mistake meets functions that are right.

*Together* is what the picture of the whole shows: the root mean square over tiles of 8 x 8 pixels,
each relative to its brightness, or to the picture's where it is darker, over that of a black
picture, with what noise adds taken away, and its interval of 99 %.
*Alone* is what the picture with one of the mistakes shows, at least. Pictures have 96 pixels along
the longer side; those of a whole pair have 2048 rays per pixel, in 32 replicates, and eight times
as many where the warm-up meets lights by chance. Where several functions of one part fail, the one
with the mistake is called by the others.
)";

}  // namespace

std::string pairLine(const StudiedPair& studied) {
  const auto& [pair, finding] = studied;
  return fmt::format("{:<33} {:<28} together {:<27} alone {:>8} or more  fails: {}{}{}\n",
                     pair.name, sceneWords(pair), interval(finding.bias),
                     percent(leastAlone(finding)), fmt::join(finding.failed, ", "),
                     hides(finding) ? "" : "   <-- shows",
                     caught(pair, finding) ? "" : "   <-- not caught as it must be");
}

std::string pairChapter(std::span<const StudiedPair> pairs, std::uint64_t seed) {
  std::string text(kIntroduction);
  const auto hidden =
      std::count_if(pairs.begin(), pairs.end(), [](const auto& s) { return hides(s.finding); });
  const auto found = std::count_if(pairs.begin(), pairs.end(),
                                   [](const auto& s) { return caught(s.pair, s.finding); });
  text += fmt::format(
      "\nOf {0} pairs, {1} hide: a comparison as `./pathmark compare` makes it (alpha = {2:g}) "
      "finds no difference, and the interval of the bias lies below {3}, which an eye may just "
      "see; "
      "that of each mistake alone lies above. In {4} of {0} pairs every function with a mistake "
      "fails in its own part, and no part fails "
      "that has none. Made by `./pathmark pairs --seed {5} --output "
      "handouts/compensating_mistakes.md`; the patches are listed in "
      "`grader/variants/pairs/pairs.json`.\n\n",
      pairs.size(), hidden, kSameAlpha, percent(kSeen), found, seed);
  text +=
      "| Pair | Scene | Mistakes, with their parts | Together | Alone | Functions that fail |\n";
  text += "|---|---|---|---|---|---|\n";
  for (const StudiedPair& studied : pairs) text += rowOf(studied);
  return text;
}

}  // namespace pathmark::pairs
