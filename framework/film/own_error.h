// ownError: how far an image may be from the truth, by the variance that it stores.
#pragma once

#include "film/image.h"

namespace pathmark {

struct OwnError {
  // The standard error of the image's mean relative to that mean, of the channel where it is
  // largest.
  double ofMean = 0.0;
  // The root of the mean over pixels and channels of variance / (value^2 + 0.01), which is the
  // relative mean squared error that is to be expected.
  double ofPixels = 0.0;
};

// The image must have variances. Pixels count as independent of each other.
OwnError ownError(const Image& image);

}  // namespace pathmark
