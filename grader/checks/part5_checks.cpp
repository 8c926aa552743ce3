// What is asked of part 5, the path tracer.
//
// Its worker has stand-ins for all that tracePath calls (standins/): direct light is looked for in
// one direction, the BRDFs draw theirs uniformly, Phong's is not symmetric and says "no sample" for
// an eighth of its samples, and the roulette ends seven paths of ten.
#include "checks/part5_checks.h"
#include "checks/all_checks.h"
#include "checks/channels.h"
#include "checks/exact.h"
#include "checks/hollow.h"
#include "checks/lopsided_furnace.h"
#include "checks/matt_room.h"
#include "checks/path_estimates.h"
#include "checks/points.h"
#include "checks/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pathmark::checks {

namespace {

using namespace path;
using F = CourseworkFunction;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

// Errors that are found: of the radiance of one ray in one channel, and of all of them together.
struct Deltas {
  double one = 0.02, all = 0.005;
};

// Where the question is which way a path goes, or what the roulette was asked.
constexpr Deltas kCoarse{0.05, 0.01};

void addMeans(std::vector<Mean>& means, const std::string& what, const glm::dvec3& radiance) {
  for (int c = 0; c < 3; ++c)
    means.push_back({.what = inChannel(what, c), .expected = radiance[c], .scale = radiance[c]});
}

// The mean of all values, each over what it must be.
double meanRatio(std::span<const double> values, const std::vector<Mean>& means) {
  double sum = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) sum += values[k] / means[k].expected;
  return sum / static_cast<double>(values.size());
}

// `means`: three channels of each ray. Judged are these, and their mean ratio to what they must be,
// which has the least noise.
Finding judgePaths(CheckRun& run, const std::vector<PathRay>& rays, std::uint32_t paths,
                   const std::vector<Mean>& means, const Deltas& deltas, const std::string& where,
                   std::vector<Suspicion> suspicions = {}) {
  PathEstimates estimates(run, rays, paths);
  std::vector<Mean> all = means;
  for (Mean& mean : all) mean.delta = deltas.one;
  all.push_back({.what = "radiance / what it must be, mean over all rays",
                 .expected = 1.0,
                 .delta = deltas.all});
  for (Suspicion& s : suspicions) s.means.push_back(meanRatio(s.means, means));
  const auto measure = [&](std::uint32_t first, std::uint32_t count, std::span<double> values) {
    std::vector<double> single(count * means.size());
    estimates.measure(first, count, single);
    for (std::size_t r = 0; r < count; ++r) {
      const auto of = std::span(single).subspan(r * means.size(), means.size());
      std::copy(of.begin(), of.end(), values.begin() + static_cast<std::ptrdiff_t>(r * all.size()));
      values[r * all.size() + means.size()] = meanRatio(of, means);
    }
  };
  Finding finding = judgeMeans(run, all, measure, where, suspicions);
  finding.calls = estimates.paths();
  return finding;
}

Finding lopsidedFurnace(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  const Colour kd(0.3f, 0.2f, 0.1f), emission(1.0f, 0.5f, 2.0f);
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  std::vector<PathRay> rays;
  std::vector<Mean> means;
  std::vector<Suspicion> suspicions;
  for (const FurnaceMistake& mistake : furnaceMistakes())
    suspicions.push_back({mistake.wordsFor(run.function), {}});
  for (const int bounces : {1, 2, 3, 8})
    for (const double cosine : {0.9, 0.3}) {
      rays.push_back({hollow.rayAt(cosine, random), bounces});
      glm::dvec3 radiance;
      for (int c = 0; c < 3; ++c) {
        const LopsidedFurnace furnace{double{emission[c]}, double{kd[c]}};
        radiance[c] = furnace.radiance(cosine, bounces);
        for (std::size_t k = 0; k < suspicions.size(); ++k)
          suspicions[k].means.push_back(furnaceMistakes()[k].radiance(furnace, cosine, bounces));
      }
      addMeans(means,
               fmt::format("radiance where cos(wo) = {}, maxBounces() = {}", cosine, bounces),
               radiance);
    }
  Finding finding = judgePaths(
      run, rays, 512, means, {},
      fmt::format("inside a sphere that emits {} everywhere; a surface for testing, with a BRDF "
                  "that depends on wo and wi, and a roulette that ends 7 paths of 10",
                  text(emission)),
      suspicions);
  addCauseOfRoundedStart(run, finding);
  return finding;
}

Finding furnaceWithSphere(CheckRun& run) {
  Random random(run.seed);
  const float inner = static_cast<float>(random.between(0.5, 1.0)),
              outer = inner * static_cast<float>(random.between(2.0, 4.0));
  const Colour emission(1.0f, 0.5f, 2.0f);
  const Point centre(random.direction());
  SceneBuilder builder;
  const Surface wall{.kd = Colour(0.25f), .emission = emission};
  builder.sphere(wall, centre, outer, true).sphere(wall, centre, inner);
  run.worker.loadScene(builder.flat());
  std::vector<PathRay> rays;
  std::vector<Mean> means;
  for (const int bounces : {1, 3})
    for (const bool ball : {true, false}) {
      const Vector towards = random.direction();
      // Past the inner sphere's middle, or its limb, by this share of its radius.
      const double past = ball ? 0.7 : 1.4;
      const Point eye = centre + 0.5f * (inner + outer) * towards;
      const Vector side = atCosine(towards, 0.0, random.between(0.0, kTwoPi));
      const glm::dvec3 target = glm::dvec3(centre) + past * double{inner} * glm::dvec3(side);
      rays.push_back({{eye, Vector(glm::normalize(target - glm::dvec3(eye)))}, bounces});
      addMeans(means,
               fmt::format("radiance from the {}, maxBounces() = {}",
                           ball ? "inner sphere" : "wall", bounces),
               (4.0 - std::ldexp(1.0, -2 * bounces)) / 3.0 * glm::dvec3(emission));
    }
  return judgePaths(run, rays, 512, means, {},
                    fmt::format("between two spheres of radius {:.4g} and {:.4g} that emit {} and "
                                "reflect a quarter",
                                inner, outer, text(emission)));
}

Finding mattRoom(CheckRun& run) {
  const MattRoom room(run.seed);
  run.worker.loadScene(room.scene().flat());
  Random random(run.seed + 1);
  std::vector<PathRay> rays;
  std::vector<Mean> means;
  for (int wall = 0; wall < MattRoom::kWalls; ++wall) {
    const glm::dvec3 eye(random.between(1.2, 1.8), random.between(0.8, 1.4),
                         random.between(1.0, 1.6));
    const glm::dvec3 target =
        room.point(wall, random.between(0.25, 0.75), random.between(0.25, 0.75));
    rays.push_back({{Point(eye), Vector(glm::normalize(target - eye))}, 2});
    addMeans(means, fmt::format("radiance from wall {}", wall + 1), room.radiance(wall, target, 2));
  }
  return judgePaths(run, rays, 256, means, kCoarse,
                    "a closed room of six walls with different emissions and reflectances, "
                    "maxBounces() = 2");
}

Finding unfairRoulette(CheckRun& run) {
  Random random(run.seed);
  const Hollow hollow(random);
  const Colour kd(0.4f, 0.3f, 0.0f), emission(1.0f, 0.5f, 2.0f);
  run.worker.loadScene(furnaceIn(hollow, kd, emission));
  std::vector<PathRay> rays;
  std::vector<Mean> means;
  std::vector<Suspicion> suspicions{
      {"RussianRoulette is not asked, or its answer is not used", {}},
      {"depth counts from 0: it is the number of scattering events so far, 1 at hit 1", {}},
      {"depth is one too large: it is the number of scattering events so far, 1 at hit 1", {}},
      {"the roulette is shown the throughput from before its update", {}},
  };
  for (const int bounces : {2, 3}) {
    rays.push_back({hollow.rayAt(0.8, random), bounces});
    glm::dvec3 radiance;
    for (int c = 0; c < 3; ++c) {
      const LopsidedFurnace furnace{double{emission[c]}, double{kd[c]}};
      const auto unfair = [&](int first, bool updated) {
        return unfairRadiance(furnace, 0.8, bounces, first, updated);
      };
      radiance[c] = unfair(1, true);
      suspicions[0].means.push_back(furnace.radiance(0.8, bounces));
      suspicions[1].means.push_back(unfair(0, true));
      suspicions[2].means.push_back(unfair(2, true));
      suspicions[3].means.push_back(unfair(1, false));
    }
    addMeans(means, fmt::format("radiance, maxBounces() = {}", bounces), radiance);
  }
  return judgePaths(run, rays, 256, means, kCoarse,
                    "inside a sphere that emits everywhere, with a roulette for testing: where the "
                    "throughput's blue is 0, as after every update here, its weight is not 1/q but "
                    "(1 + 1/(1 + depth)) / q",
                    suspicions);
}

}  // namespace

std::vector<Check> path::checksOf(CourseworkFunction pathTracer) {
  return {
      {"emission", pathTracer,
       "of a light that is seen directly comes what its front emits, counted once; its back and "
       "the world around are black, and so are the back of any surface, and a lit one where "
       "maxBounces() = 0",
       0.0, emissionIsSeen},
      {"valid", pathTracer,
       "the radiance is finite and not negative, also where reflection says \"no sample\"", 0.0,
       radianceIsValid},
      {"repeatable", pathTracer,
       "the same random numbers give the same radiance, whatever was traced before", 0.0,
       sameNumbersSameRadiance},
      {"twice-the-emission", pathTracer,
       "with the same random numbers, twice the emission gives twice the radiance, bit for bit",
       0.0, twiceTheEmission},
      {"furnace", pathTracer,
       "inside a sphere the mean radiance is E + integral of f L cos(theta), for each number of "
       "bounces",
       Deltas{}.all, lopsidedFurnace},
      {"bounces", pathTracer,
       "each further bounce adds the light that has been scattered once more, up to maxBounces() "
       "of them, in small rooms and on dark walls too",
       kBounceDelta, bouncesAdd},
      {"furnace-with-sphere", pathTracer,
       "where all surfaces emit E and reflect a quarter, the mean radiance is E (4 - 4^-B) / 3",
       Deltas{}.all, furnaceWithSphere},
      {"room", pathTracer,
       "in a room of unequal walls the mean radiance is that of the light which arrives where the "
       "path is",
       kCoarse.all, mattRoom},
      {"roulette", pathTracer,
       "RussianRoulette is asked after each update of the throughput, with the updated throughput "
       "and the number of scattering events so far, and what it says is done",
       kCoarse.all, unfairRoulette},
  };
}

std::span<const Check> part5Checks() {
  static const std::vector<Check> kChecks = path::checksOf(F::kTracePath);
  return kChecks;
}

}  // namespace pathmark::checks
