#include "pairs/pair_table.h"

#include <fmt/format.h>

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

// Of the channels, that which is furthest off for its interval.
const record::Estimate& worst(const PairFinding& finding) {
  const auto size = [](const record::Estimate& e) {
    return std::abs(e.value) / std::max(e.high - e.low, 1e-12);
  };
  return *std::max_element(finding.meanErrors.begin(), finding.meanErrors.end(),
                           [&](const auto& a, const auto& b) { return size(a) < size(b); });
}

std::string rowsOf(const StudiedPair& studied) {
  const auto& [pair, finding] = studied;
  std::string rows;
  for (std::size_t k = 0; k < pair.mistakes.size(); ++k) {
    const Variant& mistake = pair.mistakes[k];
    const bool first = k == 0;
    rows +=
        fmt::format("| {} | {} | {} | `{}`: {} | {} | {} | {} |\n",
                    first ? fmt::format("`{}`", pair.name) : "", first ? sceneWords(pair) : "",
                    mistake.part, mistake.function, mistake.what, percent(finding.alone[k].value),
                    first ? interval(finding.bias) : "", first ? interval(worst(finding)) : "");
  }
  return rows;
}

constexpr std::string_view kIntroduction = R"(# Compensating mistakes

Two mistakes may hide each other: a BRDF without its 1/pi under a loop that divides by pi makes the
right picture. A grader that looks at pictures gives full marks for it, and one that looks at the
whole program cannot say which part is wrong. Here each part is linked by itself, with stand-ins
and solutions for the others, so that each mistake meets functions that are right.

Each row is a mistake. *Alone* is what a picture shows of it by itself, *together* what it shows of
the whole pair: the root mean square over tiles of 8 x 8 pixels, relative to the picture's
brightness, with what noise adds taken away, and its interval of 99 %. *Mean* is the error of the
whole picture's mean in the channel that is furthest off. Pictures have 96 pixels along the longer
side, those of pairs 1024 rays per pixel and the others 128, in 32 replicates.
)";

}  // namespace

std::string pairLine(const StudiedPair& studied) {
  const auto& [pair, finding] = studied;
  double least = HUGE_VAL;
  for (const record::Estimate& alone : finding.alone) least = std::min(least, alone.value);
  return fmt::format("{:<33} {:<28} together {:<27} alone {:>8} or more  fails: {}{}{}\n",
                     pair.name, sceneWords(pair), interval(finding.bias), percent(least),
                     fmt::join(finding.failed, ", "), hides(finding) ? "" : "   <-- shows",
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
  text += "| Pair | Scene | Part | Function and mistake | Alone | Together | Mean |\n";
  text += "|---|---|---|---|---|---|---|\n";
  for (const StudiedPair& studied : pairs) text += rowsOf(studied);
  return text;
}

}  // namespace pathmark::pairs
