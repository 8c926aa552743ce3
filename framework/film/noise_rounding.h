// roundedToNoise: an image in which no bit is spent on noise.
#pragma once

#include "film/image.h"

namespace pathmark {

// Where the variance is known, values are rounded to multiples of a power of two that is at most an
// eighth of their standard error s, and variances to 3 bits behind the leading one. Other values
// stay as they are.
//
// Nothing is lost: rounding to steps of s/8 adds a variance of at most (s/8)^2 / 12, which is
// 0.13 % of s^2, and no bias, since the noise of 8 steps or more makes all remainders equally
// likely (Widrow & Kollar, Quantization Noise, 2008, chapter 4). The 6 % of the variances are less
// than their own error sqrt(2 / (replicates - 1)) for any number of replicates below 500. What is
// gained are trailing zeros, which compression folds away.
Image roundedToNoise(const Image& image);

}  // namespace pathmark
