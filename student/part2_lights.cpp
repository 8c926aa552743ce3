// Part 2: points on lights, and direct light. Handout: handouts/part2_lights.md
//
// All densities of this part are per unit AREA of the light.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 2.1 (handout section 2.1): a point that is uniform by area on a triangle.
//
// The triangle is p(0), p(1), p(2). Two uniform numbers used directly as barycentric coordinates
// crowd the points together somewhere: see the handout for two maps that do not.
// (Shirley, Wang & Zimmerman 1996, section 3.3)
//
//   s, t   uniform in [0,1)
//
// Returns the point, normal(), and the density 2 / |(p1 - p0) x (p2 - p0)|.
LightSample Polygon::TriangularSampling(float /*s*/, float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "Polygon::TriangularSampling");
  return {p(0), normal(), 0.0f};
}

// Part 2.2 (handout section 2.2): a point that is uniform by area on a rectangle.
//
// With the edges v1 = p(1) - p(0) and v2 = p(3) - p(0), the point p(0) + s v1 + t v2.
//
//   s, t   uniform in [0,1)
//
// Returns the point, normal(), and the density 1 / |v1 x v2|.
LightSample Polygon::RectangularSampling(float /*s*/, float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "Polygon::RectangularSampling");
  return {p(0), normal(), 0.0f};
}

// Part 2.3 (handout section 2.3): a point that is uniform by area on any simple polygon.
//
// How is up to you. The polygon may have a dent, so that the triangles between p(0) and each edge
// do not cover it; triangle(k) for k < triangleCount() are triangles that do.
//
//   s, t   uniform in [0,1)
//
// Returns the point, normal(), and the density 1 / (area of the polygon).
LightSample Polygon::PolygonSampling(float /*s*/, float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "Polygon::PolygonSampling");
  return {p(0), normal(), 0.0f};
}

// Part 2.4 (handout section 2.4): a point of a sphere, uniform over the solid angle that the
// sphere fills as seen from `from`.
//
// Seen from x the sphere fills a cone of half-angle thetaMax, sin(thetaMax) = r / |x - c|. Take a
// direction that is uniform in that cone, and the nearer of the points where it meets the sphere.
// Mind spheres that are small or far: 1 - cos(thetaMax) cancels, and the handout shows the form
// that does not; and a point found as x + t * direction is rounded as the distance is, not as the
// sphere. (Shirley, Wang & Zimmerman 1996, section 3.2)
//
//   from   the point x that is lit
//   s, t   uniform in [0,1)
//
// Returns the point x', the outward normal there, and the density per unit area
//   cos(theta') / (2 pi |x' - x|^2 (1 - cos(thetaMax))),
// theta' the angle at x' between the normal and the direction to x. If x is inside or on the
// sphere: a point uniform over its whole area, density 1 / (4 pi r^2).
LightSample Sphere::sample(const Point& /*from*/, float /*s*/, float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "Sphere::sample");
  return {centre() + Vector(radius(), 0.0f, 0.0f), Vector(1.0f, 0.0f, 0.0f), 0.0f};
}

// Part 2.5 (handout section 2.5): the density of Sphere::sample, by itself.
//
//   from   the point x that is lit
//   p, n   a point of the sphere and the outward normal there
//
// Returns the density per unit area with which sample(from, ...) returns p; 0 where it never does.
float Sphere::pdf(const Point& /*from*/, const Point& /*p*/, const Vector& /*n*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "Sphere::pdf");
  return 0.0f;
}

// Part 2.6 (handout section 2.6): the light that comes straight from the lights and is reflected
// once, at `hit`.
//
// For each light of lights(), one point y from light.sample(hit.p, s, t), and the sum of
//   Le f(wo, wi) V G / pdf,   G = cos(thetaX) cos(thetaY) / r^2,
// with Le = light.emission(), f = hit.brdf->brdf(wo, wi, hit.n), V = visible(hit, y) and r the
// distance from hit.p to y.p. Lights shine from their front only, and y.pdf == 0 means that there
// is no sample: both give nothing.
//
//   hit       the point x that is lit, its normal and its BRDF
//   wo        unit vector from x towards where the light goes
//   sampler   for s and t of each light
//
// Returns a radiance.
Colour LitScene::directLighting(const Hit& /*hit*/, const Vector& /*wo*/,
                                Sampler& /*sampler*/) const {
  PATHMARK_UNIMPLEMENTED("part2_lights.cpp", "LitScene::directLighting");
  return Colour(0.0f);
}

}  // namespace pathmark
