// Part 3: the Lambertian BRDF. Handout: handouts/part3_lambertian.md
#include <pathmark/coursework.h>

namespace pathmark {

Colour lambertianBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  return dot(wo, n) > 0.0f && dot(wi, n) > 0.0f ? Kd * kInvPi : Colour(0.0f);
}

float lambertianBRDF::pdf(const Vector&, const Vector& wi, const Vector& n) const {
  return std::max(dot(wi, n), 0.0f) * kInvPi;
}

// Uniform on the unit disc (radius sqrt(1 - t)), lifted to the hemisphere: Malley's method. The
// result is unit length as it is, like the frame's axes.
DirectionSample lambertianBRDF::reflection(const Vector& wo, const Vector& n, float s, float t,
                                           float) const {
  const vec2 onDisc = std::sqrt(1.0f - t) * onUnitCircle(s);
  const Vector wi = Frame(n).toWorld({onDisc.x, std::sqrt(t), onDisc.y});
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
