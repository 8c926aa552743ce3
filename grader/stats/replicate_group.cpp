#include "stats/replicate_group.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace pathmark::stats {

ReplicateMoments::ReplicateMoments(std::vector<Statistic> statistics, double alpha)
    : statistics_(std::move(statistics)) {
  for (Statistic& statistic : statistics_) {
    statistic.guarantee.alpha = alpha / static_cast<double>(statistics_.size());
    tests_.emplace_back(statistic.expected, statistic.expectedStandardError, statistic.guarantee);
  }
}

void ReplicateMoments::add(std::span<const double> replicate) {
  assert(replicate.size() == tests_.size());
  for (std::size_t i = 0; i < tests_.size(); ++i) tests_[i].add(replicate[i]);
}

std::vector<RankedJudgement> ReplicateMoments::judge(int look) const {
  std::vector<RankedJudgement> ranked;
  for (std::size_t i = 0; i < tests_.size(); ++i) ranked.push_back({i, tests_[i].judge(look)});
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedJudgement& a, const RankedJudgement& b) {
                     return worse(a.judgement, b.judgement);
                   });
  return ranked;
}

ReplicateCells::ReplicateCells(std::span<const double> probabilities,
                               std::int64_t pointsPerReplicate, const Guarantee& guarantee)
    : pools_(probabilities, kMinExpected / static_cast<double>(pointsPerReplicate)),
      sums_(pools_.probabilities.size(), 0.0) {
  Guarantee share = guarantee;
  share.alpha /= static_cast<double>(sums_.size());
  for (const double probability : pools_.probabilities)
    tests_.emplace_back(probability, 0.0, share);
}

void ReplicateCells::add(std::size_t cell, double weight) {
  ++points_;
  const std::size_t pool = pools_.poolOf[cell];
  if (pool == CellPools::kNone)
    massOutside_ = massOutside_ || weight != 0.0;
  else
    sums_[pool] += weight;
}

void ReplicateCells::endReplicate() {
  for (std::size_t pool = 0; pool < sums_.size(); ++pool) {
    tests_[pool].add(sums_[pool] / static_cast<double>(points_));
    sums_[pool] = 0.0;
  }
  points_ = 0;
}

RankedJudgement ReplicateCells::judge(int look) const {
  if (massOutside_ || tests_.empty()) {
    return {CellPools::kNone,
            {.outcome = Outcome::kFail,
             .statistic = std::numeric_limits<double>::infinity(),
             .pValue = 0.0,
             .look = look}};
  }
  RankedJudgement worst{0, tests_[0].judge(look)};
  for (std::size_t pool = 1; pool < tests_.size(); ++pool) {
    const Judgement judgement = tests_[pool].judge(look);
    if (worse(judgement, worst.judgement)) worst = {pool, judgement};
  }
  return worst;
}

}  // namespace pathmark::stats
