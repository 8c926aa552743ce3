// A picture whose noise is known well enough to tell noise from error.
#pragma once

#include "preview/picture.h"

#include <memory>

namespace pathmark::preview {

// How many rays each of at least two replicates must have for each pixel. With few, hardly any of
// them meets what is seen rarely, such as a caustic, and a picture is called different from its
// equal. Measured with the solutions, diy_caustic at 48x48 pixels and a declared rate of 0.1, the
// rates among 50 pairs: with four replicates 0.24 of 8 rays each, 0.06 of 16 and 0.02 of 32; with
// two of 32 rays 0.08.
constexpr double kRaysOfReplicate = 32.0;

// The picture's image; null if it is too early, that is if there are fewer replicates or rays than
// these, or pixels have no variance yet. Where values that are no radiance have left a pixel
// without a variance, it is marked as invalid.
std::shared_ptr<const Image> imageWithKnownNoise(const std::shared_ptr<const Picture>& picture);

}  // namespace pathmark::preview
