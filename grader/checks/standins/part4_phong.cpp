// Stands in for part 4 where another part is checked: the BRDF of lopsided.h, and that of beam.h
// for large exponents.
#include "checks/standins/beam.h"
#include "checks/standins/lopsided.h"
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

namespace {

bool isBeam(const phongBRDF& brdf) { return brdf.exponent >= beam::kLeastExponent; }

}  // namespace

Colour phongBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  const float cosO = dot(wo, n), cosI = dot(wi, n);
  if (!(cosO > 0.0f && cosI > 0.0f)) return Colour(0.0f);
  if (isBeam(*this))
    return cosI >= beam::kLeastCosine ? Kd * (beam::kDensity / cosI) : Colour(0.0f);
  return Kd * (kInvPi * lopsided::shape(cosO, cosI));
}

float phongBRDF::pdf(const Vector&, const Vector& wi, const Vector& n) const {
  if (isBeam(*this)) return dot(wi, n) >= beam::kLeastCosine ? beam::kDensity : 0.0f;
  return dot(wi, n) > 0.0f ? lopsided::kShareOfSamples * kUniformDensity : 0.0f;
}

DirectionSample phongBRDF::reflection(const Vector& wo, const Vector& n, float s, float t,
                                      float u) const {
  // By a rounding the direction may be just outside, and is none then.
  if (isBeam(*this)) {
    const Vector wi = uniformDirection(n, s, 1.0f - t * (1.0f - beam::kLeastCosine));
    return {wi, pdf(wo, wi, n)};
  }
  if (!lopsided::isSample(s, t, u)) return {n, 0.0f};
  const Vector wi = uniformDirection(n, s, t);
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
