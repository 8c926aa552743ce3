// What each further bounce of 5.1 adds.
#include "checks/exact.h"
#include "checks/hollow.h"
#include "checks/lopsided_furnace.h"
#include "checks/part5_checks.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/standins/beam.h"
#include "checks/standins/leaning.h"
#include "checks/standins/lopsided.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace pathmark::checks::path {

namespace {

const Colour kEmission(1.0f, 0.5f, 2.0f);
constexpr std::array kLit{0, 2};  // channels that the walls reflect
constexpr int kMostBounces = 3;

// The weight of a bounce changes the radiance of the whole by much less than itself. With the same
// random numbers the paths of one bounce more are the same paths, continued: what they add has
// little noise, and an error of the weight shows in full. A wall that is black in green keeps the
// roulette's stand-in from ending paths, which would be most of the noise. With the third bounce it
// shows whether the throughput remembers the first.
struct Walls {
  Hollow hollow;
  Colour kd;
  std::uint32_t paths;   // of a replicate
  double delta;          // of the weight of one bounce
  double rounding;       // of what a bounce adds, which is small next to what is emitted
  bool leaning = false;  // of the BRDF of standins/leaning.h

  Surface surface() const {
    Surface wall = lopsidedWall(kd, kEmission);
    if (leaning) wall.exponent = leaning::kExponent;
    return wall;
  }
  // Radiance in a channel, where it is seen at this cosine.
  double radiance(int channel, double cosine, int bounces) const {
    const double emission{kEmission[channel]}, rho{kd[channel]};
    if (leaning) return emission * (1.0 - std::pow(rho, bounces + 1.0)) / (1.0 - rho);
    return LopsidedFurnace{emission, rho}.radiance(cosine, bounces);
  }
};

Finding judgeBounces(CheckRun& run, const Walls& walls, Random& random,
                     const std::vector<Suspicion>& suspicions = {}) {
  SceneBuilder builder;
  builder.sphere(walls.surface(), walls.hollow.centre, walls.hollow.radius, true);
  run.worker.loadScene(builder.flat());
  const double cosine = 0.6;
  const Ray ray = walls.hollow.rayAt(cosine, random);
  std::vector<PathEstimates> upTo;
  std::vector<Mean> ratios;
  for (int bounces = 1; bounces <= kMostBounces; ++bounces) {
    upTo.emplace_back(run, std::vector<PathRay>{{ray, bounces}}, walls.paths);
    if (bounces > 1)
      ratios.push_back({.what = fmt::format("what bounce {} adds / what it must", bounces),
                        .expected = 1.0,
                        .tolerance = walls.rounding,
                        .delta = (bounces - 1) * walls.delta});
  }
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> before(3 * count), after(3 * count);
    upTo[0].measure(first, count, before);
    for (int bounces = 2; bounces <= kMostBounces; ++bounces, std::swap(before, after)) {
      upTo[static_cast<std::size_t>(bounces - 1)].measure(first, count, after);
      for (std::size_t r = 0; r < count; ++r) {
        double& ratio = values[r * ratios.size() + static_cast<std::size_t>(bounces - 2)];
        ratio = 0.0;
        for (const int c : kLit) {
          const double added =
              walls.radiance(c, cosine, bounces) - walls.radiance(c, cosine, bounces - 1);
          const std::size_t at = 3 * r + static_cast<std::size_t>(c);
          ratio += (after[at] - before[at]) / (added * kLit.size());
        }
      }
    }
  };
  Finding finding = judgeMeans(
      run, ratios, measure,
      fmt::format("inside a sphere of radius {:.4g} that emits {} everywhere and has Kd = {}, "
                  "maxBounces() = 1 to {} with the same random numbers",
                  walls.hollow.radius, text(kEmission), text(walls.kd), kMostBounces),
      suspicions);
  for (const PathEstimates& estimates : upTo) finding.calls += estimates.paths();
  return finding;
}

constexpr double kUsualRounding = Mean{}.tolerance;
// Where the question is whether paths go on at all.
constexpr double kCoarseDelta = 0.05;

Finding usualWalls(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  Suspicion numberAgain{kNumberAgain, {}};
  for (int bounce = 2; bounce <= kMostBounces; ++bounce)
    numberAgain.means.push_back(std::pow(double{lopsided::kShareOfSamples}, 1 - bounce));
  return judgeBounces(run, {hollow, Colour(0.5f, 0.0f, 0.75f), 1024, kBounceDelta, kUsualRounding},
                      random, {numberAgain});
}

// So dark that the third bounce adds less than a ten-thousandth.
Finding darkWalls(CheckRun& run) {
  Random random(run.seed + 1);
  const Hollow hollow(random);
  Finding finding =
      judgeBounces(run, {hollow, Colour(0.05f, 0.0f, 0.03f), 256, kCoarseDelta, 5e-3}, random);
  if (finding.status == Status::kFail)
    finding.cause =
        "on brighter walls it is right: paths of small throughput are cut, which is the task of "
        "RussianRoulette alone";
  return finding;
}

// Smaller than any fixed distance that keeps rays from the surface which they leave.
Finding smallRoom(CheckRun& run) {
  constexpr float kScale = 2e-3f;
  Random random(run.seed + 2);
  Hollow hollow(random);
  hollow.centre *= kScale;
  hollow.radius *= kScale;
  Finding finding = judgeBounces(
      run, {hollow, Colour(0.5f, 0.0f, 0.75f), 256, kCoarseDelta, kUsualRounding}, random);
  if (finding.status == Status::kFail)
    finding.cause =
        "in a larger sphere it is right: the ray starts too far from the point that it leaves; "
        "hit.spawnRay(wi) is as near as rounding allows";
  return finding;
}

// Half of the light comes from directions that one sample in ten finds.
Finding unevenDensities(CheckRun& run) {
  Random random(run.seed + 4);
  const Hollow hollow(random);
  Suspicion leftOut{
      "directions of a small density are left out: only the density 0 says that there is none", {}};
  for (int bounce = 2; bounce <= kMostBounces; ++bounce)
    leftOut.means.push_back(std::pow(0.5, bounce - 1));
  return judgeBounces(run,
                      {hollow, Colour(0.5f, 0.0f, 0.75f), 1024, kCoarseDelta, kUsualRounding, true},
                      random, {leftOut});
}

// Bright walls, of which many bounces still add something. The stand-in of standins/beam.h
// multiplies the throughput by Kd at every bounce, whatever the direction: others would be too
// noisy after so many.
Finding manyBounces(CheckRun& run) {
  constexpr int kBounces = 40;
  const Colour kd(0.9f, 0.0f, 0.9f);
  Random random(run.seed + 3);
  const Hollow hollow(random);
  SceneBuilder builder;
  builder.sphere(
      {.kd = kd, .emission = kEmission, .ks = Colour(0.125f), .exponent = beam::kLeastExponent},
      hollow.centre, hollow.radius, true);
  run.worker.loadScene(builder.flat());
  PathEstimates estimates(run, {{hollow.rayAt(0.6, random), kBounces}}, 256);
  const auto upTo = [&](int bounces) {
    const double rho = double{kd.x};
    return (1.0 - std::pow(rho, bounces + 1.0)) / (1.0 - rho);
  };
  const std::vector<Mean> means{{.what = "radiance / emission, mean over red and blue",
                                 .expected = upTo(kBounces),
                                 .delta = kCoarseDelta,
                                 .scale = upTo(kBounces)}};
  std::vector<Suspicion> suspicions;
  for (const int limit : {4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 20, 30, 32})
    suspicions.push_back(
        {fmt::format("the path ends after {} bounces, though maxBounces() allows more: it may have "
                     "no limit of its own",
                     limit),
         {upTo(limit)}});
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> single(3 * count);
    estimates.measure(first, count, single);
    for (std::size_t r = 0; r < count; ++r) {
      values[r] = 0.0;
      for (const int c : kLit)
        values[r] +=
            single[3 * r + static_cast<std::size_t>(c)] / (double{kEmission[c]} * kLit.size());
    }
  };
  Finding finding =
      judgeMeans(run, means, measure,
                 fmt::format("inside a sphere that emits {} everywhere and has Kd = {}, "
                             "maxBounces() = {}",
                             text(kEmission), text(kd), kBounces),
                 suspicions);
  finding.calls = estimates.paths();
  return finding;
}

// From a small plate in the middle of a sphere: what bounce 2 adds, over what it must.
double addedFromPlate(CheckRun& run, const Vector& n) {
  constexpr float kRadius = 2.0f, kSide = 0.02f;
  constexpr double kCosine = 0.6;
  const Colour kd(0.5f, 0.0f, 0.75f);
  const Vector v1 = kSide * atCosine(n, 0.0, 0.3), v2 = cross(n, v1);
  SceneBuilder builder;
  builder.sphere(lopsidedWall(kd, kEmission), Point(0.0f), kRadius, true)
      .parallelogram(lopsidedWall(kd, Colour(0.0f)), Point(-0.5f * (v1 + v2)), v1, v2);
  run.worker.loadScene(builder.flat());
  const Vector wo = atCosine(n, kCosine, 1.0);
  const Ray ray{Point(0.1f * v1 - 0.2f * v2 + 0.5f * kRadius * wo), -wo};
  std::array<double, 3> before{}, after{};
  for (const auto& [bounces, values] : {std::pair{1, &before}, {2, &after}})
    PathEstimates(run, {{ray, bounces}}, 1u << 14).measure(0, 1, *values);
  double ratio = 0.0;
  for (const int c : kLit) {
    // Any point of the wall is seen along its normal.
    const LopsidedFurnace furnace{double{kEmission[c]}, double{kd[c]}};
    const double scattered = furnace.radiance(kCosine, 1) / furnace.emission - 1.0,
                 arriving = furnace.radiance(1.0, 1) - furnace.emission;
    const auto at = static_cast<std::size_t>(c);
    ratio += (after[at] - before[at]) / (scattered * arriving * kLit.size());
  }
  return ratio;
}

}  // namespace

void addCauseOfRoundedStart(CheckRun& run, Finding& finding) {
  if (finding.status != Status::kFail || !finding.cause.empty()) return;
  const auto isRight = [](double ratio) { return std::abs(ratio - 1.0) < 0.1; };
  Random random(run.seed + 5);
  if (isRight(addedFromPlate(run, Vector(0, 1, 0))) &&
      !isRight(addedFromPlate(run, random.direction())))
    finding.cause =
        "rays meet the surface that they leave: hit.p is rounded, and may lie behind it; "
        "hit.spawnRay(wi) starts on the right side";
}

Finding bouncesAdd(CheckRun& run) {
  Finding first = usualWalls(run);
  addCauseOfRoundedStart(run, first);
  if (!first.passed()) return first;
  for (const auto judge : {darkWalls, smallRoom, unevenDensities, manyBounces}) {
    Finding next = judge(run);
    first.calls += next.calls;
    if (next.passed()) continue;
    next.calls = first.calls;
    return next;
  }
  return first;
}

}  // namespace pathmark::checks::path
