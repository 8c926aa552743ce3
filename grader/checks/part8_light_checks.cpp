// What is asked of 8.3 before lights that can be sampled. Its worker has the stand-ins of part 5's;
// that of part 2 gives points of rectangles.
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/hollow.h"
#include "checks/lit_room.h"
#include "checks/lopsided_furnace.h"
#include "checks/part8_checks.h"
#include "checks/part8_rooms.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/standins/lopsided.h"
#include "checks/standins/sampled_sphere.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace pathmark::checks::path {

namespace {

using F = CourseworkFunction;

constexpr double kDelta = 0.005, kTwoPi = 2.0 * std::numbers::pi;

// Of a light sample against the stand-in BRDF's uniform density.
double lightWeight(const LightTerms& t) {
  const double light = t.density * t.distance * t.distance / t.cosY,
               brdf = lopsided::kShareOfSamples / kTwoPi;
  return light * light / (light * light + brdf * brdf);
}

struct MisMistake {
  const char* words;
  Kernel kernel;
};

constexpr MisMistake kMistakes[] = {
    {"direct light is counted twice, both ways fully: without weights",
     [](const LightTerms& t) { return 2.0 * rightKernel(t); }},
    {"the half that light samples find is all: the emission of a light that the path meets is left "
     "out, or its last ray is",
     [](const LightTerms& t) { return lightWeight(t) * rightKernel(t); }},
    {"the half that the path meets by itself is all: light samples are left out",
     [](const LightTerms& t) { return (1.0 - lightWeight(t)) * rightKernel(t); }},
    {"light samples are weighted, but not the emission of a light that the path meets",
     [](const LightTerms& t) { return (1.0 + lightWeight(t)) * rightKernel(t); }},
    {"the emission of a light that the path meets is weighted, but not the light samples, or the "
     "density in their weight is asked for a wo below the surface: it is -ray.direction",
     [](const LightTerms& t) { return (2.0 - lightWeight(t)) * rightKernel(t); }},
    {"the weights are those of densities per unit area and per unit solid angle, mixed",
     [](const LightTerms& t) {
       const double area = t.density, brdf = lopsided::kShareOfSamples / kTwoPi;
       const double mixed = area * area / (area * area + brdf * brdf);
       return (1.0 - lightWeight(t) + mixed) * rightKernel(t);
     }},
};

glm::dvec3 expected(Kernel kernel, const LitRoom& room) { return radianceBy(kernel, room); }

// Channels in which there is something to see.
std::vector<int> litChannels(const glm::dvec3& radiance, Black black) {
  std::vector<int> lit;
  for (int channel = 0; channel < 3; ++channel)
    if (radiance[channel] > 0.0 && channel != (black == Black::kRed ? 0 : 1))
      lit.push_back(channel);
  return lit;
}

// Along one ray through the scene that the worker has.
Finding judgeRay(CheckRun& run, const PathRay& ray, std::uint32_t paths, const glm::dvec3& right,
                 const std::vector<int>& lit, const std::string& where,
                 const std::vector<Suspicion>& suspicions) {
  std::vector<Mean> means;
  for (const int channel : lit)
    means.push_back({.what = inChannel("radiance", channel),
                     .expected = right[channel],
                     .delta = kDelta,
                     .scale = right[channel]});
  PathEstimates estimates(run, {ray}, paths);
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> all(3 * count);
    estimates.measure(first, count, all);
    for (std::size_t r = 0; r < count; ++r)
      for (std::size_t k = 0; k < lit.size(); ++k)
        values[r * lit.size() + k] = all[3 * r + static_cast<std::size_t>(lit[k])];
  };
  Finding finding = judgeMeans(run, means, measure, where, suspicions);
  finding.calls = estimates.paths();
  return finding;
}

Finding judge(CheckRun& run, const Case& c, std::uint64_t seed) {
  run.worker.loadScene(sceneOf(c));
  const glm::dvec3 right = expected(rightKernel, c.room);
  const std::vector<int> lit = litChannels(right, c.black);
  std::vector<Suspicion> suspicions;
  if (c.room.lights.size() == 1 && c.room.receiver.lopsided && !c.isDark)
    for (const MisMistake& mistake : kMistakes) {
      const glm::dvec3 wrong = expected(mistake.kernel, c.room);
      suspicions.push_back({mistake.words, {}});
      for (const int channel : lit) suspicions.back().means.push_back(wrong[channel]);
    }
  CheckRun own{run.worker, seed, run.budget, run.function};
  return judgeRay(own, c.ray(), c.paths, right, lit,
                  fmt::format("{}, maxBounces() = 1\n{}", c.what, c.room.text()), suspicions);
}

// What a case asks that plainer ones before it have not.
std::string causeOf(const Case& c) {
  if (!c.room.receiver.lopsided)
    return "the density in the weight of a light sample is hit.brdf->pdf(wo, wi, n), with the wo "
           "of this hit, -ray.direction";
  if (c.isDark)
    return "what is black in one channel, or dark, is taken for black: compare with Colour(0)";
  if (c.room.lights.size() > 1)
    return "one of several lights: its probability belongs in both weights, and the light that the "
           "path meets is hit.light, which may be another than the one that was sampled";
  return {};
}

Finding directLight(CheckRun& run) {
  Finding worst;
  std::uint64_t calls = 0, seed = run.seed;
  for (const Case& c : directLightCases(run.seed)) {
    const Finding finding = judge(run, c, ++seed);
    calls += finding.calls;
    if (worst.passed()) worst = finding;
    if (!finding.passed()) {
      if (finding.status == Status::kFail && worst.cause.empty()) worst.cause = causeOf(c);
      break;
    }
  }
  worst.calls = calls;
  return worst;
}

// Variance of one path over the squared mean.
double relativeVariance(CheckRun& run, const Case& c, std::uint64_t& calls) {
  constexpr std::uint32_t kPaths = 1u << 13;
  run.worker.loadScene(sceneOf(c));
  PathEstimates estimates(run, {c.ray()}, 1);
  std::vector<double> values(3 * kPaths);
  estimates.measure(0, kPaths, values);
  calls += estimates.paths();
  const double mean = expected(rightKernel, c.room).x;
  double sum = 0.0;
  for (std::size_t k = 0; k < kPaths; ++k)
    sum += (values[3 * k] / mean - 1.0) * (values[3 * k] / mean - 1.0);
  return sum / kPaths;
}

// The same of light samples alone, uniform on one light: the second moment over the squared mean,
// less one.
double varianceOfLightSamples(const LitRoom& room) {
  const RoomLight& light = room.lights[0];
  const double factor = double{kReceiverKd.x} * double{light.emission.x} / std::numbers::pi;
  const Kernel squared = [](const LightTerms& t) { return rightKernel(t) * rightKernel(t); };
  const double mean = expected(rightKernel, room).x / factor;
  return light.area() * (expected(squared, room).x / factor) / (mean * mean) - 1.0;
}

// A light so near that points of it are a bad guess, and one so small that directions are: by
// either way alone the variance is above a hundred, by both it is about 1, and no path counts for
// much more than the mean.
Finding bothWays(CheckRun& run) {
  constexpr double kMost = 10.0;
  Random random(run.seed);
  Exact exact;
  bool nearFails = false, smallFails = false, lightSamplesAlone = false;
  std::uint64_t calls = 0;
  for (const bool near : {true, false}) {
    const Case c{
        near ? "a light close by" : "a small light",
        below({near ? above(random, 0.05, 2.0, 2.0) : above(random, 1.0, 0.1, 0.1)}, random)};
    const double variance = relativeVariance(run, c, calls);
    const bool right = exact.holds(
        variance <= kMost,
        fmt::format("paths whose variance is at most {:g} squared means of them", kMost),
        [&] { return fmt::format("{:.3g} squared means", variance); },
        [&] { return fmt::format("{}\n{}", c.what, c.room.text()); });
    (near ? nearFails : smallFails) = !right;
    if (near) {
      const double alone = varianceOfLightSamples(c.room);
      lightSamplesAlone = variance > 0.7 * alone && variance < 1.4 * alone;
    }
  }
  exact.count(calls);
  Finding finding = exact.finding();
  if (nearFails && smallFails)
    finding.cause = "the weights are exchanged: each sample has the weight of the other way";
  else if (nearFails)
    finding.cause = lightSamplesAlone ? "direct light comes from light samples alone, as in part 5"
                                      : "the near light is noisy: what the BRDF's directions find "
                                        "counts too little, or their paths end too early. Are both "
                                        "densities of a weight per unit solid angle? Is the "
                                        "roulette shown the updated throughput?";
  else if (smallFails)
    finding.cause = "direct light comes from the lights that paths meet by themselves alone";
  return finding;
}

// A weight that takes the density of another hit than its own is wrong from the second hit on.
Finding laterHits(CheckRun& run) {
  Random random(run.seed);
  constexpr int kBounces = 3;
  const ConeInBox box(random);
  run.worker.loadScene(box.scene());
  const std::vector<int> lit(ConeInBox::kLit.begin(), ConeInBox::kLit.end());
  const auto judgeUpTo = [&](int bounces) {
    return judgeRay(run, box.ray(bounces), 512, box.radiance(bounces), lit,
                    fmt::format("{}, maxBounces() = {}", box.text(), bounces), {});
  };
  Finding finding = judgeUpTo(kBounces);
  if (finding.status != Status::kFail) return finding;
  const Finding atFirst = judgeUpTo(1);
  finding.calls += atFirst.calls;
  if (atFirst.passed())
    finding.cause =
        "with maxBounces() = 1 it is right: from the second hit on something is still that of an "
        "earlier one. The weight of a light that the path meets has the density of the direction "
        "drawn last";
  return finding;
}

// The furnace's direct light at one hit, where the half that light samples find is left out:
// uniform by area, their density per unit solid angle is cos(wi) / pi.
double withoutOwnLight(const LopsidedFurnace& furnace, double cosine) {
  constexpr int kSteps = 4096;
  constexpr double kBrdf = lopsided::kShareOfSamples / kTwoPi;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double c = (k + 0.5) / kSteps, density = c / std::numbers::pi;
    const double found = kBrdf * kBrdf / (kBrdf * kBrdf + density * density);
    sum += found * lopsided::shape(cosine, c) * c / kSteps;
  }
  return furnace.emission * (1.0 + 2.0 * furnace.kd * sum);
}

// Of a sphere that part 2's stand-in gives points of, the inside lights itself.
Finding ownLight(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random, 2.0f * kSampledRadius);
  const Colour kd(0.6f, 0.0f, 0.8f), emission(1.0f, 0.5f, 2.0f);
  constexpr double kCosine = 0.7;
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  const std::vector<int> lit{0, 2};
  glm::dvec3 right(0.0);
  Suspicion skipped{
      "the light that a hit is on gives it no light samples: the inside of a sphere lights itself",
      {}};
  for (const int channel : lit) {
    const LopsidedFurnace furnace{double{emission[channel]}, double{kd[channel]}};
    right[channel] = furnace.radiance(kCosine, 1);
    skipped.means.push_back(withoutOwnLight(furnace, kCosine));
  }
  return judgeRay(run, {hollow.rayAt(kCosine, random), 1}, 512, right, lit,
                  fmt::format("inside a sphere that emits {} everywhere and of which light samples "
                              "are taken, maxBounces() = 1",
                              text(emission)),
                  {skipped});
}

}  // namespace

std::vector<Check> lightChecks() {
  return {
      {"direct-light", F::kTracePathMis,
       "the mean radiance of a surface before lights is the light that they send, found in two "
       "ways and counted once",
       kDelta, directLight},
      {"later-hits", F::kTracePathMis,
       "the weights at each hit are those of its own densities, not of another hit's", kDelta,
       laterHits},
      {"own-light", F::kTracePathMis,
       "a light that the hit is on gives light samples as all others do", kDelta, ownLight},
      {"unfair-roulette", F::kTracePathMis,
       "RussianRoulette is asked after each update of the throughput, with the updated throughput "
       "and the number of scattering events so far, and what it says is done",
       kRouletteDelta, unfairRoulette},
      {"both-ways", F::kTracePathMis,
       "lights are found both by points on them and by the path itself, so that neither a near "
       "light nor a small one is noisy",
       0.0, bothWays},
  };
}

}  // namespace pathmark::checks::path
