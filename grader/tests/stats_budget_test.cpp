// The error budget that all statistics of a submission share.
#include "stats/error_budget.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <vector>

namespace pathmark::stats {
namespace {

TEST(ErrorBudget, SharesTheAlphaOfASubmission) {
  ErrorBudget budget;
  EXPECT_DOUBLE_EQ(budget.take(), 1e-10);
  EXPECT_DOUBLE_EQ(budget.take(20), 2e-9);
  EXPECT_EQ(budget.taken(), 21);
}

TEST(ErrorBudget, RefusesMoreStatisticsThanDeclared) {
  ErrorBudget budget(1e-6, 10);
  budget.take(8);
  EXPECT_THROW(budget.take(3), std::logic_error);
  EXPECT_EQ(budget.taken(), 8) << "a refused group takes nothing";
  budget.take(2);
  EXPECT_THROW(budget.take(), std::logic_error);
  EXPECT_THROW(budget.take(0), std::logic_error);
}

TEST(ErrorBudget, CountsWhatThreadsTakeAtTheSameTime) {
  ErrorBudget budget(1e-6, 40000);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i)
      threads.emplace_back([&] {
        for (int k = 0; k < 10000; ++k) budget.take();
      });
  }
  EXPECT_EQ(budget.taken(), 40000);
}

}  // namespace
}  // namespace pathmark::stats
