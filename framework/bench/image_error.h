// How far an image is from its scene's reference.
//
//   Deviation      of one image
//   deviationOf    measures it
//   OwnDeviation   how far the reference itself is from what it stands for
//   ownDeviation   measures it, by the reference's variances
//   Mean           a mean of several measurements, with its standard error
#pragma once

#include "film/image.h"

#include <cstdint>
#include <span>

namespace pathmark::bench {

struct Deviation {
  // The mean over pixels and channels of (image - reference)^2 - variance.
  double mse = 0.0;
  // The mean over pixels and channels of ((image - reference)^2 - variance) / (reference^2 + 0.01),
  // where the variance is the reference's own: what it is itself off by does not count.
  double relativeMse = 0.0;
  double mean = 0.0;  // of the image, relative to the reference's mean: 0.01 is 1 % too bright
  // Outliers (fireflies): the share of the sum of (image - reference)^2 / (reference^2 + 0.01) that
  // the worst thousandth of the pixels, at least one, has. Noise that is alike everywhere gives a
  // few thousandths, one wild pixel nearly 1.
  double worstShare = 0.0;
};

// Both of the same size. A reference without variances counts as exact.
Deviation deviationOf(const Image& image, const Image& reference);

struct OwnDeviation {
  double relativeMse = 0.0;       // the mean of variance / (reference^2 + 0.01)
  double relativeMseError = 0.0;  // standard error of what is subtracted for it
};

// `replicates`: with which the variances were estimated.
OwnDeviation ownDeviation(const Image& reference, std::uint32_t replicates);

struct Mean {
  double value = 0.0;
  double error = 0.0;  // standard error; 0 of a single measurement
};

Mean meanOf(std::span<const double> values);

// Of 1 / (a b), whose errors are independent.
Mean inverseOfProduct(const Mean& a, const Mean& b);

// Of a / b, likewise.
Mean ratioOf(const Mean& a, const Mean& b);

}  // namespace pathmark::bench
