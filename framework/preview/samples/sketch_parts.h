// Pieces of sketches.
#pragma once

#include "preview/samples/direction_frame.h"
#include "preview/samples/sample_domain.h"

namespace pathmark::preview {

// A circle around the frame's axis.
Stroke circle(StrokeKind kind, const glm::dvec3& centre, const DirectionFrame& frame,
              double radius);

// Circles of latitude and meridians, of the whole sphere or of the half on the side of the axis.
void addWireSphere(Sketch& sketch, const glm::dvec3& centre, double radius,
                   const DirectionFrame& frame, bool half);

// Arrows from the origin with their names.
void addArrow(Sketch& sketch, StrokeKind kind, const glm::dvec3& direction,
              const std::string& name);

// The normal of a surface, and the view moved to the half sphere above it.
void addNormal(Sketch& sketch, const glm::dvec3& normal);

// The three axes of the world, from the origin.
void addAxes(Sketch& sketch, double length);

}  // namespace pathmark::preview
