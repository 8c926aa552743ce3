#include "diagnosis/diagnose.h"

#include "host/where_to_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pathmark::diagnosis {

namespace {

constexpr std::size_t kMostAlike = 2;

// In standard errors; infinite where one of them is a number and the other is none.
double distanceOf(const Feature& seen, double value, double error) {
  const bool noNumber = std::isnan(seen.value);
  if (noNumber || std::isnan(value))
    return noNumber && std::isnan(value) ? 0.0 : std::numeric_limits<double>::infinity();
  const double scale = std::sqrt(seen.error * seen.error + error * error + seen.slack * seen.slack);
  return std::abs(seen.value - value) / scale;
}

bool isLeftOut(const KnownSignature& known, const std::vector<std::string>& leftOut) {
  return std::find(leftOut.begin(), leftOut.end(), known.mistake) != leftOut.end();
}

// What a feature is, or was.
std::string inWords(const Feature& feature, double value) {
  if (std::isnan(value)) return "no number";
  if (feature.isAnswer) return value == 0.0 ? "no" : "yes";
  return fmt::format("{:.4g}", value);
}

// "mean of cos(theta) is 0.6366", "whether a black path ever survives: yes"
std::string asSeen(const Feature& feature) {
  return fmt::format("{}{} {}", feature.what, feature.isAnswer ? ":" : " is",
                     inWords(feature, feature.value));
}

// Up to two features that tell most, and how many there are.
std::string evidenceFor(const Signature& seen, const KnownSignature& mistake,
                        const KnownSignature& right) {
  constexpr std::size_t kMost = 2;
  const std::vector<Feature>& features = seen.features();
  std::vector<std::size_t> telling;
  for (std::size_t k = 0; k < features.size(); ++k)
    if (distanceOf(features[k], right.values[k], right.errors[k]) >= kExcluded)
      telling.push_back(k);
  const std::size_t wrong = telling.size();
  const auto size = [&](std::size_t k) {
    const double off = std::abs(features[k].value - right.values[k]);
    return std::isnan(off) ? std::numeric_limits<double>::infinity()
                           : off / (std::abs(right.values[k]) + 20.0 * features[k].error + 1e-3);
  };
  // Plain features come first, and teach more.
  std::stable_sort(telling.begin(), telling.end(), [&](std::size_t a, std::size_t b) {
    return std::min(size(a), 0.05) > std::min(size(b), 0.05);
  });
  telling.resize(std::min(wrong, kMost));
  std::string text;
  for (const std::size_t k : telling)
    text +=
        fmt::format("{} (right: {}; with this mistake: {}). ", asSeen(features[k]),
                    inWords(features[k], right.values[k]), inWords(features[k], mistake.values[k]));
  return text + fmt::format(
                    "Of {} things that were measured {} not right, and all of them agree with "
                    "this mistake.",
                    features.size(), wrong == 1 ? "1 is" : fmt::format("{} are", wrong));
}

std::string sentences(const std::vector<const KnownSignature*>& mistakes) {
  if (mistakes.size() == 1) return mistakes.front()->what;
  return fmt::format("either {}, or {}", mistakes[0]->what, mistakes[1]->what);
}

}  // namespace

double distance(const Signature& seen, const KnownSignature& known) {
  const std::vector<Feature>& features = seen.features();
  double largest = 0.0;
  for (std::size_t k = 0; k < features.size(); ++k)
    largest = std::max(largest, distanceOf(features[k], known.values[k], known.errors[k]));
  return largest;
}

bool looksLike(const KnownSignature& a, const KnownSignature& b) {
  Signature seen;
  for (std::size_t k = 0; k < a.values.size(); ++k) seen.add("", a.values[k], a.errors[k]);
  return distance(seen, b) < kExcluded;
}

std::string farthest(const Signature& seen, const KnownSignature& known) {
  const std::vector<Feature>& features = seen.features();
  std::string text;
  double largest = 0.0;
  for (std::size_t k = 0; k < features.size(); ++k) {
    const double d = distanceOf(features[k], known.values[k], known.errors[k]);
    if (!(d > largest)) continue;
    largest = d;
    text = fmt::format("{}, not {}, {:.1f} standard errors off", asSeen(features[k]),
                       inWords(features[k], known.values[k]), d);
  }
  return text;
}

Match match(const Signature& seen, const FunctionCatalogue& known,
            const std::vector<std::string>& leftOut) {
  Match result;
  if (known.features != hashOf(seen)) return result;
  result.distanceFromRight = distance(seen, known.right);
  if (!(result.distanceFromRight >= kExcluded)) return result;
  std::vector<std::pair<double, const KnownSignature*>> agreeing;
  double nextBest = std::numeric_limits<double>::infinity();
  for (const KnownSignature& mistake : known.mistakes) {
    if (isLeftOut(mistake, leftOut)) continue;
    const double d = distance(seen, mistake);
    if (d <= kAgrees)
      agreeing.emplace_back(d, &mistake);
    else
      nextBest = std::min(nextBest, d);
  }
  if (agreeing.empty() && known.stub && distance(seen, *known.stub) <= kAgrees) {
    result.mistakes = {&*known.stub};
    result.distance = distance(seen, *known.stub);
    return result;
  }
  if (agreeing.empty() || agreeing.size() > kMostAlike || nextBest < kExcluded) return result;
  std::stable_sort(agreeing.begin(), agreeing.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  result.distance = agreeing.front().first;
  for (const auto& [d, mistake] : agreeing) result.mistakes.push_back(mistake);
  return result;
}

Diagnosis diagnose(const Signature& seen, const FunctionCatalogue& known) {
  const Match found = match(seen, known);
  if (found.mistakes.empty()) return {};
  const FunctionContract& function = contractOf(known.function);
  const PartContract& part = partNumbered(function.part);
  return {found.mistakes.front()->mistake, sentences(found.mistakes),
          evidenceFor(seen, *found.mistakes.front(), known.right),
          fmt::format("{}, {} {}", handoutOf(part), function.section, function.name)};
}

}  // namespace pathmark::diagnosis
