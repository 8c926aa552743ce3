// Histograms beside the expected density, drawn.
#pragma once

#include "preview/samples/sample_histogram.h"

namespace pathmark::preview {

// All of them, in one column or two, as the width allows. `samples` is their number; `scale` that
// of the interface.
void drawHistograms(const std::vector<Histogram>& histograms, std::size_t samples, float scale);

}  // namespace pathmark::preview
