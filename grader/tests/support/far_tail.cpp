#include "tests/support/far_tail.h"

#include "stats/replicate_test.h"
#include "tests/support/uniforms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pathmark::testing {

namespace {

using stats::Guarantee;
using stats::Judgement;
using stats::Outcome;
using stats::ReplicateTest;

// Knuth's way, for rates below some ten.
int nextPoisson(Uniforms& random, double rate) {
  int count = 0;
  for (double product = random.nextDouble(), end = std::exp(-rate); product > end;
       product *= random.nextDouble())
    ++count;
  return count;
}

// The distribution that is drawn from instead: N(mean, deviation) + brightness * Poisson(rate).
struct Proposal {
  double mean = 0.0, deviation = 1.0, rate = 0.0;
};

struct Run {
  double severity = 0.0;   // at least 1 where the test fails
  double logWeight = 0.0;  // true density over the proposal's
  double sum = 0.0, sumOfSquares = 0.0, bright = 0.0;
};

Run draw(const BrightReplicate& truth, const Proposal& from, int n, const Guarantee& guarantee,
         Uniforms& random) {
  Run run;
  ReplicateTest test(truth.mean(), 0.0, guarantee);
  for (int i = 0; i < n; ++i) {
    const double z = random.nextNormal(), normal = from.mean + from.deviation * z;
    const int bright = truth.rate > 0.0 ? nextPoisson(random, from.rate) : 0;
    run.sum += normal;
    run.sumOfSquares += normal * normal;
    run.bright += bright;
    run.logWeight += 0.5 * (z * z - normal * normal) + std::log(from.deviation);
    if (truth.rate > 0.0)
      run.logWeight += bright * std::log(truth.rate / from.rate) - truth.rate + from.rate;
    test.add(normal + truth.brightness * bright);
  }
  const Judgement judgement = test.judge(0);
  const double ratio = judgement.error < 0.0 ? judgement.statistic / judgement.critical : 0.0;
  const bool fails = judgement.error < 0.0 && judgement.outcome == Outcome::kFail;
  run.severity = fails ? std::max(ratio, 1.0) : std::min(ratio, std::nextafter(1.0, 0.0));
  return run;
}

// One step: the proposal moves towards the truth given the most severe tenth, or given a fail.
// True once fails are that frequent.
bool improve(Proposal& proposal, const BrightReplicate& truth, const std::vector<Run>& runs,
             int n) {
  std::vector<double> severities;
  for (const Run& run : runs) severities.push_back(run.severity);
  std::sort(severities.begin(), severities.end());
  const double threshold = std::min(severities[severities.size() * 9 / 10], 1.0);
  double most = -std::numeric_limits<double>::infinity();
  for (const Run& run : runs)
    if (run.severity >= threshold) most = std::max(most, run.logWeight);
  double weights = 0.0, sum = 0.0, sumOfSquares = 0.0, bright = 0.0;
  for (const Run& run : runs) {
    if (run.severity < threshold) continue;
    const double weight = std::exp(std::max(run.logWeight - most, -3.0));
    weights += weight * n;
    sum += weight * run.sum;
    sumOfSquares += weight * run.sumOfSquares;
    bright += weight * run.bright;
  }
  constexpr double kStep = 0.7;
  const double mean = sum / weights, variance = sumOfSquares / weights - mean * mean;
  proposal.mean += kStep * (mean - proposal.mean);
  proposal.deviation =
      std::sqrt((1.0 - kStep) * proposal.deviation * proposal.deviation + kStep * variance);
  proposal.rate += kStep * (std::max(bright / weights, 1e-3 * truth.rate) - proposal.rate);
  return threshold >= 1.0;
}

}  // namespace

BrightReplicate BrightReplicate::withSkewness(double skewness, double share) {
  if (skewness == 0.0) return {};
  const double brightness = skewness * std::pow(1.0 + share, 1.5) / share;
  return {brightness, share / (brightness * brightness)};
}

FarTail farTail(const BrightReplicate& replicate, int n, double alpha, double assumedSkewness,
                std::uint64_t seed) {
  const Guarantee guarantee{.alpha = alpha, .looks = 1, .skewness = assumedSkewness};
  Uniforms random(seed);
  Proposal proposal{.rate = replicate.rate};
  std::vector<Run> runs(600);
  constexpr int kMostSteps = 60, kLastSteps = 4;
  for (int step = 0, reached = 0; step < kMostSteps && reached < kLastSteps; ++step) {
    for (Run& run : runs) run = draw(replicate, proposal, n, guarantee, random);
    reached += improve(proposal, replicate, runs, n) ? 1 : 0;
  }
  stats::RunningMoments weights;
  constexpr int kRuns = 2000;
  for (int i = 0; i < kRuns; ++i) {
    const Run run = draw(replicate, proposal, n, guarantee, random);
    weights.add(run.severity >= 1.0 ? std::exp(run.logWeight) : 0.0);
  }
  return {weights.mean(), weights.standardError()};
}

}  // namespace pathmark::testing
