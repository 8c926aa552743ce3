// Part 4: the modified Phong BRDF of Lafortune & Willems (1994). Handout: handouts/part4_phong.md
//
// All densities of this part are per unit SOLID ANGLE. m is the member `exponent`; R is the mirror
// direction of wo, 2 (n . wo) n - wo; alpha is the angle between wi and R.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 4.1 (handout section 4.1): the value of the BRDF,
//   f = Kd / pi + Ks (m + 2) / (2 pi) max(0, cos(alpha))^m.
// Where cos(alpha) <= 0 the second term is 0 for every exponent, also for m = 0.
//
//   wo, wi   unit vectors away from the surface
//   n        unit normal of the front
//
// Returns f(wo, wi) per steradian; 0 unless both wo and wi are above the surface.
Colour phongBRDF::brdf(const Vector& /*wo*/, const Vector& /*wi*/, const Vector& /*n*/) const {
  PATHMARK_UNIMPLEMENTED("part4_phong.cpp", "phongBRDF::brdf");
  return Colour(0.0f);
}

// Part 4.2 (handout section 4.2): the density of `reflection`, which is that of the mixture of
// both lobes, whichever of them wi came from:
//   P(diffuse) cos(theta) / pi + P(specular) (m + 1) / (2 pi) max(0, cos(alpha))^m
// The specular lobe may reach below the surface: there pdf is its density. It may be 0 there
// instead, "no sample", if reflection returns the same 0.
//
//   wo, wi   unit vectors away from the surface
//   n        unit normal of the front
//
// Returns the density per unit solid angle with which reflection(wo, n, ...) returns wi; 0 if
// Kd = Ks = 0.
float phongBRDF::pdf(const Vector& /*wo*/, const Vector& /*wi*/, const Vector& /*n*/) const {
  PATHMARK_UNIMPLEMENTED("part4_phong.cpp", "phongBRDF::pdf");
  return 0.0f;
}

// Part 4.3 (handout section 4.3): a direction from one of the two lobes.
//
// Choose the lobe with u, in proportion to the means of Kd and of Ks over their channels. Then
// diffuse: as in part 3, around n. Specular: around R, with cos(alpha) = t^(1/(m+1)) and azimuth
// 2 pi s. For large m, cos(alpha) rounds to 1: the handout shows how to get the sine.
//
//   wo        unit vector away from the surface
//   n         unit normal of the front
//   s, t, u   uniform in [0,1)
//
// Returns the unit vector wi and the density pdf(wo, wi, n) of the mixture. A direction below the
// surface is returned as it is, with the density that pdf says: it carries no light, since f is 0
// there. With Kd = Ks = 0 there is nothing to sample: density 0.
DirectionSample phongBRDF::reflection(const Vector& /*wo*/, const Vector& n, float /*s*/,
                                      float /*t*/, float /*u*/) const {
  PATHMARK_UNIMPLEMENTED("part4_phong.cpp", "phongBRDF::reflection");
  return {n, 0.0f};
}

}  // namespace pathmark
