// What is asked of part 4, the modified Phong BRDF.
#include "checks/part4_checks.h"

#include "checks/all_checks.h"

namespace pathmark::checks {

namespace {

using F = CourseworkFunction;

}  // namespace

std::span<const Check> part4Checks() {
  static const std::vector<Check> kChecks{
      {"value", F::kPhongBrdf,
       "f is Kd/pi + Ks (m + 2)/(2 pi) max(0, cos(alpha))^m where wo and wi are both above the "
       "surface, and 0 elsewhere",
       0.0, phong::valueIsTheFormula},
      {"density", F::kPhongPdf,
       "pdf is a density: at least 0, and its integral over all directions is 1; it is 0 if "
       "nothing is reflected",
       0.0, phong::densityIsADensity},
      {"valid", F::kPhongReflection,
       "for all s, t, u, also at the ends, wi is a unit vector with a density of at least 0, and "
       "the same again for the same numbers",
       0.0, phong::directionsAreValid},
      {"own-density",
       F::kPhongPdf,
       "pdf says of a direction the density with which reflection draws it",
       0.01,
       phong::densityIsThatOfReflection,
       {F::kPhongReflection}},
      {"mixture",
       F::kPhongReflection,
       "the returned density is that of the mixture, pdf(wo, wi, n), whichever lobe wi came from",
       0.0,
       phong::densityIsOfTheMixture,
       {F::kPhongPdf}},
      {"samples",
       F::kPhongReflection,
       "the directions follow the density they are returned with",
       0.01,
       phong::samplesFollowTheirDensity,
       {F::kPhongPdf}},
      {"lobes", F::kPhongReflection,
       "both lobes are drawn wherever each of them has some colour in any channel", 0.0,
       phong::bothLobesAreDrawn},
  };
  return kChecks;
}

}  // namespace pathmark::checks
