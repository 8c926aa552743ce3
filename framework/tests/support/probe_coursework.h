// The densities by which the probe's sampling functions are known.
#pragma once

namespace pathmark::test {

inline constexpr float kTriangularDensity = 3.0f;
inline constexpr float kRectangularDensity = 4.0f;
inline constexpr float kPolygonDensity = 5.0f;
inline constexpr float kSphereDensity = 7.0f;
inline constexpr float kSphericalTriangleDensity = 11.0f;
inline constexpr float kSphericalRectangleDensity = 13.0f;

}  // namespace pathmark::test
