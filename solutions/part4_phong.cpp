// Part 4: the modified Phong BRDF of Lafortune & Willems. Handout: handouts/part4_phong.md
#include <pathmark/coursework.h>

namespace pathmark {

namespace {

float mean(const Colour& c) { return (c.r + c.g + c.b) / 3.0f; }

Vector mirror(const Vector& wo, const Vector& n) { return 2.0f * dot(wo, n) * n - wo; }

// max(0, cos(alpha))^exponent for the angle alpha between unit vectors a and b. By
// 1 - cos(alpha) = |a - b|^2 / 2 the rounding of a dot product next to 1 is not raised to the
// exponent.
float cosinePower(const Vector& a, const Vector& b, float exponent) {
  const Vector difference = a - b;
  const float oneMinusCos = 0.5f * dot(difference, difference);
  if (oneMinusCos >= 1.0f) return 0.0f;
  return std::exp(exponent * std::log1p(-oneMinusCos));
}

}  // namespace

Colour phongBRDF::brdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  if (!(dot(wo, n) > 0.0f && dot(wi, n) > 0.0f)) return Colour(0.0f);
  const float lobe = cosinePower(wi, mirror(wo, n), exponent);
  return Kd * kInvPi + Ks * ((exponent + 2.0f) * 0.5f * kInvPi * lobe);
}

float phongBRDF::pdf(const Vector& wo, const Vector& wi, const Vector& n) const {
  const float kd = mean(Kd), ks = mean(Ks);
  if (kd + ks == 0.0f) return 0.0f;
  const float diffuse = std::max(dot(wi, n), 0.0f) * kInvPi;
  const float specular =
      (exponent + 1.0f) * 0.5f * kInvPi * cosinePower(wi, mirror(wo, n), exponent);
  return (kd * diffuse + ks * specular) / (kd + ks);
}

// cos(alpha) = t^(1/(m+1)) in the specular lobe; its sine from expm1, since cos(alpha) rounds to
// 1 for large exponents m.
DirectionSample phongBRDF::reflection(const Vector& wo, const Vector& n, float s, float t,
                                      float u) const {
  const float kd = mean(Kd), ks = mean(Ks);
  if (kd + ks == 0.0f) return {n, 0.0f};
  const bool diffuse = u * (kd + ks) < kd;
  const float cos2 = diffuse ? t : std::exp(2.0f * std::log(t) / (exponent + 1.0f));
  const float sin2 = diffuse ? 1.0f - t : -std::expm1(2.0f * std::log(t) / (exponent + 1.0f));
  const vec2 circle = std::sqrt(sin2) * onUnitCircle(s);
  const Frame frame(diffuse ? n : normalize(mirror(wo, n)));
  const Vector wi = normalize(frame.toWorld({circle.x, std::sqrt(cos2), circle.y}));
  return {wi, pdf(wo, wi, n)};
}

}  // namespace pathmark
