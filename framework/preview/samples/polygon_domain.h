// Points on the triangle, the parallelogram and the concave polygon of the sample view.
#pragma once

#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makePolygonDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
