// The choices of the sample view, as widgets.
//
//   chooseFunction    which sampler
//   choosePoints      which points, how many, which seed
//   chooseParameters  the sliders of the sampler
#pragma once

#include "preview/samples/sample_settings.h"

namespace pathmark::preview {

// Those of the part first.
void chooseFunction(SampleSettings& settings, int part);

void choosePoints(SampleSettings& settings, float scale);
void chooseParameters(SampleSettings& settings, float scale);

}  // namespace pathmark::preview
