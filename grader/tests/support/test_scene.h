// Scenes made in code.
//
//   SceneBuilder   collects materials, shapes and lights
//   TestScene      the built scene, to be asked as a LitScene
#pragma once

#include "render/scene_core.h"
#include "scene/flat_scene.h"

#include <pathmark/coursework.h>

#include <memory>
#include <vector>

namespace pathmark::testing {

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

  // Square pixels, `fov` the vertical field of view in radians.
  SceneBuilder& camera(const Point& eye, const Point& target, double fov, int width, int height);

  const FlatScene& flat() const { return flat_; }

 private:
  std::uint32_t addShape(const Surface& surface);

  FlatScene flat_;
};

class TestScene {
 public:
  explicit TestScene(const SceneBuilder& builder) : TestScene(builder.flat()) {}
  explicit TestScene(FlatScene flat);

  LitScene lit(int maxBounces) const { return {*core_, maxBounces}; }
  const SceneCore& core() const { return *core_; }
  const FlatScene& flat() const { return flat_; }

 private:
  FlatScene flat_;
  std::unique_ptr<SceneCore> core_;
};

}  // namespace pathmark::testing
