#include "bench/ray_rates.h"

#include "bench/fan_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pathmark::bench {

RaySubject::RaySubject(RayScene scene, Ways ways, std::string name)
    : scene_(std::move(scene)), name_(std::move(name)), set_(prepareRays(scene_)) {
  const FlatSceneView view = viewOf(scene_.flat);
  if (ways == Ways::kAll || ways == Ways::kFlatOnly) flat_.emplace(view);
  if (ways == Ways::kAll || ways == Ways::kEmbreeOnly) embree_.emplace(view);
  if (ways != Ways::kFlatOnly) raw_.emplace(view);
}

RayRates RaySubject::rates(RayKind kind, double seconds) const {
  std::vector<Work> ways;
  std::vector<double RayRates::*> fields;
  const auto add = [&](const auto& rays, double RayRates::*field) {
    if (!rays) return;
    ways.push_back(loopOf(kind, *rays, scene_, set_));
    fields.push_back(field);
  };
  add(flat_, &RayRates::flat);
  add(embree_, &RayRates::embree);
  add(raw_, &RayRates::raw);
  const std::vector<double> measured = alternate(ways, seconds);
  RayRates rates;
  for (std::size_t k = 0; k < fields.size(); ++k) rates.*fields[k] = measured[k];
  return rates;
}

std::vector<double> RaySubject::rawRates(std::span<const std::size_t> numbers,
                                         double seconds) const {
  std::vector<Work> loops;
  loops.reserve(numbers.size());
  for (const std::size_t count : numbers)
    loops.push_back(independentLoop(*raw_, set_, count, false));
  return alternate(loops, seconds);
}

double RaySubject::hitShare() const {
  const auto met = std::count_if(set_.rays.begin(), set_.rays.end(), [&](const Ray& ray) {
    PrimitiveHit hit;
    return flat_ ? flat_->closest(ray, hit) : raw_->closest(ray, hit);
  });
  return static_cast<double>(met) / static_cast<double>(set_.rays.size());
}

FanRates RaySubject::fanRates(double seconds) const {
  const std::vector<Work> ways{FanLoop(flat_->flat, scene_, set_, true),
                               FanLoop(flat_->flat, scene_, set_, false)};
  const std::vector<double> measured = alternate(ways, seconds);
  return {measured[0], measured[1]};
}

double RaySubject::disagreement() const {
  std::size_t different = 0;
  for (const Ray& ray : set_.rays) {
    PrimitiveHit a, b;
    const bool metA = flat_->closest(ray, a), metB = embree_->closest(ray, b);
    if (metA != metB || (metA && std::abs(a.t - b.t) > 1e-3f * a.t)) ++different;
  }
  return static_cast<double>(different) / static_cast<double>(set_.rays.size());
}

}  // namespace pathmark::bench
