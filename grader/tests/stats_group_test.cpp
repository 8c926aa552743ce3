// Statistics that are judged together, and the error budget that they share.
#include "stats/error_budget.h"
#include "stats/replicate_group.h"
#include "tests/support/uniforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

namespace pathmark::stats {
namespace {

using testing::Uniforms;

// Points that depend on each other: a shifted lattice, of this density's quantile.
template <typename Add>
void addLattice(Uniforms& random, int points, Add&& add) {
  const double shift = random.nextDouble();
  for (int i = 0; i < points; ++i) add((i + shift) / points);
}

constexpr std::array<double, 4> kQuarters{0.25, 0.25, 0.25, 0.25};

TEST(ReplicateMoments, PutTheWorstFirst) {
  Uniforms random(1);
  const Guarantee guarantee{.delta = 0.1};
  ReplicateMoments moments({{"E[x]", 0.5, 0.0, guarantee},
                            {"E[x^2]", 0.5, 0.0, guarantee},
                            {"E[x^3]", 0.25, 0.0, {.delta = 1e-6}}},
                           1e-10);
  for (int i = 0; i < 256; ++i) {
    double m1 = 0.0, m2 = 0.0, m3 = 0.0;
    for (int k = 0; k < 64; ++k) {
      const double x = random.nextDouble();
      m1 += x / 64, m2 += x * x / 64, m3 += x * x * x / 64;
    }
    moments.add(std::array{m1, m2, m3});
  }
  const std::vector<RankedJudgement> ranked = moments.judge(0);
  ASSERT_EQ(ranked.size(), 3u);
  EXPECT_EQ(moments.statistic(ranked[0].index).name, "E[x^2]");
  EXPECT_EQ(ranked[0].judgement.outcome, Outcome::kFail);
  EXPECT_EQ(ranked[1].index, 2u);
  EXPECT_EQ(ranked[1].judgement.outcome, Outcome::kUndecided);
  EXPECT_EQ(ranked[2].judgement.outcome, Outcome::kPass);
}

TEST(ReplicateMoments, FailTogetherAtMostAtTheDeclaredRate) {
  Uniforms random(2);
  constexpr double kAlpha = 0.02;
  constexpr int kRuns = 2000;
  int fails = 0;
  for (int run = 0; run < kRuns; ++run) {
    ReplicateMoments moments({{"x", 0.0, 0.0, {.looks = 1}}, {"y", 0.0, 0.0, {.looks = 1}}},
                             kAlpha);
    for (int i = 0; i < 256; ++i) moments.add(std::array{random.nextNormal(), random.nextNormal()});
    fails += moments.judge(0)[0].judgement.outcome == Outcome::kFail ? 1 : 0;
  }
  const double rate = static_cast<double>(fails) / kRuns;
  EXPECT_LE(rate, kAlpha + 5.0 * std::sqrt(kAlpha / kRuns));
  EXPECT_GT(fails, 0);
}

TEST(ReplicateCells, PassPointsThatDependOnEachOtherAndFindATilt) {
  Uniforms random(3);
  const Guarantee guarantee{.delta = 0.01};
  ReplicateCells right(kQuarters, 250, guarantee), tilted(kQuarters, 250, guarantee);
  for (int i = 0; i < 256; ++i) {
    addLattice(random, 250, [&](double u) {
      right.add(static_cast<std::size_t>(4.0 * u));
      tilted.add(static_cast<std::size_t>(4.0 * (u + 0.04 * u * (1.0 - u))));
    });
    right.endReplicate();
    tilted.endReplicate();
  }
  EXPECT_EQ(right.judge(1).judgement.outcome, Outcome::kPass);
  EXPECT_EQ(tilted.judge(1).judgement.outcome, Outcome::kFail);
}

TEST(ReplicateCells, PassAnotherDensityWithItsWeights) {
  Uniforms random(4);
  ReplicateCells cells(kQuarters, 256, {.delta = 0.02});
  for (int i = 0; i < 512; ++i) {
    for (int k = 0; k < 256; ++k) {
      const double u = random.nextDouble(), v = random.nextDouble();
      const double x = random.nextDouble() < 0.5 ? u : std::max(u, v);  // density 1/2 + x
      cells.add(static_cast<std::size_t>(4.0 * x), 1.0 / (0.5 + x));
    }
    cells.endReplicate();
  }
  EXPECT_EQ(cells.judge(2).judgement.outcome, Outcome::kPass);
}

TEST(ReplicateCells, PoolCellsOfSmallProbability) {
  const std::vector<double> probabilities{0.01, 0.5, 0.0, 0.02, 0.02, 0.45};
  const ReplicateCells cells(probabilities, 200, {});
  const CellPools& pools = cells.pools();
  ASSERT_EQ(pools.probabilities.size(), 3u);
  EXPECT_NEAR(pools.probabilities[0], 0.05, 1e-15);
  EXPECT_EQ(pools.poolOf[0], pools.poolOf[4]);
  EXPECT_EQ(pools.poolOf[2], CellPools::kNone);
}

TEST(ReplicateCells, FailMassWhereThereIsNone) {
  ReplicateCells cells(std::vector<double>{0.5, 0.5, 0.0}, 100, {});
  cells.addNone();
  cells.add(2, 0.0);
  EXPECT_EQ(cells.judge(0).judgement.outcome, Outcome::kUndecided) << "no weight, no mass";
  cells.add(2);
  EXPECT_EQ(cells.judge(0).judgement.outcome, Outcome::kFail);
}

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
