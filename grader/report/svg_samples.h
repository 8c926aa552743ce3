// Samples as points: directions on a disc, places in a square.
//
// Directions are shown by Lambert's azimuthal equal-area projection along the normal (Snyder, Map
// Projections, 1987, section 24): equal solid angles have equal areas, so that uniform directions
// look uniform, whatever else they are.
#pragma once

#include "record/record.h"
#include "report/html_text.h"

namespace pathmark::report {

// A figure with a caption. Samples outside of the domain are crosses, and counted; those that are
// not finite are only counted.
Markup samplePlot(const record::SampleRecord& samples);

}  // namespace pathmark::report
