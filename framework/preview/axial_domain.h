// Directions whose density depends on the angle to an axis only: the sphere, the hemisphere, the
// cosine lobe.
#pragma once

#include "preview/direction_frame.h"
#include "preview/sample_domain.h"

namespace pathmark::preview {

std::unique_ptr<SampleDomain> makeSphereDomain();
std::unique_ptr<SampleDomain> makeHemisphereDomain(const SampleSettings& settings);
std::unique_ptr<SampleDomain> makeCosineDomain(const SampleSettings& settings);

// The unit normal that the settings ask for, as coursework gets it.
vec3 normalOf(const SampleSettings& settings, const glm::dvec3& up);

// wo of the settings.
vec3 outgoingOf(const SampleSettings& settings, const glm::dvec3& normal);

// Coordinates that domains share.
Marginal azimuthMarginal(const std::string& name, const DirectionFrame& frame,
                         std::function<double(double from, double to)> turnMass);

// Whether it has the length of a direction, rounding aside.
bool isDirection(const glm::dvec3& d);

// Numbers of rings and sectors, about so many cells.
struct Grid {
  std::size_t rows, columns;
};
Grid gridOf(std::size_t about);

// The number of the interval of [0,1) divided into so many.
std::size_t intervalOf(double x, std::size_t intervals);

}  // namespace pathmark::preview
