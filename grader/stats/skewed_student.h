// Student's t where the samples are skew.
//
//   widening      the critical value over that without skewness
//   straightened  the t without skewness that is as rare as a given one
//
// Skewness G of n samples makes the tail of t heavy on the side opposite to it: it is that of the
// normal distribution times exp(t^3 G / (3 sqrt(n))) (Jing, Shao & Wang, "Self-normalized
// Cramer-type large deviations for independent random variables", Annals of Probability 31(4),
// 2003; to first order in G this is the Cornish-Fisher term (2 t^2 + 1) G / (6 sqrt(n)) of Hall,
// The Bootstrap and Edgeworth Expansion, 1992, section 2.6). The critical value x is therefore
// taken from x^2 / 2 - x^3 G / (3 sqrt(n)) = t^2 / 2, with t that of Student's distribution.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pathmark::stats {

// Of a = t G / sqrt(n): the equation has no solution beyond, nor does the tail fall any further.
inline constexpr double kEndOfWidening = 1.0 / std::numbers::sqrt3;

// y = x / t solves y^2 - 2/3 a y^3 = 1, so that w = 1 / y is the largest root of
// w^3 - w + 2/3 a = 0. Beyond kEndOfWidening: its value there, sqrt(3).
inline double widening(double a) {
  constexpr double kRoot3 = std::numbers::sqrt3;
  return kRoot3 / (2.0 * std::cos(std::acos(std::max(-kRoot3 * a, -1.0)) / 3.0));
}

// g = G / sqrt(n), not negative.
inline double straightened(double t, double g) {
  const double capped = g > 0.0 ? std::min(t, 1.0 / g) : t;
  return capped * std::sqrt(1.0 - 2.0 / 3.0 * capped * g);
}

}  // namespace pathmark::stats
