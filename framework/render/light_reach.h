// How large the coordinates are that a point of a light was made of, which its rounding error is in
// proportion to.
//
//   LightReach   of all lights of a scene
#pragma once

#include <pathmark/lit_scene.h>

#include <span>
#include <vector>

namespace pathmark {

class LightReach {
 public:
  void add(std::span<const Light::Face> faces);
  void add(const Sphere& sphere);

  // The largest coordinate of any light that the point y may belong to. A light's own points belong
  // to it, and of others few do that are near it; a large light far away is not among them, unless
  // y is on it.
  float magnitudeAt(const Point& y) const { return alike_ ? most_ : magnitudeOfThoseAt(y); }

 private:
  // Points of the light have a distance from the centre of `nearest` to `farthest`.
  struct Shell {
    Point centre;
    float nearest, farthest, magnitude;
  };

  void add(const Shell& shell);
  float magnitudeOfThoseAt(const Point& y) const;

  std::vector<Shell> shells_;
  float least_ = 0.0f, most_ = 0.0f;  // magnitude of any light
  bool alike_ = true;                 // whether they are so near each other that all is as one
};

}  // namespace pathmark
