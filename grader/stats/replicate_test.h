// Is the mean of randomised replicates what it should be? Yes, no, or not known yet.
//
//   Guarantee      what a test promises: false-fail rate, smallest error that it finds, looks
//   Judgement      what a look at the replicates says
//   ReplicateTest  takes replicates one by one and judges them in stages
//   worse          of two judgements, for statistics that are judged together
#pragma once

#include "stats/moments.h"

#include <cstdint>
#include <limits>

namespace pathmark::stats {

struct Guarantee {
  double alpha = 1e-10;    // probability that a correct mean fails, at any of the looks, two-sided
  double tolerance = 0.0;  // an error up to this is accepted: rounding, bias of a reference
  double delta = 0.0;      // an error of at least this passes with probability at most 1 - power
  double power = 0.999;
  int looks = 3;

  // The standard deviation of a replicate is taken to be at least this, so that an estimator
  // (almost) without variance does not fail on its last digit.
  double deviationFloor = 0.0;

  // The |skewness| of a correct replicate is taken to be at least this. Where the solutions' is
  // known and larger, give that one: the replicates of one submission may happen to lack just the
  // rare values that make them skew.
  double skewness = 0.5;
};

enum class Outcome { kPass, kFail, kUndecided };

struct Judgement {
  Outcome outcome = Outcome::kUndecided;
  double mean = 0.0, error = 0.0;  // error: mean - expected
  double standardError = 0.0;      // of the error
  double skewness = 0.0;           // of a replicate, as assumed in the direction of the error

  // The smallest error that this look finds with the guaranteed power.
  double shown = std::numeric_limits<double>::infinity();

  double statistic = 0.0, critical = 0.0;  // beyond the tolerance, in standard errors
  double pValue = 1.0;                     // a fail is one below alpha / looks
  std::int64_t replicates = 0;
  int look = 0;
};

// A replicate is one number: the mean over some hundred points of one independent randomisation
// (an Owen scrambling, a seed). Points within a replicate may depend on each other in any way.
//
// A look fails where |error| - tolerance exceeds the critical value; else it passes where the
// smallest error that it finds is at most delta; else it is undecided, and more replicates are
// worth their time. The numbers of replicates at the looks are chosen beforehand. alpha and
// 1 - power are shared equally among the looks (Bonferroni), so that they hold for all together.
//
// Assumption: independent replicates of one distribution, n of them, |skewness| G at most
// kMostSkewness sqrt(n) / t. The critical value is Student's, widened for the skewness against the
// error (skewed_student.h): G is that of the sample plus its standard error sqrt(6 / n), at least
// Guarantee::skewness. Where that is larger than kMostSkewness allows, nothing fails by t.
//
// Verified by importance sampling (stats_far_tail_test.cpp, and a larger run for n from 64 to
// 1024): for alpha from 1e-2 to 3e-13 the false-fail rate is at most alpha for replicates whose
// true |skewness| is at most 1.5 times Guarantee::skewness, thus 0.75 unless that is raised. The
// hardest replicates found are normal with rare bright values, whose skewness hides where just
// these are missing; for gamma replicates (means of exponential points) it holds up to 1. With
// hidden skewness of twice Guarantee::skewness the rate reaches 2 alpha, with four times it 700
// alpha. 256 independent points make 0.75 out of a skewness of 12 of one point.
class ReplicateTest {
 public:
  // With fewer, t needs more than 8 standard errors for alpha = 1e-10, and the skewness that
  // decides how far it can be trusted is not known to within 0.3: undecided.
  static constexpr std::int64_t kMinReplicates = 64;

  static constexpr double kMostSkewness = 0.55;  // of t G / sqrt(n); see kEndOfWidening

  // expectedStandardError: of the expected value, where that has been measured, with at least as
  // many replicates as are judged here.
  ReplicateTest(double expected, double expectedStandardError, const Guarantee& guarantee);

  void add(double replicate);

  // look: 0 to looks - 1. What is not finite fails at once, with any number of replicates.
  Judgement judge(int look) const;

  const RunningMoments& replicates() const { return replicates_; }

 private:
  Guarantee guarantee_;
  double expected_, expectedVariance_;
  RunningMoments replicates_;
  bool finite_ = true;
};

// A fail is worse than what is undecided, and that is worse than a pass. Of two that fail or pass
// the one further out is worse, of two undecided the one that has shown less of its delta.
bool worse(const Judgement& a, const Judgement& b);

}  // namespace pathmark::stats
