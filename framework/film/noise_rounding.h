// roundedToNoise: an image in which no bit is spent on noise.
#pragma once

#include "film/image.h"

namespace pathmark {

// Where the variance is known, values are rounded to multiples of a power of two that is at most a
// sixteenth of their standard error s, and variances to 4 bits behind the leading one. Other values
// stay as they are.
//
// Nothing is lost: rounding to steps of s/16 adds a variance of at most (s/16)^2 / 12, which is
// 0.03 % of s^2, and no bias, since the noise of 16 steps or more makes all remainders equally
// likely (Widrow & Kollar, Quantization Noise, 2008, chapter 4). The 3 % of the variances are less
// than their own error sqrt(2 / (replicates - 1)) for any number of replicates below 2000. What is
// gained are trailing zeros, which ZIP folds away.
Image roundedToNoise(const Image& image);

}  // namespace pathmark
