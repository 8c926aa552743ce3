// What surfaces do with light: the BRDF interface and its two kinds.
//
//   lambertianBRDF   brdf, pdf, reflection   (part 3)
//   phongBRDF        brdf, pdf, reflection   (part 4)
//
// wo, wi: unit vectors away from the surface, wo towards where the light goes and wi towards
// where it comes from; n: unit normal of the front. All densities are per unit solid angle.
#pragma once

#include <pathmark/types.h>

namespace pathmark {

class BRDF {
 public:
  virtual ~BRDF() = default;

  // The value f(wo, wi) of the BRDF, per steradian; 0 unless wo and wi are both above the surface
  // (their dot product with n is positive).
  virtual Colour brdf(const Vector& wo, const Vector& wi, const Vector& n) const = 0;

  // The density with which `reflection(wo, n, ...)` returns wi, >= 0.
  virtual float pdf(const Vector& wo, const Vector& wi, const Vector& n) const = 0;

  // A direction wi drawn for the given wo, with the density pdf(wo, wi, n). s, t, u in [0,1). The
  // density 0 says that there is none; wi may lie below the surface, where brdf is 0.
  virtual DirectionSample reflection(const Vector& wo, const Vector& n, float s, float t,
                                     float u) const = 0;
};

// Reflects light equally to all sides: f = Kd / pi.
class lambertianBRDF final : public BRDF {
 public:
  explicit lambertianBRDF(const Colour& diffuse) : Kd(diffuse) {}

  Colour brdf(const Vector& wo, const Vector& wi, const Vector& n) const override;
  float pdf(const Vector& wo, const Vector& wi, const Vector& n) const override;
  DirectionSample reflection(const Vector& wo, const Vector& n, float s, float t,
                             float u) const override;

  const Colour Kd;  // diffuse reflectance, each channel in [0,1]
};

// The modified Phong model (Lafortune & Willems 1994): a diffuse and a specular lobe,
//   f = Kd / pi + Ks (m + 2) / (2 pi) max(0, cos alpha)^m,
// m the exponent, alpha the angle between wi and the mirror direction of wo. From alpha = 90
// degrees on the specular lobe is 0 for every exponent, also for m = 0.
class phongBRDF final : public BRDF {
 public:
  phongBRDF(const Colour& diffuse, const Colour& specular, float m)
      : Kd(diffuse), Ks(specular), exponent(m) {}

  Colour brdf(const Vector& wo, const Vector& wi, const Vector& n) const override;
  float pdf(const Vector& wo, const Vector& wi, const Vector& n) const override;
  DirectionSample reflection(const Vector& wo, const Vector& n, float s, float t,
                             float u) const override;

  const Colour Kd;       // diffuse reflectance
  const Colour Ks;       // specular reflectance; Kd + Ks <= 1 in each channel
  const float exponent;  // 0 ... 1e6, not only integers
};

}  // namespace pathmark
