#include "preview/samples/sample_domain.h"

#include "preview/samples/axial_domain.h"
#include "preview/samples/phong_domain.h"
#include "preview/samples/polygon_domain.h"
#include "preview/samples/sphere_light_domain.h"
#include "preview/samples/square_domain.h"

#include <stdexcept>

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makeSampleDomain(const SampleSettings& settings) {
  using F = CourseworkFunction;
  switch (settings.function) {
    case F::kGetRandomNumbers:
      return makeUnitSquareDomain();
    case F::kSampleSphere:
      return makeSphereDomain();
    case F::kSampleHemisphere:
      return makeHemisphereDomain(settings);
    case F::kStratifiedRandomRay:
      return makePixelDomain(settings);
    case F::kTriangularSampling:
    case F::kRectangularSampling:
    case F::kPolygonSampling:
      return makePolygonDomain(settings);
    case F::kSphereSample:
      return makeSphereLightDomain(settings);
    case F::kLambertianReflection:
      return makeCosineDomain(settings);
    case F::kPhongReflection:
      return makePhongDomain(settings);
    default:
      throw std::invalid_argument("this function is not in the sample view");
  }
}

}  // namespace pathmark::preview
