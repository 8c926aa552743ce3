// A picture whose noise is known well enough to tell noise from error.
#pragma once

#include "preview/picture.h"

#include <memory>

namespace pathmark::preview {

// Measured, of series of comparisons with noise of skewness 2 and 4: with 4 replicates and more
// equal images are called different at most as often as declared; with 2, half as often again.
constexpr std::uint32_t kFewestReplicates = 4;

// Two are enough when each has this many rays for each pixel: the skewness of a mean falls as one
// over the root of its rays.
constexpr double kRaysOfFewReplicates = 32.0;

// The picture's image; null if it is too early, that is if there are fewer replicates than these,
// or pixels have no variance yet. Where values that are no radiance have left a pixel without
// a variance, it is marked as invalid.
std::shared_ptr<const Image> imageWithKnownNoise(const std::shared_ptr<const Picture>& picture);

}  // namespace pathmark::preview
