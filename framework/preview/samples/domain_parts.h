// What several domains need.
//
//   normalOf, outgoingOf     directions that the settings ask for, as coursework gets them
//   azimuthMarginal          a coordinate
//   isDirection              whether a vector is unit length
//   gridOf, intervalOf       dividing a domain into cells
#pragma once

#include "preview/samples/direction_frame.h"
#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

vec3 normalOf(const SampleSettings& settings, const glm::dvec3& up);
vec3 outgoingOf(const SampleSettings& settings, const glm::dvec3& normal);

// turnMass: expected between two azimuths, in turns.
Marginal azimuthMarginal(const std::string& name, const DirectionFrame& frame,
                         std::function<double(double from, double to)> turnMass);

// Rounding aside.
bool isDirection(const glm::dvec3& d);

// About so many cells.
struct Grid {
  std::size_t rows, columns;
};
Grid gridOf(std::size_t cells);

// The number of the interval of [0,1] divided into so many.
std::size_t intervalOf(double x, std::size_t intervals);

}  // namespace pathmark::preview
