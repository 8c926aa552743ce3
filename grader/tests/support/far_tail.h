// How often does a replicate test fail a correct mean, where that is too rare to be counted?
//
//   BrightReplicate  a replicate as path tracing has them: normal, and now and then a bright value
//   FarTail          a measured probability
//   farTail          the false-fail rate, by importance sampling
#pragma once

#include <cstdint>

namespace pathmark::testing {

// N(0, 1) + brightness * Poisson(rate).
struct BrightReplicate {
  double brightness = 0.0, rate = 0.0;

  // Of this skewness, and with `share` times the normal part's variance due to the bright values.
  // A small share hides the skewness best: without the bright values that happen to be missing
  // the replicates look normal.
  static BrightReplicate withSkewness(double skewness, double share);

  double mean() const { return brightness * rate; }
};

struct FarTail {
  double rate = 0.0;
  double error = 0.0;  // its standard error
};

// P(n such replicates fail against their own mean at the one look of a test with this alpha). Only
// errors below the mean count: skewness to the right makes those the frequent ones. The proposal
// is found by the cross-entropy method (Rubinstein & Kroese, The Cross-Entropy Method, 2004).
FarTail farTail(const BrightReplicate& replicate, int n, double alpha, double assumedSkewness,
                std::uint64_t seed);

}  // namespace pathmark::testing
