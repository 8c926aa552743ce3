// Traps of floating point: each test holds the naive form of a computation, in float as one would
// write it first, and the shipped form against the same oracle, on inputs where the naive form goes
// wrong.
//
//   random_numbers        integers that become numbers in [0,1)
//   sphere_light          small, far, at its limb, from its surface and from inside
//   intersection          spheres far or large; contraction; edges that triangles share
//   offset                rays that leave a surface, shadow rays
//   frame_and_sampling    frames, points on triangles, grazing directions
//   phong                 large exponents, the exponent 0, the back of the lobe
//   path                  throughputs and the roulette
//   accumulation          sums of many samples, order of threads, denormal numbers
//   far_from_origin       triangles and area lights
//   framework/tests/scene/traps_test.cpp   geometry that never reaches a worker
//
// Here is what they share:
//
//   Worst, Rms   errors of many inputs in one number
//   Errors       of both forms
//   expectTrap   the shipped form keeps a bound that the naive form breaks
//
// The figures are in the test program's record (--gtest_output=xml).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace pathmark::testing {

// The largest error; one that is no number counts as infinite.
class Worst {
 public:
  void add(double error) {
    if (!(error <= worst_))
      worst_ = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  double value() const { return worst_; }

 private:
  double worst_ = 0.0;
};

class Rms {
 public:
  void add(double error) {
    squares_ += std::isnan(error) ? std::numeric_limits<double>::infinity() : error * error;
    ++count_;
  }
  double value() const { return std::sqrt(squares_ / count_); }

 private:
  double squares_ = 0.0, count_ = 0.0;
};

template <typename Measure>
struct Errors {
  Measure naive, shipped;

  void add(double naiveError, double shippedError) {
    naive.add(naiveError);
    shipped.add(shippedError);
  }
};

inline double relativeError(double actual, long double expected) {
  return static_cast<double>(std::abs((actual - expected) / expected));
}

inline void expectTrap(const std::string& what, double naive, double shipped, double bound) {
  std::ostringstream figures;
  figures << "naive " << naive << ", shipped " << shipped << ", bound " << bound;
  ::testing::Test::RecordProperty(what, figures.str());
  EXPECT_LE(shipped, bound) << what << ": the shipped form is not stable";
  EXPECT_GT(naive, bound) << what << ": these inputs do not bite";
}

template <typename Measure>
void expectTrap(const std::string& what, const Errors<Measure>& errors, double bound) {
  expectTrap(what, errors.naive.value(), errors.shipped.value(), bound);
}

}  // namespace pathmark::testing
