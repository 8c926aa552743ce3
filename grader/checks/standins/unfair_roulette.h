// The roulette's stand-in: a path survives with q = 0.3, which ends so many of them that a weight
// that is lost or counted twice shows at once, and its weight is 1/q.
//
// Where the throughput is black in the last channel it is not fair: the weight is a multiple of 1/q
// that depends on the depth. So the mean shows whether it has been asked, with which depth and
// which throughput, and whether its answer was taken.
//
// Where the throughput is black in the first or second channel every path survives: there the mean
// has so little noise that an error of 1 % in the throughput shows.
#pragma once

namespace pathmark::unfair {

inline constexpr float kSurvival = 0.3f;

inline double factor(int depth) { return 1.0 + 1.0 / (1.0 + depth); }

}  // namespace pathmark::unfair
