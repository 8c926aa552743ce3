// Where a ray meets a triangle, in double, and how well a solution in float can know it.
//
//   Meeting        the hit, and what rounding makes of it
//   randomMeeting  a ray and a triangle of this size and shape, somewhere
#pragma once

#include "checks/points.h"

#include <pathmark/types.h>

#include <array>
#include <string>

namespace pathmark::checks {

using Corners = std::array<Point, 3>;

struct Meeting {
  double t = 0.0;  // in front of the origin or behind
  double b1 = 0.0, b2 = 0.0;
  double determinant = 0.0;  // negative: the corners run clockwise as seen along the ray
  double slack = 0.0;        // of the barycentric coordinates
  double tError = 0.0;       // allowed

  bool inside() const { return b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0; }
  bool hit() const { return inside() && t > 0.0; }
  // Neither rounding nor the contract's leave at edges decides whether it is a hit.
  bool clear() const;
};

Meeting meet(const Ray& ray, const Corners& corners);

struct RayAndTriangle {
  Ray ray;
  Corners corners;
};

// A triangle with edges of about `size`, at some place within `shift` sizes of the origin; `shape`
// is its height relative to its longest edge. The ray aims at it or past it, from either side, and
// every fourth ray away from it.
RayAndTriangle randomMeeting(Random& random, double size, double shift, double shape);

std::string text(const Ray& ray);
std::string text(const Corners& corners);

}  // namespace pathmark::checks
