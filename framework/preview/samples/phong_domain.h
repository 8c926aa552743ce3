// Directions of the modified Phong model: the mixture of the diffuse and the specular lobe.
#pragma once

#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makePhongDomain(const SampleSettings& settings);

}  // namespace pathmark::preview
