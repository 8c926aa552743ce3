// Scenes made in code, as a worker gets them.
//
//   Surface, SceneBuilder   shapes, lights and a camera, one after the other
//   emptyRoom               for functions of LitScene that look at no surface
#pragma once

#include "scene/flat_scene.h"

#include <pathmark/types.h>

#include <vector>

namespace pathmark::checks {

// What a shape is made of. With an emission that is not black it becomes a light.
struct Surface {
  Colour kd{0.0f};
  Colour emission{0.0f};
  Colour ks{0.0f};
  float exponent = 0.0f;   // Phong where ks is not black
  bool frontOnly = false;  // rays pass through its back
};

class SceneBuilder {
 public:
  // Convex, counter-clockwise seen from its front; at least three vertices.
  SceneBuilder& polygon(const Surface& surface, const std::vector<Point>& vertices);

  // The parallelogram a, a + v1, a + v1 + v2, a + v2; its front is the side of v1 x v2.
  SceneBuilder& parallelogram(const Surface& surface, const Point& a, const Vector& v1,
                              const Vector& v2);

  SceneBuilder& sphere(const Surface& surface, const Point& centre, float radius,
                       bool inward = false);

  // A material that belongs to no shape, for receivers of the judge's choice; its index.
  std::uint32_t material(const Surface& surface);

  // Square pixels, `fov` the vertical field of view in radians.
  SceneBuilder& camera(const Point& eye, const Point& target, double fov, int width, int height);

  SceneBuilder& maxBounces(int bounces);

  const FlatScene& flat() const { return flat_; }

 private:
  std::uint32_t addShape(const Surface& surface);

  FlatScene flat_;
};

FlatScene emptyRoom();

}  // namespace pathmark::checks
