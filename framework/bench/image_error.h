// How far an image is from its scene's reference.
//
//   Deviation      of one image
//   deviationOf    measures it
//   Mean           a mean of several measurements, with its standard error
#pragma once

#include "film/image.h"

#include <span>

namespace pathmark::bench {

struct Deviation {
  // The mean over pixels and channels of ((image - reference)^2 - variance) / (reference^2 + 0.01),
  // where the variance is the reference's own: what it is itself off by does not count.
  double relativeMse = 0.0;
  double mean = 0.0;  // of the image, relative to the reference's mean: 0.01 is 1 % too bright
};

// The reference must have variances, and both the same size.
Deviation deviationOf(const Image& image, const Image& reference);

struct Mean {
  double value = 0.0;
  double error = 0.0;  // standard error; 0 of a single measurement
};

Mean meanOf(std::span<const double> values);

// Of 1 / (a b), whose errors are independent.
Mean inverseOfProduct(const Mean& a, const Mean& b);

}  // namespace pathmark::bench
