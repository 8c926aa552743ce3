// CameraPose: a camera that can be moved, from a scene's own.
//
//   orbit   turns around the target     pan     moves eye and target sidewards
//   dolly   nearer to it, or further    camera  what the worker renders with
#pragma once

#include "scene/load_scene.h"

#include <glm/glm.hpp>

namespace pathmark::preview {

class CameraPose {
 public:
  explicit CameraPose(const LoadedScene& scene);

  // Whether the scene has its camera where the one has it that this was made from.
  bool isOf(const LoadedScene& scene) const;

  // Angles in radians: to the right, and upwards. The camera never passes the poles of `up`.
  void orbit(double right, double upwards);

  // In pixels of the picture: what is at the target's distance moves by so much.
  void pan(double right, double down);

  // Multiplies the distance to the target, within [1e-3, 1e3] of the file's.
  void dolly(double factor);

  FlatCamera camera() const;
  bool moved() const { return moved_; }  // not where the file has it
  void reset();

  const glm::dvec3& eye() const { return eye_; }
  const glm::dvec3& target() const { return target_; }

 private:
  struct Axes {
    glm::dvec3 right, up, forward;
  };
  Axes axes() const;

  FlatCamera file_;
  glm::dvec3 fileEye_, fileTarget_, fileUp_;
  glm::dvec3 eye_, target_, up_;
  glm::dvec3 topLeft_;  // of the film, along right, up and forward
  double pixel_;        // its spacing
  bool moved_ = false;
};

}  // namespace pathmark::preview
