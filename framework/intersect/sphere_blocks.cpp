#include "intersect/sphere_blocks.h"

namespace pathmark {

SphereBlocks::SphereBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> spheres,
                           const FlatTests& tests) {
  const std::size_t count = spheres.size(), least = tests.kindsOfNothing ? 1 : 0;
  blocks_.resize(std::max(least, (count + kLanes - 1) / kLanes));
  for (std::size_t i = 0; i < blocks_.size() * kLanes; ++i) {
    Block& block = blocks_[i / kLanes];
    const std::size_t lane = i % kLanes;
    const FlatSphere sphere =
        i < count ? scene.spheres[spheres[i]] : FlatSphere{{kNaN, kNaN, kNaN}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      block.centre[axis].lane[lane] = sphere.centre[axis];
    block.radius.lane[lane] = sphere.radius;
    const bool frontOnly = i < count && scene.shapes[sphere.shape].frontOnly != 0;
    block.hideOutside.lane[lane] = frontOnly && sphere.inward != 0 ? 1.0f : 0.0f;
    block.hideInside.lane[lane] = frontOnly && sphere.inward == 0 ? 1.0f : 0.0f;
    block.index.lane[lane] = i < count ? bitsOfIndex(spheres[i]) : 0.0f;
  }
}

// Where the line of the ray enters each sphere and leaves it; NaN where it passes by.
struct SphereBlocks::Roots {
  FloatV enter, leave;
  FloatV::mask_type enterMet, leaveMet;
};

SphereBlocks::Roots SphereBlocks::roots(const Block& block, const Point& origin,
                                        const Vector& direction) {
  const FloatV fx = origin.x - load(block.centre[0]), fy = origin.y - load(block.centre[1]),
               fz = origin.z - load(block.centre[2]), radius = load(block.radius);
  const float a = dot(direction, direction);
  const FloatV b = -(fx * direction.x + fy * direction.y + fz * direction.z), foot = b / a;
  const FloatV lx = fx + foot * direction.x, ly = fy + foot * direction.y,
               lz = fz + foot * direction.z;
  const FloatV discriminant = radius * radius - (lx * lx + ly * ly + lz * lz);
  const FloatV distance = sqrt(fx * fx + fy * fy + fz * fz);
  const FloatV c = (distance - radius) * (distance + radius);
  FloatV root = sqrt(a * discriminant);
  where(b < 0.0f, root) = -root;
  const FloatV q = b + root, one = c / q, other = q / a;
  const FloatV::mask_type met = discriminant > 0.0f;
  return {min(one, other), max(one, other), met && load(block.hideOutside) == 0.0f,
          met && load(block.hideInside) == 0.0f};
}

bool SphereBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  NearestV nearest(tMax);
  for (const Block& block : blocks_) {
    const Roots met = roots(block, ray.origin, ray.direction);
    const FloatV index = load(block.index);
    nearest.take(met.enterMet, met.enter, index);
    nearest.take(met.leaveMet, met.leave, index);
  }
  if (!nearest.reduce(tMax, hit)) return false;
  hit.isSphere = true;
  return true;
}

bool SphereBlocks::occluded(const Point& origin, const Vector& segment) const {
  const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
  for (const Block& block : blocks_) {
    const Roots met = roots(block, origin, segment);
    if (any_of((met.enterMet && within(met.enter)) || (met.leaveMet && within(met.leave))))
      return true;
  }
  return false;
}

}  // namespace pathmark
