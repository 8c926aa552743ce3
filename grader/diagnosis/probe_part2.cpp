// Points on lights, and direct light.
#include "diagnosis/light_probes.h"
#include "diagnosis/probes.h"

namespace pathmark::diagnosis {

Signature probePart2(const ProbeRun& run) {
  switch (run.function) {
    case CourseworkFunction::kSphereSample:
      return probeSphereSample(run);
    case CourseworkFunction::kSpherePdf:
      return probeSpherePdf(run);
    case CourseworkFunction::kDirectLighting:
      return probeDirectLighting(run);
    default:
      return probePolygon(run);
  }
}

}  // namespace pathmark::diagnosis
