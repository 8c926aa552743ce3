// What is asked of every function that draws directions, whatever its density.
//
//   judgeOwnDensity           the samples follow the density that they are returned with
//   axialMoments, momentsOf   what judgeOwnDensity would see of a mistake
#pragma once

#include "checks/calls.h"
#include "checks/means.h"
#include "checks/points.h"

#include <functional>
#include <string>

namespace pathmark::checks {

struct DrawnDirection {
  Vector wi;
  double pdf;  // as claimed, per unit solid angle; 0: no sample
};

// Draws for a list of points: fills one direction for each.
struct DirectionDraw {
  vec2 st;
  float u;
};
using DrawDirections =
    std::function<std::vector<DrawnDirection>(const std::vector<DirectionDraw>&)>;

// The points of `count` replicates from number `first` on.
std::vector<DirectionDraw> drawsOf(Points& points, std::uint32_t pointsPerReplicate,
                                   std::uint32_t first, std::uint32_t count);

// The directions that a material's reflection draws with these points.
std::vector<DrawnDirection> drawReflections(CheckRun& run, CourseworkFunction reflection,
                                            const Words& material, const Vector& wo,
                                            const Vector& n,
                                            const std::vector<DirectionDraw>& points);

// A density q around an axis, in which only the cosine matters, and its integral over the cosines
// from `low` to `high` and all azimuths.
struct AxialDensity {
  std::function<double(double cosine)> density;
  std::function<double(double low, double high)> mass;
  double lowest = 0.0;  // cosines below this have no mass
  // E[c], E[c^2], and E[1 - c^2], under q.
  double meanCosine = 0.0, meanCosine2 = 0.0;
};

// Importance-weighted (each sample counts with q/pdf, so that any valid sampler passes): the mass,
// the mean direction, second moments, an azimuthal harmonic of order 3, and the mass of 16 cells.
// `pointsPerReplicate` a power of two.
Finding judgeOwnDensity(CheckRun& run, const Vector& axis, const AxialDensity& q,
                        const DrawDirections& draw, const std::string& where,
                        std::uint32_t pointsPerReplicate = 64,
                        const std::vector<Suspicion>& suspicions = {});

// The moments that a sampler would have whose samples have one density and claim another, in the
// order of judgeOwnDensity's means, for suspicions about axial densities.
std::vector<double> axialMoments(const AxialDensity& q,
                                 const std::function<double(double cosine)>& actual,
                                 const std::function<double(double cosine)>& claimed,
                                 double lowest);

// Those of a sampler that is given by its code, for suspicions about any other.
std::vector<double> momentsOf(const Vector& axis, const AxialDensity& q,
                              const std::function<DrawnDirection(const DirectionDraw&)>& drawOne);

}  // namespace pathmark::checks
