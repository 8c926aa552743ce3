// How many rays intersectors make in a second.
//
//   RaySubject   a scene with its rays and all intersectors that can be used with it
//   RayRates     what they made
//   FanRates     what the flat loop made of shadow rays from common points
#pragma once

#include "bench/raw_embree.h"
#include "bench/ray_loops.h"
#include "bench/report.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace pathmark::bench {

// Rays per CPU second; 0 where an intersector was not measured.
struct RayRates {
  double flat = 0.0, embree = 0.0, raw = 0.0;
};

// The same, of shadow rays from one point to several of a lamp.
struct FanRates {
  double together = 0.0, apart = 0.0;
};

class RaySubject {
 public:
  enum class Ways { kAll, kFlatOnly, kEmbreeOnly, kRawOnly };  // kEmbreeOnly: raw too

  // `name` stands for the number of primitives where there is one.
  RaySubject(RayScene scene, Ways ways, std::string name = "");
  RaySubject(const RaySubject&) = delete;  // the intersectors look at the scene
  RaySubject& operator=(const RaySubject&) = delete;

  std::size_t primitives() const {
    return scene_.flat.triangles.size() + scene_.flat.spheres.size();
  }
  Cell label() const {
    return name_.empty() ? Cell(static_cast<double>(primitives())) : Cell(name_);
  }

  // In turns; `seconds` for each intersector.
  RayRates rates(RayKind kind, double seconds) const;

  // How many independent rays there are.
  std::size_t rays() const { return set_.rays.size(); }

  // Raw Embree's rate with each number of independent rays over and over, in turns.
  std::vector<double> rawRates(std::span<const std::size_t> numbers, double seconds) const;

  // The share of the independent rays that meet something. A ray that meets nothing costs little.
  double hitShare() const;

  // The flat loop's.
  FanRates fanRates(double seconds) const;

  // The share of the independent rays for which the flat loop and Embree find different distances.
  // Different rounding at an edge makes a few of a million.
  double disagreement() const;

 private:
  RayScene scene_;
  std::string name_;
  RaySet set_;
  std::optional<FlatRays> flat_;
  std::optional<EmbreeRays> embree_;
  std::optional<RawEmbree> raw_;
};

}  // namespace pathmark::bench
