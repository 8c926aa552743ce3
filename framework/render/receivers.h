// Receivers: the first surfaces of a block's pixels, as receivers of light from one point, a vector
// of them at a time.
//
//   put, takeAway   the surface of a pixel; none at first
//   look            what each of them sees of a point of another surface
#pragma once

#include "render/scene_core.h"

#include <cstdint>
#include <vector>

namespace pathmark {

class Receivers {
 public:
  explicit Receivers(std::size_t pixels);

  void put(std::size_t pixel, const Hit& surface);
  void takeAway(std::size_t pixel);

  // What all pixels but one see of the point y, from its front. Returns the number of shadow rays.
  std::uint64_t look(const SceneCore& core, const Hit& y, std::size_t except);

  // By the last look:
  // whether the pixel sees y, which then lies in front of its surface;
  bool sees(std::size_t pixel) const { return cosX(pixel) > 0.0f; }
  // the unit vector towards y;
  Vector wi(std::size_t pixel) const {
    const Group& group = groups_[pixel / kLanes];
    const std::size_t lane = pixel % kLanes;
    return {group.wi[0].lane[lane], group.wi[1].lane[lane], group.wi[2].lane[lane]};
  }
  // its cosine with the surface's normal;
  float cosX(std::size_t pixel) const { return groups_[pixel / kLanes].cosX.lane[pixel % kLanes]; }
  // and how much solid angle y has per area of its surface: the cosine there over the squared
  // distance.
  float perArea(std::size_t pixel) const {
    return groups_[pixel / kLanes].perArea.lane[pixel % kLanes];
  }

 private:
  struct Group {
    LaneArray p[3], n[3];  // NaN where there is no surface
    LaneArray origin[3];   // of rays that leave the surface's front
    LaneArray wi[3], cosX, perArea;
  };

  std::vector<Group> groups_;
};

}  // namespace pathmark
