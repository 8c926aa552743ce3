#include "intersect/sphere_blocks.h"

namespace pathmark {

SphereBlocks::SphereBlocks(const FlatSceneView& scene, std::span<const std::uint32_t> spheres,
                           const FlatTests& tests)
    : spheres_(spheres.size()) {
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

// One sphere of a block, for all lanes.
struct SphereBlocks::OneSphere {
  const Block& block;
  std::size_t lane;

  const LaneArray (&centre)[3] = block.centre;
  const LaneArray& radius = block.radius;
  const LaneArray& hideOutside = block.hideOutside;
  const LaneArray& hideInside = block.hideInside;

  FloatV take(const LaneArray& a) const { return a.lane[lane]; }
};

// Where the line of the ray enters each sphere and leaves it; NaN where it passes by.
struct SphereBlocks::Roots {
  FloatV enter, leave;
  FloatV::mask_type enterMet, leaveMet;

  FloatV::mask_type onSegment() const {
    const auto within = [](const FloatV& t) { return t > 0.0f && t < 1.0f; };
    return (enterMet && within(enter)) || (leaveMet && within(leave));
  }
};

template <class Spheres>
inline SphereBlocks::Roots SphereBlocks::roots(const Spheres& spheres, const Point& origin,
                                               const std::array<FloatV, 3>& direction) {
  const auto& [dx, dy, dz] = direction;
  const FloatV fx = origin.x - spheres.take(spheres.centre[0]),
               fy = origin.y - spheres.take(spheres.centre[1]),
               fz = origin.z - spheres.take(spheres.centre[2]),
               radius = spheres.take(spheres.radius);
  const FloatV a = dx * dx + dy * dy + dz * dz;
  const FloatV b = -(fx * dx + fy * dy + fz * dz), foot = b / a;
  const FloatV lx = fx + foot * dx, ly = fy + foot * dy, lz = fz + foot * dz;
  const FloatV discriminant = radius * radius - (lx * lx + ly * ly + lz * lz);
  const FloatV distance = sqrt(fx * fx + fy * fy + fz * fz);
  const FloatV c = (distance - radius) * (distance + radius);
  FloatV root = sqrt(a * discriminant);
  where(b < 0.0f, root) = -root;
  const FloatV q = b + root, one = c / q, other = q / a;
  const FloatV::mask_type met = discriminant > 0.0f;
  return {min(one, other), max(one, other), met && spheres.take(spheres.hideOutside) == 0.0f,
          met && spheres.take(spheres.hideInside) == 0.0f};
}

namespace {

std::array<FloatV, 3> forAllLanes(const Vector& v) { return {v.x, v.y, v.z}; }

}  // namespace

bool SphereBlocks::closest(const Ray& ray, float tMax, PrimitiveHit& hit) const {
  NearestV nearest(tMax);
  const std::array<FloatV, 3> direction = forAllLanes(ray.direction);
  for (const Block& block : blocks_) {
    const Roots met = roots(block, ray.origin, direction);
    const FloatV index = load(block.index);
    nearest.take(met.enterMet, met.enter, index);
    nearest.take(met.leaveMet, met.leave, index);
  }
  if (!nearest.reduce(tMax, hit)) return false;
  hit.isSphere = true;
  return true;
}

bool SphereBlocks::occluded(const Point& origin, const Vector& segment) const {
  const std::array<FloatV, 3> direction = forAllLanes(segment);
  for (const Block& block : blocks_)
    if (any_of(roots(block, origin, direction).onSegment())) return true;
  return false;
}

SegmentFan::Mask SphereBlocks::occluded(const SegmentFan& fan) const {
  SegmentFan::Mask occluded(false);
  for (std::size_t i = 0; i < spheres_; ++i) {
    const OneSphere sphere{blocks_[i / kLanes], i % kLanes};
    occluded = occluded || roots(sphere, fan.origin, fan.way).onSegment();
  }
  return occluded && fan.lanes;
}

}  // namespace pathmark
