// ErrorBudget: how the chance to fail a correct submission is shared among its statistics.
#pragma once

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace pathmark::stats {

// Probability that any check fails a submission that is correct throughout.
inline constexpr double kSubmissionAlpha = 1e-6;

// More statistics than the checks of all parts take together.
inline constexpr std::int64_t kMostStatistics = 10'000;

// Every statistic gets the same share (Bonferroni), whatever the others depend on and in whatever
// order they are taken. Threads may take from one budget.
class ErrorBudget {
 public:
  explicit ErrorBudget(double alpha = kSubmissionAlpha, std::int64_t most = kMostStatistics)
      : alpha_(alpha), most_(most) {}

  double alphaPerStatistic() const { return alpha_ / static_cast<double>(most_); }

  // The false-fail rate for a group of statistics that are judged together. Throws, and takes
  // nothing, where fewer are left: a check that takes more than was declared is a mistake in the
  // grader.
  double take(std::int64_t statistics = 1) {
    std::int64_t taken = taken_.load();
    do {
      if (statistics < 1 || statistics > most_ - taken)
        throw std::logic_error("a check asks for " + std::to_string(statistics) +
                               " statistics, but " + std::to_string(most_ - taken) + " of " +
                               std::to_string(most_) + " are left in the error budget");
    } while (!taken_.compare_exchange_weak(taken, taken + statistics));
    return alphaPerStatistic() * static_cast<double>(statistics);
  }

  std::int64_t taken() const { return taken_.load(); }

 private:
  double alpha_;
  std::int64_t most_;
  std::atomic<std::int64_t> taken_ = 0;
};

}  // namespace pathmark::stats
