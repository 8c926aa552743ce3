// The scenes in which submissions are marked: like the shipped ones, but nobody has seen them.
//
//   MarkingScene      a scene of the family of a shipped one
//   scenesOfPart      those that show what a part does
//   scenesOfWhole     those of a coursework as it was submitted
#pragma once

#include "render/render_job.h"
#include "scene/flat_scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pathmark::marking {

struct MarkingScene {
  std::string name;  // "a scene like cornell_box"
  FlatScene flat;
  Estimator estimator = Estimator::kPath;
  double exposure = 1.0;  // for display
};

// By the seed they differ in colours, reflectances, exponents, in what the camera sees, and in
// where, how large and how turned the scene is in its coordinates: a mistake that happens to cancel
// where walls are parallel to the axes shows. Throws SceneError if a shipped scene is damaged.
std::vector<MarkingScene> scenesOfPart(int part, std::uint64_t seed);
std::vector<MarkingScene> scenesOfWhole(std::uint64_t seed);

}  // namespace pathmark::marking
