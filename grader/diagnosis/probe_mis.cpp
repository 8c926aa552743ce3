// The path tracer with multiple importance sampling, among the stand-ins that the checks use. How
// many points of which lights it takes is left open, and whether a roulette comes before the light
// that the ray finds: what depends on either is no feature.
#include "diagnosis/mis_probe.h"

#include "checks/lopsided_furnace.h"
#include "checks/part8_rooms.h"
#include "checks/standins/sampled_sphere.h"
#include "checks/standins/unfair_roulette.h"
#include "diagnosis/path_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;
using path::Case;

const Colour kEmission(1.0f, 0.5f, 2.0f);

PathQuestion furnace(const ProbeRun& run, const Colour& kd, const FurnaceRays& rays,
                     float size = 1.0f) {
  Random random(81);
  const Hollow hollow(random, size);
  return furnaceQuestion(run, hollow, random, kd, kEmission, rays);
}

void probeFurnaces(const ProbeRun& run, Signature& signature) {
  addPathMeans(run,
               furnace(run, {0.5f, 0.0f, 0.75f},
                       {{0, 1, 2}, {0, 1, 2, 3}, {0.6}, "in a furnace where no path ends early"}),
               signature);
  addPathMeans(run,
               furnace(run, {0.0f, 0.6f, 0.8f},
                       {{0, 1, 2}, {1, 2, 3}, {0.6}, "in a furnace that is black in red"}),
               signature);
  addPathMeans(
      run,
      furnace(run, {0.6f, 0.0f, 0.8f},
              {{0, 2}, {0, 1, 2}, {0.7}, "inside a sphere of which light samples are taken"},
              2.0f * kSampledRadius),
      signature);
}

// Radiance over what is right with one bounce, in the brightest channel.
PathQuestion questionOf(const Case& c, const std::vector<int>& bounces) {
  const glm::dvec3 right = radianceBy(rightKernel, c.room);
  const auto largest = static_cast<float>(std::max({right.x, right.y, right.z}));
  PathQuestion question{{}, {c.black == path::Black::kRed ? 1 : 0, 2}, Colour(largest), 1024};
  for (const int b : bounces) {
    PathRay ray = c.ray();
    ray.bounces = b;
    question.rays.push_back({ray, fmt::format("relative radiance of a surface before {}, "
                                              "maxBounces() = {}",
                                              c.what, b)});
  }
  return question;
}

// Alike from the receiver, so that each way of choosing among them is as likely to take any.
Case threeLights(Random& random) {
  Case c{"three lights that are alike", path::below({}, random)};
  for (int k = 0; k < 3; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / 3.0;
    const glm::dvec3 out(std::cos(turn), 0.0, std::sin(turn)), across(-out.z, 0.0, out.x),
        up(0.0, 1.0, 0.0);
    const glm::dvec3 centre = 0.8 * out + 0.8 * up, side = 0.3 * across,
                     rise = 0.3 * glm::normalize(up - out);
    RoomLight light;
    light.emission = kEmission;
    for (const glm::dvec3& p :
         {centre - side - rise, centre - side + rise, centre + side + rise, centre + side - rise})
      light.vertices.emplace_back(p);
    const glm::dvec3 normal = glm::cross(glm::dvec3(light.vertices[1] - light.vertices[0]),
                                         glm::dvec3(light.vertices[2] - light.vertices[0]));
    if (glm::dot(normal, centre) > 0.0) std::reverse(light.vertices.begin(), light.vertices.end());
    c.room.lights.push_back(light);
  }
  return c;
}

void probeLights(const ProbeRun& run, Signature& signature) {
  Random random(82);
  std::vector<Case> cases{threeLights(random)};
  for (Case& c : path::directLightCases(83))
    if (c.room.lights.size() == 1) cases.push_back(std::move(c));
  for (const Case& c : cases) {
    run.worker.loadScene(sceneOf(c));
    std::vector<int> bounces{1};
    if (!c.isDark) bounces.push_back(0);
    // The lights are not alike from one another.
    if (!c.isDark && c.room.lights.size() == 1) bounces.push_back(2);
    addPathMeans(run, questionOf(c, bounces), signature);
  }
}

// Of a matt surface nothing depends on wo.
void probeMatt(const ProbeRun& run, Signature& signature) {
  SceneBuilder builder;
  builder.parallelogram({.emission = kEmission}, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2})
      .parallelogram({.kd = Colour(0.8f)}, {-0.1f, 0, -0.1f}, {0, 0, 0.2f}, {0.2f, 0, 0});
  run.worker.loadScene(builder.flat());
  const Ray ray{{0.3f, 0.4f, 0}, normalize(Vector(-0.3f, -0.4f, 0))};
  addPathMeans(run,
               {{{{ray, 1}, "radiance over emission of a matt surface before one light"}},
                {0, 2},
                kEmission,
                1024},
               signature);
}

void probeLaterHits(const ProbeRun& run, Signature& signature) {
  Random random(84);
  const path::ConeInBox box(random);
  run.worker.loadScene(box.scene());
  const glm::dvec3 right = box.radiance(1);
  PathQuestion question{{}, {0, 2}, Colour(right.x, 1.0, right.z), 512};
  for (const int bounces : {1, 2, 3})
    question.rays.push_back(
        {box.ray(bounces), fmt::format("relative radiance of a surface that reflects into a narrow "
                                       "cone, in a box, maxBounces() = {}",
                                       bounces)});
  addPathMeans(run, question, signature);
}

// Red's mean radiance along one ray, and its variance for one path.
struct Moments {
  double mean = 0.0, variance = 0.0;
};

Moments momentsOf(const ProbeRun& run, const PathRay& ray, std::uint32_t paths) {
  stats::ErrorBudget budget;
  CheckRun own{run.worker, run.seed, budget, run.function};
  PathEstimates estimates(own, {ray}, 1);
  std::vector<double> values(std::size_t{3} * paths);
  estimates.measure(0, paths, values);
  Moments moments;
  for (std::size_t k = 0; k < paths; ++k) moments.mean += values[3 * k] / paths;
  for (std::size_t k = 0; k < paths; ++k) {
    const double off = values[3 * k] - moments.mean;
    moments.variance += off * off / paths;
  }
  return moments;
}

// With both ways the variance is about one squared mean, with the wrong one alone above a hundred.
void probeNoise(const ProbeRun& run, Signature& signature) {
  constexpr double kMost = 10.0;
  Random random(85);
  for (const bool near : {true, false}) {
    const Case c{near ? "a light close by" : "a small light",
                 path::below({near ? path::above(random, 0.05, 2.0, 2.0)
                                   : path::above(random, 1.0, 0.1, 0.1)},
                             random)};
    run.worker.loadScene(sceneOf(c));
    const double right = radianceBy(rightKernel, c.room).x;
    const Moments moments = momentsOf(run, c.ray(), 1u << 13);
    signature.addAnswer(fmt::format("whether paths before {} have a variance above {:g} squared "
                                    "means",
                                    c.what, kMost),
                        moments.variance > kMost * right * right);
  }
}

// Wherever the roulette comes, one that is not fair changes the mean.
void probeRoulette(const ProbeRun& run, Signature& signature) {
  constexpr double kCosine = 0.8;
  constexpr int kBounces = 2;
  Random random(86);
  const Hollow hollow(random);
  const LopsidedFurnace furnace{1.0, 0.9};
  run.worker.loadScene(furnaceIn(hollow, {0.9f, 0.8f, 0.0f}, kEmission));
  const double fair = furnace.radiance(kCosine, kBounces);
  double least = std::numeric_limits<double>::infinity();
  for (const LightBefore before : {LightBefore::kNone, LightBefore::kLast, LightBefore::kAll})
    least = std::min(
        least,
        std::abs(unfairMisRadiance(furnace, kCosine, kBounces, before, unfair::factor) - fair));
  const Moments moments = momentsOf(run, {hollow.rayAt(kCosine, random), kBounces}, 1u << 15);
  signature.addAnswer("whether a roulette that is not fair changes the radiance in a furnace",
                      std::abs(moments.mean - fair) > 0.5 * least);
}

}  // namespace

Signature probePathMis(const ProbeRun& run) {
  Signature signature;
  probeFurnaces(run, signature);
  probeLights(run, signature);
  probeMatt(run, signature);
  probeLaterHits(run, signature);
  probeNoise(run, signature);
  probeRoulette(run, signature);
  return signature;
}

}  // namespace pathmark::diagnosis
