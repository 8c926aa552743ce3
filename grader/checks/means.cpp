#include "checks/means.h"

#include "stats/replicate_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pathmark::checks {

namespace {

stats::Guarantee guaranteeOf(const Mean& mean, double alpha, int looks) {
  stats::Guarantee guarantee;
  guarantee.alpha = alpha;
  guarantee.tolerance = mean.tolerance * mean.scale;
  guarantee.delta = mean.delta * mean.scale;
  guarantee.looks = looks;
  // Quasi-random points may leave a cell's share without any noise in most replicates, and with a
  // little in some: far too skew for any test, and far too small to matter. With the floor, the
  // smallest error that is found at the first look is still below delta / 2.
  guarantee.deviationFloor = 0.5 * mean.delta * mean.scale;
  guarantee.skewness = mean.skewness;
  return guarantee;
}

// Matches all means by what is measured, and is not as good as right. The floors that the judgement
// puts under a deviation would let it match too much.
bool explains(const Suspicion& suspicion, const std::vector<Mean>& means,
              const std::vector<stats::ReplicateTest>& tests) {
  constexpr double kSigmas = 5.0;
  bool differs = false;
  for (std::size_t k = 0; k < means.size(); ++k) {
    const stats::RunningMoments& measured = tests[k].replicates();
    const double slack = kSigmas * std::hypot(measured.standardError(), means[k].expectedError) +
                         means[k].tolerance * means[k].scale;
    if (!(std::abs(measured.mean() - suspicion.means[k]) <= slack)) return false;
    if (std::abs(means[k].expected - suspicion.means[k]) > 2.0 * slack) differs = true;
  }
  return differs;
}

// What a sum leaves of terms that cancel is meant as 0.
double withoutRounding(const Mean& mean) {
  return std::abs(mean.expected) < 1e-12 * mean.scale ? 0.0 : mean.expected;
}

Finding describe(const Mean& mean, const stats::Judgement& j, const std::string& where) {
  Finding finding;
  finding.where = where;
  finding.expected = fmt::format("{} = {:.6g}", mean.what, withoutRounding(mean));
  finding.got = fmt::format("{} = {:.6g}", mean.what, j.mean);
  finding.tolerance = fmt::format("{:.2g} and {:.1f} standard errors of {:.2g}",
                                  mean.tolerance * mean.scale, j.critical, j.standardError);
  finding.shown = j.shown / mean.scale;
  return finding;
}

// Of the means that fail, from what they must be, in their deltas.
double farthest(const std::vector<Mean>& means, const std::vector<stats::Judgement>& judgements) {
  double largest = 0.0;
  for (std::size_t k = 0; k < means.size(); ++k) {
    if (judgements[k].outcome != stats::Outcome::kFail) continue;
    const double off = std::abs(judgements[k].mean - means[k].expected);
    largest = std::max(largest, off / (means[k].delta * means[k].scale));
  }
  return largest;
}

}  // namespace

Finding judgeMeans(CheckRun& run, const std::vector<Mean>& means, const Measure& measure,
                   const std::string& where, const std::vector<Suspicion>& suspicions, int looks) {
  std::vector<stats::ReplicateTest> tests;
  for (const Mean& mean : means) {
    const double alpha = run.budget.take();
    tests.emplace_back(mean.expected, mean.expectedError, guaranteeOf(mean, alpha, looks));
  }
  std::vector<stats::Judgement> judgements(means.size());
  std::size_t worst = 0;
  std::uint32_t made = 0;
  for (int look = 0; look < looks; ++look) {
    const std::uint32_t wanted = kReplicatesOfLook[look];
    std::vector<double> values(std::size_t{wanted - made} * means.size());
    measure(made, wanted - made, values);
    for (std::size_t r = 0; r * means.size() < values.size(); ++r)
      for (std::size_t k = 0; k < means.size(); ++k) tests[k].add(values[r * means.size() + k]);
    made = wanted;
    worst = 0;
    for (std::size_t k = 0; k < means.size(); ++k) {
      judgements[k] = tests[k].judge(look);
      if (stats::worse(judgements[k], judgements[worst])) worst = k;
    }
    if (judgements[worst].outcome != stats::Outcome::kUndecided) break;
  }
  // Means come from plain ones to rare ones: of those that fail the first teaches most.
  for (std::size_t k = means.size(); k-- > 0;)
    if (judgements[k].outcome == stats::Outcome::kFail) worst = k;
  Finding finding = describe(means[worst], judgements[worst], where);
  switch (judgements[worst].outcome) {
    case stats::Outcome::kPass:
      finding.status = Status::kPass;
      break;
    case stats::Outcome::kUndecided:
      finding.status = Status::kUndecided;
      break;
    case stats::Outcome::kFail:
      finding.status = Status::kFail;
      finding.distance = farthest(means, judgements);
      for (const Suspicion& suspicion : suspicions)
        if (finding.cause.empty() && explains(suspicion, means, tests))
          finding.cause = suspicion.mistake;
      break;
  }
  return finding;
}

}  // namespace pathmark::checks
