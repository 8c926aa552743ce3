// Part 3: the Lambertian BRDF. Handout: handouts/part3_lambertian.md
//
// All densities of this part are per unit SOLID ANGLE.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 3.1 (handout section 3.1): the value of the BRDF, f = Kd / pi.
//
//   wo, wi   unit vectors away from the surface: towards where light goes, and where it comes from
//   n        unit normal of the front
//
// Returns f(wo, wi) per steradian; 0 unless both wo and wi are above the surface.
Colour lambertianBRDF::brdf(const Vector& /*wo*/, const Vector& /*wi*/, const Vector& /*n*/) const {
  PATHMARK_UNIMPLEMENTED("part3_lambertian.cpp", "lambertianBRDF::brdf");
  return Colour(0.0f);
}

// Part 3.2 (handout section 3.2): the density of `reflection`, cos(theta) / pi.
//
//   wo       not needed by this BRDF
//   wi       unit vector away from the surface, towards where light comes from
//   n        unit normal of the front
//
// Returns the density per unit solid angle with which reflection(wo, n, ...) returns wi; 0 below
// the surface.
float lambertianBRDF::pdf(const Vector& /*wo*/, const Vector& /*wi*/, const Vector& /*n*/) const {
  PATHMARK_UNIMPLEMENTED("part3_lambertian.cpp", "lambertianBRDF::pdf");
  return 0.0f;
}

// Part 3.3 (handout section 3.3): a direction with density cos(theta) / pi.
//
// In the frame U, N, V around the normal, with y along N:
//   x = cos(2 pi s) sqrt(1 - t),  y = sqrt(t),  z = sin(2 pi s) sqrt(1 - t)
// Frame(n).toWorld({x, y, z}) turns it into a direction of the world.
//
//   wo        not needed by this BRDF
//   n         unit normal of the front
//   s, t, u   uniform in [0,1); u is not needed by this BRDF
//
// Returns the unit vector wi and its density. On the horizon the density is 0: "no sample".
DirectionSample lambertianBRDF::reflection(const Vector& /*wo*/, const Vector& n, float /*s*/,
                                           float /*t*/, float /*u*/) const {
  PATHMARK_UNIMPLEMENTED("part3_lambertian.cpp", "lambertianBRDF::reflection");
  return {n, 0.0f};
}

}  // namespace pathmark
