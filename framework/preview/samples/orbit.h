// Orbit: a camera that turns around the middle of a sketch.
#pragma once

#include "preview/samples/sample_domain.h"

#include <glm/glm.hpp>

namespace pathmark::preview {

class Orbit {
 public:
  // What is seen first.
  explicit Orbit(const Sketch& sketch);

  // Goes on from the same side, when the sketch has moved.
  void lookAt(const Sketch& sketch);

  // By a drag, in heights of the view; x to the right and y downwards.
  void drag(const glm::dvec2& by);
  void zoom(double steps);  // of the mouse's wheel; positive: closer

  // x to the right and y upwards, in half heights of the view; z towards the viewer, in radii of
  // the sketch: 1 to -1 for what belongs to it.
  glm::dvec3 project(const glm::dvec3& point) const;

 private:
  glm::dvec3 centre_, up_, right_, front_;
  double radius_;
  double turn_, tilt_, zoom_ = 1.0;
};

}  // namespace pathmark::preview
