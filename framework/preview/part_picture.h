// PartPicture: how the picture of a part is made, so that the part's own functions are in it.
//
//   isPart          whether there is a part of functions with this number
//   pictureOfPart   of each part
//   wayWords        for the eye; empty for what most parts have
#pragma once

#include "render/render_job.h"
#include "scene/flat_scene.h"
#include "worker/contract.h"

#include <algorithm>
#include <string_view>

namespace pathmark::preview {

struct PartPicture {
  Estimator estimator = Estimator::kPath;
  LightSampling lightSampling = LightSampling::kByArea;
};

inline bool isPart(int number) {
  const auto all = parts();
  return std::any_of(all.begin(), all.end(),
                     [number](const PartContract& p) { return p.part == number; });
}

inline PartPicture pictureOfPart(int part) {
  switch (part) {
    case 0:
      return {.estimator = Estimator::kWarmUp};
    case 8:
      return {.estimator = Estimator::kMis};
    case 9:
      return {.lightSampling = LightSampling::kBySolidAngle};
    default:
      return {};
  }
}

inline std::string_view wayWords(const PartPicture& picture) {
  if (picture.estimator == Estimator::kWarmUp) return "get_ray_radiance";
  if (picture.estimator == Estimator::kMis) return "tracePathMIS";
  if (picture.lightSampling == LightSampling::kBySolidAngle) return "lights by solid angle";
  return {};
}

}  // namespace pathmark::preview
