// Part 9, bonus: lights by the solid angle that they fill. Handout: handouts/part9_solid_angle.md
//
// The points of this part are uniform over the SOLID ANGLE that a light fills as seen from the
// point that is lit, as those of part 2.4 are; densities are nevertheless per unit AREA, as in all
// of LightSample: cos(theta') / (omega r^2), omega the solid angle, r the distance from the point
// that is lit and theta' the angle there between the light's normal and the direction back.
//
// From 1e-3 sr on a sum of angles in float is good enough: omega may be off by 4e-6 sr, and a point
// may lie beyond an edge by what that moves it. The handout says how far that is.
#include <pathmark/coursework.h>

namespace pathmark {

// Part 9.1 (handout section 9.1): a point of a triangle, uniform over its solid angle.
//
// The triangle is p(0), p(1), p(2). Choose a direction that is uniform in the spherical triangle
// that it fills as seen from `from`, and find the point of the plane in that direction. A sum of
// angles minus pi cancels for small and far triangles: see the handout for forms that do not. Below
// 1e-3 sr points that are uniform by area, with their density, will do. (Arvo 1995; Peters 2021)
//
//   from   the point that is lit
//   s, t   uniform in [0,1)
//
// Returns the point, normal(), and the density per unit area; density 0 if `from` is behind the
// triangle or in its plane, where it sees nothing of the front.
LightSample Polygon::SphericalTriangleSampling(const Point& /*from*/, float /*s*/,
                                               float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalTriangleSampling");
  return {p(0), normal(), 0.0f};
}

// Part 9.2 (handout section 9.2): the density per unit area with which SphericalTriangleSampling
// returns a point of the triangle.
//
//   from   the point that is lit
//   p      a point of the triangle, in world space
//
// Returns 0 if `from` is behind the triangle or in its plane.
float Polygon::SphericalTrianglePdf(const Point& /*from*/, const Point& /*p*/) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalTrianglePdf");
  return 0.0f;
}

// Part 9.3 (handout section 9.3): the same for a rectangle, p(0), p(1), p(2), p(3), whose edges
// v1 = p(1) - p(0) and v2 = p(3) - p(0) are at right angles.
//
// Urena, Fajardo & King map the unit square to it without a seam. Two triangles, chosen by their
// solid angles, are right as well.
//
//   from   the point that is lit
//   s, t   uniform in [0,1)
//
// Returns the point, normal(), and the density per unit area; density 0 if `from` is behind the
// rectangle or in its plane.
LightSample Polygon::SphericalRectangleSampling(const Point& /*from*/, float /*s*/,
                                                float /*t*/) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalRectangleSampling");
  return {p(0), normal(), 0.0f};
}

// Part 9.4 (handout section 9.4): the density per unit area with which SphericalRectangleSampling
// returns a point of the rectangle.
//
//   from   the point that is lit
//   p      a point of the rectangle, in world space
//
// Returns 0 if `from` is behind the rectangle or in its plane.
float Polygon::SphericalRectanglePdf(const Point& /*from*/, const Point& /*p*/) const {
  PATHMARK_UNIMPLEMENTED("part9_solid_angle.cpp", "Polygon::SphericalRectanglePdf");
  return 0.0f;
}

}  // namespace pathmark
