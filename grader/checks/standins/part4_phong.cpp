// Stands in for part 4 where another part is checked: the BRDF of lopsided.h.
#include "checks/standins/lopsided.h"
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

Colour phongBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  const float cosO = dot(wo, n), cosI = dot(wi, n);
  if (!(cosO > 0.0f && cosI > 0.0f)) return Colour(0.0f);
  return Kd * (kInvPi * lopsided::shape(cosO, cosI));
}

float phongBRDF::pdf(const Vector&, const Vector& wi, const Vector& n) const {
  return dot(wi, n) > 0.0f ? lopsided::kShareOfSamples * kUniformDensity : 0.0f;
}

DirectionSample phongBRDF::reflection(const Vector& wo, const Vector& n, float s, float t,
                                      float u) const {
  if (u >= lopsided::kShareOfSamples) return {n, 0.0f};
  const Vector wi = uniformDirection(n, s, t);
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
