// Stands in for part 3 where another part is checked: reflects equally to all sides, by directions
// that are uniform on the hemisphere.
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

Colour lambertianBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  const float lower = std::min(dot(wo, n), dot(wi, n));
  return lower > 0.0f ? kInvPi * Kd : Colour(0.0f);
}

float lambertianBRDF::pdf(const Vector&, const Vector& wi, const Vector& n) const {
  return dot(wi, n) <= 0.0f ? 0.0f : kUniformDensity;
}

DirectionSample lambertianBRDF::reflection(const Vector& wo, const Vector& n, float s, float t,
                                           float) const {
  const Vector wi = uniformDirection(n, s, t);
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
