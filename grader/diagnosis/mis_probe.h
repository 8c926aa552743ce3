// The probe of tracePathMIS.
#pragma once

#include "diagnosis/probes.h"

namespace pathmark::diagnosis {

Signature probePathMis(const ProbeRun& run);

}  // namespace pathmark::diagnosis
