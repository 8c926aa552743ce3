// Verdict: what a statistical test says.
#pragma once

namespace pathmark::stats {

// A test fails where its statistic exceeds the critical value. The false-fail rate alpha is the
// probability that this happens although the hypothesis is true.
struct Verdict {
  bool pass = false;
  double statistic = 0.0;
  double critical = 0.0;
  double pValue = 0.0;   // probability of a statistic at least this large under the hypothesis
  double degrees = 0.0;  // degrees of freedom, 0 where the statistic was not needed

  explicit operator bool() const { return pass; }
};

}  // namespace pathmark::stats
