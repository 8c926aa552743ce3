// FlatPolygon: a planar polygon as triangles in coordinates of its own plane.
//
//   areaBelow     of the part whose coordinate is below a value
//   triangleAt    where a point lies
//   cellsOf       congruent parts of the triangles
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace pathmark::preview {

using FlatTriangle = std::array<glm::dvec2, 3>;

double areaOf(const FlatTriangle& triangle);

// Of the part of the triangle with coordinate `axis` (0 or 1) below `value`.
double areaBelow(const FlatTriangle& triangle, int axis, double value);

// Weights of the three corners; they add up to 1.
glm::dvec3 barycentrics(const FlatTriangle& triangle, const glm::dvec2& point);

// A triangle is divided into n x n congruent ones: number of the one that a point lies in.
std::size_t partOf(const glm::dvec3& weights, std::size_t n);

}  // namespace pathmark::preview
