// Spheres as lights, and points that they are looked at from.
//
//   SphereView         a sphere and a viewer, with the oracle that knows the contract's density
//   viewsFromOutside, viewsAlongAxes, viewsFromInside
//   SphereReference    a density that samples are weighed with, uniform in two coordinates
//   DensitySuspects    known wrong formulas of the density
#pragma once

#include "checks/points.h"
#include "checks/sphere_oracle.h"

#include <string>
#include <vector>

namespace pathmark::checks {

struct SphereView {
  Point centre;
  float radius;
  Point from;
  SphereOracle oracle;

  SphereView(const Point& c, float r, const Point& x)
      : centre(c), radius(r), from(x), oracle(Sphere(c, r), x) {}

  std::string text() const;
  double ratio() const { return static_cast<double>(oracle.r / oracle.d); }
  double magnitude() const;  // the largest coordinate or length

  // Relative, of a density at c + r n.
  double tolerance(const Vector& n) const;
};

// From plain ones to spheres like a point, and viewers next to the surface.
std::vector<SphereView> viewsFromOutside(std::uint64_t seed);

// From outside, on and next to the axes, where frames that are made by hand break down.
std::vector<SphereView> viewsAlongAxes();

// And from exactly on the surface.
std::vector<SphereView> viewsFromInside(std::uint64_t seed);

// Of a sphere's points, by their normals: uniform over the solid angle, over the area of the cap
// that can be seen, or over all of the area.
struct SphereReference {
  enum class Kind { kCone, kCap, kWhole };

  const SphereView& view;
  Kind kind;

  double density(const Vector& n) const;
  double fraction(const Vector& n) const;  // uniform in [0,1], and so is the azimuth
};

class DensitySuspects {
 public:
  void see(const SphereView& view, const Vector& n, double density);
  std::string cause() const;  // the formula that explains all that was seen; empty if none does

 private:
  static constexpr std::size_t kCount = 8;
  std::array<bool, kCount> excluded_{}, differs_{};
};

}  // namespace pathmark::checks
