#include "render/path_filter.h"

#include "sampling/mix.h"

#include <limits>

namespace pathmark {

namespace {

// Keeps the filter's numbers apart from the samplers', which are made of the same seeds.
constexpr std::uint64_t kStream = 0x6c6967687470617full;

float distance2(const Point& a, const Point& b) {
  const Vector difference = a - b;
  return dot(difference, difference);
}

}  // namespace

PathFilter::PathFilter(const SceneCore& scene, const PathAutomaton& automaton, const Point& eye,
                       std::uint64_t seed)
    : scene_(scene),
      automaton_(automaton),
      eye_(eye),
      seedKey_(mix(mix(seed + kGolden) ^ kStream)) {}

void PathFilter::startPixel(int i, int j, std::uint64_t raysBefore) {
  const auto column = static_cast<std::uint32_t>(i), row = static_cast<std::uint32_t>(j);
  const std::uint64_t pixel = (static_cast<std::uint64_t>(row) << 32) | column;
  random_ = mix(mix(seedKey_ + pixel + kGolden) + raysBefore + kGolden);
  path_.clear();
}

bool PathFilter::follows(const Point& origin) {
  const Vertex* start = nearestVertex(origin);
  if (start == nullptr || distance2(origin, eye_) < distance2(origin, start->p)) {
    path_.clear();
    before_ = automaton_.start;
    return before_ != PathAutomaton::kDead;
  }
  before_ = start->state;
  return before_ != PathAutomaton::kDead;
}

void PathFilter::meet(Hit& hit) {
  if (!automaton_.lightMayCome(before_)) hit.emission = Colour(0.0f);
  path_.push_back({hit.p, scatter(hit.brdf)});
}

bool PathFilter::lightMayCome(const Point& surface) const {
  const Vertex* vertex = nearestVertex(surface);
  return vertex != nullptr && automaton_.lightMayCome(vertex->state);
}

// The latest of equally near ones: a ray may be followed twice.
const PathFilter::Vertex* PathFilter::nearestVertex(const Point& p) const {
  const Vertex* nearest = nullptr;
  float least = std::numeric_limits<float>::infinity();
  for (const Vertex& vertex : path_)
    if (const float distance = distance2(p, vertex.p); distance <= least) {
      nearest = &vertex;
      least = distance;
    }
  return nearest;
}

// Returns the state after a scattering event here, and leaves the lobe that scatters.
PathAutomaton::State PathFilter::scatter(const BRDF*& brdf) {
  const MaterialLobes& lobes = scene_.lobesOf(*brdf);
  const LobeShares& shares = lobes.shares();
  const PathAutomaton::State diffuse = automaton_.next(before_, Lobe::kDiffuse);
  const PathAutomaton::State specular = automaton_.next(before_, Lobe::kSpecular);
  if (!shares.hasBoth()) return shares.specular > 0.0f ? specular : diffuse;
  if (diffuse == specular) return diffuse;
  const bool onlyDiffuse = specular == PathAutomaton::kDead;
  const bool onlySpecular = diffuse == PathAutomaton::kDead;
  const Lobe lobe = onlyDiffuse || (!onlySpecular && number() < shares.diffuse) ? Lobe::kDiffuse
                                                                                : Lobe::kSpecular;
  brdf = onlyDiffuse || onlySpecular ? &lobes.alone(lobe) : &lobes.overShare(lobe);
  return lobe == Lobe::kDiffuse ? diffuse : specular;
}

float PathFilter::number() {
  random_ += kGolden;
  return static_cast<float>(mix(random_) >> 40) * 0x1p-24f;
}

}  // namespace pathmark
