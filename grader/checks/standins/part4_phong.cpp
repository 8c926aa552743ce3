// Stands in for part 4 where another part is checked: the BRDF of lopsided.h, and that of beam.h
// for large exponents, and for those of leaning.h that of leaning.h.
#include "checks/standins/beam.h"
#include "checks/standins/leaning.h"
#include "checks/standins/lopsided.h"
#include "checks/standins/uniform_direction.h"

#include <pathmark/coursework.h>

namespace pathmark {

namespace {

bool isBeam(const phongBRDF& brdf) { return brdf.exponent >= beam::kLeastExponent; }

bool isLeaning(const phongBRDF& brdf) { return brdf.exponent == leaning::kExponent; }

}  // namespace

Colour phongBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  const float cosO = dot(wo, n), cosI = dot(wi, n);
  if (!(cosO > 0.0f && cosI > 0.0f)) return Colour(0.0f);
  if (isBeam(*this))
    return cosI >= beam::kLeastCosine ? Kd * (beam::kDensity / cosI) : Colour(0.0f);
  if (isLeaning(*this)) return kInvPi * Kd;
  return Kd * (kInvPi * lopsided::shape(cosO, cosI));
}

// Like Phong's, from below the surface nothing is drawn.
float phongBRDF::pdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  if (!(dot(wo, n) > 0.0f)) return 0.0f;
  if (isLeaning(*this))
    return dot(wi, n) > 0.0f ? leaning::shareOf(wo, wi, n) * 2.0f * kUniformDensity : 0.0f;
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
  if (isLeaning(*this)) {
    const float share = s < leaning::kMirrorShare ? leaning::kMirrorShare : leaning::kOwnShare;
    const bool mirror = s < leaning::kMirrorShare;
    const Vector any = uniformDirection(n, mirror ? s / share : (s - 1.0f + share) / share, t);
    const Vector wi = leaning::onSide(any, wo, n, mirror);
    return {wi, pdf(wo, wi, n)};
  }
  if (!lopsided::isSample(s, t, u)) return {n, 0.0f};
  const Vector wi = uniformDirection(n, s, t);
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
