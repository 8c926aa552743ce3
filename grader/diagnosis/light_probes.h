// The probes of part 2.
#pragma once

#include "diagnosis/probes.h"

namespace pathmark::diagnosis {

Signature probePolygon(const ProbeRun& run);  // triangles and rectangles too
Signature probeSphereSample(const ProbeRun& run);
Signature probeSpherePdf(const ProbeRun& run);
Signature probeDirectLighting(const ProbeRun& run);

}  // namespace pathmark::diagnosis
