// FanLoop: shadow rays from one point to as many points of a lamp as a vector has lanes, as pixels
// that share their paths trace them: all at once, or one after the other.
#pragma once

#include "bench/quick_random.h"
#include "bench/ray_set.h"
#include "intersect/flat_intersector.h"

#include <array>

namespace pathmark::bench {

class FanLoop {
 public:
  // All must outlive it.
  FanLoop(const FlatIntersector& flat, const RayScene& scene, const RaySet& set, bool together)
      : flat_(&flat), set_(&set), together_(together) {
    QuickRandom random(9);
    for (Ends& ends : ends_)
      for (std::size_t i = 0; i < kLanes; ++i) {
        const Lamp& lamp = scene.lamp;
        const Point p = lamp.corner + random.next() * lamp.side + random.next() * lamp.otherSide;
        for (int axis = 0; axis < 3; ++axis) ends[static_cast<std::size_t>(axis)].lane[i] = p[axis];
      }
  }

  std::uint64_t operator()() {
    constexpr std::size_t kFans = 256;  // between two looks at the clock
    for (std::size_t k = 0; k < kFans; ++k, next_ = next_ + 1 < set_->rays.size() ? next_ + 1 : 0) {
      const Point& origin = set_->rays[next_].origin;
      const Ends& ends = ends_[next_ % kSets];
      if (together_) {
        const SegmentFan::Mask occluded = flat_->occluded(
            {origin,
             {load(ends[0]) - origin.x, load(ends[1]) - origin.y, load(ends[2]) - origin.z},
             SegmentFan::Mask(true)});
        sum_ += popcount(occluded);
      } else {
        for (std::size_t i = 0; i < kLanes; ++i)
          sum_ += flat_->occluded(origin,
                                  Point(ends[0].lane[i], ends[1].lane[i], ends[2].lane[i]) - origin)
                      ? 1
                      : 0;
      }
    }
    return kFans * kLanes;
  }

 private:
  using Ends = std::array<LaneArray, 3>;
  static constexpr std::size_t kSets = 64;

  const FlatIntersector* flat_;
  const RaySet* set_;
  bool together_;
  std::array<Ends, kSets> ends_;
  std::size_t next_ = 0;
  int sum_ = 0;
};

}  // namespace pathmark::bench
