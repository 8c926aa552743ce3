// The loops in which intersectors are measured. An intersector has
//
//   bool closest(const Ray&, PrimitiveHit&) const
//   bool occluded(const Point& origin, const Vector& segment) const
//
//   FlatRays, EmbreeRays   ours with these functions; RawEmbree has them itself
//   RayKind, loopOf        what is measured
#pragma once

#include "bench/alternate.h"
#include "bench/quick_random.h"
#include "bench/ray_set.h"
#include "intersect/embree_intersector.h"
#include "intersect/flat_intersector.h"

#include <array>
#include <limits>

namespace pathmark::bench {

struct FlatRays {
  explicit FlatRays(const FlatSceneView& scene) : flat(scene) {}
  bool closest(const Ray& ray, PrimitiveHit& hit) const { return flat.closest(ray, hit); }
  bool occluded(const Point& origin, const Vector& segment) const {
    return flat.occluded(origin, segment);
  }
  FlatIntersector flat;
};

struct EmbreeRays {
  explicit EmbreeRays(const FlatSceneView& scene) : embree(scene) {}
  bool closest(const Ray& ray, PrimitiveHit& hit) const {
    return embree.closest(ray, std::numeric_limits<float>::infinity(), hit);
  }
  bool occluded(const Point& origin, const Vector& segment) const {
    return embree.occluded(origin, segment);
  }
  EmbreeIntersector embree;
};

enum class RayKind {
  kClosest,   // independent rays
  kOccluded,  // independent shadow rays
  kChained,   // each ray starts where the one before has met the scene
  kPath,      // chained, with a shadow ray from each vertex
};

// Rays that are made between two looks at the clock, which take microseconds on some machines.
inline constexpr std::size_t kRaysOfChunk = 4096;

// The first `count` rays of the set, over and over.
template <class Rays>
Work independentLoop(const Rays& rays, const RaySet& set, std::size_t count, bool shadow) {
  return [&rays, &set, count, shadow, next = std::size_t{0}, sum = std::uint32_t{0}]() mutable {
    for (std::size_t i = 0; i < kRaysOfChunk; ++i, next = next + 1 < count ? next + 1 : 0) {
      const Ray& ray = set.rays[next];
      if (shadow) {
        sum += rays.occluded(ray.origin, set.segments[next]) ? 1u : 0u;
      } else {
        PrimitiveHit hit;
        if (rays.closest(ray, hit)) sum += hit.index;
      }
    }
    return std::uint64_t{kRaysOfChunk};
  };
}

// A chain goes on in a direction of the hemisphere from a table, so that next to nothing but
// intersection is measured, and anew from a prepared ray when it has left the scene.
template <class Rays>
class Chain {
 public:
  Chain(const Rays& rays, const RayScene& scene, const RaySet& set, bool shadow)
      : rays_(&rays), scene_(&scene), view_(viewOf(scene.flat)), set_(&set), shadow_(shadow) {
    for (std::size_t i = 0; i < kDirections; ++i) directions_[i] = set.rays[i].direction;
    ray_ = set.starts.front();
  }

  std::uint64_t operator()() {
    std::uint64_t made = 0;
    while (made < kRaysOfChunk) {
      ++made;
      PrimitiveHit hit;
      if (!rays_->closest(ray_, hit)) {
        ray_ = set_->starts[random_.bits() % RaySet::kStarts];
        continue;
      }
      const Surface surface = surfaceAt(view_, ray_, hit);
      const std::uint32_t bits = random_.bits();
      const Vector& d = directions_[bits % kDirections];
      ray_ = {leave(surface, *scene_), dot(d, surface.n) < 0.0f ? -d : d};
      if (shadow_) {
        constexpr float kUnit = 0x1p-16f;
        const Lamp& lamp = scene_->lamp;
        const Point onLamp = lamp.corner + kUnit * static_cast<float>(bits >> 16) * lamp.side +
                             kUnit * static_cast<float>(bits & 0xffff) * lamp.otherSide;
        lit_ += rays_->occluded(ray_.origin, 0.999f * (onLamp - ray_.origin)) ? 0u : 1u;
        ++made;
      }
    }
    return made;
  }

 private:
  static constexpr std::size_t kDirections = 1024;

  const Rays* rays_;
  const RayScene* scene_;
  FlatSceneView view_;
  const RaySet* set_;
  bool shadow_;
  std::array<Vector, kDirections> directions_;
  Ray ray_;
  QuickRandom random_{7};
  std::uint64_t lit_ = 0;
};

// All arguments must outlive the loop.
template <class Rays>
Work loopOf(RayKind kind, const Rays& rays, const RayScene& scene, const RaySet& set) {
  switch (kind) {
    case RayKind::kClosest:
      return independentLoop(rays, set, set.rays.size(), false);
    case RayKind::kOccluded:
      return independentLoop(rays, set, set.rays.size(), true);
    case RayKind::kChained:
      return Chain<Rays>(rays, scene, set, false);
    case RayKind::kPath:
      return Chain<Rays>(rays, scene, set, true);
  }
  return {};
}

}  // namespace pathmark::bench
