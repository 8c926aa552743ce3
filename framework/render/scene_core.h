// SceneCore: a worker's scene, built once from the host's arrays and then immutable.
//
// Holds what LitScene and its lights look at: BRDFs, lights, the intersector, the camera, and the
// triangles of the warm-up. The block of memory behind the view must outlive it.
#pragma once

#include "intersect/intersector.h"
#include "render/light_reach.h"
#include "render/material_lobes.h"
#include "scene/flat_scene.h"

#include <pathmark/brdf.h>
#include <pathmark/camera.h>
#include <pathmark/lit_scene.h>
#include <pathmark/warmup.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace pathmark {

SimpleCamera makeCamera(const FlatCamera& camera);

class SceneCore {
 public:
  explicit SceneCore(const FlatSceneView& view, ShadowOrigins origins = ShadowOrigins::kAnywhere,
                     Skips skips = {});
  SceneCore(const SceneCore&) = delete;
  SceneCore& operator=(const SceneCore&) = delete;

  const SimpleCamera& camera() const { return camera_; }
  int maxBounces() const { return maxBounces_; }
  std::span<const Light> lights() const { return lights_; }
  const BRDF& material(std::size_t i) const { return *materials_[i]; }
  std::size_t materialCount() const { return materials_.size(); }
  const MaterialLobes& lobes(std::size_t i) const { return *lobes_[i]; }

  // Of one of the materials.
  const MaterialLobes& lobesOf(const BRDF& material) const;

  bool intersect(const Ray& ray, Hit& hit) const;

  // How many camera rays are met together faster than one by one; 1: none.
  std::size_t packetSize() const { return intersector_.packetSize(); }

  // Of at most so many rays. Bit i of what it returns says whether ray i meets anything, and only
  // then is hits[i] set.
  std::uint32_t intersect(std::span<const Ray> rays, std::span<Hit> hits) const;

  bool visible(const Hit& from, const LightSample& to) const;

  // Whether anything lies on a segment, whose ends were moved off surfaces.
  bool occluded(const Point& origin, const Vector& segment) const {
    return intersector_.occluded(origin, segment);
  }
  // Whether that may depend on at which end the segment starts.
  bool hidesOneWay() const { return intersector_.hidesOneWay(); }

  // On which segments of a fan, whose ends were moved off surfaces, anything lies.
  SegmentFan::Mask occluded(const SegmentFan& fan) const { return intersector_.occluded(fan); }

  // The scene's triangles in the form of part 0; spheres are left out.
  std::vector<Triangle> warmUpTriangles() const;

 private:
  // What a shape's primitives have in common.
  struct Surface {
    const BRDF* brdf;
    Colour emission;
    const Light* light;
  };

  void buildLights();
  void meet(const Ray& ray, const PrimitiveHit& primitive, Hit& hit) const;
  const Surface& meetSphere(const Ray& ray, const PrimitiveHit& primitive, Hit& hit) const;
  const Surface& meetTriangle(const Ray& ray, const PrimitiveHit& primitive, Hit& hit) const;

  FlatSceneView view_;
  SimpleCamera camera_;
  int maxBounces_;
  Intersector intersector_;
  std::vector<std::unique_ptr<BRDF>> materials_;
  std::vector<std::unique_ptr<MaterialLobes>> lobes_;  // of each material
  std::vector<Surface> surfaces_;
  std::vector<Point> lightVertices_;
  std::vector<Light::Face> faces_;
  std::vector<Light> lights_;
  LightReach lightReach_;
};

}  // namespace pathmark
