// ErrorBudget: how many statistics may be judged, so that a whole submission of a correct student
// fails with a probability below kSubmissionAlpha.
#pragma once

#include <atomic>
#include <stdexcept>

namespace pathmark::stats {

inline constexpr double kSubmissionAlpha = 1e-6;
inline constexpr int kMostStatistics = 10000;

// Of one statistic, over all its looks.
inline constexpr double kStatisticAlpha = kSubmissionAlpha / kMostStatistics;

class ErrorBudget {
 public:
  // Takes alpha for this many statistics. Throws std::logic_error where there is none left.
  void take(int statistics = 1) {
    if ((taken_ += statistics) > kMostStatistics)
      throw std::logic_error("more statistics than the false-fail rate is shared among");
  }
  int taken() const { return taken_; }

 private:
  std::atomic<int> taken_{0};
};

}  // namespace pathmark::stats
