// The points that a sampling function is fed with.
#pragma once

#include "preview/samples/sample_settings.h"

#include <vector>

namespace pathmark::preview {

struct CallNumbers {
  float s = 0.0f, t = 0.0f, u = 0.0f;  // in [0,1)
};

// As many as the settings say: what a pixel's rays would get. For a camera ray, whose strata are a
// point set already, a pass of one point in each stratum after another, so that the number is a
// multiple of the number of strata.
std::vector<CallNumbers> makeCallNumbers(const SampleSettings& settings);

}  // namespace pathmark::preview
