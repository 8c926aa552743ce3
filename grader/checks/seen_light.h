// SeenLight: a triangle or a rectangle as seen from a point, as the judge knows it, in long double.
//
//   omega, density        the solid angle, and the density of points that are uniform over it
//   means, add            moments and cells of such points
//   lightsInSight         from plain ones to those that are near, far, grazing, narrow
#pragma once

#include "checks/means.h"
#include "checks/outline.h"
#include "checks/points.h"

#include <array>
#include <string>
#include <vector>

namespace pathmark::checks {

using LongVector = glm::tvec3<long double>;

// Below this solid angle, sr, any density is right that its own points follow.
inline constexpr double kSmallestSolidAngle = 1e-3;

class SeenLight {
 public:
  // Of three vertices or, at right angles, four; `from` is in front of it.
  SeenLight(std::string what, std::vector<Point> vertices, const Point& from);

  const Outline& outline() const { return outline_; }
  const std::string& what() const { return what_; }
  const Point& from() const { return from_; }
  std::string text() const;

  double omega() const { return static_cast<double>(omega_); }
  bool mustBeUniform() const { return omega() >= kSmallestSolidAngle; }

  // Per unit area, of points that are uniform over the solid angle.
  double density(const Point& p) const;

  // Of a sum of angles in float, sr.
  double angleTolerance() const;

  // Relative, of a density: what a sum of angles in float may cost, and the rounding of inputs.
  double tolerance(const Point& p) const;

  // How far beyond an edge p may lie, and how far off the plane.
  double edgeTolerance(const Point& p) const;
  double planeTolerance() const;
  double offPlane(const Point& p) const;

  // Of points with that density, or weighted to it.
  std::vector<Mean> means() const;
  void add(const Point& p, double weight, std::span<double> sums) const;

  // What the means would be of points that are uniform by area but claim that density.
  std::vector<double> meansByArea() const;

  // Points with their shares of an integral over the area.
  std::vector<std::pair<Point, double>> quadrature() const;

 private:
  static constexpr std::size_t kSide = 4, kMoments = 6;  // cells along a side

  // Two numbers that are uniform in [0,1) and independent, for points that are uniform over the
  // solid angle: the share of it on one side of a plane, and the place within that plane.
  std::array<double, 2> fractions(const Point& p) const;
  std::array<double, 2> triangleFractions(const LongVector& p) const;
  std::array<double, 2> rectangleFractions(const LongVector& p) const;

  std::string what_;
  Outline outline_;
  Point from_;
  std::vector<LongVector> v_;  // from `from` to the vertices
  long double omega_ = 0.0L, height_ = 0.0L;
};

std::vector<SeenLight> lightsInSight(bool triangles, std::uint64_t seed);

}  // namespace pathmark::checks
