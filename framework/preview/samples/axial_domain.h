// Directions whose density depends on the angle to an axis only: the sphere, the hemisphere, the
// cosine lobe.
#pragma once

#include "preview/samples/direction_frame.h"
#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makeSphereDomain();
std::unique_ptr<SampleDomain> makeHemisphereDomain(const SampleSettings& settings);
std::unique_ptr<SampleDomain> makeCosineDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
