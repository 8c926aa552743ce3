// The probes of part 0's estimators.
#pragma once

#include "diagnosis/probes.h"

namespace pathmark::diagnosis {

Signature probeBounce(const ProbeRun& run);
Signature probeWarmUpPath(const ProbeRun& run);

}  // namespace pathmark::diagnosis
