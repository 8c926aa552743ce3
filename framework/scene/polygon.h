// Polygons in double: their normal, and what makes them planar and simple.
//
//   newellVector          the normal of a polygon, as long as twice its area
//   acrossVector          the same of three of its vertices, where areas may cancel
//   diameter              the longest side of its bounding box
//   distanceFromPlane     how far it is from being planar
//   isParallelogram       whether its four vertices make one
//   project, Outline      the same polygon in a plane of coordinates
//   findCrossing          where it is not simple
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace pathmark {

// An area below this times the square of the longest side is rounding.
inline constexpr double kFlatArea = 1e-12;

// Newell's method (Sutherland, Sproull & Schumacker 1974): exact for planar polygons, concave ones
// too, and the best fit for others. Points to the side from which the vertices run
// counter-clockwise.
glm::dvec3 newellVector(std::span<const glm::dvec3> vertices);

// Across the plane of the first vertex, the one farthest from it and a third: the longest such
// vector. Of vertices on a line it is 0, but not of a polygon whose signed areas cancel.
glm::dvec3 acrossVector(std::span<const glm::dvec3> vertices);

double diameter(std::span<const glm::dvec3> vertices);

// The largest distance of a vertex from the plane through the vertices' mean with this unit normal.
double distanceFromPlane(std::span<const glm::dvec3> vertices, const glm::dvec3& normal);

// Whether p0 - p1 + p2 - p3 is no longer than `tolerance` times the diameter. Then the vertices are
// planar to the same tolerance.
bool isParallelogram(std::span<const glm::dvec3> vertices, double tolerance);

// A polygon in the plane, counter-clockwise.
using Outline = std::vector<glm::dvec2>;

// Drops the coordinate along which the normal is longest, and keeps the orientation.
Outline project(std::span<const glm::dvec3> vertices, const glm::dvec3& normal);

// Twice the signed area of the triangle a b c; positive if it runs counter-clockwise.
inline double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// The first vertices of two edges that meet where they must not: edge i goes from vertex i to the
// next. Nothing if the polygon is simple. Straight angles are allowed, folding back is not.
std::optional<std::array<std::size_t, 2>> findCrossing(const Outline& outline);

}  // namespace pathmark
