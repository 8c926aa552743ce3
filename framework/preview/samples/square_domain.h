// The unit square of get_random_numbers, and the pixel of StratifiedRandomRay.
#pragma once

#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makeUnitSquareDomain();
std::unique_ptr<SampleDomain> makePixelDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
