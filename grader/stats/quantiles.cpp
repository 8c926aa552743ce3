#include "stats/quantiles.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace pathmark::stats {

namespace {

// By complement, so that a tail of 1e-10 is not 1 minus a rounded number.
template <typename Distribution>
double upperQuantile(const Distribution& distribution, double tail) {
  return boost::math::quantile(boost::math::complement(distribution, tail));
}

template <typename Distribution>
double upperTail(const Distribution& distribution, double x) {
  return boost::math::cdf(boost::math::complement(distribution, x));
}

}  // namespace

double studentCritical(double alpha, double degrees) {
  return upperQuantile(boost::math::students_t(degrees), 0.5 * alpha);
}

double studentTail(double t, double degrees) {
  if (!std::isfinite(t)) return 0.0;
  return 2.0 * upperTail(boost::math::students_t(degrees), std::abs(t));
}

double chiSquareCritical(double alpha, double degrees) {
  return upperQuantile(boost::math::chi_squared(degrees), alpha);
}

double chiSquareTail(double x, double degrees) {
  if (!std::isfinite(x)) return 0.0;
  return upperTail(boost::math::chi_squared(degrees), std::max(x, 0.0));
}

double sampleQuantile(std::span<const double> ascending, double q) {
  assert(!ascending.empty() && q >= 0.0 && q <= 1.0);
  const double position = q * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  const double fraction = position - static_cast<double>(below);
  return ascending[below] + fraction * (ascending[above] - ascending[below]);
}

}  // namespace pathmark::stats
