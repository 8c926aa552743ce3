// Points on a sphere light, as seen from a receiver at the origin.
#pragma once

#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makeSphereLightDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
