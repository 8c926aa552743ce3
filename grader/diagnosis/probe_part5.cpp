// The path tracer, among the stand-ins that the checks use: see checks/part5_checks.cpp.
#include "checks/hollow.h"
#include "checks/matt_room.h"
#include "checks/standins/beam.h"
#include "checks/standins/leaning.h"
#include "diagnosis/path_means.h"

#include <fmt/format.h>

#include <vector>

namespace pathmark::diagnosis {

namespace {

using namespace checks;

PathQuestion furnace(const ProbeRun& run, const Colour& kd, const Colour& emission,
                     const FurnaceRays& rays) {
  Random random(51);
  const Hollow hollow(random);
  return furnaceQuestion(run, hollow, random, kd, emission, rays);
}

void probeFurnaces(const ProbeRun& run, Signature& signature) {
  addPathMeans(run,
               furnace(run, {0.3f, 0.2f, 0.1f}, {1.0f, 0.5f, 2.0f},
                       {{0, 2}, {1, 2, 3, 8}, {0.9, 0.3}, "in a furnace with a roulette of 0.3"}),
               signature);
  // The stand-in for the roulette lets all paths live here.
  PathQuestion lasting =
      furnace(run, {0.5f, 0.0f, 0.75f}, {1.0f, 0.5f, 2.0f},
              {{0, 1, 2}, {1, 2, 3}, {0.6}, "in a furnace where no path ends early"});
  lasting.paths = 2048;  // the weight of a bounce changes little
  addPathMeans(run, lasting, signature);
  addPathMeans(
      run,
      furnace(run, {0.4f, 0.3f, 0.0f}, {1.0f, 0.5f, 2.0f},
              {{0, 1, 2}, {2, 3}, {0.8}, "in a furnace whose roulette is told by its depth"}),
      signature);
  addPathMeans(run,
               furnace(run, {0.75f, 0.0f, 0.25f}, {0.5f, 8.0f, 40.0f},
                       {{0, 2}, {1, 4}, {0.5}, "in a bright furnace"}),
               signature);
}

// Between two spheres that emit and reflect alike: a path that goes on from the wrong place or in
// the wrong direction sees another one.
void probeRooms(const ProbeRun& run, Signature& signature) {
  const MattRoom room(52);
  run.worker.loadScene(room.scene().flat());
  PathQuestion question{{}, {0, 2}, Colour(1.0f), 512};
  for (int wall = 0; wall < MattRoom::kWalls; ++wall) {
    const glm::dvec3 eye(1.4, 1.2, 1.3), target = room.point(wall, 0.4, 0.6);
    for (const int bounces : {1, 2})
      question.rays.push_back(
          {{{Point(eye), Vector(glm::normalize(target - eye))}, bounces},
           fmt::format("radiance from wall {} of a room, maxBounces() = {}", wall + 1, bounces)});
  }
  addPathMeans(run, question, signature);
}

// Where paths that are right elsewhere may go wrong: over the emission of the wall.
void probeUnusualFurnaces(const ProbeRun& run, Signature& signature) {
  struct Furnace {
    float exponent, scale;  // of the material, of the sphere
    int bounces;
    const char* words;
  };
  const Furnace furnaces[] = {
      {leaning::kExponent, 1.0f, 3, "in a furnace with directions of unequal density"},
      {beam::kLeastExponent, 1.0f, 40, "in a bright furnace after many bounces"},
      {leaning::kExponent, 2e-3f, 3, "in a small furnace"}};
  for (const Furnace& f : furnaces) {
    Random random(53);
    Hollow hollow(random);
    hollow.centre *= f.scale;
    hollow.radius *= f.scale;
    SceneBuilder builder;
    builder.sphere({.kd = Colour(0.8f, 0.0f, 0.8f),
                    .emission = Colour(1.0f),
                    .ks = Colour(0.125f),
                    .exponent = f.exponent},
                   hollow.centre, hollow.radius, true);
    run.worker.loadScene(builder.flat());
    const std::string what =
        fmt::format("radiance over emission, {}, maxBounces() = {}", f.words, f.bounces);
    addPathMeans(run, {{{{hollow.rayAt(0.6, random), f.bounces}, what}}, {0, 2}}, signature);
  }
}

// A matt plate in a bright sphere, from behind; and its lit front with no bounces.
void probeDarkness(const ProbeRun& run, Signature& signature) {
  SceneBuilder builder;
  builder.sphere({.kd = Colour(0.5f), .emission = Colour(1.0f)}, Point(0.0f), 4.0f, true)
      .parallelogram({.kd = Colour(0.5f)}, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
  run.worker.loadScene(builder.flat());
  const Ray back{{0.1f, -2, 0.2f}, {0, 1, 0}}, front{{0.1f, 2, 0.2f}, {0, -1, 0}};
  addPathMeans(run,
               {{{{back, 3}, "radiance of the back of a plate in a bright sphere"},
                 {{front, 0}, "radiance of a lit plate, maxBounces() = 0"}},
                {0}},
               signature);
}

void probeEmission(const ProbeRun& run, Signature& signature) {
  const Colour emission(3, 2, 1);
  SceneBuilder builder;
  builder.parallelogram({.kd = Colour(0.5f), .emission = emission}, {-1, -1, 0}, {2, 0, 0},
                        {0, 2, 0});
  run.worker.loadScene(builder.flat());
  PathQuestion question{{}, {0}, emission, 1};
  const Ray front{{0.3f, 0.2f, 2}, {0, 0, -1}}, back{{0.3f, 0.2f, -2}, {0, 0, 1}},
      past{{5, 0, 2}, {0, 0, -1}};
  for (const int bounces : {0, 8}) {
    const std::string where = fmt::format(" over emission, maxBounces() = {}", bounces);
    question.rays.push_back({{front, bounces}, "radiance of a lamp that is seen" + where});
    question.rays.push_back({{back, bounces}, "radiance of a lamp's back" + where});
    question.rays.push_back({{past, bounces}, "radiance where a ray meets nothing" + where});
  }
  addPathMeans(run, question, signature);
}

}  // namespace

Signature probePart5(const ProbeRun& run) {
  Signature signature;
  probeEmission(run, signature);
  probeFurnaces(run, signature);
  probeRooms(run, signature);
  probeUnusualFurnaces(run, signature);
  probeDarkness(run, signature);
  return signature;
}

}  // namespace pathmark::diagnosis
